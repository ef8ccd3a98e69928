// Which block a solve that has not converged stalls by, and the remedy, as a table.

#include <continua/finite_element/solvers/stalled_block.h>

#include "../unit_test.h"

#include <limits>

namespace test_of_stalled_block
{
using namespace Continua;

namespace
{
/// A tube whose wall has multigrid and whose blocks are all good enough.
BlockFactors good()
{
  BlockFactors factors;
  factors.residual = 1e-3;
  factors.has_stiff = factors.has_fluid = true;
  factors.of_all = 0.7;
  factors.of_stiff = 0.3;
  factors.of_fluid = 0.2;
  return factors;
}

void expect(const std::string &name,
            const BlockFactors &factors,
            const LinearSolverParameters &parameters,
            const std::string &pattern)
{
  const std::string text = describe_stalled_block(factors, parameters);
  const bool matches = check::matches(text, pattern);
  check::is_true(matches ? name : name + ", " + text, matches);
}
} // namespace

UNIT_TEST(stalled_block)
{
  LinearSolverParameters parameters;
  parameters.restart_length = parameters.maximum_iterations;
  BlockFactors factors = good();
  expect(
      "all is good", factors, parameters,
      "together 0.7, the stiff block alone 0.3, the fluid block alone 0.2. No block stalls.*more "
      "Linear solver/Maximum iterations");
  factors.of_all = 0.9;
  expect("pressure", factors, parameters,
         "block of the pressure stalls, or what couples.*: use Linear solver/Type = direct$");
  parameters.restart_length = 30;
  expect("pressure, or the restart", factors, parameters, "larger Linear solver/Restart length");
  parameters.schur_complement = SchurApproximation::simple;
  expect("pressure of simple", factors, parameters, "use Linear solver/Schur complement = cahouet");

  factors.of_stiff = 0.85;
  expect("stiff block", factors, parameters, "So the stiff block stalls.*Stiff block = direct");
  factors.of_all = 0.7;
  expect("stiff block, not yet all", factors, parameters, "So the stiff block stalls");
  factors.of_fluid = 0.9;
  expect("the worse of both", factors, parameters,
         "So the fluid block stalls.*Fluid block = algebraic multigrid");
  factors.fluid_is_viscous = true;
  expect("fluid with multigrid", factors, parameters,
         "fluid block stalls: use a smaller time step");
  factors.has_inertia = false;
  expect("fluid without inertia", factors, parameters,
         "fluid block stalls: use Linear solver/Type = direct");

  // Of a correction of Newton's iteration: what the linear terms ask for does not help.
  factors.tangent_terms = TangentTerms::convection;
  parameters.schur_complement = SchurApproximation::cahouet_chabard;
  expect("fluid with convection", factors, parameters,
         "fluid block stalls: use a smaller time step, or Linear solver/Type = direct$");
  factors = good();
  factors.tangent_terms = TangentTerms::convection;
  expect("all is good with convection", factors, parameters,
         "No block stalls: use more Linear solver/Maximum iterations, or a smaller time step$");
  factors.of_all = 0.9;
  expect("pressure with convection, and the restart", factors, parameters,
         "block of the pressure stalls.*larger Linear solver/Restart length");
  parameters.restart_length = parameters.maximum_iterations;
  expect("pressure with convection", factors, parameters,
         "block of the pressure stalls.*use a smaller time step, or Linear solver/Type");
  factors.of_stiff = 0.85;
  expect("stiff block beside convection", factors, parameters,
         "Stiff block = direct, a smaller time step, or Type = direct$");
  factors.tangent_terms = TangentTerms::finite_deformation;
  expect("stiff block in finite deformation", factors, parameters,
         "the stiff block alone 0.85.*So the stiff block stalls: its preconditioner is that of "
         "small strains.*Use a smaller time step, or Linear solver/Type = direct$");
  factors.of_stiff = 0.;
  factors.stiff_is_direct = true;
  expect("a factor in finite deformation", factors, parameters,
         "the stiff block has a factor of its linear terms, the fluid block alone 0.2. So the "
         "stiff block stalls, or "
         "what couples the blocks: its preconditioner is that of small strains");
  parameters.schur_complement = SchurApproximation::simple;
  expect("a factor in finite deformation, and simple", factors, parameters,
         "block of the pressure stalls.*use Linear solver/Schur complement = cahouet-chabard$");
  parameters.schur_complement = SchurApproximation::cahouet_chabard;
  factors.has_stiff = false;
  expect("finite deformation that is not stiff", factors, parameters,
         "block of the pressure stalls.*use a smaller time step");
  factors.residual = 1e-14;
  expect("round-off of a correction", factors, parameters, "use a larger Newton/Krylov tolerance");
  parameters.restart_length = 30;

  factors = good();
  factors.of_all = 0.99;
  factors.stiff_is_direct = true;
  factors.of_stiff = 0.;
  expect("a factor", factors, parameters, "the stiff block alone 0, since it has a factor");
  factors.has_stiff = factors.has_fluid = false;
  expect("no blocks", factors, parameters, "together 0.99. So the block of the pressure");
  factors.residual = 1e-14;
  expect("round-off", factors, parameters, "round-off: use a larger Linear solver/Tolerance");
  factors.residual = std::numeric_limits<double>::quiet_NaN();
  expect("no number", factors, parameters, "^The residual is no number");
}
} // namespace test_of_stalled_block
