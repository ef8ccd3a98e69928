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
      section, "Convection stabilisation", stabilisation,
      {{"none", ConvectionStabilisation::none}, {"grad-div", ConvectionStabilisation::grad_div}},
      "grad-div - adds the residual of the equation of state times the divergence of the "
      "test function, which lets the velocity conserve volume more closely.");
  section.add("Stabilisation viscosity", stabilisation_viscosity, Dimensions::viscosity,
              "Factor of grad-div; 0.1 to 0.2 times density, speed and size of a cell is usual.",
              Range::positive());
  const bool is_stabilised = stabilisation != ConvectionStabilisation::none;
  if (is_stabilised)
    section.require("Stabilisation viscosity");
  else if (section.given("Stabilisation viscosity"))
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
              "A new factor is made when the residual is more than this fraction of that of the "
              "iteration before.",
              Range{0., 1., true, true});
}
} // namespace Continua
