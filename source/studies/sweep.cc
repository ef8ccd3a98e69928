#include <continua/studies/sweep.h>

#include <continua/base/checksum.h>
#include <continua/base/input_error.h>
#include <continua/base/nearest_name.h>
#include <continua/base/quoted_name.h>
#include <continua/studies/run_pool.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace Continua
{
namespace
{
/// The input of all runs is read before the first if there are at most so many.
constexpr unsigned int most_runs_to_read = 64;
/// 2^5 corners of a larger grid.
constexpr std::size_t most_axes_with_corners = 5;

/// The lines of the text that tell what input files contain.
std::string lines_of_files(const std::string &identity_text)
{
  std::istringstream lines(identity_text);
  std::string result;
  for (std::string line; std::getline(lines, line);)
    if (line.compare(0, 11, "content of ") == 0)
      result += line + "; ";
  return result;
}

/// "young-s-modulus-2-mpa-6fb3c6a98f0d2c11": with a checksum of the values.
std::string with_checksum(const std::string &name, const std::string &values)
{
  Checksum sum;
  sum.add(values);
  std::ostringstream text;
  text << name << "-" << std::hex << std::setw(16) << std::setfill('0') << sum.value();
  return text.str();
}
} // namespace

Sweep::Sweep(const AnalysisInput &input) : Study(input, "Sweep")
{
  parameters.read(file.root());
  if (parameters.axes.empty())
    section().refuse_missing(
        "no entry is swept",
        "Write in its subsection Entries for example 'set "
        "Materials/wall/Young's modulus = 1 MPa, 2 MPa', or give --sweep on the "
        "command line");
  choose_analysis();
  choose_parallel();
  set_parameters(parameters);
  read_input();
  find_entries();
  for (const unsigned int run : runs_to_read())
    read_run(run);
  name_quantities();
  quantities.refuse_unknown(file, section().subsection("Expected"), parameters.expected);
  set_parameters(parameters);
}

void Sweep::choose_analysis()
{
  ParameterSection root = file.root();
  std::string &analysis = parameters.analysis;
  if (analysis == "automatic")
  {
    analysis = root.has_subsection("Time") ? "transient" : "steady";
    for (const auto &[own, section_name] : {std::pair<const char *, const char *>{"modal", "Modal"},
                                            {"material", "Laboratory"},
                                            {"spin coating", "Spin coating"},
                                            {"amplification", "Amplification"}})
      if (root.sets_in_subsection(section_name))
        analysis = own;
    return;
  }
  std::vector<std::string> names;
  for (const AnalysisRow &row : analyses.rows())
    if (!row.is_study())
      names.push_back(row.name);
    else if (row.name == analysis)
      section().refuse("Analysis", "'" + analysis + "' is a study, of several runs itself",
                       "Sweep one of its runs: transient, steady, modal, linear wave theory or an "
                       "analysis of the laboratory");
  if (std::find(names.begin(), names.end(), analysis) != names.end())
    return;
  const std::string nearest = nearest_name(analysis, names);
  std::string all;
  for (const std::string &name : names)
    all += (all.empty() ? "" : ", ") + name;
  section().refuse("Analysis", "there is no analysis '" + analysis + "'",
                   (nearest.empty() ? "" : "Did you mean '" + nearest + "'? ") +
                       std::string("Give automatic or one of: ") + all);
}

void Sweep::choose_parallel()
{
  const bool has_ranks = dealii::Utilities::MPI::n_mpi_processes(communicator) > 1;
  if (has_ranks && parameters.asked_parallel > 1)
    section().refuse("Parallel runs", "under mpirun the runs take all ranks, one after the other",
                     "Call the program without mpirun for runs side by side, or remove the entry");
  parameters.n_parallel = has_ranks                        ? 1
                          : parameters.asked_parallel == 0 ? RunPool::n_cores()
                                                           : parameters.asked_parallel;
}

void Sweep::read_input()
{
  const AnalysisRow &row = analyses.row(parameters.analysis);
  if (!row.has_case())
  {
    CommandLine checking = command_line;
    checking.validate = true;
    checking.restart = false;
    GeneralParameters of_runs = general;
    of_runs.analysis = parameters.analysis;
    row.make({file, of_runs, checking, communicator, analyses});
  }
  else if (n_dimensions() == 2)
    analyses.read_case<2>(file, communicator, CaseUse::check, parameters.analysis);
  else
    analyses.read_case<3>(file, communicator, CaseUse::check, parameters.analysis);
}

void Sweep::find_entries()
{
  for (const SweepParameters::Axis &axis : parameters.axes)
    axes.emplace_back(file, entries(), axis);
  for (auto one = axes.begin(); one != axes.end(); ++one)
    for (auto other = axes.begin(); other != one; ++other)
    {
      if (one->path_of_entry() != other->path_of_entry())
        continue;
      if (!one->entry || !other->entry)
        entries().refuse(one->path, "this is of the same list as '" + other->path + "'",
                         "Sweep the list as a whole, or some of its numbers by their places");
      if (one->entry->path() == other->entry->path())
        entries().refuse(one->path, "this is the number of '" + other->path + "'",
                         "Give all its values in one line");
    }
}

bool Sweep::is_read(const SweptAxis &axis, const std::size_t place)
{
  const std::size_t n = axis.values.size(),
                    stride = (n + most_runs_to_read - 1) / most_runs_to_read;
  // What an entry does not accept is refused with its range.
  return !axis.entry || !axis.entry->accepts(axis.numbers[place]) || place % stride == 0 ||
         place + 1 == n;
}

std::vector<unsigned int> Sweep::runs_to_read() const
{
  const unsigned int n_runs = parameters.n_runs();
  std::vector<unsigned int> result;
  for (unsigned int run = 0; run < n_runs; ++run)
  {
    const std::vector<unsigned int> places = parameters.places(run);
    std::size_t n_first = 0, n_ends = 0, n_read = 0;
    for (std::size_t axis = 0; axis < axes.size(); ++axis)
    {
      n_read += is_read(axes[axis], places[axis]) ? 1 : 0;
      n_first += places[axis] == 0 ? 1 : 0;
      n_ends += places[axis] == 0 || places[axis] + 1 == axes[axis].values.size() ? 1 : 0;
    }
    const bool is_corner = n_ends == axes.size() && axes.size() <= most_axes_with_corners;
    // The other values of a grid are the first ones, which are read; together all have one place.
    const bool is_value =
        parameters.is_grid ? n_first + 1 >= axes.size() && n_read == axes.size() : n_read > 0;
    if (n_runs <= most_runs_to_read || is_value || is_corner)
      result.push_back(run);
  }
  return result;
}

Sweep::Settings Sweep::settings(const unsigned int run) const
{
  const std::vector<unsigned int> places = parameters.places(run);
  Settings result;
  std::vector<NumericEntry> in_lists;
  std::vector<double> numbers;
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (axes[i].entry && axes[i].entry->is_in_list())
    {
      in_lists.push_back(*axes[i].entry);
      numbers.push_back(axes[i].numbers[places[i]]);
    }
    else
      result.emplace_back(axes[i].path, axes[i].texts[places[i]]);
  for (const auto &setting : NumericEntry::settings(in_lists, numbers))
    result.push_back(setting);
  return result;
}

CommandLine Sweep::command_line_of(const unsigned int run) const
{
  CommandLine result = command_line;
  result.restart = false;
  result.sweeps.clear();
  remove_entries_of(result, "Sweep");
  set_entry(result, "Analysis", parameters.analysis);
  // A value may be the name of a file with this letter.
  set_entry(result, "Title", quoted_name(title_of_run(parameters.name(run)), "#"));
  for (const auto &[path, value] : settings(run))
    set_entry(result, path, value);
  return result;
}

void Sweep::read_run(const unsigned int run)
{
  CommandLine checking = command_line_of(run);
  checking.validate = true;
  ReadRun &result = read_runs[run];
  try
  {
    ParameterFile of_run(checking.parameter_file, checking.overrides);
    const std::unique_ptr<Analysis> analysis = analyses.make(of_run, checking, communicator);
    result.quantities = analysis->quantity_names();
    result.memory = analysis->estimated_memory();
    result.content_of_files = lines_of_files(of_run.identity_text());
  }
  catch (const InputError &error)
  {
    entries().refuse(axes.size() == 1 ? axes.front().path : "",
                     "with " + parameters.name(run) + " the input is refused: " + error.what(), "");
  }
}

void Sweep::name_quantities()
{
  QuantityNames of_any;
  for (const auto &[run, read] : read_runs)
    of_any.add(read.quantities);
  of_any.refuse_unknown(section(), "Quantities", parameters.quantities);
  for (unsigned int run = 0; run < parameters.n_runs(); ++run)
  {
    const auto read = read_runs.find(run);
    SweepReport::name_quantities(parameters.quantities, parameters.name(run),
                                 read == read_runs.end() ? of_any : read->second.quantities,
                                 quantities);
  }
}

std::string Sweep::identity(const std::string &of_file, const unsigned int run) const
{
  std::string text = of_file + " " + parameters.analysis;
  for (const auto &[path, value] : settings(run))
    text.append(", ").append(path).append("=").append(value);
  // A word may name a file; each value of a grid was read with the first values of the others.
  const std::vector<unsigned int> places = parameters.places(run);
  for (std::size_t axis = 0; axis < axes.size(); ++axis)
    for (const auto &[number, read] : read_runs)
      if (!axes[axis].entry && parameters.places(number)[axis] == places[axis])
      {
        text += ", " + read.content_of_files;
        break;
      }
  return text;
}

std::vector<std::string> Sweep::names_of_folders() const
{
  constexpr std::size_t longest = 150;
  std::vector<std::string> names;
  std::map<std::string, unsigned int> numbers;
  for (unsigned int run = 0; run < parameters.n_runs(); ++run)
  {
    names.push_back(folder_name(parameters.name(run)));
    ++numbers[names.back()];
  }
  for (unsigned int run = 0; run < names.size(); ++run)
  {
    if (names[run].size() <= longest && numbers[names[run]] == 1)
      continue;
    std::string values;
    const std::vector<unsigned int> places = parameters.places(run);
    for (std::size_t i = 0; i < axes.size(); ++i)
      values += axes[i].path + "=" + axes[i].values[places[i]] + "\n";
    names[run] = with_checksum(names[run].substr(0, longest), values);
  }
  return names;
}

std::vector<PlannedRun> Sweep::plan_runs(const std::string &output) const
{
  std::vector<std::string> left_out = {"Sweep", "Analysis", "Title"};
  for (const SweptAxis &axis : axes)
    left_out.push_back(axis.path_of_entry());
  const std::string of_file = file.identity(left_out);
  double most_memory = 0.;
  for (const auto &[run, read] : read_runs)
    most_memory = std::max(most_memory, read.memory);
  const std::vector<std::string> names = names_of_folders();
  std::vector<PlannedRun> plans;
  for (unsigned int run = 0; run < parameters.n_runs(); ++run)
  {
    PlannedRun plan;
    plan.name = names[run];
    plan.command_line = command_line_of(run);
    plan.command_line.output_directory = output + "/" + plan.name;
    plan.identity = identity(of_file, run);
    const auto read = read_runs.find(run);
    plan.memory = read == read_runs.end() ? most_memory : read->second.memory;
    plans.push_back(plan);
  }
  return plans;
}

std::vector<SweptEntry> Sweep::swept_entries() const
{
  std::vector<SweptEntry> result;
  for (std::size_t i = 0; i < axes.size(); ++i)
  {
    SweptEntry entry;
    entry.path = axes[i].path;
    entry.unit = axes[i].entry ? axes[i].entry->unit() : "";
    for (unsigned int run = 0; run < parameters.n_runs(); ++run)
      entry.values.push_back(axes[i].in_table(parameters.places(run)[i]));
    result.push_back(entry);
  }
  return result;
}

std::unique_ptr<StudyReport> Sweep::make_report(const std::vector<RunResult> &runs) const
{
  std::vector<SweptRun> swept;
  swept.reserve(runs.size());
  for (unsigned int run = 0; run < runs.size(); ++run)
    swept.push_back({runs[run], parameters.name(run)});
  return std::make_unique<SweepReport>(parameters.quantities, swept_entries(), swept);
}

void Sweep::describe_runs(Summary &summary) const
{
  summary.set("swept", SweepReport::columns(swept_entries()));
  summary.set("combined", parameters.is_grid ? "grid" : "together");
}

std::vector<std::string> Sweep::outline() const
{
  std::vector<std::string> lines = {"analysis: sweep of " + parameters.analysis};
  for (const SweptAxis &axis : axes)
  {
    std::string line = axis.path + ":";
    for (const std::string &value : axis.values)
      line += (value == axis.values.front() ? " " : ", ") + value;
    lines.push_back(line);
  }
  lines.push_back("runs: " + std::to_string(parameters.n_runs()));
  return lines;
}
} // namespace Continua
