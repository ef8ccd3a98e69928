#include <continua/signal/waveform.h>

namespace Continua
{
namespace
{
std::shared_ptr<const TimeTable>
read_table(ParameterSection &section, const std::string &key, const Dimension &dimension)
{
  if (section.given(key))
    section.refuse(key, "is given as well as 'Waveform = table'",
                   "Remove it, or set 'Waveform = formula'");

  std::string path, column;
  std::string interpolation = "linear";
  std::string after = "hold";
  double offset = 0.;
  section.add_input_file("Table", path,
                         "A csv file of " + key +
                             " over time, with a header such as 'time [ms], value [" +
                             dimension.unit() + "]'.");
  section.add("Column", column, "The column to use; may be left out if there is but one.");
  section.add_choice("Interpolation", interpolation, {"linear", "cubic"},
                     "Between the rows; cubic is smooth and does not overshoot.");
  section.add("Offset", offset, dimension, "Added to the values of the table.");
  section.add_choice("After the table", after, {"hold", "repeat", "zero"},
                     "After the last row: its value, the table again with the period last time - "
                     "first time, or zero without the offset.");
  section.require("Table");
  // Without a table only where the documentation of the entries is made.
  if (path.empty())
    return nullptr;

  return std::make_shared<const TimeTable>(
      path, dimension,
      interpolation == "cubic" ? TimeTable::Interpolation::cubic : TimeTable::Interpolation::linear,
      after == "repeat" ? TimeTable::After::repeat
      : after == "zero" ? TimeTable::After::zero
                        : TimeTable::After::hold,
      offset, column);
}

void refuse_table_entries(const ParameterSection &section)
{
  for (const char *const entry :
       {"Table", "Column", "Interpolation", "Offset", "After the table", "Direction"})
    if (section.given(entry))
      section.refuse(entry, "is of use with 'Waveform = table' only",
                     "Set that, or remove the entry");
}
} // namespace

Waveform::Waveform(const double constant) : expression(constant) {}

Waveform::Waveform(const Expression &expression) : expression(expression) {}

Waveform Waveform::read(ParameterSection &section,
                        const std::string &key,
                        const Dimension &dimension,
                        const std::string &text,
                        const bool required)
{
  Waveform waveform;
  std::string kind = "formula";
  section.add_choice("Waveform", kind, {"formula", "table"},
                     "Whether '" + key + "' is an expression or comes from a table over time.");
  if (kind == "table")
  {
    waveform.table = read_table(section, key, dimension);
    waveform.expression = Expression(1.);
    return waveform;
  }

  refuse_table_entries(section);
  add_expression(section, key, waveform.expression, dimension, text);
  if (required)
    section.require(key);
  return waveform;
}

std::vector<Waveform> Waveform::read_vector(ParameterSection &section,
                                            const std::string &key,
                                            const unsigned int n_components,
                                            const Dimension &dimension,
                                            const std::string &text)
{
  std::string kind = "formula";
  section.add_choice("Waveform", kind, {"formula", "table"},
                     "Whether '" + key +
                         "' is an expression or comes from a table of its size over time.");
  std::vector<Expression> components(n_components);
  std::shared_ptr<const TimeTable> table;
  if (kind == "table")
  {
    table = read_table(section, key, dimension);
    add_expressions(section, "Direction", components, n_components, Dimensions::none,
                    "What the table's value is multiplied by in each direction.");
    section.require("Direction");
  }
  else
  {
    refuse_table_entries(section);
    add_expressions(section, key, components, n_components, dimension, text);
    section.require(key);
  }
  std::vector<Waveform> waveforms;
  waveforms.reserve(n_components);
  for (const Expression &component : components)
  {
    waveforms.emplace_back(component);
    waveforms.back().table = table;
  }
  return waveforms;
}

double Waveform::operator()(const double *point, const double time) const
{
  return table ? (*table)(time)*expression(point, time) : expression(point, time);
}

bool Waveform::depends_on_time() const
{
  return table != nullptr || expression.depends_on_time();
}

bool Waveform::depends_on_space() const
{
  return expression.depends_on_space();
}

bool Waveform::is_zero() const
{
  return expression.is_zero();
}
} // namespace Continua
