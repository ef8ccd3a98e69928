// A file is either the old or the new one, whole.

#include <continua/base/atomic_file.h>
#include <continua/base/input_error.h>

#include "../unit_test.h"

#include <sys/resource.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>

using namespace Continua;

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

  check::throws<RunError>(
      "no folder", []() { write_file_atomically("no-such-folder/a", ""); }, "No such file");
  std::filesystem::create_directories("atomic-file-test-folder");
  check::throws<RunError>(
      "a folder", []() { write_file_atomically("atomic-file-test-folder", "x"); },
      "cannot write 'atomic-file-test-folder'");
  std::filesystem::remove_all("atomic-file-test-folder");
  std::filesystem::remove(file);
}
