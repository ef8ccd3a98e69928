#include <continua/finite_volume/cell_wise_parameters.h>

namespace Continua
{
const Words<PressureUpdate> &pressure_update_words()
{
  static const Words<PressureUpdate> words = {
      {"as the displacement", PressureUpdate::as_displacement},
      {"trapezoidal", PressureUpdate::trapezoidal},
      {"euler", PressureUpdate::euler}};
  return words;
}

void CellWiseParameters::read(ParameterSection section)
{
  add_choice(section, "Variant", variant,
             {{"continua", CellWiseVariant::continua}, {"thesis", CellWiseVariant::thesis}},
             "What the entries below are unless they are given: continua, the scheme as it "
             "is right; thesis, as the thesis has it.");
  if (variant == CellWiseVariant::thesis)
  {
    rhie_chow = RhieChow::pressure;
    rhie_chow_in_time = RhieChowInTime::made_anew;
    stencil_coefficient = StencilCoefficient::longitudinal;
    pressure_update = PressureUpdate::trapezoidal;
    boundary_pressure = BoundaryPressure::momentum;
    boundary_velocity_as = BoundaryVelocityAs::gradient;
  }
  add_choice(section, "Formulation", formulation,
             {{"displacement", Formulation::displacement},
              {"velocity", Formulation::velocity},
              {"velocity explicit pressure", Formulation::velocity_explicit_pressure},
              {"velocity-pressure", Formulation::velocity_pressure}},
             "The unknowns: displacement; velocity, with the stress of the accumulated "
             "displacement; velocity with the pressure computed from it; velocity and "
             "pressure. The first two are for Hookean solids only.");
  add_choice(section, "Solution", solution,
             {{"coupled", CellWiseSolution::coupled}, {"segregated", CellWiseSolution::segregated}},
             "coupled: all unknowns at once, the matrix factored once; segregated: "
             "component by component in a loop, the thesis's way.");
  add_choice(section, "Accumulated term", accumulated_term,
             {{"consistent", AccumulatedTerm::consistent},
              {"inconsistent", AccumulatedTerm::inconsistent}},
             "The stencil of the stress accumulated so far: consistent, that of the new "
             "velocity; inconsistent, the wide one.");
  add_choice(section, "Rhie-Chow", rhie_chow,
             {{"increment", RhieChow::increment},
              {"pressure", RhieChow::pressure},
              {"none", RhieChow::none}},
             "What the face fluxes are corrected by: the pressure's increment in solids and "
             "the pressure in fluids; the pressure everywhere, which makes a solid creep; "
             "nothing.");
  add_choice(section, "Rhie-Chow in time", rhie_chow_in_time,
             {{"momentum of faces", RhieChowInTime::momentum_of_faces},
              {"made anew", RhieChowInTime::made_anew}},
             "How the correction by the pressure goes on in time in a fluid: momentum of faces, "
             "what the correction adds to the velocity of a face has a momentum of its own, and "
             "the result has a limit as the time step falls; made anew in each step with the "
             "inverse of the momentum diagonal, the thesis's way, which fades away with the time "
             "step.");
  add_choice(section, "Convective interpolation", convective_interpolation,
             {{"central", ConvectiveInterpolation::central},
              {"upwind", ConvectiveInterpolation::upwind},
              {"blended", ConvectiveInterpolation::blended}},
             "What a flux through a face carries, of a run with convection: central, the mean of "
             "both cells; upwind, what the cell has that the flux comes from, which is of first "
             "order; blended, Blending factor times central and the rest upwind.");
  section.add("Blending factor", blending_factor, Dimensions::none,
              "Share of central in Convective interpolation = blended.",
              Range{0., 1., false, false});
  if (convective_interpolation == ConvectiveInterpolation::blended)
    section.require("Blending factor");
  else if (section.given("Blending factor"))
    section.refuse("Blending factor", "only Convective interpolation = blended makes use of it",
                   "Remove it, or set Convective interpolation = blended");
  add_choice(section, "Stencil coefficient", stencil_coefficient,
             {{"automatic", StencilCoefficient::automatic},
              {"longitudinal", StencilCoefficient::longitudinal},
              {"deviatoric", StencilCoefficient::deviatoric},
              {"shear", StencilCoefficient::shear}},
             "Modulus of the compact part of the traction: longitudinal 2 mu + lambda, "
             "deviatoric 4/3 mu, shear mu; automatic is deviatoric in the velocity-pressure "
             "form, else longitudinal.");
  add_choice(section, "Pressure update", pressure_update, pressure_update_words(),
             "How the pressure follows the velocity: by Time/Update, or by the mean of old "
             "and new velocity, or by the new one.");
  add_choice(
      section, "Pressure at boundaries", boundary_pressure,
      {{"momentum", BoundaryPressure::momentum},
       {"definition", BoundaryPressure::definition},
       {"force balance", BoundaryPressure::force_balance},
       {"zero gradient", BoundaryPressure::zero_gradient}},
      "Pressure of a boundary face: extrapolated by the momentum equation, from its "
      "definition by the divergence, from the force balance, or that of the cell. "
      "Where a velocity is given, the definition holds in solids only, elsewhere "
      "it is extrapolated. The force balance, one of the thesis's choices, is refused: it is the "
      "face's own equation once more.");
  add_choice(section, "Pressure at boundaries as", boundary_pressure_as,
             {{"value", BoundaryPressureAs::value}, {"gradient", BoundaryPressureAs::gradient}},
             "What of it the segregated pressure equation is given.");
  add_choice(
      section, "Velocity at boundaries as", boundary_velocity_as,
      {{"automatic", BoundaryVelocityAs::automatic},
       {"gradient", BoundaryVelocityAs::gradient},
       {"value", BoundaryVelocityAs::value},
       {"balance", BoundaryVelocityAs::balance}},
      "What the segregated momentum equation is given on a boundary with a given traction: "
      "gradient "
      "or value, from the force balance divided by the stencil coefficient, the thesis's way; "
      "balance, the gradient that solves the face's own equations; automatic is balance in the "
      "velocity-pressure form, else gradient.");
  add_choice(section, "Boundary gradient", boundary_gradient,
             {{"replaced", BoundaryGradient::replaced}, {"cell", BoundaryGradient::cell}},
             "The gradient on a boundary face: the cell's with its normal part replaced by "
             "that of the face, or the cell's.");
  add_choice(section, "Power operator", power_operator,
             {{"scheme", PowerOperator::scheme},
              {"compact", PowerOperator::compact},
              {"wide", PowerOperator::wide}},
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
  add_choice(section, "At the cap", at_cap, {{"warn", AtCap::warn}, {"fail", AtCap::fail}},
             "What a step does whose loop reaches the cap: goes on, with a warning, or ends "
             "the run.");
  section.add("Residual history", residual_history,
              "Whether the residuals of every correction of every step of the segregated loop are "
              "written to residuals.csv.");
}
} // namespace Continua
