#include <continua/base/words.h>
#include <continua/signal/time_table.h>
#include <continua/signal/waveform.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <utility>

namespace Continua
{
using dealii::numbers::PI;

namespace
{
std::shared_ptr<const TimeTable> read_table(ParameterSection &section,
                                            const std::string &key,
                                            const Dimension &dimension,
                                            std::string &file)
{
  std::string path, column;
  TimeTable::Interpolation interpolation = TimeTable::Interpolation::linear;
  TimeTable::After after = TimeTable::After::hold;
  double offset = 0.;
  section.add_input_file("Table", path,
                         "A csv file of " + key +
                             " over time, with a header such as 'time [ms], value [" +
                             dimension.unit() + "]'.");
  section.add("Column", column, "The column to use; may be left out if there is but one.");
  add_choice(
      section, "Interpolation", interpolation,
      {{"linear", TimeTable::Interpolation::linear}, {"cubic", TimeTable::Interpolation::cubic}},
      "Between the rows; cubic is smooth and does not overshoot.");
  section.add("Offset", offset, dimension, "Added to the values of the table.");
  add_choice(section, "After the table", after,
             {{"hold", TimeTable::After::hold},
              {"repeat", TimeTable::After::repeat},
              {"zero", TimeTable::After::zero}},
             "After the last row: its value, the table again with the period last time - "
             "first time, or zero without the offset.");
  section.require("Table");
  // Without a table only where the documentation of the entries is made.
  if (path.empty())
    return nullptr;

  file = path;
  return std::make_shared<const TimeTable>(path, dimension, interpolation, after, offset, column);
}

std::function<double(double)>
read_sine_squared(ParameterSection &section, const std::string &key, const Dimension &dimension)
{
  double amplitude = 0., start = 0.;
  double duration = std::numeric_limits<double>::infinity();
  section.add("Amplitude", amplitude, dimension, "Largest value of the pulse of " + key + ".");
  section.add("Duration", duration, Dimensions::time,
              "T: the pulse is A sin^2(pi (t - t0)/T) from its start t0 to t0 + T.",
              Range::positive());
  section.add("Start", start, Dimensions::time, "t0: when the pulse begins.");
  section.require("Amplitude");
  section.require("Duration");
  return [=](const double time)
  {
    const double phase = (time - start) / duration;
    if (phase <= 0. || phase >= 1.)
      return 0.;
    const double sine = std::sin(PI * phase);
    return amplitude * sine * sine;
  };
}

std::function<double(double)>
read_gaussian(ParameterSection &section, const std::string &key, const Dimension &dimension)
{
  double amplitude = 0., peak = 0.;
  double width = std::numeric_limits<double>::infinity();
  section.add("Amplitude", amplitude, dimension, "Largest value of the pulse of " + key + ".");
  section.add("Time of the peak", peak, Dimensions::time,
              "t0: the pulse is A exp(-((t - t0)/s)^2), for all times.");
  section.add("Width", width, Dimensions::time,
              "s: from its peak to where the pulse has fallen to A/e.", Range::positive());
  section.require("Amplitude");
  section.require("Time of the peak");
  section.require("Width");
  return [=](const double time)
  {
    const double distance = (time - peak) / width;
    return amplitude * std::exp(-distance * distance);
  };
}

const std::string formula = "formula";
const std::string sine_squared_pulse = "sine squared pulse";
const std::string gaussian_pulse = "gaussian pulse";
const std::vector<std::string> kinds = {formula, "table", sine_squared_pulse, gaussian_pulse};

/// The entries of each kind but the formula, which has KEY.
const std::vector<std::pair<std::string, std::vector<std::string>>> entries_of_kinds = {
    {"table", {"Table", "Column", "Interpolation", "Offset", "After the table", "Direction"}},
    {sine_squared_pulse, {"Amplitude", "Duration", "Start", "Direction"}},
    {gaussian_pulse, {"Amplitude", "Time of the peak", "Width", "Direction"}}};

/// Refuses what belongs to another kind of waveform than the one chosen.
void refuse_other_entries(const ParameterSection &section,
                          const std::string &key,
                          const std::string &chosen)
{
  if (chosen != formula && section.given(key))
    section.refuse(key, "is given as well as 'Waveform = " + chosen + "'",
                   "Remove it, or set 'Waveform = formula'");
  for (const auto &kind : entries_of_kinds)
    for (const std::string &entry : kind.second)
    {
      std::string users;
      bool used = false;
      for (const auto &other : entries_of_kinds)
        if (std::find(other.second.begin(), other.second.end(), entry) != other.second.end())
        {
          users += (users.empty() ? "'Waveform = " : " or 'Waveform = ") + other.first + "'";
          used = used || other.first == chosen;
        }
      if (!used && section.given(entry))
        section.refuse(entry, "is of use with " + users + " only", "Set that, or remove the entry");
    }
}

std::string read_kind(ParameterSection &section, const std::string &key)
{
  std::string kind = formula;
  section.add_choice("Waveform", kind, kinds,
                     "How '" + key +
                         "' is given: by an expression, by a table over time, or as a single "
                         "pulse.");
  refuse_other_entries(section, key, kind);
  return kind;
}

double read_ramp(ParameterSection &section)
{
  double ramp = 0.;
  section.add("Ramp", ramp, Dimensions::time,
              "The value is multiplied by sin^2(pi t/(2 Ramp)) until this time, so that it rises "
              "smoothly from zero; 0: it is not.",
              Range::not_negative());
  return ramp;
}
} // namespace

Waveform::Waveform(const double constant) : expression(constant) {}

Waveform::Waveform(const Expression &expression) : expression(expression) {}

std::shared_ptr<const Waveform::TimeFunction> Waveform::read_function(ParameterSection &section,
                                                                      const std::string &key,
                                                                      const Dimension &dimension,
                                                                      const std::string &kind)
{
  TimeFunction function;
  if (kind == sine_squared_pulse)
    function.value = read_sine_squared(section, key, dimension);
  else if (kind == gaussian_pulse)
    function.value = read_gaussian(section, key, dimension);
  else
  {
    std::string file;
    const auto table = read_table(section, key, dimension, file);
    if (!table)
      return nullptr;
    function.value = [table](const double time) { return (*table)(time); };
    if (!section.given("After the table"))
    {
      function.held_file = file;
      function.last_time = table->last_time();
    }
  }
  return std::make_shared<const TimeFunction>(function);
}

Waveform Waveform::read(ParameterSection &section,
                        const std::string &key,
                        const Dimension &dimension,
                        const std::string &text,
                        const bool required)
{
  Waveform waveform;
  const std::string kind = read_kind(section, key);
  if (kind == formula)
  {
    add_expression(section, key, waveform.expression, dimension, text);
    if (required)
      section.require(key);
  }
  else
  {
    if (section.given("Direction"))
      section.refuse("Direction", "'" + key + "' is a number, not a vector", "Remove the entry");
    waveform.of_time = read_function(section, key, dimension, kind);
    waveform.expression = Expression(1.);
  }
  waveform.ramp = read_ramp(section);
  return waveform;
}

std::vector<Waveform> Waveform::read_vector(ParameterSection &section,
                                            const std::string &key,
                                            const unsigned int n_components,
                                            const Dimension &dimension,
                                            const std::string &text)
{
  std::vector<Expression> components(n_components);
  std::shared_ptr<const TimeFunction> of_time;
  const std::string kind = read_kind(section, key);
  if (kind == formula)
  {
    add_expressions(section, key, components, n_components, dimension, text);
    section.require(key);
  }
  else
  {
    of_time = read_function(section, key, dimension, kind);
    add_expressions(section, "Direction", components, n_components, Dimensions::none,
                    "What the value over time is multiplied by in each direction.");
    section.require("Direction");
  }
  const double ramp = read_ramp(section);
  std::vector<Waveform> waveforms;
  waveforms.reserve(n_components);
  for (const Expression &component : components)
  {
    waveforms.emplace_back(component);
    waveforms.back().of_time = of_time;
    waveforms.back().ramp = ramp;
  }
  return waveforms;
}

double Waveform::operator()(const double *point, const double time) const
{
  double value = expression(point, time);
  if (of_time)
    value *= of_time->value(time);
  if (ramp > 0. && time < ramp)
  {
    const double sine = time > 0. ? std::sin(0.5 * PI * time / ramp) : 0.;
    value *= sine * sine;
  }
  return value;
}

bool Waveform::depends_on_time() const
{
  return of_time != nullptr || expression.depends_on_time() || (ramp > 0. && !is_zero());
}

bool Waveform::depends_on_space() const
{
  return expression.depends_on_space();
}

std::string Waveform::table_warning(const double end_time) const
{
  if (!of_time || of_time->held_file.empty() || of_time->last_time >= end_time * (1. - 1e-9))
    return "";
  return "the table '" + std::filesystem::path(of_time->held_file).filename().string() +
         "' ends at t = " + shortest_number(of_time->last_time) + " s, the run at " +
         shortest_number(end_time) +
         " s: its last value holds in between. Set 'After the table' to hold, repeat or zero";
}

bool Waveform::is_zero() const
{
  return expression.is_zero();
}
} // namespace Continua
