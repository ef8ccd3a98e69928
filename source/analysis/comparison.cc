#include <continua/analysis/comparison.h>

#include <continua/analysis/case_run.h>
#include <continua/base/atomic_file.h>
#include <continua/base/citations.h>
#include <continua/base/input_error.h>
#include <continua/base/parameter_text.h>
#include <continua/base/units.h>
#include <continua/base/version.h>
#include <continua/postprocess/writing_rank.h>

#include <deal.II/base/mpi.h>
#include <deal.II/grid/grid_tools.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <thread>

namespace Continua
{
using namespace dealii;

namespace
{
/// The largest Mesh/Refinements.
constexpr unsigned int most_refinements = 12;

/// "taylor-hood".
std::string folder_name(const std::string &text)
{
  std::string name;
  for (const unsigned char letter : text)
    if (std::isalnum(letter) != 0)
      name += static_cast<char>(std::tolower(letter));
    else if (!name.empty() && name.back() != '-')
      name += '-';
  return name;
}

/// The path of an override "Section/Key=value", without blanks that do not count.
std::string path_of(const std::string &override_text)
{
  std::istringstream parts(override_text.substr(0, override_text.find('=')) + "/");
  std::vector<std::string> names;
  for (std::string part; std::getline(parts, part, '/');)
    names.push_back(collapse_blanks(part));
  return join_path(names);
}

/// Sets an entry over the file and over what the command line says of it.
void set(CommandLine &command_line, const std::string &path, const std::string &value)
{
  std::vector<std::string> &all = command_line.overrides;
  const std::string text = path + "=" + value;
  all.erase(std::remove_if(all.begin(), all.end(),
                           [&text](const std::string &other)
                           { return path_of(other) == path_of(text); }),
            all.end());
  all.push_back(text);
}

/// As a shell reads it back.
std::string quoted(const std::string &text)
{
  std::string result = "'";
  for (const char letter : text)
    result += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  return result + "'";
}

std::string text_of(const CommandLine &command_line)
{
  std::string text = "continua " + quoted(command_line.parameter_file);
  for (const std::string &entry : command_line.overrides)
    text += " --set " + quoted(entry);
  return text + " --output " + quoted(command_line.output_directory);
}

/// What tells this program from others: of one revision there may be several, changed and not
/// committed.
std::string program_identity()
{
  const std::filesystem::path file = std::filesystem::canonical("/proc/self/exe");
  std::ostringstream text;
  text << version() << " " << revision() << " of "
       << std::filesystem::last_write_time(file).time_since_epoch().count() << ", "
       << std::filesystem::file_size(file) << " bytes";
  return text.str();
}

/// Whether every rank comes here within a minute: an exception that all threw, not one alone while
/// the others wait for it elsewhere. `communicator`: used for nothing else.
bool all_ranks_arrive(const MPI_Comm communicator)
{
  using Clock = std::chrono::steady_clock;
  MPI_Request request;
  MPI_Ibarrier(communicator, &request);
  const Clock::time_point start = Clock::now();
  for (int done = 0; Clock::now() - start < std::chrono::minutes(1);)
  {
    MPI_Test(&request, &done, MPI_STATUS_IGNORE);
    if (done != 0)
      return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return false;
}

/// The file as rank 0 sees it, on all ranks; empty if it cannot be read.
std::string content_of(const std::string &file, const MPI_Comm communicator)
{
  std::string content;
  if (Utilities::MPI::this_mpi_process(communicator) == 0)
  {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    content = text.str();
  }
  return Utilities::MPI::broadcast(communicator, content);
}
} // namespace

Comparison::Comparison(ParameterFile &file,
                       const CommandLine &command_line,
                       const MPI_Comm communicator)
    : command_line(command_line), communicator(communicator)
{
  general.read(file.root());
  parameters.read(file.root());
  dimension = n_dimensions(model_of(general.model));
  if (dimension == 2)
    read_ways<2>(file);
  else
    read_ways<3>(file);
  input_files = file.input_files();
}

template <int dim>
void Comparison::read_ways(ParameterFile &file)
{
  // The file alone first: what is wrong with it is not said of one of the ways.
  const Case<dim> input(file, communicator, false);
  volume = GridTools::volume(*input.triangulation);
  const ParameterSection section = file.root().subsection("Comparison");
  for (unsigned int way = 0; way < 2; ++way)
  {
    try
    {
      ways.push_back(read_way<dim>(way));
    }
    catch (const InputError &error)
    {
      section.refuse("Values",
                     "with " + parameters.entry + " = " + parameters.values[way] +
                         " the case is refused: " + error.what(),
                     "");
    }
    if (ways[way].refinements + parameters.meshes_of(way).back() > most_refinements)
      section.refuse(way == 0 ? "Meshes" : "Meshes of the second",
                     "with Mesh/Refinements the cells would be divided more than " +
                         std::to_string(most_refinements) + " times",
                     "Give fewer divisions");
  }
  if (folder_name(parameters.name(0)) == folder_name(parameters.name(1)))
    section.refuse("Values", "the folders of the two would have the same name",
                   "Write the values otherwise");
}

template <int dim>
Comparison::Way Comparison::read_way(const unsigned int way) const
{
  Way result;
  result.command_line = command_line;
  result.command_line.restart = false;
  set(result.command_line, "Analysis", parameters.analysis);
  set(result.command_line, parameters.entry, parameters.values[way]);
  ParameterFile file(command_line.parameter_file, result.command_line.overrides);
  const Case<dim> input(file, communicator, false);
  result.identity = file.identity({"Comparison"});
  result.refinements = input.mesh.refinements;
  if (parameters.analysis == "transient")
    result.time = input.time;
  // At best, as displacements at vertices by elements of degree k: 2 k.
  result.orders.highest = 2. * input.discretisation.velocities_per_cell();
  if (parameters.refine_time_step && result.time.scheme_type() == Scheme::euler_implicit)
    result.orders.assumed = 1.;
  return result;
}

Comparison::Plan
Comparison::plan(const unsigned int way, const unsigned int mesh, const std::string &output) const
{
  const Way &of_way = ways[way];
  Plan result;
  result.name = folder_name(parameters.name(way)) + "-" + std::to_string(mesh);
  result.way = way;
  result.mesh = mesh;
  result.command_line = of_way.command_line;
  set(result.command_line, "Title",
      (general.title.empty() ? "" : general.title + ": ") + parameters.name(way) + ", mesh " +
          std::to_string(mesh));
  set(result.command_line, "Mesh/Refinements", std::to_string(of_way.refinements + mesh));
  const double share = parameters.refine_time_step ? std::ldexp(1., -static_cast<int>(mesh)) : 1.;
  result.time_step = share * of_way.time.time_step;
  if (parameters.refine_time_step)
  {
    set(result.command_line, "Time/Time step", shortest_number(result.time_step) + " s");
    std::string changes;
    for (const auto &[time, step] : of_way.time.changes)
      changes += (changes.empty() ? "" : ", ") + shortest_number(time) +
                 " s : " + shortest_number(share * step) + " s";
    if (!changes.empty())
      set(result.command_line, "Time/Time step changes", changes);
  }
  result.command_line.output_directory = output + "/" + result.name;
  result.command_line.text = text_of(result.command_line);
  return result;
}

std::vector<Comparison::Plan> Comparison::plans(const std::string &output) const
{
  std::vector<Plan> result;
  for (unsigned int way = 0; way < 2; ++way)
    for (const unsigned int mesh : parameters.meshes_of(way))
      result.push_back(plan(way, mesh, output));
  std::stable_sort(result.begin(), result.end(),
                   [](const Plan &a, const Plan &b) { return a.mesh < b.mesh; });
  return result;
}

std::string Comparison::identity(const Plan &plan) const
{
  std::ostringstream text;
  text << plan.name << " case " << ways[plan.way].identity << " time step "
       << shortest_number(plan.time_step) << " ranks "
       << Utilities::MPI::n_mpi_processes(communicator) << " program " << program_identity();
  return text.str();
}

void Comparison::perform(const OutputDirectory &directory, Log &log) const
{
  const std::vector<Plan> all = plans(directory.path());
  // The checkpoint of a comparison: a line for each run that is finished.
  const std::string checkpoint = directory.file("checkpoint/finished runs");
  std::string finished =
      command_line.restart ? content_of(checkpoint, communicator) : std::string();
  const auto is_finished = [&](const Plan &plan)
  {
    return ("\n" + finished).find("\n" + identity(plan) + "\n") != std::string::npos &&
           !content_of(plan.command_line.output_directory + "/summary.json", communicator).empty();
  };

  // Before the first run, since a folder may be refused.
  std::vector<std::unique_ptr<OutputDirectory>> folders;
  for (const Plan &plan : all)
    folders.push_back(is_finished(plan) ? nullptr
                                        : std::make_unique<OutputDirectory>(
                                              plan.command_line.output_directory,
                                              command_line.overwrite || command_line.restart
                                                  ? OutputDirectory::Mode::overwrite
                                                  : OutputDirectory::Mode::fresh,
                                              communicator, input_files));
  MPI_Comm watch;
  MPI_Comm_dup(communicator, &watch);
  std::vector<ComparedRun> runs;
  bool asked_known[2] = {false, false};
  for (unsigned int i = 0; i < all.size(); ++i)
  {
    const std::string failure =
        folders[i] == nullptr ? std::string() : perform(all[i], *folders[i], watch);
    runs.push_back(result(all[i]));
    ComparedRun &run = runs.back();
    run.failure = failure;
    log.line(run.name + (!failure.empty()        ? ": failed"
                         : folders[i] == nullptr ? ": was finished before"
                                                 : ": finished"));
    if (!failure.empty())
      continue;
    std::ostringstream detail;
    detail << run.name << " took " << run.wall_time << " s";
    log.detail(detail.str());
    if (!asked_known[run.way])
      ComparisonReport::check_asked(parameters, run);
    asked_known[run.way] = true;
    if (folders[i] != nullptr)
      finished += identity(all[i]) + "\n";
    on_writing_rank(communicator, [&]() { write_file_atomically(checkpoint, finished); });
  }
  MPI_Comm_free(&watch);
  report(runs, directory, log);
}

std::string
Comparison::perform(const Plan &plan, const OutputDirectory &directory, const MPI_Comm watch) const
{
  try
  {
    if (dimension == 2)
      run_case<2>(plan, directory);
    else
      run_case<3>(plan, directory);
  }
  catch (const std::exception &error)
  {
    // One rank alone cannot go on to the next run: main ends them all.
    if (!all_ranks_arrive(watch))
      throw;
    const std::string reason = collapse_blanks(error.what());
    return reason.empty() ? "unknown reason" : reason;
  }
  return "";
}

template <int dim>
void Comparison::run_case(const Plan &plan, const OutputDirectory &directory) const
{
  ParameterFile file(plan.command_line.parameter_file, plan.command_line.overrides);
  Case<dim> input(file, communicator, false);
  Log log(communicator, false);
  begin_output(file, plan.command_line, communicator, input.general.title, directory, log);
  perform_case(input, file, plan.command_line, directory, log);
}

ComparedRun Comparison::result(const Plan &plan) const
{
  ComparedRun run;
  run.name = plan.name;
  run.way = plan.way;
  run.mesh = plan.mesh;
  run.time_step = plan.time_step;
  const std::string text =
      content_of(plan.command_line.output_directory + "/summary.json", communicator);
  if (text.empty())
    return run;
  const nlohmann::json summary = nlohmann::json::parse(text);
  run.n_cells = summary.value("cells", 0.);
  run.n_steps = summary.value("steps", 0.);
  run.cell_size = run.n_cells > 0. ? std::pow(volume / run.n_cells, 1. / dimension) : 0.;
  if (summary.count("degrees of freedom") > 0)
    for (const auto &field : summary["degrees of freedom"])
      run.n_dofs += field.get<double>();
  if (summary.count("wall time [s]") > 0)
    run.wall_time = summary["wall time [s]"].value("total", 0.);
  for (const auto &quantity : summary["quantities"])
    if (quantity["value"].is_number())
      run.quantities.push_back(
          {quantity["name"], quantity["value"], quantity["unit"], quantity["probe"]});
  return run;
}

void Comparison::report(const std::vector<ComparedRun> &runs,
                        const OutputDirectory &directory,
                        Log &log) const
{
  const ComparisonReport comparison(parameters, {ways[0].orders, ways[1].orders}, runs);
  for (const std::string &line : comparison.lines())
    log.line(line);
  Summary summary;
  summary.set("title", general.title);
  summary.set("status", "finished");
  summary.set("version", version());
  summary.set("revision", revision());
  summary.set("revision has uncommitted changes", revision_is_dirty() ? 1. : 0.);
  summary.set("command line", command_line.text);
  summary.set("parameter file", command_line.parameter_file);
  summary.set("analysis", "comparison");
  summary.set("analysis of the runs", parameters.analysis);
  summary.set("model", general.model);
  summary.set("compared", std::vector<std::string>{parameters.name(0), parameters.name(1)});
  summary.set("ranks", static_cast<double>(Utilities::MPI::n_mpi_processes(communicator)));
  std::string failed, reasons;
  for (const ComparedRun &run : runs)
    if (!run.failure.empty())
    {
      failed += (failed.empty() ? "" : ", ") + run.name;
      reasons += (reasons.empty() ? "" : "; ") + run.name + ": " + run.failure;
    }
  if (!failed.empty())
  {
    summary.set("status", "failed");
    summary.set("failure", reasons);
  }
  comparison.add_quantities(summary);
  bool all_passed = true;
  for (const std::string &verdict : summary.check(parameters.expected, all_passed))
    log.line(verdict);
  summary.set("warnings", log.warnings());
  // No rank may end the program before the files are there.
  on_writing_rank(communicator,
                  [&]()
                  {
                    comparison.write_quantities(directory.file("comparison.csv"));
                    comparison.write_runs(directory.file("runs.csv"));
                    summary.write(directory.file("summary.json"));
                    Citations citations;
                    citations.add("roache1994");
                    citations.add("celik2008");
                    citations.write(directory.file("citation.bib"));
                  });
  if (!failed.empty())
    throw RunError("these runs failed: " + failed);
}
} // namespace Continua
