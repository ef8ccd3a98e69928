#ifndef continua_analysis_rigid_motions_h
#define continua_analysis_rigid_motions_h

#include <continua/continuum/problem.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>
#include <deal.II/distributed/tria_base.h>
#include <deal.II/fe/mapping.h>

#include <string>
#include <vector>

namespace Continua
{
/// A rigid motion u(x) = translation + rotation x (x - centre), small.
template <int dim>
struct RigidMotion
{
  std::string axis;     ///< "x", "y" or "z"
  bool rotates = false; ///< about the axis by 1 rad, or along it by 1 m
  /// What the whole body would weigh in this motion: its mass [kg] (of a plane model [kg/m]), or
  /// its moment of inertia about the axis through the centre of mass [kg m^2].
  double inertia = 0.;
  unsigned int axis_number = 0; ///< 0 is x
  dealii::Point<dim> centre;    ///< about which it turns, such as that of mass

  /// The displacement at a point [m].
  dealii::Tensor<1, dim> operator()(const dealii::Point<dim> &point) const;
};

/// The rigid motions that a model has, translations first, about any point; without inertia.
template <int dim>
std::vector<RigidMotion<dim>> rigid_motions(const dealii::Point<dim> &centre, bool axisymmetric);

/**
 * The rigid motions of the body that a mesh describes, translations first: along each axis and,
 * beside them, turns about the centre of mass; in a plane model about z, in axisymmetry none, and
 * there along x alone (the mass is that of the whole circumference). Collective.
 */
template <int dim>
std::vector<RigidMotion<dim>>
rigid_motions(const dealii::parallel::TriangulationBase<dim> &triangulation,
              const dealii::Mapping<dim> &mapping,
              const Problem &problem);
} // namespace Continua

#endif
