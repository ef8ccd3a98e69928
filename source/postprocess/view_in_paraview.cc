#include <continua/base/embedded_file.h>
#include <continua/postprocess/view_in_paraview.h>

namespace Continua
{
namespace
{
/// Of view_in_paraview.py alone; `mark_of_file` stands in it for the place where it is written.
const EmbeddedFile embedded_files[] = {
#include <continua/postprocess/view_in_paraview.inc>
};
const std::string mark_of_file = "@FILE@";

/// What a literal of Python between double quotes is to have in it.
std::string in_quotes(const std::string &text)
{
  std::string result;
  for (const char letter : text)
    if (letter == '\n')
      result += "\\n";
    else
    {
      if (letter == '"' || letter == '\\')
        result += '\\';
      result += letter;
    }
  return result;
}
} // namespace

std::string view_in_paraview(const std::string &file)
{
  std::string result = embedded_files[0].text;
  result.replace(result.find(mark_of_file), mark_of_file.size(), in_quotes(file));
  return result;
}
} // namespace Continua
