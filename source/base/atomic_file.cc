#include <continua/base/atomic_file.h>
#include <continua/base/input_error.h>

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

namespace Continua
{
namespace
{
[[noreturn]] void fail(const std::string &file, const std::string &temporary, const int error)
{
  ::unlink(temporary.c_str());
  throw RunError("cannot write '" + file + "': " + std::strerror(error));
}

/// fsync, which a signal may interrupt on a network file system.
int flush(const int descriptor)
{
  int result;
  do
    result = ::fsync(descriptor);
  while (result != 0 && errno == EINTR);
  return result;
}
} // namespace

std::string folder_of(const std::string &file)
{
  const std::size_t slash = file.rfind('/');
  return slash == std::string::npos ? "." : file.substr(0, slash + 1);
}

void require_folder_of(const std::string &file)
{
  if (!std::filesystem::is_directory(folder_of(file)))
    throw InputError({file, 0}, "", "the folder '" + folder_of(file) + "' does not exist",
                     "Make this folder, or name another one");
}

void flush_to_disk(const std::string &path)
{
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0)
    throw RunError("cannot open '" + path + "': " + std::strerror(errno));
  const int error = flush(descriptor) == 0 ? 0 : errno;
  ::close(descriptor);
  // Some file systems cannot flush a folder.
  if (error != 0 && error != EINVAL)
    throw RunError("cannot write '" + path + "' to the disk: " + std::strerror(error));
}

void replace_file(const std::string &file, const std::string &content, const std::string &rest)
{
  const std::string temporary = file + ".new";
  const int descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor < 0)
    throw RunError("cannot write '" + file + "': " + std::strerror(errno));

  for (const std::string *part : {&content, &rest})
    for (std::size_t n_written = 0; n_written < part->size();)
    {
      const ssize_t n = ::write(descriptor, part->data() + n_written, part->size() - n_written);
      if (n < 0 && errno == EINTR)
        continue;
      if (n < 0)
      {
        const int error = errno;
        ::close(descriptor);
        fail(file, temporary, error);
      }
      n_written += static_cast<std::size_t>(n);
    }
  if (flush(descriptor) != 0)
  {
    const int error = errno;
    ::close(descriptor);
    fail(file, temporary, error);
  }
  // Network file systems report a full disk only here.
  if (::close(descriptor) != 0 && errno != EINTR)
    fail(file, temporary, errno);
  if (std::rename(temporary.c_str(), file.c_str()) != 0)
    fail(file, temporary, errno);
}

void write_file_atomically(const std::string &file,
                           const std::string &content,
                           const std::string &rest)
{
  replace_file(file, content, rest);
  flush_to_disk(folder_of(file));
}
} // namespace Continua
