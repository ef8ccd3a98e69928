#ifndef continua_tests_unit_test_h
#define continua_tests_unit_test_h

#include "check.h"

#include <string>

namespace unit_test
{
using Function = void (*)(int argc, char **argv);

/// Enters a test into the table of its program.
struct Registration
{
  Registration(const std::string &name, Function function);
};
} // namespace unit_test

/// The unit test of the file `name`.cc; `argc` and `argv` are there for MPI_InitFinalize. What the
/// file defines stands in a namespace test_of_`name`, since several files are compiled as one and
/// the files of a folder make one program.
#define UNIT_TEST(name)                                                                            \
  static void run_##name(int argc, char **argv);                                                   \
  static const unit_test::Registration registration_of_##name(#name, run_##name);                  \
  static void run_##name([[maybe_unused]] int argc, [[maybe_unused]] char **argv)

#endif
