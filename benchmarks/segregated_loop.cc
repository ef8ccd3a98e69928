// What the segregated loop of the cell-wise discretisation costs for a cell and correction, and
// beside the coupled solution: the thesis's beam in the displacement form, loop to 1e-8, on three
// meshes.
//
//   benchmark_segregated_loop OUTPUT SOURCE_DIRECTORY
//
// writes OUTPUT.txt and OUTPUT.md.

#include "measurement.h"

#include <continua/base/log.h>
#include <continua/case/case.h>
#include <continua/continuum/discrete_continuum.h>
#include <continua/finite_volume/cell_wise.h>
#include <continua/program/analyses.h>

#include <algorithm>
#include <stdexcept>

namespace Benchmarks
{
using namespace Continua;

constexpr unsigned int n_repetitions = 5;
/// Each repetition takes as many steps as fit into this time, and at least one [s].
constexpr double repetition_time = 0.3;

/// Of one step.
struct StepCost
{
  double time = 0.;        ///< [s]
  double corrections = 0.; ///< mean
};

StepCost
measure(const std::string &source_directory, const std::string &cells, const std::string &solution)
{
  ParameterFile file(source_directory + "/parameter_files/thesis/chapter-4/common/fv-beam.prm",
                     {"Mesh/Cells=" + cells, "Cell-wise/Formulation=displacement",
                      "Cell-wise/Solution=" + solution, "Cell-wise/Tolerance=1e-8"});
  Log log(MPI_COMM_WORLD);
  Case<2> input = analyses().read_case<2>(file, MPI_COMM_WORLD);
  DiscreteContinuum<2> body(std::make_unique<CellWise<2>>(*input.triangulation, input.problem,
                                                          input.discretisation.cell_wise, log),
                            input.problem, log);
  body.initialise();
  const double size = input.time.time_step;
  unsigned int n_steps = 0;
  double n_corrections = 0.;
  const auto advance = [&]()
  {
    n_corrections +=
        body.advance(euler_step(n_steps * size, size, input.time.update_type())).corrections;
    ++n_steps;
  };
  // The first step makes the factors, the second tells how many fit into a repetition.
  advance();
  const double one = processor_time(advance);
  const unsigned int steps_of_repetition =
      std::max(1u, static_cast<unsigned int>(repetition_time / one));
  n_corrections = 0.;
  std::vector<double> times;
  for (unsigned int repetition = 0; repetition < n_repetitions; ++repetition)
    times.push_back(processor_time(
                        [&]()
                        {
                          for (unsigned int i = 0; i < steps_of_repetition; ++i)
                            advance();
                        }) /
                    steps_of_repetition);
  return {median(times), n_corrections / (n_repetitions * steps_of_repetition)};
}

void run(const std::string &output, const std::string &source_directory)
{
  Report report("The segregated loop");
  describe_machine(report);
  describe_libraries(report);
  report.start_table("A step of the displacement form, processor time",
                     {"cells", "corrections", "segregated [ms]",
                      "segregated, of a cell and correction [us]", "coupled [ms]", "ratio"});
  for (const auto &[cells, n_cells] :
       {std::pair<std::string, double>{"40, 10", 400.}, {"200, 50", 10000.}, {"400, 100", 40000.}})
  {
    const StepCost segregated = measure(source_directory, cells, "segregated");
    const StepCost coupled = measure(source_directory, cells, "coupled");
    report.row({cells, number(segregated.corrections), number(1e3 * segregated.time),
                number(1e6 * segregated.time / (n_cells * segregated.corrections)),
                number(1e3 * coupled.time), number(segregated.time / coupled.time)});
  }
  report.line("load at the end: " + number(load()));
  report.finish(output);
}
} // namespace Benchmarks

int main(int argc, char **argv)
{
  return Benchmarks::main_of(argc, argv,
                             [](const std::string &output, const std::string &sources, bool)
                             { Benchmarks::run(output, sources); });
}
