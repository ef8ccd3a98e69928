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
#include <continua/continuum/linear_system.h>
#include <continua/continuum/nonlinear_system.h>
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

/// The parts of Newton's iteration.
struct Parts
{
  Part residual, tangent, linearisation, solution, cell_matrices, product;
};

/// The same terms, with their times.
class TimedNonlinear : public NonlinearSystem
{
public:
  TimedNonlinear(NonlinearSystem &system, Parts &parts) : system(system), parts(parts) {}

  bool is_in(const unsigned int region) const override { return system.is_in(region); }
  bool has_all_terms() const override { return system.has_all_terms(); }
  void add(const StepSolution &state, DistributedVector &momentum, DistributedVector &mass) override
  {
    parts.residual.add([&]() { system.add(state, momentum, mass); });
  }
  ResidualScales residual_scales(const DistributedVector &velocity,
                                 const DistributedVector &pressure) const override
  {
    return system.residual_scales(velocity, pressure);
  }
  std::string place_of_largest(const DistributedVector &momentum,
                               const DistributedVector &mass,
                               const bool of_momentum) const override
  {
    return system.place_of_largest(momentum, mass, of_momentum);
  }
  bool linearise(const StepSolution &state) override
  {
    // The integrals by themselves, which the next call makes again.
    parts.tangent.add([&]() { system.keep_derivative(state); });
    bool is_new = false;
    parts.linearisation.add([&]() { is_new = system.linearise(state); });
    return is_new;
  }
  bool solves_with_kept_derivative() const override { return system.solves_with_kept_derivative(); }
  void forget_linearisation() override { system.forget_linearisation(); }
  bool has_derivative_products() const override { return system.has_derivative_products(); }
  void keep_derivative(const StepSolution &state) override
  {
    parts.cell_matrices.add([&]() { system.keep_derivative(state); });
  }
  void add_derivative_product(const DistributedVector &velocity,
                              const DistributedVector &pressure,
                              DistributedVector &momentum,
                              DistributedVector &mass) override
  {
    parts.product.add([&]() { system.add_derivative_product(velocity, pressure, momentum, mass); });
  }
  void add_powers(const unsigned int region,
                  const StepSolution &state,
                  const DistributedVector &of_velocity,
                  const TermsTaken taken,
                  NonlinearPowers &powers,
                  DistributedVector *const momentum) override
  {
    system.add_powers(region, state, of_velocity, taken, powers, momentum);
  }
  NonlinearEnergy energy(const unsigned int region, const State &state) override
  {
    return system.energy(region, state);
  }

private:
  NonlinearSystem &system;
  Parts &parts;
};

/// The same system, with the times of its solves.
class TimedLinear : public LinearSystem
{
public:
  TimedLinear(LinearSystem &system, Parts &parts) : system(system), parts(parts) {}

  SystemChange prepare(const SystemCoefficients &coefficients, const double pressure_time) override
  {
    return system.prepare(coefficients, pressure_time);
  }
  void eliminate_prescribed(const DistributedVector &prescribed,
                            DistributedVector &momentum,
                            DistributedVector &mass) override
  {
    system.eliminate_prescribed(prescribed, momentum, mass);
  }
  bool starts_from_guess() const override { return system.starts_from_guess(); }
  void solve(const DistributedVector &prescribed,
             DistributedVector &momentum,
             DistributedVector &mass,
             DistributedVector &velocity,
             DistributedVector &pressure,
             StepReport &report) override
  {
    parts.solution.add([&]()
                       { system.solve(prescribed, momentum, mass, velocity, pressure, report); });
  }
  void add_velocity_product(const DistributedVector &velocity, DistributedVector &result) override
  {
    system.add_velocity_product(velocity, result);
  }
  void add_divergence(const DistributedVector &velocity, DistributedVector &result) override
  {
    system.add_divergence(velocity, result);
  }
  void restrict_residuals(DistributedVector &momentum, DistributedVector &mass) const override
  {
    system.restrict_residuals(momentum, mass);
  }

private:
  LinearSystem &system;
  Parts &parts;
};

/// Times what Newton's iteration asks for.
template <int dim>
class TimedTaylorHood : public TaylorHood<dim>
{
public:
  using TaylorHood<dim>::TaylorHood;

  NonlinearSystem *nonlinear() override { return &timed_terms; }
  LinearSystem &system() override { return timed_system; }

  Parts parts;

private:
  TimedNonlinear timed_terms{*TaylorHood<dim>::nonlinear(), parts};
  TimedLinear timed_system{TaylorHood<dim>::system(), parts};
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
  const Parts &parts = discretisation->parts;
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
