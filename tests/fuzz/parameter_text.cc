// Parameter files: refused with an InputError, or read so that the tree written as text is read to
// the same tree.

#include <continua/base/parameter_text.h>

#include "input_file.h"

namespace
{
using Continua::ParameterText;

std::string text_of(const ParameterText::Section &section)
{
  std::string text;
  for (const ParameterText::Entry &entry : section.entries)
    text += "set " + entry.key + " = " + entry.value() + "\n";
  for (const ParameterText::Section &child : section.sections)
    text += "subsection " + child.name + "\n" + text_of(child) + "end\n";
  return text;
}
} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, const std::size_t size)
{
  const std::string input(reinterpret_cast<const char *>(data), size);
  // The reader may read what is included; nothing outside of the folder, which a device could be.
  if (input.find('/') != std::string::npos && input.find("nclude") != std::string::npos)
    return 0;
  if (input.find('/') != std::string::npos && input.find("NCLUDE") != std::string::npos)
    return 0;
  std::string text;
  try
  {
    text = text_of(ParameterText(Fuzz::input_file(input, "input.prm"), {}).root());
  }
  catch (const Continua::InputError &)
  {
    return 0;
  }
  const ParameterText again(Fuzz::input_file(text, "again.prm"), {});
  Fuzz::require(text_of(again.root()) == text, "what was read differs from what was written");
  return 0;
}
