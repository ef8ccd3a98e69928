#include <continua/continuum/convection.h>

#include <continua/base/words.h>

namespace Continua
{
void Convection::read(ParameterSection section)
{
  add_choice(section, "Convective term", term,
             {{"skew", ConvectiveTerm::skew}, {"advective", ConvectiveTerm::advective}},
             "How convection of momentum is written: skew - with half of the velocity times the "
             "equation of state, so that its power is a flux through the boundary; advective - "
             "without.");
  add_choice(
      section, "Time treatment", treatment,
      {{"newton", ConvectionTreatment::newton}, {"explicit", ConvectionTreatment::extrapolated}},
      "Where a time step takes the convective terms from: newton - from the state that it "
      "balances, with Newton's iteration; explicit - from the velocity extrapolated to "
      "that state from the last two levels. The matrix is then constant and a step is one "
      "solve, which is stable for short steps alone.");
  add_choice(
      section, "Convection stabilisation", stabilisation,
      {{"none", ConvectionStabilisation::none},
       {"grad-div", ConvectionStabilisation::grad_div},
       {"supg", ConvectionStabilisation::supg}},
      "grad-div - adds the residual of the equation of state times the divergence of the "
      "test function, which lets the velocity conserve volume more closely; supg - also adds the "
      "residual of the momentum equation times the derivative of the test function along the "
      "flow, which damps waves of the length of a cell. The cell-wise path has none.");
  section.add("Stabilisation viscosity", stabilisation_viscosity, Dimensions::viscosity,
              "Factor of grad-div; by itself 0.15 times density, local speed and size of the cell.",
              Range::positive());
  if (stabilisation == ConvectionStabilisation::none && section.given("Stabilisation viscosity"))
    section.refuse("Stabilisation viscosity", "Convection stabilisation = none makes no use of it",
                   "Remove it, or set Convection stabilisation = grad-div");
}

void NewtonParameters::read(ParameterSection section)
{
  section.add("Tolerance", tolerance, Dimensions::none,
              "A step ends when the residuals of momentum and of volume are below this fraction of "
              "the largest ones met in the step, or at round-off.",
              Range{0., 1e-2, true, false});
  section.add("Maximum iterations", maximum_iterations,
              "Iterations after which a step has failed [1].", 1);
  section.add("Slowest rate", slowest_rate, Dimensions::none,
              "An iteration is slow when its residual is more than this fraction of that of the "
              "iteration before.",
              Range{0., 1., true, true});
  add_choice(section, "Slow iteration", slow_iteration,
             {{"krylov", SlowIteration::krylov}, {"new factor", SlowIteration::new_factor}},
             "What follows a slow iteration: krylov - GMRES solves with the tangent at that state, "
             "preconditioned with the kept factor; new factor - that tangent is factored. With "
             "outlets or cavities, and on the cell-wise path, always a new factor.");
  add_choice(
      section, "Tangent products", tangent_products,
      {{"assembled", TangentProducts::assembled}, {"differences", TangentProducts::differences}},
      "Products with the tangent for GMRES: assembled - from integrals of the derivative, "
      "which are kept for the step; differences - from differences of the terms that are "
      "not linear, which needs no memory.");
  section.add("Krylov tolerance", krylov_tolerance, Dimensions::none,
              "GMRES ends when the residual is below this fraction of that at its start.",
              Range{0., 1., true, true});
  section.add(
      "Most Krylov iterations", most_krylov_iterations,
      "When GMRES needs more iterations than this in a step, the next slow iteration makes a "
      "new factor [1].",
      1);
  if (slow_iteration != SlowIteration::krylov)
    for (const char *const key : {"Tangent products", "Krylov tolerance", "Most Krylov iterations"})
      if (section.given(key))
        section.refuse(key, "Slow iteration = new factor makes no use of it",
                       "Remove it, or set Slow iteration = krylov");
}
} // namespace Continua
