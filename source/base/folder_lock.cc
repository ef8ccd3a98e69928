#include <continua/base/folder_lock.h>
#include <continua/base/input_error.h>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <ctime>
#include <thread>

namespace Continua
{
namespace
{
/// What the text of a lock begins with.
const std::string mark = "Continua: ";

std::string this_process()
{
  std::array<char, 256> host = {};
  ::gethostname(host.data(), host.size() - 1);
  const std::time_t now = std::time(nullptr);
  std::tm local = {};
  ::localtime_r(&now, &local);
  std::array<char, 64> time = {};
  std::strftime(time.data(), time.size(), "%Y-%m-%d %H:%M:%S %z", &local);
  return "process " + std::to_string(::getpid()) + " on " + host.data() + " since " + time.data();
}

/// The beginning of a file, as much as a lock has.
std::string text_of(const int descriptor)
{
  std::array<char, 512> bytes;
  const ssize_t n = ::pread(descriptor, bytes.data(), bytes.size(), 0);
  return n > 0 ? std::string(bytes.data(), static_cast<std::size_t>(n)) : std::string();
}

/// Who has the lock. Who has just got it may not have said so yet.
std::string holder_in(const int descriptor)
{
  for (unsigned int attempt = 0; attempt < 50; ++attempt)
  {
    const std::string text = text_of(descriptor);
    if (text.compare(0, mark.size(), mark) == 0 && text.back() == '\n')
      return text.substr(mark.size(), text.find('\n') - mark.size());
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return "a process whose name is not in the file 'lock'";
}

/// Whether that is what the system says where files have no locks.
bool has_no_locks(const int error)
{
  return error == ENOLCK || error == EOPNOTSUPP || error == EINVAL || error == ENOSYS;
}

/// 0, or the error.
int lock(const int descriptor)
{
  while (::flock(descriptor, LOCK_EX | LOCK_NB) != 0)
    if (errno != EINTR)
      return errno;
  return 0;
}

/// A descriptor that is closed with its scope, unless it is released.
struct Descriptor
{
  explicit Descriptor(const int number) : number(number) {}
  Descriptor(const Descriptor &) = delete;
  Descriptor &operator=(const Descriptor &) = delete;
  ~Descriptor()
  {
    if (number >= 0)
      ::close(number);
  }
  int release()
  {
    const int result = number;
    number = -1;
    return result;
  }
  int number;
};
} // namespace

FolderLock::FolderLock(const std::string &folder) : file(folder + "/lock")
{
  while (!try_to_lock())
  {
  }
}

FolderLock::~FolderLock()
{
  if (descriptor < 0)
    return;
  // While the lock is held: whoever waits for this file finds that it is no longer in the folder.
  ::unlink(file.c_str());
  ::close(descriptor);
}

bool FolderLock::try_to_lock()
{
  const int flags = O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK;
  Descriptor opened(::open(file.c_str(), O_RDWR | O_CREAT | flags, 0666));
  // What another user's run left can be locked, too, and then removed.
  const bool is_foreign = opened.number < 0 && errno == EACCES;
  if (is_foreign)
    opened.number = ::open(file.c_str(), O_RDONLY | flags);
  struct stat of_descriptor, of_file;
  if (opened.number < 0 || ::fstat(opened.number, &of_descriptor) != 0)
    throw RunError("cannot write '" + file + "': " + std::strerror(errno));
  if (!S_ISREG(of_descriptor.st_mode))
    throw RunError("cannot write '" + file + "': it is not a file");

  const int error = lock(opened.number);
  if (error == EWOULDBLOCK)
  {
    other_holder = holder_in(opened.number);
    return true;
  }
  const std::string text = text_of(opened.number);
  if (!text.empty() && text.compare(0, mark.size(), mark) != 0)
    throw RunError("the file '" + file + "' is in the place of the lock and not of Continua");
  if (has_no_locks(error))
  {
    ::unlink(file.c_str());
    missing = "the file system of the output folder has no locks (" +
              std::string(std::strerror(error)) +
              "): take care that no other run works in the same folder";
    return true;
  }
  if (error != 0)
    throw RunError("cannot lock '" + file + "': " + std::strerror(error));
  // Between opening and locking the process that had it may have removed the file.
  if (::stat(file.c_str(), &of_file) != 0 || of_file.st_dev != of_descriptor.st_dev ||
      of_file.st_ino != of_descriptor.st_ino)
    return false;
  if (is_foreign)
  {
    if (::unlink(file.c_str()) != 0)
      throw RunError("cannot write '" + file + "': " + std::strerror(errno));
    return false;
  }
  descriptor = opened.release();
  name_holder();
  return true;
}

void FolderLock::name_holder() const
{
  const std::string text = mark + this_process() + '\n';
  // On a full disk the lock holds without the text.
  if (::ftruncate(descriptor, 0) == 0) [[maybe_unused]]
    const ssize_t n = ::pwrite(descriptor, text.data(), text.size(), 0);
}
} // namespace Continua
