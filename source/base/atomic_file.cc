#include <continua/base/atomic_file.h>
#include <continua/base/input_error.h>

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace Continua
{
namespace
{
[[noreturn]] void fail(const std::string &file, const std::string &temporary, const int error)
{
  ::unlink(temporary.c_str());
  throw RunError("cannot write '" + file + "': " + std::strerror(error));
}
} // namespace

void flush_to_disk(const std::string &path)
{
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0)
    throw RunError("cannot open '" + path + "': " + std::strerror(errno));
  const int error = ::fsync(descriptor) == 0 ? 0 : errno;
  ::close(descriptor);
  // Some file systems cannot flush a folder.
  if (error != 0 && error != EINVAL)
    throw RunError("cannot write '" + path + "' to the disk: " + std::strerror(error));
}

void write_file_atomically(const std::string &file,
                           const std::string &content,
                           const std::string &rest)
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
  if (::fsync(descriptor) != 0)
  {
    const int error = errno;
    ::close(descriptor);
    fail(file, temporary, error);
  }
  // Network file systems report a full disk only here.
  if (::close(descriptor) != 0)
    fail(file, temporary, errno);
  if (std::rename(temporary.c_str(), file.c_str()) != 0)
    fail(file, temporary, errno);
  // After a power failure the rename is kept only if the folder, too, reached the disk.
  const std::size_t slash = file.rfind('/');
  flush_to_disk(slash == std::string::npos ? "." : file.substr(0, slash + 1));
}
} // namespace Continua
