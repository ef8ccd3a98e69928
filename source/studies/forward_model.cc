#include <continua/studies/forward_model.h>

#include <continua/base/parameter_text.h>
#include <continua/base/quoted_name.h>

#include <algorithm>

namespace Continua
{
namespace
{
/// The names of an override "Section/Key=value".
std::vector<std::string> names_of_override(const std::string &text)
{
  std::vector<std::string> names;
  for (const std::string &part : split_unquoted(text.substr(0, find_unquoted(text, "=")), '/'))
    names.push_back(without_quotes(collapse_blanks(part)));
  return names;
}

/// Leaves out a section or an entry, whoever sets it.
void leave_out(const std::vector<std::string> &path,
               const ParameterText &file,
               CommandLine &command_line)
{
  std::vector<std::string> &overrides = command_line.overrides;
  overrides.erase(std::remove_if(overrides.begin(), overrides.end(),
                                 [&path](const std::string &text)
                                 {
                                   const std::vector<std::string> names = names_of_override(text);
                                   return names.size() >= path.size() &&
                                          std::equal(path.begin(), path.end(), names.begin());
                                 }),
                  overrides.end());
  const std::vector<std::string> parent(path.begin(), path.end() - 1);
  const ParameterText::Section *const section = file.find(parent);
  const ParameterText::Section *const itself = file.find(path);
  const bool has_entries =
      itself != nullptr && (!itself->entries.empty() || !itself->sections.empty());
  if (has_entries || (section != nullptr && section->entry(path.back()) != nullptr))
    overrides.push_back(join_path(path));
}
} // namespace

CommandLine without_data(const CommandLine &command_line)
{
  CommandLine result = command_line;
  result.restart = false;
  const ParameterText file(command_line.parameter_file, {}),
      with_overrides(command_line.parameter_file, command_line.overrides);
  leave_out({"Expected"}, file, result);
  if (const ParameterText::Section *const probes = with_overrides.find({"Probes"}))
    for (const ParameterText::Section &probe : probes->sections)
      for (const char *const key :
           {"Measured", "Measured factors", "Measured shift", "Measured period"})
        leave_out({"Probes", probe.name, key}, file, result);
  return result;
}
} // namespace Continua
