#include <continua/base/words.h>
#include <continua/signal/time_table.h>
#include <continua/signal/waveform.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <limits>
#include <utility>

namespace Continua
{
using dealii::numbers::PI;

namespace
{
/// Times at which a mean over time takes a function of time alone, and one of place and time, at
/// each of its many points.
constexpr unsigned int n_times_of_mean = 1 << 14, n_times_of_mean_at_point = 1 << 8;

/// By the midpoint rule: the ends of a period, where a function may jump, are no points of it.
double mean_of(const std::function<double(double)> &function,
               const double begin,
               const double length,
               const unsigned int n_times)
{
  double sum = 0.;
  for (unsigned int i = 0; i < n_times; ++i)
    sum += function(begin + (i + 0.5) * length / n_times);
  return sum / n_times;
}

/// The name of an entry in the section: `prefix` comes before it, where there is one.
std::string named(const std::string &prefix, std::string entry)
{
  if (prefix.empty())
    return entry;
  entry.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(entry.front())));
  return prefix + " " + entry;
}

/// What a table over time is read with, but for its column.
struct TableEntries
{
  std::string path; ///< empty only where the documentation of the entries is made
  TimeTable::Reading reading;
  Waveform::TableNames names;

  /// Null without a path.
  std::shared_ptr<const TimeTable> table(const Dimension &dimension,
                                         const std::string &column) const
  {
    if (path.empty())
      return nullptr;
    return std::make_shared<const TimeTable>(path, dimension, reading, column);
  }
};

TableEntries read_table(ParameterSection &section,
                        const std::string &prefix,
                        const std::string &key,
                        const Dimension &dimension)
{
  using Outside = TimeTable::Outside;
  const Words<Outside> outside = {
      {"hold", Outside::hold}, {"repeat", Outside::repeat}, {"zero", Outside::zero}};
  TableEntries table;
  TimeTable::Reading &reading = table.reading;
  section.add_input_file(named(prefix, "Table"), table.path,
                         "A csv file of " + key +
                             " over time, with a header such as 'time [ms], value [" +
                             dimension.unit() + "]'.");
  add_choice(
      section, named(prefix, "Interpolation"), reading.interpolation,
      {{"linear", TimeTable::Interpolation::linear}, {"cubic", TimeTable::Interpolation::cubic}},
      "Between the rows; cubic is smooth and does not overshoot.");
  section.add(named(prefix, "Table factor"), reading.factor, Dimensions::none,
              "What the values of the table are multiplied by, such as -1 where the table counts a "
              "flow out of the body as positive.");
  section.add(named(prefix, "Offset"), reading.offset, dimension,
              "Added to the values of the table, after their factor.");
  section.add(named(prefix, "Table shift"), reading.shift, Dimensions::time,
              "Added to the times of the table: by how much later its values act.");
  add_choice(section, named(prefix, "Before the table"), reading.before, outside,
             "Before the first row: its value, the table repeated backwards, or zero without the "
             "offset.");
  add_choice(section, named(prefix, "After the table"), reading.after, outside,
             "After the last row: its value, the table again and again with the period, or zero "
             "without the offset.");
  const std::string period_key = named(prefix, "Table period");
  section.add(period_key, reading.period, Dimensions::time,
              "The period of a table that is repeated. Between the last row and the first one of "
              "the next period the values are interpolated. 0: from the first to the last row, "
              "which is then the first one of the next period.",
              Range::not_negative());
  section.require(named(prefix, "Table"));
  if (reading.period > 0. && reading.before != Outside::repeat && reading.after != Outside::repeat)
    section.refuse(period_key, "the table is not repeated",
                   "Set '" + named(prefix, "After the table") + " = repeat', or remove the entry");
  reading.period_key = period_key;
  reading.factor_key = named(prefix, "Table factor");
  table.names.file = std::filesystem::path(table.path).filename().string();
  const std::pair<const char *, std::string *> silent_keys[] = {
      {"Before the table", &table.names.before_key},
      {"After the table", &table.names.after_key},
      {"Table period", &table.names.period_key}};
  for (const auto &[entry, silent_key] : silent_keys)
    if (!section.given(named(prefix, entry)))
      *silent_key = named(prefix, entry);
  return table;
}

std::string read_column(ParameterSection &section, const std::string &prefix)
{
  std::string column;
  section.add(named(prefix, "Column"), column,
              "The column to use; may be left out if there is but one.");
  return column;
}

