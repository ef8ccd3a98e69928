#ifndef continua_finite_volume_cell_wise_parameters_h
#define continua_finite_volume_cell_wise_parameters_h

#include <continua/base/words.h>

namespace Continua
{
/// Which of the two schemes sets the defaults of the other entries.
enum class CellWiseVariant
{
  continua, ///< the scheme as it is right
  thesis    ///< as the thesis has it
};

/// Which unknowns the cell-wise path solves for.
enum class Formulation
{
  displacement,               ///< D (equation 3.36)
  velocity,                   ///< U, stress from the accumulated D (3.39)
  velocity_explicit_pressure, ///< U, with p computed from U (3.40, 2.25)
  velocity_pressure           ///< U and p (3.41, 3.58)
};

/// How a step's equations are solved.
enum class CellWiseSolution
{
  coupled,   ///< all unknowns at once
  segregated ///< component by component in a loop
};

/// The stencil of the stress accumulated so far.
enum class AccumulatedTerm
{
  consistent,  ///< the stencil of the new velocity
  inconsistent ///< the wide one
};

/// What the face fluxes are corrected by.
enum class RhieChow
{
  increment, ///< of the pressure in solids, the pressure in fluids
  pressure,  ///< everywhere
  none
};

/// How the correction by the pressure itself goes on in time in a fluid.
enum class RhieChowInTime
{
  momentum_of_faces, ///< the faces' excess velocity has a momentum: ExcessVelocity
  made_anew          ///< in each step, with 1/a_P
};

/// How the velocity that a flux through a face carries is found (equations 3.2 to 3.5).
enum class ConvectiveInterpolation
{
  central, ///< between the two cells
  upwind,  ///< the velocity of the cell that the flux comes from
  blended  ///< of both
};

/// The modulus of the compact part of the traction.
enum class StencilCoefficient
{
  automatic,    ///< deviatoric in the velocity-pressure form, else longitudinal
  longitudinal, ///< 2 mu + lambda
  deviatoric,   ///< 4/3 mu
  shear         ///< mu
};

/// How the pressure follows the velocity.
enum class PressureUpdate
{
  as_displacement, ///< by the update of the displacement
  trapezoidal,     ///< by the mean of old and new velocity
  euler            ///< by the new one
};

const Words<PressureUpdate> &pressure_update_words();

/// How the pressure of a boundary face is found.
enum class BoundaryPressure
{
  momentum,      ///< by the gradient of the owner's momentum equation (3.74 to 3.76)
  definition,    ///< from the divergence on the face (3.72)
  force_balance, ///< from the normal traction (3.73)
  zero_gradient  ///< the owner's
};

/// What of the pressure of a boundary face the segregated pressure equation is given.
enum class BoundaryPressureAs
{
  value,
  gradient
};

/// What the segregated momentum equation is given on a boundary with a given traction.
enum class BoundaryVelocityAs
{
  automatic, ///< balance in the velocity-pressure form, else gradient
  gradient,  ///< from the force balance divided by the stencil coefficient
  value,     ///< likewise
  balance    ///< the gradient that solves the face's own equations
};

/// The gradient on a boundary face.
enum class BoundaryGradient
{
  replaced, ///< the cell's, its normal part replaced by that of the face
  cell      ///< the cell's
};

/// What the power ledger is made of.
enum class PowerOperator
{
  scheme,  ///< the scheme's own operators
  compact, ///< the change of the kinetic energy, the stress's power by the compact operator
  wide     ///< the same by the wide operator
};

/// What a step does whose loop reaches the cap of corrections.
enum class AtCap
{
  warn, ///< goes on with a warning
  fail  ///< ends the run
};

/// The section Cell-wise. Where the thesis's scheme and the one that is right differ, `Variant`
/// sets what the other entries are by default.
struct CellWiseParameters
{
  CellWiseVariant variant = CellWiseVariant::continua;
  Formulation formulation = Formulation::velocity_pressure;
  CellWiseSolution solution = CellWiseSolution::coupled;
  AccumulatedTerm accumulated_term = AccumulatedTerm::consistent;
  RhieChow rhie_chow = RhieChow::increment;
  RhieChowInTime rhie_chow_in_time = RhieChowInTime::momentum_of_faces;
  ConvectiveInterpolation convective_interpolation = ConvectiveInterpolation::central;
  double blending_factor = 1.; ///< gamma: 1 central, 0 upwind
  StencilCoefficient stencil_coefficient = StencilCoefficient::automatic;
  PressureUpdate pressure_update = PressureUpdate::as_displacement;
  BoundaryPressure boundary_pressure = BoundaryPressure::definition;
  BoundaryPressureAs boundary_pressure_as = BoundaryPressureAs::value;
  BoundaryVelocityAs boundary_velocity_as = BoundaryVelocityAs::automatic;
  BoundaryGradient boundary_gradient = BoundaryGradient::replaced;
  PowerOperator power_operator = PowerOperator::scheme;
  double tolerance = 1e-8; ///< of the residual of the segregated loop [1]
  unsigned int maximum_corrections = 50;
  unsigned int pressure_corrections = 2;
  AtCap at_cap = AtCap::warn;
  bool residual_history = false;

  /// Declares and reads; throws InputError.
  void read(ParameterSection section);

  /// Whether the pressure is apart from the other stresses.
  bool has_pressure() const
  {
    return formulation == Formulation::velocity_pressure ||
           formulation == Formulation::velocity_explicit_pressure;
  }
  double share_of_central() const
  {
    return convective_interpolation == ConvectiveInterpolation::central  ? 1.
           : convective_interpolation == ConvectiveInterpolation::upwind ? 0.
                                                                         : blending_factor;
  }
  /// Whether the segregated loop solves the faces' own equations face by face.
  bool faces_balance() const
  {
    return boundary_velocity_as == BoundaryVelocityAs::balance ||
           (boundary_velocity_as == BoundaryVelocityAs::automatic &&
            formulation == Formulation::velocity_pressure);
  }
  bool is_segregated() const { return solution == CellWiseSolution::segregated; }
};
} // namespace Continua

#endif
