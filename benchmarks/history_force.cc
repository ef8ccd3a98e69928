// What the memory of a viscoelastic wall costs: the step of tube A of chapter 6 with an elastic
// wall and with walls of a spring and several branches, measured in turn.
//
//   benchmark_history_force OUTPUT SOURCE_DIRECTORY
//
// writes OUTPUT.txt and OUTPUT.md.

#include "measurement.h"

#include <continua/base/log.h>
#include <continua/case/case.h>
#include <continua/continuum/discrete_continuum.h>
#include <continua/finite_element/taylor_hood.h>
#include <continua/program/analyses.h>

#include <cmath>
#include <map>
#include <memory>
#include <sstream>

namespace Benchmarks
{
using namespace Continua;

/// Repetitions, in each of which every wall is measured once.
constexpr unsigned int n_repetitions = 25;
constexpr unsigned int steps_of_repetition = 60;

struct Wall
{
  std::string name;
  unsigned int n_branches, n_bulk_branches;
  bool ledger;
};

/// One tube that is stepped on and on.
class Tube
{
public:
  Tube(const std::string &parameter_file, const Wall &wall);
  /// Makes the steps of a repetition and keeps their times.
  void repeat();
  /// Median over the repetitions of a section's processor time in a step [s].
  double time(const std::string &section) const { return median(times.at(section)); }
  const std::vector<double> &all(const std::string &section) const { return times.at(section); }
  double n_dofs() const;

private:
  const Wall wall;
  Log log;
  ParameterFile file;
  Case<2> input;
  std::unique_ptr<DiscreteContinuum<2>> body;
  unsigned int n_steps = 0;
  std::map<std::string, std::vector<double>> times;