std::function<double(double)> read_sine_squared(ParameterSection &section,
                                                const std::string &prefix,
                                                const std::string &key,
                                                const Dimension &dimension)
{
  const std::string amplitude_key = named(prefix, "Amplitude"),
                    duration_key = named(prefix, "Duration");
  double amplitude = 0., start = 0.;
  double duration = std::numeric_limits<double>::infinity();
  section.add(amplitude_key, amplitude, dimension, "Largest value of the pulse of " + key + ".");
  section.add(duration_key, duration, Dimensions::time,
              "T: the pulse is A sin^2(pi (t - t0)/T) from its start t0 to t0 + T.",
              Range::positive());
  section.add(named(prefix, "Start"), start, Dimensions::time, "t0: when the pulse begins.");
  section.require(amplitude_key);
  section.require(duration_key);
  return [=](const double time)
  {
    const double phase = (time - start) / duration;
    if (phase <= 0. || phase >= 1.)
      return 0.;
    const double sine = std::sin(PI * phase);
    return amplitude * sine * sine;
  };
}

std::function<double(double)> read_gaussian(ParameterSection &section,
                                            const std::string &prefix,
                                            const std::string &key,
                                            const Dimension &dimension)
{
  const std::string amplitude_key = named(prefix, "Amplitude"),
                    peak_key = named(prefix, "Time of the peak"),
                    width_key = named(prefix, "Width");
  double amplitude = 0., peak = 0.;
  double width = std::numeric_limits<double>::infinity();
  section.add(amplitude_key, amplitude, dimension, "Largest value of the pulse of " + key + ".");
  section.add(peak_key, peak, Dimensions::time,
              "t0: the pulse is A exp(-((t - t0)/s)^2), for all times.");
  section.add(width_key, width, Dimensions::time,
              "s: from its peak to where the pulse has fallen to A/e.", Range::positive());
  section.require(amplitude_key);
  section.require(peak_key);
  section.require(width_key);
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
    {"table",
     {"Table", "Column", "Columns", "Interpolation", "Table factor", "Offset", "Table shift",
      "Before the table", "After the table", "Table period", "Direction"}},
    {sine_squared_pulse, {"Amplitude", "Duration", "Start", "Offset", "Direction"}},
    {gaussian_pulse, {"Amplitude", "Time of the peak", "Width", "Offset", "Direction"}}};

/// Refuses what belongs to another kind of waveform than the one chosen.
void refuse_other_entries(const ParameterSection &section,
                          const std::string &prefix,
                          const std::string &key,
                          const std::string &chosen)
{
  const std::string waveform = named(prefix, "Waveform");
  if (chosen != formula && section.given(key))
    section.refuse(key, "is given as well as '" + waveform + " = " + chosen + "'",
                   "Remove it, or set '" + waveform + " = formula'");
  for (const auto &kind : entries_of_kinds)
    for (const std::string &entry : kind.second)
    {
      std::string users;
      bool used = false;
      for (const auto &other : entries_of_kinds)
        if (std::find(other.second.begin(), other.second.end(), entry) != other.second.end())
        {
          users += (users.empty() ? "'" : " or '") + waveform + " = " + other.first + "'";
          used = used || other.first == chosen;
        }
      if (!used && section.given(named(prefix, entry)))
        section.refuse(named(prefix, entry), "is of use with " + users + " only",
                       "Set that, or remove the entry");
    }
}

std::string read_kind(ParameterSection &section, const std::string &prefix, const std::string &key)
{
  std::string kind = formula;
  section.add_choice(named(prefix, "Waveform"), kind, kinds,
                     "How '" + key +
                         "' is given: by an expression, by a table over time, or as a single "
                         "pulse.");
  refuse_other_entries(section, prefix, key, kind);
  return kind;
}

double read_ramp(ParameterSection &section, const std::string &prefix)
{
  double ramp = 0.;
  section.add(named(prefix, "Ramp"), ramp, Dimensions::time,
              "The value is multiplied by sin^2(pi t/(2 Ramp)) until this time, so that it rises "
              "smoothly from zero; 0: it is not.",
              Range::not_negative());
  return ramp;
}
} // namespace

Waveform::Waveform(const double constant) : expression(constant) {}

Waveform::Waveform(const Expression &expression) : expression(expression) {}

