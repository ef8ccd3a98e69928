// What more ranks bring and what they exchange: a tube of water in two and three dimensions, with
// the direct and the iterative solver, on the same mesh (strong scaling) and on one that grows with
// the ranks (weak), with both partitioners; and the memory that a mesh takes on each rank.
//
//   benchmark_scaling OUTPUT SOURCE_DIRECTORY [--ranks 1,2] [--rounds 3]
//                     [--solvers direct,iterative] [--mpirun COMMAND] [--set KEY=VALUE ...]
//
// writes OUTPUT.txt, OUTPUT.md and, for extrapolate_ranks.py, OUTPUT.json. It starts itself under
// COMMAND -np N for every number of ranks, in turns, so that ratios are those of one round; the
// entries of --set go to all runs of the tube.

#include "communication.h"
#include "measurement.h"

#include <continua/base/log.h>
#include <continua/case/case.h>
#include <continua/postprocess/field_writer.h>
#include <continua/program/analyses.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>
#include <deal.II/grid/grid_generator.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <sstream>
#include <stdexcept>

namespace Benchmarks
{
using namespace Continua;

/// What a run of one number of ranks tells, by name.
using Values = std::map<std::string, double>;

/// Of /proc/self/status, in bytes: VmRSS is what is resident now, VmHWM the most that ever was.
double memory(const std::string &key)
{
  std::ifstream stream("/proc/self/status");
  std::string line;
  while (std::getline(stream, line))
    if (line.compare(0, key.size() + 1, key + ":") == 0)
      return 1024. * std::stod(line.substr(key.size() + 1));
  throw std::runtime_error("/proc/self/status has no " + key);
}

// ---- in the ranks

/// Of all ranks; not counted as communication of the run.
double largest(double value)
{
  PMPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
  return value;
}

double mean(double value)
{
  int n_ranks = 1;
  PMPI_Comm_size(MPI_COMM_WORLD, &n_ranks);
  PMPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  return value / n_ranks;
}

/// Wall time of the slowest rank [s].
double common_time(const std::function<void()> &function)
{
  PMPI_Barrier(MPI_COMM_WORLD);
  return largest(wall_time(function));
}

/// Adds what a stage of the run exchanged, for each of `n` repetitions: of the rank with most.
void add_communication(const std::string &stage,
                       const Communication &earlier,
                       const double n,
                       Values &values)
{
  const Communication exchanged = Communication::until_now() - earlier;
  for (unsigned int kind = 0; kind < Communication::n_kinds; ++kind)
    for (const auto origin : {Communication::other, Communication::mumps})
    {
      const CommunicationCount &count = exchanged.counts[origin][kind];
      const std::string name = stage + (origin == Communication::mumps ? " mumps " : " other ") +
                               Communication::kind_names[kind];
      values[name + " calls"] = largest(count.calls) / n;
      values[name + " bytes"] = largest(count.bytes) / n;
    }
}

/// The time that a number of steps is to take, and their least number.
constexpr double time_of_steps = 1.;
constexpr unsigned int least_steps = 4;

template <int dim>
void measure_tube(ParameterFile &file, const std::string &folder, Values &values)
{
  const double before = memory("VmRSS");
  Communication start = Communication::until_now();
  Log log(MPI_COMM_WORLD, false);
  std::unique_ptr<Case<dim>> input;
  std::unique_ptr<ContinuumSolver<dim>> solver;
  values["coarse mesh [s]"] = common_time(
      [&]() { input.reset(new Case<dim>(analyses().read_case<dim>(file, MPI_COMM_WORLD))); });
  values["set-up [s]"] = common_time(
      [&]()
      {
        refine(*input->triangulation, input->mesh.refinements);
        solver =
            make_solver<dim>(*input->triangulation, input->problem, input->discretisation, log);
        solver->initialise();
        input->probes.attach(*solver, input->problem.model);
      });
  add_communication("set-up", start, 1., values);

  const double size = input->time.time_step;
  unsigned int n_steps = 0;
  double n_iterations = 0.;
  const auto advance = [&]()
  {
    n_iterations += solver
                        ->advance(backward_differencing_step(n_steps * size, size, size,
                                                             input->time.update_type()))
                        .linear_iterations;
    ++n_steps;
  };
  start = Communication::until_now();
  values["first step [s]"] = common_time(advance);
  add_communication("first step", start, 1., values);
  const double one = common_time(advance);
  const unsigned int n = std::max(least_steps, static_cast<unsigned int>(time_of_steps / one));
  n_iterations = 0.;
  start = Communication::until_now();
  std::vector<double> times;
  for (unsigned int i = 0; i < n; ++i)
    times.push_back(common_time(advance));
  values["step [s]"] = median(times);
  values["iterations"] = n_iterations / n;
  add_communication("step", start, n, values);
  values["memory [bytes]"] = largest(memory("VmRSS") - before);
  values["mean memory [bytes]"] = mean(memory("VmRSS") - before);
  values["most memory [bytes]"] = largest(memory("VmHWM"));

  start = Communication::until_now();
  for (unsigned int i = 0; i < least_steps; ++i)
    input->probes.present_values();
  add_communication("probes", start, least_steps, values);
  FieldWriter<dim> fields(MPI_COMM_WORLD, folder, 1, false);
  start = Communication::until_now();
  values["fields [s]"] = common_time([&]() { fields.write(*solver, n_steps * size); });
  add_communication("fields", start, 1., values);

  const PartitionQuality quality = measure_partition(*input->triangulation);
  values["imbalance"] = quality.imbalance;
  values["cut faces"] = quality.n_cut_faces;
  const SolverSizes sizes = solver->sizes();
  values["cells"] = sizes.n_cells;
  for (const auto &field : sizes.n_dofs)
    values["dofs"] += field.second;
  values["factor memory [bytes]"] = sizes.factor_memory;
}

/// A cube of n^3 coarse cells, each refined; nothing but the mesh.
void measure_mesh(const std::string &partitioner,
                  const unsigned int n,
                  const unsigned int refinements,
                  Values &values)
{
  PartitionParameters parameters;
  parameters.partitioner = value_of(partitioner_words(), partitioner);
  const double before = memory("VmRSS");
  const auto mesh = make_triangulation<3>(MPI_COMM_WORLD, parameters, {});
  dealii::GridGenerator::subdivided_hyper_cube(*mesh, n);
  refine(*mesh, refinements);
  values["memory [bytes]"] = mean(memory("VmRSS") - before);
  values["cells"] = mesh->n_global_active_cells();
}

/// Rank 0 prints "NAME<tab>VALUE", one a line.
void measure(const std::vector<std::string> &arguments)
{
  Values values;
  if (arguments.at(0) == "mesh")
    measure_mesh(arguments.at(1), std::stoul(arguments.at(2)), std::stoul(arguments.at(3)), values);
  else
  {
    const std::vector<std::string> overrides(arguments.begin() + 2, arguments.end());
    ParameterFile general_file(arguments.at(0), overrides);
    GeneralParameters general;
    general.read(general_file.root(), analyses().types());
    ParameterFile file(arguments.at(0), overrides);
    if (n_dimensions(model_of(general.model)) == 2)
      measure_tube<2>(file, arguments.at(1), values);
    else
      measure_tube<3>(file, arguments.at(1), values);
  }
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
  {
    std::cout.precision(17);
    for (const auto &[name, value] : values)
      std::cout << name << '\t' << value << '\n';
  }
}

// ---- in the program that starts them

struct Options
{
  std::string output, source_directory, program;
  std::vector<unsigned int> ranks = {1, 2};
  std::vector<std::string> solvers = {"direct", "iterative"};
  unsigned int n_rounds = 3;
  std::string mpirun = "mpirun";
  std::vector<std::string> overrides;
};

/// Runs this program on so many ranks; throws std::runtime_error with what it said if it fails.
Values
run_on(const Options &options, const unsigned int n_ranks, std::vector<std::string> arguments)
{
  const auto quoted = [](const std::string &text) { return " '" + text + "'"; };
  std::string command =
      options.mpirun + " -np " + std::to_string(n_ranks) + quoted(options.program) + " --measure";
  for (const std::string &argument : arguments)
    command += quoted(argument);
  FILE *const stream = popen((command + " 2>&1").c_str(), "r");
  if (stream == nullptr)
    throw std::runtime_error("cannot start " + command);
  std::string text;
  char buffer[4096];
  while (std::fgets(buffer, sizeof(buffer), stream) != nullptr)
    text += buffer;
  if (pclose(stream) != 0)
    throw std::runtime_error("failed: " + command + "\n" + text);
  Values values;
  std::istringstream lines(text);
  std::string line;
  while (std::getline(lines, line))
  {
    const std::size_t tabulator = line.find('\t');
    if (tabulator != std::string::npos)
      values[line.substr(0, tabulator)] = std::stod(line.substr(tabulator + 1));
  }
  return values;
}

/// The tube in two or three dimensions, solved in one way.
struct Tube
{
  unsigned int n_dimensions;
  std::string solver; ///< of Linear solver/Type
  unsigned int axial_cells() const { return n_dimensions == 2 ? 100 : 20; }
};

Values run_tube(const Options &options,
                const Tube &tube,
                const unsigned int n_ranks,
                const unsigned int length,
                const std::string &partitioner)
{
  const std::string dimension = std::to_string(tube.n_dimensions);
  std::vector<std::string> arguments = {
      options.source_directory + "/benchmarks/scaling-tube-" + dimension + "d.prm",
      options.output + "-fields",
      "Linear solver/Type=" + tube.solver,
      "Mesh/Axial cells=" + std::to_string(length * tube.axial_cells()),
      "Geometry/Length=" + std::to_string(50 * length) + " mm",
      "Mesh/Partitioner=" + partitioner};
  arguments.insert(arguments.end(), options.overrides.begin(), options.overrides.end());
  return run_on(options, n_ranks, arguments);
}

/// The median over rounds of one value.
double median_of(const std::vector<Values> &rounds, const std::string &name)
{
  std::vector<double> values;
  for (const Values &round : rounds)
    values.push_back(round.at(name));
  return median(values);
}

/// The median over rounds of first over second.
double ratio_of(const std::vector<Values> &first,
                const std::vector<Values> &second,
                const std::string &name)
{
  std::vector<double> ratios;
  for (std::size_t i = 0; i < first.size(); ++i)
    ratios.push_back(first[i].at(name) / second[i].at(name));
  return median(ratios);
}

/// All rounds of one tube.
struct Rounds
{
  Tube tube;
  std::string kind; ///< strong, weak, metis
  unsigned int n_ranks;
  std::vector<Values> values;
};

std::vector<Rounds> run_tubes(const Options &options)
{
  std::vector<Rounds> all;
  std::vector<Tube> tubes;
  for (const unsigned int n_dimensions : {2, 3})
    for (const std::string &solver : options.solvers)
      tubes.push_back({n_dimensions, solver});
  for (const Tube &tube : tubes)
  {
    std::vector<Rounds> of_tube;
    for (const unsigned int n : options.ranks)
    {
      of_tube.push_back({tube, "strong", n, {}});
      if (n > options.ranks.front())
        of_tube.push_back({tube, "weak", n, {}});
      if (n > 1)
        of_tube.push_back({tube, "metis", n, {}});
    }
    for (unsigned int round = 0; round < options.n_rounds; ++round)
      for (Rounds &one : of_tube)
        one.values.push_back(run_tube(options, tube, one.n_ranks,
                                      one.kind == "weak" ? one.n_ranks : 1,
                                      one.kind == "metis" ? "metis" : "p4est"));
    all.insert(all.end(), of_tube.begin(), of_tube.end());
  }
  return all;
}

void write_times(Report &report, const std::vector<Rounds> &all)
{
  report.start_table("Times and memory; ratios to the first number of ranks",
                     {"dim", "solver", "mesh", "ranks", "cells", "dofs", "set-up [s]",
                      "first step [s]", "step [ms]", "iterations", "set-up ratio",
                      "first step ratio", "step ratio", "memory a rank [MB]", "memory ratio",
                      "most memory [MB]", "factor [MB]"});
  const Rounds *first = nullptr;
  for (const Rounds &rounds : all)
  {
    if (first == nullptr || rounds.tube.n_dimensions != first->tube.n_dimensions ||
        rounds.tube.solver != first->tube.solver)
      first = &rounds;
    const auto value = [&](const std::string &name) { return median_of(rounds.values, name); };
    const auto ratio = [&](const std::string &name)
    { return number(ratio_of(first->values, rounds.values, name)); };
    report.row({std::to_string(rounds.tube.n_dimensions), rounds.tube.solver, rounds.kind,
                std::to_string(rounds.n_ranks), std::to_string(static_cast<long>(value("cells"))),
                std::to_string(static_cast<long>(value("dofs"))), number(value("set-up [s]")),
                number(value("first step [s]")), number(1e3 * value("step [s]")),
                number(value("iterations")), ratio("set-up [s]"), ratio("first step [s]"),
                ratio("step [s]"), number(1e-6 * value("mean memory [bytes]")),
                ratio("mean memory [bytes]"), number(1e-6 * value("most memory [bytes]")),
                number(1e-6 * value("factor memory [bytes]"))});
  }
}

void write_communication(Report &report, const std::vector<Rounds> &all)
{
  for (const std::string stage : {"set-up", "first step", "step", "probes", "fields"})
  {
    std::vector<std::string> columns = {"dim", "solver", "mesh", "ranks", "cut faces", "of"};
    for (const std::string &kind : Communication::kind_names)
    {
      columns.push_back(kind);
      if (kind != "barriers")
        columns.push_back("kB");
    }
    report.start_table("Communication of a rank: " + stage, columns);
    for (const Rounds &rounds : all)
      for (const std::string origin : {"other", "mumps"})
      {
        const auto value = [&](const std::string &name)
        { return median_of(rounds.values, stage + " " + origin + " " + name); };
        std::vector<std::string> row = {std::to_string(rounds.tube.n_dimensions),
                                        rounds.tube.solver,
                                        rounds.kind,
                                        std::to_string(rounds.n_ranks),
                                        number(median_of(rounds.values, "cut faces")),
                                        origin};
        double n_calls = 0.;
        for (const std::string &kind : Communication::kind_names)
        {
          n_calls += value(kind + " calls");
          row.push_back(number(value(kind + " calls")));
          if (kind != "barriers")
            row.push_back(number(1e-3 * value(kind + " bytes")));
        }
        if (n_calls > 0.)
          report.row(row);
      }
  }
}

/// The medians of everything, for extrapolate_ranks.py.
nlohmann::json medians(const std::vector<Rounds> &all)
{
  nlohmann::json list = nlohmann::json::array();
  for (const Rounds &rounds : all)
  {
    nlohmann::json values;
    for (const auto &entry : rounds.values.front())
      values[entry.first] = median_of(rounds.values, entry.first);
    list.push_back({{"dimensions", rounds.tube.n_dimensions},
                    {"solver", rounds.tube.solver},
                    {"mesh", rounds.kind},
                    {"ranks", rounds.n_ranks},
                    {"values", values}});
  }
  return list;
}

/// Also as a list for extrapolate_ranks.py.
nlohmann::json write_meshes(Report &report, const Options &options)
{
  nlohmann::json list = nlohmann::json::array();
  report.start_table("Memory of the mesh alone, a rank's mean",
                     {"partitioner", "coarse cells", "refinements", "cells", "ranks", "MB",
                      "bytes a cell of the mesh", "bytes a cell of the rank"});
  const unsigned int last = options.ranks.back();
  for (const std::string partitioner : {"p4est", "metis"})
    for (const auto &[n, refinements] : {std::pair<unsigned int, unsigned int>(32, 0), {4, 3}})
      for (const unsigned int n_ranks : {1u, last, 2 * last})
      {
        const Values values =
            run_on(options, n_ranks,
                   {"mesh", partitioner, std::to_string(n), std::to_string(refinements)});
        const double bytes = values.at("memory [bytes]"), n_cells = values.at("cells");
        report.row({partitioner, std::to_string(n * n * n), std::to_string(refinements),
                    number(n_cells), std::to_string(n_ranks), number(1e-6 * bytes),
                    number(bytes / n_cells), number(bytes / n_cells * n_ranks)});
        list.push_back({{"partitioner", partitioner},
                        {"coarse cells", n * n * n},
                        {"cells", n_cells},
                        {"ranks", n_ranks},
                        {"bytes", bytes}});
      }
  return list;
}

void run(const Options &options)
{
  std::filesystem::create_directories(options.output + "-fields/fields");
  Report report("Ranks");
  report.line("processor: " + processor() + "; load before the start " + number(load()));
  describe_libraries(report);
  for (const std::string &entry : options.overrides)
    report.line("set: " + entry);
  report.line("rounds: " + std::to_string(options.n_rounds));
  const std::vector<Rounds> all = run_tubes(options);
  write_times(report, all);
  write_communication(report, all);
  const nlohmann::json meshes = write_meshes(report, options);
  report.line("load at the end: " + number(load()));
  report.finish(options.output);
  std::ofstream(options.output + ".json")
      << nlohmann::json({{"tubes", medians(all)}, {"meshes", meshes}}).dump(1) << '\n';
}

Options read_options(const std::vector<std::string> &arguments)
{
  if (arguments.size() < 3)
    throw std::runtime_error("usage: benchmark_scaling OUTPUT SOURCE_DIRECTORY [--ranks 1,2] "
                             "[--rounds 3] [--solvers direct,iterative] [--mpirun COMMAND] "
                             "[--set KEY=VALUE ...]");
  Options options;
  options.program = std::filesystem::canonical("/proc/self/exe").string();
  options.output = arguments[1];
  options.source_directory = arguments[2];
  for (std::size_t i = 3; i < arguments.size(); i += 2)
  {
    const std::string &name = arguments[i], &value = arguments.at(i + 1);
    if (name == "--ranks")
    {
      options.ranks.clear();
      for (const std::string &one : dealii::Utilities::split_string_list(value))
        options.ranks.push_back(std::stoul(one));
    }
    else if (name == "--solvers")
      options.solvers = dealii::Utilities::split_string_list(value);
    else if (name == "--rounds")
      options.n_rounds = std::stoul(value);
    else if (name == "--mpirun")
      options.mpirun = value;
    else if (name == "--set")
      options.overrides.push_back(value);
    else
      throw std::runtime_error("unknown option " + name);
  }
  return options;
}
} // namespace Benchmarks

int main(int argc, char **argv)
{
  try
  {
    const std::vector<std::string> arguments(argv, argv + argc);
    if (arguments.size() > 1 && arguments[1] == "--measure")
    {
      const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
      Benchmarks::measure({arguments.begin() + 2, arguments.end()});
    }
    else
      Benchmarks::run(Benchmarks::read_options(arguments));
  }
  catch (const std::exception &error)
  {
    std::cerr << "error: " << error.what() << std::endl;
    return 1;
  }
}
