#include <continua/studies/sweep_parameters.h>

#include <continua/base/parameter_text.h>
#include <continua/base/quoted_name.h>
#include <continua/studies/planned_run.h>
#include <continua/studies/swept_values.h>

#include <algorithm>
#include <cctype>
#include <stdexcept>

namespace Continua
{
namespace
{
constexpr double most_runs = 10000.;

const std::string example_of_values = "Write for example '1 MPa, 2 MPa', '1 MPa to 3 MPa in 5' or "
                                      "'1 Hz to 100 Hz in 7 logarithmic'";

/// The last `n` names of the path.
std::string tail(const std::string &path, const std::size_t n)
{
  const std::vector<std::string> names = split_unquoted(path, '/');
  std::string result;
  for (std::size_t i = names.size() - std::min(n, names.size()); i < names.size(); ++i)
    result += (result.empty() ? "" : "/") + without_quotes(names[i]);
  return result;
}

/// A colon would end the name of a probe.
std::string without_colons(std::string text)
{
  std::replace(text.begin(), text.end(), ':', ' ');
  return collapse_blanks(text);
}
} // namespace

void SweepParameters::read(ParameterSection root)
{
  ParameterSection section = root.subsection("Sweep");
  section.add(
      "Analysis", analysis,
      "What the runs do: any analysis but a study; automatic: modal, material, spin coating "
      "or amplification if the file has its section, else transient if it has a section "
      "Time, else steady.");
  std::string combine = "grid";
  section.add_choice("Combine", combine, {"grid", "together"},
                     "grid: every value of an entry with every value of the others; together: the "
                     "first values of all entries, then the second ones, and so on.");
  section.add("Quantities", quantities,
              "What the table has, as in Expected (tip: frequency); empty: every quantity but "
              "those that tell errors, counts or theory beside a run, or all if there are no "
              "others.");
  section.add("Parallel runs", asked_parallel,
              "So many runs at a time, each on one rank; 0: as many as there are cores. Fewer "
              "where the memory is not enough by estimate. Under mpirun the runs take all ranks, "
              "one after the other.",
              0, 1000);
  ParameterSection entries = section.subsection("Entries");
  for (const auto &[key, text] : entries.add_free_entries(
           "SECTION/KEY = VALUES: an entry of the file and the values that it takes, separated by "
           "commas, or ranges (1 MPa to 3 MPa in 5, 1 Hz to 100 Hz in 7 logarithmic); a value with "
           "commas stands in parentheses; a number of a list is named with its place (Shear "
           "moduli 2)."))
    try
    {
      axes.push_back({tidy_path(key), swept_values(text), entries.origin(key).file});
    }
    catch (const std::invalid_argument &error)
    {
      entries.refuse(key, error.what(), example_of_values);
    }
  expected = read_expected(section.subsection("Expected"));

  is_grid = combine == "grid";
  for (auto one = axes.begin(); one != axes.end(); ++one)
  {
    const Axis &axis = *one;
    if (std::any_of(axes.begin(), one,
                    [&axis](const Axis &other) { return other.path == axis.path; }))
      entries.refuse(axis.path, "this entry is swept twice", "Give all its values in one line");
    if (!is_grid && axis.values.size() != axes.front().values.size())
      entries.refuse(axis.path,
                     std::to_string(axis.values.size()) + " values go together with " +
                         std::to_string(axes.front().values.size()) + " of '" + axes.front().path +
                         "'",
                     "Give as many of both, or write 'set Combine = grid'");
    const std::string first = tail(axis.path, split_unquoted(axis.path, '/').size());
    for (const char *const own : {"Analysis", "Title", "Sweep"})
      if (first == own ||
          first.compare(0, std::string(own).size() + 1, std::string(own) + "/") == 0)
        entries.refuse(axis.path, "the sweep itself sets this",
                       "Sweep an entry of the case; Sweep/Analysis says what the runs do");
  }
  double n_all = 1.;
  for (const Axis &axis : axes)
    n_all *= static_cast<double>(axis.values.size());
  if (is_grid && n_all > most_runs)
    section.refuse("Combine", "the grid has more than 10000 runs",
                   "Give fewer values, or write 'set Combine = together'");
}

unsigned int SweepParameters::n_runs() const
{
  if (!is_grid)
    return static_cast<unsigned int>(axes.front().values.size());
  unsigned int n = 1;
  for (const Axis &axis : axes)
    n *= static_cast<unsigned int>(axis.values.size());
  return n;
}

std::vector<unsigned int> SweepParameters::places(unsigned int run) const
{
  std::vector<unsigned int> result(axes.size(), run);
  for (std::size_t axis = axes.size(); is_grid && axis-- > 0;)
  {
    const unsigned int n = static_cast<unsigned int>(axes[axis].values.size());
    result[axis] = run % n;
    run /= n;
  }
  return result;
}

std::string SweepParameters::key(const unsigned int axis) const
{
  for (std::size_t n = 1;; ++n)
  {
    std::string text = tail(axes[axis].path, n);
    const bool is_alone =
        std::count_if(axes.begin(), axes.end(),
                      [&](const Axis &other) { return tail(other.path, n) == text; }) == 1;
    if (!is_alone)
      continue; // the whole paths differ
    if (n == 1)
      text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
    return text;
  }
}

std::string SweepParameters::name(const unsigned int run) const
{
  const std::vector<unsigned int> values = places(run);
  std::string text;
  for (unsigned int axis = 0; axis < axes.size(); ++axis)
    text +=
        (axis == 0 ? "" : ", ") + key(axis) + " " + without_quotes(axes[axis].values[values[axis]]);
  return without_colons(text);
}
} // namespace Continua