  static std::vector<std::string> overrides(const Wall &wall);
  void step();
};

/// Moduli of a tenth of the elastic one, times one after the other from 0.5 ms to 1 s.
std::vector<std::string> Tube::overrides(const Wall &wall)
{
  const auto list = [](const unsigned int n, const auto &value, const std::string &unit)
  {
    std::ostringstream text;
    for (unsigned int k = 0; k < n; ++k)
      text << (k > 0 ? ", " : "") << value(k) << unit;
    return text.str();
  };
  const auto modulus = [](unsigned int) { return 0.05; };
  const auto times = [](const unsigned int n)
  {
    return [n](const unsigned int k)
    { return 0.5 * std::pow(2000., n > 1 ? static_cast<double>(k) / (n - 1) : 0.); };
  };
  const std::string section = "Materials/wall/";
  std::vector<std::string> result;
  if (wall.n_branches == 0)
    return result;
  result = {section + "Type=prony",
            section + "Shear moduli=" + list(wall.n_branches, modulus, " MPa"),
            section + "Relaxation times=" + list(wall.n_branches, times(wall.n_branches), " ms")};
  if (wall.n_bulk_branches > 0)
  {
    result.push_back(section + "Volumetric relaxation=own branches");
    result.push_back(section + "Bulk moduli=" + list(wall.n_bulk_branches, modulus, " MPa"));
    result.push_back(section + "Bulk relaxation times=" +
                     list(wall.n_bulk_branches, times(wall.n_bulk_branches), " ms"));
  }
  return result;
}

Tube::Tube(const std::string &parameter_file, const Wall &wall)
    : wall(wall),
      log(MPI_COMM_WORLD),
      file(parameter_file, overrides(wall)),
      input(analyses().read_case<2>(file, MPI_COMM_WORLD))
{
  log.timer().take_processor_times();
  body = std::make_unique<DiscreteContinuum<2>>(
      std::make_unique<TaylorHood<2>>(*input.triangulation, input.problem,
                                      input.discretisation.taylor_hood, log),
      input.problem, log);
  body->initialise();
  step(); // factors
}

void Tube::step()
{
  const double size = input.time.time_step;
  body->advance(crank_nicolson_step(n_steps * size, size));
  if (wall.ledger)
    body->power_balance(true);
  ++n_steps;
}

void Tube::repeat()
{
  step(); // brings the factor back to the cache
  const auto sections = [this]() { return log.timer().processor_times(); };
  const std::map<std::string, double> before = sections();
  const double whole = processor_time(
      [this]()
      {
        for (unsigned int i = 0; i < steps_of_repetition; ++i)
          step();
      });
  const std::map<std::string, double> after = sections();
  for (const char *const section : {"right-hand side", "solve", "update"})
    times[section].push_back((after.at(section) - before.at(section)) / steps_of_repetition);
  times["step"].push_back(whole / steps_of_repetition);
}

double Tube::n_dofs() const
{
  double sum = 0.;
  for (const auto &field : body->sizes().n_dofs)
    sum += static_cast<double>(field.second);
  return sum;
}

void run(const std::string &output, const std::string &source_directory)
{
  const std::string parameter_file = "parameter_files/thesis/chapter-6/tube-a.prm";
  Report report("The history force of a viscoelastic wall");
  describe_machine(report);
  describe_libraries(report);
  report.line("run: " + parameter_file + " with other walls, Crank-Nicolson, 0.2 ms");
  report.line("times: processor time of one core; in each of " + std::to_string(n_repetitions) +
              " repetitions every wall makes " + std::to_string(steps_of_repetition) +
              " steps in turn; medians, ratios those of the same repetition");
  report.line(
      "vectors over elastic: the elastic step with the right-hand side and update of this wall "
      "in place of its own");

  const std::vector<Wall> walls = {{"elastic", 0, 0, false},
                                   {"1 branch", 1, 0, false},
                                   {"10 branches", 10, 0, false},
                                   {"20 branches", 20, 0, false},
                                   {"10 branches, volumetric 10 besides", 10, 10, false},
                                   {"elastic, with ledger", 0, 0, true},
                                   {"10 branches, with ledger", 10, 0, true}};
  std::vector<std::unique_ptr<Tube>> tubes;
  for (const Wall &wall : walls)
    tubes.push_back(std::make_unique<Tube>(source_directory + "/" + parameter_file, wall));
  report.line("unknowns: " + std::to_string(static_cast<long>(tubes.front()->n_dofs())));
  for (unsigned int repetition = 0; repetition < n_repetitions; ++repetition)
    for (const auto &tube : tubes)
      tube->repeat();
  report.line("load at the end: " + number(load()));

  report.start_table("A step",
                     {"wall", "right-hand side [ms]", "solve [ms]", "update [ms]", "whole [ms]",
                      "over elastic", "smallest", "largest", "vectors over elastic"});
  // What is done for the history, beside a solve that is the same for all.
  const auto vectors = [](const Tube &tube)
  { return tube.time("right-hand side") + tube.time("update"); };
  const Tube *elastic = nullptr;
  for (std::size_t i = 0; i < walls.size(); ++i)
  {
    const Tube &tube = *tubes[i];
    if (walls[i].n_branches == 0)
      elastic = &tube; // of the rows that follow
    std::vector<double> ratios;
    for (unsigned int repetition = 0; repetition < n_repetitions; ++repetition)
      ratios.push_back(tube.all("step")[repetition] / elastic->all("step")[repetition]);
    report.row({walls[i].name, number(1e3 * tube.time("right-hand side")),
                number(1e3 * tube.time("solve")), number(1e3 * tube.time("update")),
                number(1e3 * tube.time("step")), number(median(ratios)),
                number(*std::min_element(ratios.begin(), ratios.end())),
                number(*std::max_element(ratios.begin(), ratios.end())),
                number(1. + (vectors(tube) - vectors(*elastic)) / elastic->time("step"))});
  }
  report.finish(output);
}
} // namespace Benchmarks

int main(int argc, char **argv)
{
  return Benchmarks::main_of(argc, argv,
                             [](const std::string &output, const std::string &sources, bool)
                             { Benchmarks::run(output, sources); });
}
