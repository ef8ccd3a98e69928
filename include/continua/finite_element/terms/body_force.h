#ifndef continua_finite_element_terms_body_force_h
#define continua_finite_element_terms_body_force_h

#include <continua/continuum/nonlinear_terms.h>
#include <continua/finite_element/terms/point_change.h>
#include <continua/finite_element/terms/term_list.h>
#include <continua/finite_element/terms/tested.h>

#include <deal.II/base/tensor.h>

namespace Continua
{
/// What is given at the present place x of a point.
template <int dim>
struct BodyForcePoint
{
  dealii::Tensor<1, dim> force;         ///< rho b(x) + f(x) [N/m^3]
  dealii::Tensor<2, dim> slope;         ///< [c][d]: of component c along d [N/m^4]
  double displacement_by_velocity = 0.; ///< b = dD/dU, 0 where the place is held [s]
};

/// -int v . ( rho b(x) + f(x) ) dv with the acceleration b and the force density f at the present
/// place. A liquid has its present volume dv and the density rho of the material, a solid its
/// volume dV and the density of the stress-free material.
struct BodyForce
{
  static constexpr PowerKind power = &NonlinearPowers::load;

  template <int dim>
  static void add(const BodyForcePoint<dim> &point, Tested<dim> &tested)
  {
    tested.by_value -= point.force;
  }
  template <int dim>
  static void add_derivative(const BodyForcePoint<dim> &point,
                             const PointChange<dim> &change,
                             Tested<dim> &tested)
  {
    tested.by_value -= point.displacement_by_velocity * (point.slope * change.velocity);
  }
};

/// The terms that liquids and solids have inside their cells alike.
using BodyForceTerms = TermList<BodyForce>;
} // namespace Continua

#endif
