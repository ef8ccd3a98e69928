#ifndef continua_finite_element_terms_solid_point_h
#define continua_finite_element_terms_solid_point_h

#include <continua/base/deviatoric_part.h>
#include <continua/continuum/kinematics.h>
#include <continua/continuum/right_stretch.h>
#include <continua/finite_element/terms/point_change.h>
#include <continua/finite_element/terms/tested.h>

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <type_traits>

namespace Continua
{
/// What the terms of one solid have at every point.
struct SolidScheme
{
  double displacement_by_velocity = 0.;  ///< b = dD/dU [s]
  double rate_by_velocity = 0.;          ///< d(dU/dt)/dU [1/s]
  double pressure_rate_by_pressure = 0.; ///< d(dp/dt)/dp [1/s]
  /// Whether the row of volume is its rate, as in the middle of a step.
  bool volume_is_rate = false;
  double density = 0.;              ///< of the stress-free body [kg/m^3]
  double viscosity = 0.;            ///< that acts in the step [Pa s]
  double inverse_bulk_modulus = 0.; ///< [1/Pa]
  bool has_own_mean_stress = false; ///< StrainLaw::has_own_mean_stress()
};

/**
 * The state of a solid in finite deformation at a point of the reference mesh, with the stress that
 * its law gives: a term knows neither laws nor meshes. Gradients are 3x3 in every model, by the
 * present place. `Number`: double, or several points at once.
 */
template <int dim, typename Number = double>
struct SolidPoint
{
  using Matrix = dealii::Tensor<2, 3, Number>;
  using Symmetric = dealii::SymmetricTensor<2, 3, Number>;

  SolidScheme scheme;
  KinematicsOf<Number> kinematics; ///< F = I + Grad D
  Number hoop = 0.;                ///< 1/r of the present place in axisymmetry, else 0 [1/m]
  dealii::Tensor<1, dim, Number> velocity, acceleration;
  Matrix velocity_gradient; ///< grad U [1/s]
  Number pressure = 0., pressure_rate = 0.;
  Number stress_free_ratio = 1.; ///< det F0: StressFreeState::volume_ratio [1]
  Number mass_ratio = 1.;        ///< the mass over that of the mesh's volume [1]

  // By the law, with the branches that relax.
  Symmetric stress;                              ///< det F0 tau [Pa]
  dealii::SymmetricTensor<4, 3, Number> tangent; ///< det F0 C: see StrainLaw::set_tangent() [Pa]
  Number mean_stress = 0.;                       ///< of a law that has one [Pa]
  Symmetric mean_stress_slope;                   ///< see StrainLaw::set_mean_stress() [Pa]
  /// Of 1 + Grad D0, in a step that finds the unloaded shape X + D0: there F = 1 and D0 = -D. Else
  /// null; of double alone.
  const RightStretch *unloading = nullptr;

  SolidPoint(const SolidScheme &scheme, const KinematicsOf<Number> &kinematics)
      : scheme(scheme), kinematics(kinematics)
  {
  }
  Number volume_ratio() const { return kinematics.volume_ratio(); }
  /// 2 J eta dev sym grad U [Pa].
  Symmetric viscous_stress() const
  {
    return (2. * scheme.viscosity * volume_ratio()) *
           deviatoric_part(symmetrize(velocity_gradient));
  }
  /// Adds a stress per reference volume: it is multiplied by grad v.
  void add_stress(const Matrix &of_point, Tested<dim, Number> &tested) const
  {
    dealii::Tensor<2, dim, Number> plane;
    for (unsigned int c = 0; c < dim; ++c)
      for (unsigned int d = 0; d < dim; ++d)
        plane[c][d] = of_point[c][d];
    tested.add_stress(plane, of_point[2][2], hoop);
  }
};

/// A change of the unknowns of a solid at a point, with what follows from it.
template <int dim, typename Number = double>
struct SolidChange
{
  using Matrix = dealii::Tensor<2, 3, Number>;

  dealii::Tensor<1, dim, Number> acceleration;
  Matrix velocity_gradient;      ///< of grad U by the place that moves, too [1/s]
  Matrix moved;                  ///< dF F^-1 [1]
  Matrix elastic;                ///< the same of the elastic deformation [1]
  Number stress_free_ratio = 0.; ///< of det F0, over it [1]
  Number pressure = 0., pressure_rate = 0.;

  SolidChange(const SolidPoint<dim, Number> &point, const PointChange<dim, Number> &change)
      : acceleration(point.scheme.rate_by_velocity * change.velocity),
        velocity_gradient(
            whole_gradient<dim, Number>(change.velocity_gradient, point.hoop * change.velocity[1])),
        pressure(change.pressure),
        pressure_rate(point.scheme.pressure_rate_by_pressure * change.pressure)
  {
    const double b = point.scheme.displacement_by_velocity;
    if constexpr (std::is_same_v<Number, double>)
      if (point.unloading != nullptr)
      {
        // The elastic deformation is U0^-1 times what is known.
        elastic = b * (point.unloading->inverse() * point.unloading->change(velocity_gradient));
        stress_free_ratio = -trace(elastic);
        return;
      }
    moved = b * velocity_gradient;
    elastic = moved;
    velocity_gradient -= point.velocity_gradient * moved;
  }
};
} // namespace Continua

#endif
