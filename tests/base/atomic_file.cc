// A file is either the old or the new one, whole.

#include <continua/base/atomic_file.h>
#include <continua/base/input_error.h>

#include "../unit_test.h"

#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace test_of_atomic_file
{
using namespace Continua;

namespace
{
/// Which flushing the disk refuses from now on: of a file, or of a folder.
mode_t refused_type = 0;
/// How many flushes a signal interrupts first.
int n_interrupted = 0;
} // namespace

/// In place of the system's.
extern "C" int fsync(const int descriptor)
{
  struct stat status;
  if (n_interrupted-- > 0)
  {
    errno = EINTR;
    return -1;
  }
  if (refused_type != 0 && fstat(descriptor, &status) == 0 &&
      (status.st_mode & S_IFMT) == refused_type)
  {
    errno = EIO;
    return -1;
  }
  return static_cast<int>(syscall(SYS_fsync, descriptor));
}

namespace
{
std::string content(const std::string &file)
{
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}
} // namespace

UNIT_TEST(atomic_file)
{
  const std::string file = "atomic-file-test.txt";
  write_file_atomically(file, "old");
  check::equal("written", content(file), "old");
  write_file_atomically(file, std::string("new\0", 4));
  check::is_true("replaced", content(file) == std::string("new\0", 4));
  check::is_true("no temporary file", !std::filesystem::exists(file + ".new"));

  // A limit on the size of files stands for the full disk.
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit limit;
  getrlimit(RLIMIT_FSIZE, &limit);
  const rlim_t before = limit.rlim_cur;
  limit.rlim_cur = 65536;
  setrlimit(RLIMIT_FSIZE, &limit);
  check::throws<RunError>(
      "full disk", [&file]() { write_file_atomically(file, std::string(100000, 'x')); },
      "cannot write 'atomic-file-test.txt': File too large");
  limit.rlim_cur = before;
  setrlimit(RLIMIT_FSIZE, &limit);
  check::is_true("the old file is kept", content(file) == std::string("new\0", 4));
  check::is_true("the temporary file is gone", !std::filesystem::exists(file + ".new"));

  refused_type = S_IFREG;
  check::throws<RunError>(
      "the disk fails", [&file]() { replace_file(file, "newer"); },
      "cannot write 'atomic-file-test.txt': Input/output error");
  check::is_true("the old file is kept", content(file) == std::string("new\0", 4));
  check::is_true("the temporary file is gone", !std::filesystem::exists(file + ".new"));
  refused_type = S_IFDIR;
  check::throws<RunError>(
      "the folder fails", [&file]() { write_file_atomically(file, "newer"); },
      "cannot write '.' to the disk: Input/output error");
  check::equal("the new file stands", content(file), "newer");
  replace_file(file, "newest");
  check::equal("replaced without the folder", content(file), "newest");
  refused_type = 0;
  n_interrupted = 2;
  write_file_atomically(file, "through signals");
  check::equal("a signal does not matter", content(file), "through signals");

  check::throws<RunError>(
      "no folder", []() { write_file_atomically("no-such-folder/a", ""); }, "No such file");
  std::filesystem::create_directories("atomic-file-test-folder");
  check::throws<RunError>(
      "a folder", []() { write_file_atomically("atomic-file-test-folder", "x"); },
      "cannot write 'atomic-file-test-folder'");
  std::filesystem::remove_all("atomic-file-test-folder");
  std::filesystem::remove(file);
}
} // namespace test_of_atomic_file
