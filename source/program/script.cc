#include <continua/base/input_error.h>
#include <continua/base/rank_agreement.h>
#include <continua/program/examples.h>
#include <continua/program/script.h>

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string>

namespace Continua
{
namespace
{
constexpr std::array<const char *, 2> names_of_scripts = {{"plot", "report"}};
} // namespace

std::string script_file(const std::string &name)
{
  // Beside the examples: share/continua of a prefix, or the checkout.
  return (std::filesystem::path(examples_folder()).parent_path() / "scripts" / name).string();
}

std::optional<int> become_script(const int argc, char **argv)
{
  if (argc < 2 || std::none_of(names_of_scripts.begin(), names_of_scripts.end(),
                               [argv](const std::string &name) { return name == argv[1]; }))
    return {};
  const std::string name = argv[1];
  try
  {
    const std::string script = script_file(name);
    ::execv(script.c_str(), argv + 1);
    throw InputError({"command line", 0}, name,
                     script + " cannot be started: " + std::strerror(errno),
                     "Install the program with its scripts, and python3");
  }
  catch (const InputError &error)
  {
    RankAgreement::print_error(error.what(), exit_status_of_wrong_input);
    return exit_status_of_wrong_input;
  }
}
} // namespace Continua