std::shared_ptr<const Waveform::TimeFunction> Waveform::read_pulse(ParameterSection &section,
                                                                   const std::string &prefix,
                                                                   const std::string &key,
                                                                   const Dimension &dimension,
                                                                   const std::string &kind)
{
  const std::function<double(double)> pulse =
      kind == sine_squared_pulse ? read_sine_squared(section, prefix, key, dimension)
                                 : read_gaussian(section, prefix, key, dimension);
  double offset = 0.;
  section.add(named(prefix, "Offset"), offset, dimension,
              "Added to the pulse: the mean value that it stands on.");
  TimeFunction function;
  function.value = [pulse, offset](const double time) { return offset + pulse(time); };
  return std::make_shared<const TimeFunction>(function);
}

std::shared_ptr<const Waveform::TimeFunction>
Waveform::function_of_table(const std::shared_ptr<const TimeTable> &table, const TableNames &names)
{
  if (!table)
    return nullptr;
  TimeFunction function;
  function.value = [table](const double time) { return (*table)(time); };
  function.table = table;
  function.names = names;
  return std::make_shared<const TimeFunction>(function);
}

Waveform Waveform::read(ParameterSection &section,
                        const std::string &key,
                        const Dimension &dimension,
                        const std::string &text,
                        const bool required)
{
  Waveform waveform;
  const std::string kind = read_kind(section, "", key);
  if (kind == formula)
  {
    add_expression(section, key, waveform.expression, dimension, text);
    if (required)
      section.require(key);
  }
  else
  {
    for (const std::string entry : {"Direction", "Columns"})
      if (section.given(entry))
        section.refuse(entry, "'" + key + "' is a number, not a vector", "Remove the entry");
    if (kind == "table")
    {
      const TableEntries table = read_table(section, "", key, dimension);
      waveform.of_time =
          function_of_table(table.table(dimension, read_column(section, "")), table.names);
    }
    else
      waveform.of_time = read_pulse(section, "", key, dimension, kind);
    waveform.expression = Expression(1.);
  }
  waveform.ramp = read_ramp(section, "");
  return waveform;
}

std::vector<Waveform> Waveform::read_vector(ParameterSection &section,
                                            const std::string &key,
                                            const unsigned int n_components,
                                            const Dimension &dimension,
                                            const std::string &text,
                                            const bool required,
                                            const std::string &prefix)
{
  const std::string kind = read_kind(section, prefix, key);
  std::vector<Expression> components(n_components);
  std::vector<std::shared_ptr<const TimeFunction>> of_time(n_components);
  if (kind == formula)
  {
    add_expressions(section, key, components, n_components, dimension, text);
    if (required)
      section.require(key);
  }
  else
  {
    const std::string columns_key = named(prefix, "Columns"),
                      direction_key = named(prefix, "Direction");
    std::vector<std::string> columns;
    if (kind == "table")
    {
      const TableEntries table = read_table(section, prefix, key, dimension);
      section.add(columns_key, columns,
                  "The columns of the components, one for each direction, in place of 'Column' and "
                  "'Direction'.");
      if (columns.empty())
        of_time.assign(
            n_components,
            function_of_table(table.table(dimension, read_column(section, prefix)), table.names));
      else
      {
        for (const std::string &entry : {named(prefix, "Column"), direction_key})
          if (section.given(entry))
            section.refuse(entry, "is given as well as '" + columns_key + "'",
                           "Remove one of the two");
        if (columns.size() != n_components)
          section.refuse(columns_key,
                         "there are " + std::to_string(columns.size()) + " columns for " +
                             std::to_string(n_components) + " components",
                         "Name one column for each direction");
        for (unsigned int c = 0; c < n_components; ++c)
          of_time[c] = function_of_table(table.table(dimension, columns[c]), table.names);
      }
    }
    else
      of_time.assign(n_components, read_pulse(section, prefix, key, dimension, kind));
    if (columns.empty())
    {
      add_expressions(section, direction_key, components, n_components, Dimensions::none,
                      "What the value over time is multiplied by in each direction.");
      section.require(direction_key);
    }
    else
      components.assign(n_components, Expression(1.));
  }
  const double ramp = read_ramp(section, prefix);
  std::vector<Waveform> waveforms;
  waveforms.reserve(n_components);
  for (unsigned int c = 0; c < n_components; ++c)
  {
    waveforms.emplace_back(components[c]);
    waveforms.back().of_time = of_time[c];
    waveforms.back().ramp = ramp;
  }
  return waveforms;
}

