// One folder, one process: who holds it, what a kill leaves, forked processes, file systems without
// locks.

#include <continua/base/folder_lock.h>
#include <continua/base/input_error.h>

#include "../unit_test.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <sstream>

namespace test_of_folder_lock
{
using namespace Continua;
namespace fs = std::filesystem;

namespace
{
/// What the file system says of locks; 0: it has them.
int error_of_flock = 0;
/// Called once between opening and locking.
std::function<void()> meanwhile;
} // namespace

/// In place of the system's.
extern "C" int flock(const int descriptor, const int operation) noexcept
{
  if (meanwhile)
  {
    const std::function<void()> call = meanwhile;
    meanwhile = nullptr;
    call();
  }
  if (error_of_flock != 0)
  {
    errno = error_of_flock;
    return -1;
  }
  return static_cast<int>(syscall(SYS_flock, descriptor, operation));
}

namespace
{
const std::string folder = "folder-lock-test";

std::string text_of_lock()
{
  std::ostringstream text;
  text << std::ifstream(folder + "/lock").rdbuf();
  return text.str();
}

std::string holder()
{
  return FolderLock(folder).holder();
}

/// A process of its own that locks the folder, and the number it has.
pid_t locking_process(const std::function<void()> &then)
{
  int ready[2];
  if (pipe(ready) != 0)
    return -1;
  const pid_t process = fork();
  if (process == 0)
  {
    const FolderLock lock(folder);
    [[maybe_unused]] const ssize_t n = write(ready[1], "x", 1);
    then();
    _exit(0);
  }
  char letter;
  [[maybe_unused]] const ssize_t n = read(ready[0], &letter, 1);
  close(ready[0]);
  close(ready[1]);
  return process;
}
} // namespace

UNIT_TEST(folder_lock)
{
  fs::remove_all(folder);
  fs::create_directories(folder);
  {
    const FolderLock lock(folder);
    check::equal("nobody else", lock.holder() + lock.warning(), "");
    check::is_true("in words",
                   check::matches(text_of_lock(), "^Continua: process " + std::to_string(getpid()) +
                                                      " on [^ ]+ since 20[0-9]{2}-"));
    check::equal("the other is told", "Continua: " + holder() + "\n", text_of_lock());
    check::is_true("and leaves the file", fs::exists(folder + "/lock"));
  }
  check::is_true("the end removes the file", !fs::exists(folder + "/lock"));

  const pid_t process = locking_process([]() { pause(); });
  check::is_true("another process",
                 check::matches(holder(), "^process " + std::to_string(process) + " on "));
  kill(process, SIGKILL);
  waitpid(process, nullptr, 0);
  check::is_true("kill -9 leaves the file", fs::exists(folder + "/lock"));
  check::equal("but no lock", holder(), "");

  // A child that is forked has the same lock, one that is started none.
  auto lock = std::make_unique<FolderLock>(folder);
  const pid_t started = fork();
  if (started == 0)
  {
    execlp("sleep", "sleep", "60", static_cast<char *>(nullptr));
    _exit(1);
  }
  const std::string name_of_child = "/proc/" + std::to_string(started) + "/comm";
  for (std::string name; name != "sleep"; usleep(1000))
    std::ifstream(name_of_child) >> name;
  lock.reset();
  check::equal("a program that was started does not hold it", holder(), "");
  kill(started, SIGKILL);
  waitpid(started, nullptr, 0);

  // The process that has the lock ends while another one has opened the file and waits.
  lock = std::make_unique<FolderLock>(folder);
  meanwhile = [&lock]() { lock.reset(); };
  {
    const FolderLock next(folder);
    check::equal("the file was removed meanwhile: no holder", next.holder(), "");
    check::is_true("and the lock is on a file that is there", !holder().empty());
  }
  // One that has just locked has not said its name yet.
  const int descriptor = open((folder + "/lock").c_str(), O_RDWR | O_CREAT, 0666);
  flock(descriptor, LOCK_EX);
  check::equal("a nameless one", holder(), "a process whose name is not in the file 'lock'");
  close(descriptor);

  for (const int error : {ENOLCK, EOPNOTSUPP, EINVAL, ENOSYS})
  {
    error_of_flock = error;
    const FolderLock none(folder), second(folder);
    check::is_true("no locks there: a warning, and both go on",
                   none.holder().empty() && second.holder().empty() &&
                       check::matches(second.warning(), "file system .* has no locks"));
    check::is_true("no file is left", !fs::exists(folder + "/lock"));
  }
  error_of_flock = EIO;
  check::throws<RunError>(
      "another error", []() { FolderLock broken(folder); }, "cannot lock .*Input/output error");
  error_of_flock = 0;

  std::ofstream(folder + "/lock") << "of the user\n";
  check::throws<RunError>(
      "a file of the user", []() { FolderLock foreign(folder); }, "not of Continua");
  check::equal("it stays", text_of_lock(), "of the user\n");
  fs::remove(folder + "/lock");
  fs::create_directories(folder + "/lock");
  check::throws<RunError>(
      "a folder", []() { FolderLock foreign(folder); }, "cannot write '.*lock': Is a directory");
  fs::remove(folder + "/lock");
  fs::create_symlink("elsewhere", folder + "/lock");
  check::throws<RunError>(
      "a link", []() { FolderLock foreign(folder); }, "cannot write '.*lock'");
  check::is_true("it is not followed", !fs::exists(folder + "/elsewhere"));
  fs::remove(folder + "/lock");
  mkfifo((folder + "/lock").c_str(), 0666);
  check::throws<RunError>(
      "a pipe", []() { FolderLock foreign(folder); }, "it is not a file");
  fs::remove_all(folder);
}
} // namespace test_of_folder_lock
