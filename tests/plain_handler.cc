// A printed parameter file holds the values of the run for deal.II's own reader, too:
// plain_handler FOLDER... reads FOLDER/printed.prm by a plain dealii::ParameterHandler that has
// declared the entries of FOLDER/printed.json, and compares all values. Exit status 1 if one
// differs.

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/utilities.h>

#include <nlohmann/json.hpp>

#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

namespace
{
/// The names of a path "A/B/C"; one with a slash stands between quotes.
std::vector<std::string> names_of(const std::string &path)
{
  std::vector<std::string> names(1);
  bool is_quoted = false;
  for (const char letter : path)
    if (letter == '"')
      is_quoted = !is_quoted;
    else if (letter == '/' && !is_quoted)
      names.emplace_back();
    else
      names.back() += letter;
  return names;
}

void declare(dealii::ParameterHandler &handler,
             const std::vector<std::string> &section,
             const std::string &key,
             const std::string &default_value)
{
  for (const std::string &name : section)
    handler.enter_subsection(name);
  handler.declare_entry(key, default_value, dealii::Patterns::Anything());
  for (std::size_t i = 0; i < section.size(); ++i)
    handler.leave_subsection();
}

/// How many values are not their default; throws std::runtime_error for one that is read as
/// another.
unsigned int compare(const std::string &folder)
{
  std::ifstream json(folder + "/printed.json"), prm(folder + "/printed.prm");
  if (!json || !prm)
    throw std::runtime_error("printed.json or printed.prm is missing");
  const nlohmann::json entries = nlohmann::json::parse(json);
  dealii::ParameterHandler handler;
  for (const auto &entry : entries)
  {
    std::vector<std::string> section = names_of(entry["path"]);
    const std::string key = section.back();
    section.pop_back();
    declare(handler, section, key, entry["default"]);
  }
  handler.parse_input(prm, "printed.prm");
  unsigned int n_changed = 0;
  for (const auto &entry : entries)
  {
    std::vector<std::string> section = names_of(entry["path"]);
    const std::string key = section.back();
    section.pop_back();
    const std::string value = entry["value"], read = handler.get(section, key);
    if (read != value)
      throw std::runtime_error(entry["path"].get<std::string>() + " is '" + value +
                               "', but a plain ParameterHandler reads '" + read + "'");
    n_changed += value != entry["default"].get<std::string>();
  }
  return n_changed;
}
} // namespace

int main(int argc, char **argv)
{
  int status = argc > 1 ? 0 : 1;
  for (int i = 1; i < argc; ++i)
    try
    {
      const unsigned int n_changed = compare(argv[i]);
      std::cout << argv[i] << ": " << n_changed << " values are not their default" << std::endl;
      // No shipped file leaves everything as it is.
      if (n_changed == 0)
        throw std::runtime_error("all values are their default");
    }
    catch (const std::exception &error)
    {
      std::cout << argv[i] << ": FAILED: " << error.what() << std::endl;
      status = 1;
    }
  return status;
}
