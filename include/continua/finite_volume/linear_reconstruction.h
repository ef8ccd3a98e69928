#ifndef continua_finite_volume_linear_reconstruction_h
#define continua_finite_volume_linear_reconstruction_h

#include <continua/continuum/problem.h>
#include <continua/finite_volume/cell_wise_space.h>

#include <deal.II/base/index_set.h>

namespace Continua
{
/// Where a field is looked at: in a cell, or on a face with a value of its own, from the side of
/// that cell.
struct CellPlace
{
  static constexpr unsigned int none = dealii::numbers::invalid_unsigned_int;

  unsigned int cell = none;
  unsigned int face = none; ///< none: in the cell
};

/**
 * What the values of cells and faces say of the points between them: in a cell its value plus its
 * gradient times the distance from its centre; on a face with its own value that plus the part of
 * the cell's gradient along the face. Exact for linear functions.
 */
template <int dim>
class LinearReconstruction
{
public:
  LinearReconstruction(const CellWiseSpace<dim> &space, const Problem &problem)
      : space(space), problem(problem)
  {
  }

  /// Finds which values of other ranks are needed on the present mesh.
  void build();

  /// A component of a velocity (or of an internal displacement), and the pressure, at a point.
  Stencil<double> velocity(const CellPlace &place, const dealii::Point<dim> &point) const;
  Stencil<double> pressure(const CellPlace &place, const dealii::Point<dim> &point) const;
  /**
   * A component of the displacement. A liquid's is the way that its particles have gone, which
   * grows for ever in a stream and says nothing of where its surface is. So a face between a liquid
   * and a solid is the solid's, whose gradient counts along it, and a face on which the liquid's
   * velocity is prescribed has one value all over. On a mesh that moves the solids see their own
   * place, the undeformed one.
   */
  Stencil<double> displacement(const CellPlace &place,
                               const dealii::Point<dim> &point,
                               const dealii::Point<dim> &undeformed) const;
  /// The cell that owns a face between a liquid and a solid: the solid's. Of another face the given
  /// one of its cells.
  unsigned int owner_along(unsigned int face, unsigned int cell) const;
  /// The gradient of a component [1/m]: in a cell one for all of it; on a face with its normal part
  /// from the face's value.
  Stencil<dealii::Tensor<1, dim>> velocity_gradient(const CellPlace &place) const;
  /// u_r/r as the factor of u_r, likewise; empty if not axisymmetric [1/m].
  Stencil<double> hoop(const CellPlace &place) const;

  /// Copies that have every value that the stencils of this rank's cells, and of those beside them,
  /// need.
  DistributedVector ghosted_velocity(const DistributedVector &owned) const;
  DistributedVector ghosted_pressure(const DistributedVector &owned) const;

  /// A stencil's sum over a vector with ghosts.
  static dealii::Tensor<1, dim> vector_value(const Stencil<double> &stencil,
                                             const DistributedVector &velocity);
  static double value(const Stencil<double> &stencil, const DistributedVector &pressure);
  /// The same of a gradient, of which row c is that of component c.
  static dealii::Tensor<2, dim> vector_gradient(const Stencil<dealii::Tensor<1, dim>> &stencil,
                                                const DistributedVector &velocity);

private:
  const CellWiseSpace<dim> &space;
  const Problem &problem;
  dealii::IndexSet relevant_velocities, relevant_pressures;

  bool is_solid(unsigned int cell) const;
  /// Whether all of the velocity is prescribed on a face.
  bool is_held(unsigned int face) const;
  Stencil<double> at_point(const ValueSpace<dim> &values,
                           const GaussGradient<dim> &gradient,
                           const CellPlace &place,
                           const dealii::Point<dim> &point) const;
  dealii::IndexSet relevant(const ValueSpace<dim> &values,
                            const GaussGradient<dim> &gradient,
                            unsigned int n_components) const;
};
} // namespace Continua

#endif
