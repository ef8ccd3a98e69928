#include <continua/base/entry_pattern.h>
#include <continua/base/units.h>

#include "../unit_test.h"

#include <deal.II/base/parameter_handler.h>

namespace test_of_entry_pattern
{
using namespace Continua;

namespace
{
void read_length(const std::string &text)
{
  parse_quantity(text, Dimensions::length);
}
} // namespace

UNIT_TEST(entry_pattern)
{
  const EntryPattern length("number", false, read_length);
  check::is_true("a quantity with its unit", length.match("3 mm"));
  check::is_true("another dimension", !length.match("3 s"));
  check::is_true("no number", !length.match("long"));
  check::is_true("empty", !length.match(""));
  check::is_true("empty where it may be", EntryPattern("number", true, read_length).match(""));
  check::equal("description", length.description(), "[number]");

  dealii::ParameterHandler handler;
  handler.declare_entry("Length", "1 m", length);
  handler.set("Length", "3 mm");
  check::equal("in a handler", handler.get("Length"), "3 mm");
  check::throws<dealii::ExceptionBase>(
      "the handler refuses", [&] { handler.set("Length", "3 s"); }, "3 s");
}
} // namespace test_of_entry_pattern