double Waveform::value(const double *point, const double time) const
{
  const double value = expression(point, time);
  return of_time ? value * of_time->value(time) : value;
}

double Waveform::operator()(const double *point, const double time) const
{
  if (time == mean_over_period)
    return mean(point);
  if (ramp > 0. && time < ramp)
  {
    const double sine = time > 0. ? std::sin(0.5 * PI * time / ramp) : 0.;
    return value(point, time) * (sine * sine);
  }
  return value(point, time);
}

void Waveform::set_period(const double length, const double end)
{
  period = length;
  period_begin = end - length;
  if (of_time && !expression.depends_on_time())
    mean_of_time = mean_of(of_time->value, period_begin, period, n_times_of_mean);
  else if (expression.depends_on_time() && !depends_on_space())
  {
    const double origin[3] = {0., 0., 0.};
    mean_of_time = mean_of([&](const double time) { return value(origin, time); }, period_begin,
                           period, n_times_of_mean);
  }
}

double Waveform::mean(const double *point) const
{
  Assert(period > 0. || !depends_on_time(),
         dealii::ExcMessage("A waveform has a mean over time once it has a period."));
  if (!expression.depends_on_time())
    return expression(point, 0.) * mean_of_time;
  if (!depends_on_space())
    return mean_of_time;
  return mean_of([&](const double time) { return value(point, time); }, period_begin, period,
                 n_times_of_mean_at_point);
}

double Waveform::table_period() const
{
  return of_time && of_time->table && of_time->table->is_repeated() ? of_time->table->period() : 0.;
}

bool Waveform::depends_on_time() const
{
  return of_time != nullptr || expression.depends_on_time() || (ramp > 0. && !is_zero());
}

bool Waveform::depends_on_space() const
{
  return expression.depends_on_space();
}

std::vector<Waveform::Remark> Waveform::table_remarks(const double end_time) const
{
  if (!of_time || !of_time->table)
    return {};
  constexpr double time_slack = 1e-9;   // of the end time
  constexpr double largest_jump = 1e-2; // of the range of the values
  const TimeTable &table = *of_time->table;
  const TableNames &names = of_time->names;
  const std::string name = "the table '" + names.file + "'";
  std::vector<Remark> remarks;
  if (table.is_repeated())
    remarks.push_back({name + " repeats itself after " + table.period_text() +
                           (names.period_key.empty() ? "" : ", from its first to its last row"),
                       false});
  if (!names.before_key.empty() && table.first_time() > end_time * time_slack)
    remarks.push_back({name + " begins at t = " + shortest_number(table.first_time()) +
                           " s: its first value holds from the start on. Set '" + names.before_key +
                           "' to hold, repeat or zero",
                       true});
  if (!names.after_key.empty() && table.last_time() < end_time * (1. - time_slack))
    remarks.push_back({name + " ends at t = " + shortest_number(table.last_time()) +
                           " s, the run at " + shortest_number(end_time) +
                           " s: its last value holds in between. Set '" + names.after_key +
                           "' to hold, repeat or zero",
                       true});
  if (!names.period_key.empty() && table.is_repeated() && table.jump() > largest_jump)
    remarks.push_back({name +
                           " does not end with its first value, which follows its last row at "
                           "once. Set '" +
                           names.period_key + "': " + table.period_text() +
                           " if the value is to jump, the period if the row that closes it is "
                           "missing",
                       true});
  return remarks;
}

std::vector<Waveform::Remark> Waveform::table_remarks(
    const std::vector<const Waveform *> &waveforms, const std::string &owner, const double end_time)
{
  std::vector<Remark> remarks;
  for (const Waveform *const waveform : waveforms)
    for (Remark &remark : waveform->table_remarks(end_time))
    {
      remark.text.insert(0, owner);
      if (std::none_of(remarks.begin(), remarks.end(),
                       [&remark](const Remark &other) { return other.text == remark.text; }))
        remarks.push_back(remark);
    }
  return remarks;
}

bool Waveform::table_begins_with_jump() const
{
  constexpr double least_jump = 0.05; // of the range of the rows
  return of_time && of_time->table && ramp == 0. &&
         std::abs(of_time->value(0.)) > least_jump * of_time->table->range();
}

bool Waveform::is_zero() const
{
  return expression.is_zero();
}
} // namespace Continua
