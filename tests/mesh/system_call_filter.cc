// What a thread can no longer do, and what it and others still can.

#include <continua/mesh/system_call_filter.h>

#include "../unit_test.h"

#include <signal.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>

namespace test_of_system_call_filter
{
using namespace Continua;

namespace
{
bool can_write(const std::string &file)
{
  return bool(std::ofstream(file) << "x");
}
} // namespace

UNIT_TEST(system_call_filter)
{
  const std::filesystem::path folder = "filter-test";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directory(folder);
  const std::string old_file = folder / "old", new_file = folder / "new";
  std::ofstream(old_file) << "text";

  std::thread(
      [&]
      {
        refuse_programs_and_writing_to_this_thread();
        check::is_true("a program", std::system(("touch " + new_file).c_str()) != 0 &&
                                        !std::filesystem::exists(new_file));
        check::is_true("a program with a pipe",
                       ::popen(("touch " + new_file).c_str(), "r") == nullptr);
        check::is_true("a process", ::fork() < 0);
        check::is_true("a new file", !can_write(new_file));
        check::is_true("an old file", !can_write(old_file));
        check::is_true("the end of a file", std::fopen(old_file.c_str(), "a") == nullptr);
        std::error_code error;
        check::is_true("removal", !std::filesystem::remove(old_file, error) && error);
        std::filesystem::rename(old_file, new_file, error);
        check::is_true("another name", bool(error));
        check::is_true("a folder", !std::filesystem::create_directory(folder / "f", error));
        check::is_true("a signal", ::kill(::getppid(), 0) != 0);
        std::string text;
        std::ifstream(old_file) >> text;
        check::equal("reading", text, "text");
        bool runs = false, writes = true;
        std::thread(
            [&]
            {
              runs = true;
              writes = can_write(new_file);
            })
            .join();
        check::is_true("a thread of the thread", runs && !writes);
      })
      .join();
  check::is_true("another thread may write", can_write(new_file));
  check::is_true("and run programs", std::system("true") == 0);
  std::filesystem::remove_all(folder);
}
} // namespace test_of_system_call_filter
