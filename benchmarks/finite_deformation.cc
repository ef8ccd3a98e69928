// What the parts of a load step in finite deformation cost: Cook's membrane in two dimensions and
// the pulled cube in three, on meshes of several sizes, the whole load in one step.
//
//   benchmark_finite_deformation OUTPUT SOURCE_DIRECTORY
//
// writes OUTPUT.txt and OUTPUT.md.

#include "measurement.h"

#include <continua/base/log.h>
#include <continua/case/case.h>
#include <continua/continuum/discrete_continuum.h>
#include <continua/finite_element/taylor_hood.h>
#include <continua/program/analyses.h>

#include <functional>
#include <iostream>
#include <memory>

namespace Benchmarks
{
using namespace Continua;

/// Processor time [s] and number of calls.
struct Part
{
  double time = 0.;
  unsigned int n_calls = 0;

  void add(const std::function<void()> &call)
  {
    time += processor_time(call);
    ++n_calls;
  }
  double mean() const { return n_calls > 0 ? time / n_calls : 0.; }
};

/// Times what Newton's iteration asks for.
template <int dim>
class TimedTaylorHood : public TaylorHood<dim>
{
public:
  using Base = TaylorHood<dim>;
  using Base::Base;

  Part residual, tangent, linearisation, solution, cell_matrices, product;

  void add_nonlinear_terms(const StepSolution &state,
                           DistributedVector &momentum,
                           DistributedVector &mass) override
  {
    residual.add([&]() { Base::add_nonlinear_terms(state, momentum, mass); });
  }
  bool linearise(const StepSolution &state) override
  {
    // The integrals by themselves, which the next call makes again.
    tangent.add([&]() { Base::keep_derivative(state); });
    bool is_new = false;
    linearisation.add([&]() { is_new = Base::linearise(state); });
    return is_new;
  }
  void keep_derivative(const StepSolution &state) override
  {
    cell_matrices.add([&]() { Base::keep_derivative(state); });
  }
  void add_derivative_product(const DistributedVector &velocity,
                              const DistributedVector &pressure,
                              DistributedVector &momentum,
                              DistributedVector &mass) override
  {
    product.add([&]() { Base::add_derivative_product(velocity, pressure, momentum, mass); });
  }
  void solve(const DistributedVector &prescribed,
             DistributedVector &momentum,
             DistributedVector &mass,
             DistributedVector &velocity,
             DistributedVector &pressure,
             StepReport &report) override
  {
    solution.add([&]() { Base::solve(prescribed, momentum, mass, velocity, pressure, report); });
  }
};

template <int dim>
void measure(Report &report,
             const std::string &source_directory,
             const std::string &cells,
             const std::string &solver)
{
  const std::string name = dim == 2 ? "finite-strain-cook.prm" : "finite-strain-block.prm";
  ParameterFile file(
      source_directory + "/parameter_files/verification/" + name,
      {"Mesh/Cells=" + cells, "Steady/Load steps=1", "Linear solver/Direct solver=" + solver});
  Case<dim> input = analyses().read_case<dim>(file, MPI_COMM_WORLD);
  Log log(MPI_COMM_WORLD);
  auto discretisation = std::make_unique<TimedTaylorHood<dim>>(
      *input.triangulation, input.problem, input.discretisation.taylor_hood, log);
  const TimedTaylorHood<dim> &parts = *discretisation;
  DiscreteContinuum<dim> body(std::move(discretisation), input.problem, log);
  body.initialise();
  // As the search for a steady state has it.
  Step step = euler_step(0., input.steady.time_step, Update::implicit);
  step.balance_time = step.time = 0.;
  step.finds_steady_state = true;
  StepReport found;
  const double whole = processor_time([&]() { found = body.advance(step); }) - parts.tangent.time;

  const SolverSizes sizes = body.sizes();
  double n_dofs = 0.;
  for (const auto &field : sizes.n_dofs)
    n_dofs += static_cast<double>(field.second);
  const auto milliseconds = [](const Part &part)
  { return part.n_calls > 0 ? number(1e3 * part.mean()) : std::string("-"); };
  const double factor = parts.linearisation.time - parts.tangent.time;
  const auto share = [whole](const double time) { return number(100. * time / whole); };
  report.row({std::to_string(dim), cells, std::to_string(static_cast<long>(n_dofs)), solver,
              milliseconds(parts.residual), milliseconds(parts.tangent),
              number(1e3 * factor / parts.linearisation.n_calls), milliseconds(parts.solution),
              milliseconds(parts.product), std::to_string(found.corrections),
              std::to_string(found.factors), std::to_string(found.linear_iterations), number(whole),
              share(parts.residual.time + parts.tangent.time + parts.cell_matrices.time),
              share(factor), share(parts.solution.time + parts.product.time)});
  std::cerr << dim << "-D, " << n_dofs << " dofs, " << solver << ": " << whole << " s" << std::endl;
}

void run(const std::string &output, const std::string &source_directory)
{
  Report report("A load step in finite deformation");
  describe_machine(report);
  describe_libraries(report);
  report.line("finite-strain-cook.prm (uniform meshes) and finite-strain-block.prm, the whole load "
              "in one step; processor times of one call of each part, and of the step");
  report.start_table("Parts",
                     {"dim", "cells", "unknowns", "solver", "residual [ms]", "tangent [ms]",
                      "factor [ms]", "solve [ms]", "product [ms]", "corrections", "factors",
                      "GMRES", "step [s]", "assembly [%]", "factor [%]", "solve [%]"});
  for (const char *const cells : {"16, 16", "32, 32", "64, 64", "128, 128"})
    for (const char *const solver : {"umfpack", "mumps"})
      measure<2>(report, source_directory, cells, solver);
  for (const char *const cells : {"4, 4, 4", "6, 6, 6", "8, 8, 8"})
    for (const char *const solver : {"umfpack", "mumps"})
      measure<3>(report, source_directory, cells, solver);
  // UMFPACK would take minutes there.
  for (const char *const cells : {"10, 10, 10", "13, 13, 13"})
    measure<3>(report, source_directory, cells, "mumps");
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
