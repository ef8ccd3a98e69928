#ifndef continua_finite_element_terms_flow_point_h
#define continua_finite_element_terms_flow_point_h

#include <continua/finite_element/terms/point_change.h>

#include <deal.II/base/tensor.h>

#include <cmath>

namespace Continua
{
/// What the terms of one liquid have at every point.
struct FlowScheme
{
  double carries = 1.;                   ///< of U in what carries: 0 without convection [1]
  double skew = 0.;                      ///< of the skew form, 1/2 or 0 [1]
  double grad_div_viscosity = 0.;        ///< constant part of gamma [Pa s]
  double rate_by_velocity = 0.;          ///< d(dU/dt)/dU [1/s]
  double pressure_rate_by_pressure = 0.; ///< d(dp/dt)/dp [1/s]
};

/**
 * The state of a liquid at a point, by the present place, with what the material is at this state:
 * a term knows neither laws nor meshes. `Number`: double, or several points at once.
 */
template <int dim, typename Number = double>
struct FlowPoint
{
  using Vector = dealii::Tensor<1, dim, Number>;
  using Matrix = dealii::Tensor<2, dim, Number>;

  FlowScheme scheme;
  Number hoop = 0.; ///< 1/r in axisymmetry, else 0 [1/m]
  Vector velocity, acceleration;
  Vector carrier;           ///< the velocity that carries, by the mesh [m/s]
  Matrix velocity_gradient; ///< [c][d]: of component c along d [1/s]
  Number pressure = 0., pressure_rate = 0.;
  Vector pressure_gradient;

  Number density = 0.;               ///< rho(p) [kg/m^3]
  Number compressibility = 0.;       ///< c(p) [1/Pa]
  Number compressibility_slope = 0.; ///< dc/dp [1/Pa^2]
  Number viscosity = 0.;             ///< eta [Pa s]
  Number viscosity_slope = 0.;       ///< (d eta/d g)/g of the FlowCurve at g [Pa s^3]
  Number grad_div_over_speed = 0.;   ///< of gamma, that grows with |U| [Pa s^2/m]

  // Made by finish() and set_strain_rate().
  Number divergence = 0.;
  Number pressure_motion = 0.; ///< dp/dt + U . grad p [Pa/s]
  Number source = 0.;          ///< m = c (dp/dt + U . grad p) + div U [1/s]
  Matrix strain_rate;          ///< deviatoric, in the plane or in space [1/s]
  Number across = 0.;          ///< of it, across the plane [1/s]

  /// gamma [Pa s].
  Number gamma() const { return scheme.grad_div_viscosity + grad_div_over_speed * velocity.norm(); }
  /// g = sqrt(2 dev D : dev D) [1/s]; after set_strain_rate().
  Number shear_rate() const
  {
    return std::sqrt(2. * (strain_rate.norm_square() + across * across));
  }

  /// From hoop, velocity and its gradient: the divergence, too.
  void set_strain_rate()
  {
    divergence = trace(velocity_gradient) + hoop * velocity[1];
    set_deviator(velocity_gradient, divergence, hoop * velocity[1], strain_rate, across);
  }
  /// From the rest, after set_strain_rate().
  void finish()
  {
    pressure_motion = pressure_rate + carrier * pressure_gradient;
    source = compressibility * pressure_motion + divergence;
  }

  /// dev sym of a gradient, in the plane or in space, and across the plane. `of_circle`: the
  /// component of the gradient along the circumference.
  static void set_deviator(const Matrix &gradient,
                           const Number &divergence,
                           const Number &of_circle,
                           Matrix &deviator,
                           Number &across)
  {
    const Number mean = divergence / 3.;
    for (unsigned int c = 0; c < dim; ++c)
    {
      for (unsigned int d = 0; d < dim; ++d)
        deviator[c][d] = 0.5 * (gradient[c][d] + gradient[d][c]);
      deviator[c][c] -= mean;
    }
    if (dim == 2)
      across = of_circle - mean;
  }
};

/// A change of the unknowns of a liquid at a point, with what follows from it.
template <int dim, typename Number = double>
struct FlowChange : PointChange<dim, Number>
{
  using Vector = dealii::Tensor<1, dim, Number>;
  using Matrix = dealii::Tensor<2, dim, Number>;

  Vector acceleration, carrier;
  Number density = 0., divergence = 0., source = 0.;

  FlowChange(const FlowPoint<dim, Number> &point, const PointChange<dim, Number> &change)
      : PointChange<dim, Number>(change)
  {
    acceleration = point.scheme.rate_by_velocity * change.velocity;
    carrier = point.scheme.carries * change.velocity;
    density = point.density * point.compressibility * change.pressure;
    divergence = trace(change.velocity_gradient) + point.hoop * change.velocity[1];
    const Number motion = point.scheme.pressure_rate_by_pressure * change.pressure +
                          carrier * point.pressure_gradient +
                          point.carrier * change.pressure_gradient;
    source = point.compressibility_slope * change.pressure * point.pressure_motion +
             point.compressibility * motion + divergence;
  }
};
} // namespace Continua

#endif
