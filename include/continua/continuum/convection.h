#ifndef continua_continuum_convection_h
#define continua_continuum_convection_h

#include <continua/base/parameter_section.h>

#include <cmath>

namespace Continua
{
/// How the convective term of the momentum equation is written.
enum class ConvectiveTerm
{
  skew, ///< with half of U times the equation of state: its power is a flux through the boundary
  advective ///< rho (U . grad) U alone
};

/// Where a step takes the convective terms from.
enum class ConvectionTreatment
{
  newton,      ///< from the level that it balances: Newton's iteration
  extrapolated ///< from the velocity extrapolated to that level: one linear solve, one matrix
};

enum class ConvectionStabilisation
{
  none,
  grad_div, ///< the residual of the equation of state times the divergence of the test function
  supg      ///< StreamlineTerms, with grad-div
};

/// The convective terms of the liquids; off by default. Sections: the entry `Convection` at the top
/// of a parameter file and the section `Flow`.
struct Convection
{
  bool is_on = false;
  ConvectiveTerm term = ConvectiveTerm::skew;
  ConvectionTreatment treatment = ConvectionTreatment::newton; ///< in steps of a run in time
  ConvectionStabilisation stabilisation = ConvectionStabilisation::grad_div;
  /// gamma of grad-div [Pa s]; 0: by the local speed.
  double stabilisation_viscosity = 0.;
  /// gamma over density, speed and cell size where it is not given [1].
  static constexpr double grad_div_factor = 0.15;

  /// Reads the section Flow. Throws InputError.
  void read(ParameterSection section);
  /// Whether some step takes the convective terms from the extrapolated velocity.
  bool is_explicit() const { return is_on && treatment == ConvectionTreatment::extrapolated; }
  /// The part of gamma that is given [Pa s]; 0 where there is no grad-div.
  double constant_viscosity() const
  {
    return stabilisation == ConvectionStabilisation::none ? 0. : stabilisation_viscosity;
  }
  /// gamma over the local speed [Pa s^2/m] in a cell of that size [m], of a liquid of that density
  /// [kg/m^3]; 0 where gamma is given.
  double viscosity_over_speed(const double density, const double size) const
  {
    return stabilisation == ConvectionStabilisation::none || stabilisation_viscosity > 0.
               ? 0.
               : grad_div_factor * density * size;
  }
  /// The size of a cell [m]: its diameter over the root of the dimension, and of a higher degree
  /// that of the cells of degree 2 that would have as many unknowns.
  template <int dim>
  static double cell_size(const double diameter, const unsigned int degree)
  {
    return 2. * diameter / (std::sqrt(static_cast<double>(dim)) * degree);
  }
};

/// What Newton's iteration does when the kept factor leaves too much of the residual.
enum class SlowIteration
{
  new_factor, ///< factors the tangent at the present iterate
  krylov      ///< takes GMRES with that tangent, preconditioned with the kept factor
};

/// Where GMRES takes products with the tangent from.
enum class TangentProducts
{
  assembled,  ///< the integrals of the derivative, made once and kept for the step
  differences ///< differences of the terms that are not linear
};

/// How Newton's iteration of a step goes on, when it ends, and when it gives up. The section
/// Newton.
struct NewtonParameters
{
  /// Of the residual over the largest one met in the step, of momentum and of volume each [1].
  double tolerance = 1e-8;
  unsigned int maximum_iterations = 25;
  /// Residual over that of the iteration before above which a new factor is made [1].
  double slowest_rate = 0.2;
  SlowIteration slow_iteration = SlowIteration::krylov;
  TangentProducts tangent_products = TangentProducts::assembled;
  double krylov_tolerance = 1e-2; ///< of the residual after GMRES over that before [1]
  /// Of GMRES in a step above which the factor is no longer kept.
  unsigned int most_krylov_iterations = 6;

  void read(ParameterSection section);
};
} // namespace Continua

#endif
