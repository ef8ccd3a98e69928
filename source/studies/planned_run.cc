#include <continua/studies/planned_run.h>

#include <continua/base/parameter_text.h>
#include <continua/base/quoted_name.h>

#include <algorithm>
#include <cctype>

namespace Continua
{
namespace
{
/// The path of an override "Section/Key=value", without blanks that do not count.
std::string path_of(const std::string &override_text)
{
  return tidy_path(override_text.substr(0, find_unquoted(override_text, "=")));
}

/// Whether the letter is the sign of a number, and not that of an exponent or between two words.
bool is_minus(const std::string &text, const std::size_t place)
{
  const auto is_of_number = [&text](const std::size_t i)
  {
    return i < text.size() && (std::isalnum(static_cast<unsigned char>(text[i])) || text[i] == '.');
  };
  return text[place] == '-' && (place == 0 || !is_of_number(place - 1)) && is_of_number(place + 1);
}

/// As a shell reads it back.
std::string quoted(const std::string &text)
{
  std::string result = "'";
  for (const char letter : text)
    result += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  return result + "'";
}

bool sets_a_value(const std::string &override_text)
{
  return find_unquoted(override_text, "=") != std::string::npos;
}
} // namespace

std::string folder_name(const std::string &text)
{
  std::string name;
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    const unsigned char letter = static_cast<unsigned char>(text[i]);
    if (std::isalnum(letter) != 0)
    {
      name += static_cast<char>(std::tolower(letter));
      continue;
    }
    if (!name.empty() && name.back() != '-')
      name += '-';
    if (is_minus(text, i))
      name += "minus-";
  }
  return name;
}

std::string tidy_path(const std::string &path)
{
  std::vector<std::string> names;
  for (const std::string &part : split_unquoted(path, '/'))
    names.push_back(without_quotes(collapse_blanks(part)));
  return join_path(names);
}

void set_entry(CommandLine &command_line, const std::string &path, const std::string &value)
{
  std::vector<std::string> &all = command_line.overrides;
  const std::string text = path + "=" + value;
  all.erase(std::remove_if(all.begin(), all.end(),
                           [&text](const std::string &other)
                           { return path_of(other) == path_of(text); }),
            all.end());
  all.push_back(text);
}

void remove_entries_of(CommandLine &command_line, const std::string &section)
{
  std::vector<std::string> &all = command_line.overrides;
  all.erase(std::remove_if(
                all.begin(), all.end(),
                [&section](const std::string &one) {
                  return (path_of(one) + "/").compare(0, section.size() + 1, section + "/") == 0;
                }),
            all.end());
}

std::string text_of(const CommandLine &command_line)
{
  std::string text = "continua " + quoted(command_line.parameter_file);
  for (const std::string &entry : command_line.overrides)
    text += (sets_a_value(entry) ? " --set " : " --unset ") + quoted(entry);
  return text + " --output " + quoted(command_line.output_directory);
}

std::vector<std::string> arguments_of(const CommandLine &command_line)
{
  std::vector<std::string> arguments = {command_line.parameter_file};
  // Behind the equals sign a value may begin with two dashes.
  for (const std::string &entry : command_line.overrides)
    arguments.push_back((sets_a_value(entry) ? "--set=" : "--unset=") + entry);
  arguments.push_back("--output=" + command_line.output_directory);
  if (command_line.restart)
    arguments.emplace_back("--restart");
  if (command_line.overwrite)
    arguments.emplace_back("--overwrite");
  if (command_line.allow_mesh_commands)
    arguments.emplace_back("--allow-mesh-commands");
  return arguments;
}
} // namespace Continua
