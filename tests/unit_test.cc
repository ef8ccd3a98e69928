// The main function of a folder's unit tests: the first argument is the name of the test, without
// one it lists the tests. With --serve SOCKET it performs tests that served.c asks for,
// each in a copy of the process.

#include "unit_test.h"

#include <continua/base/command_server.h>
#include <continua/base/message_passing.h>
#include <continua/mesh/gmsh_process.h>

#include <iostream>
#include <map>
#include <regex>

namespace unit_test
{
namespace
{
/// A function's own variable, so that it is there when the first test enters itself.
std::map<std::string, Function> &table()
{
  static std::map<std::string, Function> functions;
  return functions;
}
} // namespace

Registration::Registration(const std::string &name, const Function function)
{
  table()[name] = function;
}
} // namespace unit_test

namespace check
{
bool matches(const std::string &text, const std::string &pattern)
{
  return std::regex_search(text, std::regex(pattern));
}
} // namespace check

namespace
{
int run(int argc, char **argv)
{
  const auto &tests = unit_test::table();
  const auto chosen = argc > 1 ? tests.find(argv[1]) : tests.end();
  if (chosen == tests.end())
  {
    for (const auto &[name, function] : tests)
      std::cerr << name << std::endl;
    return 2;
  }
  Continua::prepare_message_passing();
  chosen->second(argc - 1, argv + 1);
  return 0;
}
} // namespace

int main(int argc, char **argv)
{
  // A test that meshes with gmsh starts this program again.
  if (Continua::is_gmsh_process(argc, argv))
    return Continua::run_gmsh_process(argc, argv);
  if (argc == 3 && argv[1] == std::string("--serve"))
  {
    constexpr double idle_time = 60.; // [s]
    Continua::CommandServer(argv[2], run).serve(idle_time);
    return 0;
  }
  return run(argc, argv);
}
