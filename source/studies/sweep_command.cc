#include <continua/studies/sweep_command.h>

#include <continua/base/parameter_text.h>
#include <continua/base/quoted_name.h>
#include <continua/case/case.h>
#include <continua/studies/planned_run.h>

#include <set>

namespace Continua
{
CommandLine with_sweeps(const CommandLine &command_line)
{
  CommandLine result = command_line;
  result.sweeps.clear();
  if (command_line.sweeps.empty())
    return result;
  const ParameterText text(command_line.parameter_file, command_line.overrides);
  const ParameterText::Entry *const analysis = text.root().entry("Analysis");
  const std::string own = analysis == nullptr ? GeneralParameters().analysis : analysis->value();
  if (own != "sweep")
  {
    set_entry(result, "Analysis", "sweep");
    set_entry(result, "Sweep/Analysis", own);
  }
  std::set<std::string> paths;
  for (const std::string &sweep : command_line.sweeps)
  {
    const std::size_t equals = find_unquoted(sweep, "=");
    const std::string path = collapse_blanks(sweep.substr(0, equals));
    // The second would replace the first.
    if (!paths.insert(tidy_path(path)).second)
      throw InputError({ParameterText::command_line, 0}, "--sweep " + sweep,
                       "this entry is swept twice", "Give all its values in one --sweep");
    set_entry(result, "Sweep/Entries/" + quoted_name(path, "#=/"),
              collapse_blanks(sweep.substr(equals + 1)));
  }
  return result;
}
} // namespace Continua
