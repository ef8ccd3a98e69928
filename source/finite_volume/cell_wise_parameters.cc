#include <continua/finite_volume/cell_wise_parameters.h>

namespace Continua
{
void CellWiseParameters::read(ParameterSection section)
{
  section.add_choice("Variant", variant, {"continua", "thesis"},
                     "What the entries below are unless they are given: continua, the scheme as it "
                     "is right; thesis, as the thesis has it.");
  if (variant == "thesis")
  {
    rhie_chow = "pressure";
    stencil_coefficient = "longitudinal";
    pressure_update = "trapezoidal";
    boundary_pressure = "momentum";
    boundary_velocity_as = "gradient";
  }
  section.add_choice(
      "Formulation", formulation,
      {"displacement", "velocity", "velocity explicit pressure", "velocity-pressure"},
      "The unknowns: displacement; velocity, with the stress of the accumulated "
      "displacement; velocity with the pressure computed from it; velocity and "
      "pressure. The first two are for Hookean solids only.");
  section.add_choice("Solution", solution, {"coupled", "segregated"},
                     "coupled: all unknowns at once, the matrix factored once; segregated: "
                     "component by component in a loop, the thesis's way.");
  section.add_choice("Accumulated term", accumulated_term, {"consistent", "inconsistent"},
                     "The stencil of the stress accumulated so far: consistent, that of the new "
                     "velocity; inconsistent, the wide one.");
  section.add_choice(
      "Rhie-Chow", rhie_chow, {"increment", "pressure", "none"},
      "What the face fluxes are corrected by: the pressure's increment in solids and "
      "the pressure in fluids; the pressure everywhere, which makes a solid creep; "
      "nothing.");
  section.add_choice(
      "Stencil coefficient", stencil_coefficient,
      {"automatic", "longitudinal", "deviatoric", "shear"},
      "Modulus of the compact part of the traction: longitudinal 2 mu + lambda, "
      "deviatoric 4/3 mu, shear mu; automatic is deviatoric in the velocity-pressure "
      "form, else longitudinal.");
  section.add_choice("Pressure update", pressure_update,
                     {"as the displacement", "trapezoidal", "euler"},
                     "How the pressure follows the velocity: by Time/Update, or by the mean of old "
                     "and new velocity, or by the new one.");
  section.add_choice(
      "Pressure at boundaries", boundary_pressure,
      {"momentum", "definition", "force balance", "zero gradient"},
      "Pressure of a boundary face: extrapolated by the momentum equation, from its "
      "definition by the divergence, from the force balance, or that of the cell. "
      "Where a velocity is given, the definition holds in solids only, elsewhere "
      "it is extrapolated. The force balance, one of the thesis's choices, is refused: it is the "
      "face's own equation once more.");
  section.add_choice("Pressure at boundaries as", boundary_pressure_as, {"value", "gradient"},
                     "What of it the segregated pressure equation is given.");
  section.add_choice(
      "Velocity at boundaries as", boundary_velocity_as,
      {"automatic", "gradient", "value", "balance"},
      "What the segregated momentum equation is given on a boundary with a given traction: "
      "gradient "
      "or value, from the force balance divided by the stencil coefficient, the thesis's way; "
      "balance, the gradient that solves the face's own equations; automatic is balance in the "
      "velocity-pressure form, else gradient.");
  section.add_choice("Boundary gradient", boundary_gradient, {"replaced", "cell"},
                     "The gradient on a boundary face: the cell's with its normal part replaced by "
                     "that of the face, or the cell's.");
  section.add_choice("Power operator", power_operator, {"scheme", "compact", "wide"},
                     "What the power ledger is made of: the scheme's own operators, or, as in the "
                     "thesis, the change of the kinetic energy and the stress's power by the "
                     "compact or the wide operator.");
  section.add("Tolerance", tolerance, Dimensions::none,
              "Of the segregated loop: it ends when the residual at its start is below this.",
              Range::positive());
  section.add("Maximum corrections", maximum_corrections,
              "The segregated loop's cap on the corrections in a step [1].", 1);
  section.add("Pressure corrections", pressure_corrections,
              "Pressure equations solved after each momentum equation [1].", 1);
  section.add_choice(
      "At the cap", cap, {"warn", "fail"},
      "What a step does whose loop reaches the cap: goes on, with a warning, or ends "
      "the run.");
  section.add("Residual history", residual_history,
              "Whether the residual of every correction of every step of the segregated loop is "
              "written to log.txt.");
}

Formulation CellWiseParameters::formulation_type() const
{
  if (formulation == "displacement")
    return Formulation::displacement;
  if (formulation == "velocity")
    return Formulation::velocity;
  return formulation == "velocity-pressure" ? Formulation::velocity_pressure
                                            : Formulation::velocity_explicit_pressure;
}

BoundaryPressure CellWiseParameters::boundary_pressure_type() const
{
  if (boundary_pressure == "momentum")
    return BoundaryPressure::momentum;
  if (boundary_pressure == "definition")
    return BoundaryPressure::definition;
  return boundary_pressure == "force balance" ? BoundaryPressure::force_balance
                                              : BoundaryPressure::zero_gradient;
}
} // namespace Continua
