#ifndef continua_finite_element_solvers_loaded_boundary_h
#define continua_finite_element_solvers_loaded_boundary_h

#include <continua/continuum/problem.h>
#include <continua/finite_element/solvers/loaded_cells.h>
#include <continua/finite_element/space/deformed_face_point.h>
#include <continua/finite_element/space/space.h>
#include <continua/linear_algebra/distributed_vector.h>

#include <vector>

namespace Continua
{
/// Integrals over the boundaries of a body that rests under loads, on its present faces. Vectors
/// hold the owned entries of this rank, with hanging nodes condensed. All methods are collective.
template <int dim>
class LoadedBoundary
{
public:
  /// All must outlive it.
  LoadedBoundary(const Space<dim> &space, const Problem &problem, const LoadedCells<dim> &cells);

  /// int v . n over the faces of a boundary condition [m^2].
  DistributedVector flow_of_velocities(unsigned int condition) const;
  /// Forces of the tractions of a boundary condition at `time` [s] that follow the faces, which
  /// Loads does not have [N].
  DistributedVector following_forces(unsigned int condition, double time) const;

private:
  struct Face
  {
    unsigned int condition;
    const LoadedCell<dim> *cell;
    std::vector<DeformedFacePoint<dim>> points;
  };
  const Space<dim> &space;
  const Problem &problem;
  const LoadedCells<dim> &cells;
  std::vector<Face> faces; ///< of each boundary condition

  /// int v . t over the faces of a boundary condition; `force_of(region, point, n da, displacements
  /// of the cell)` is t da at a point.
  template <typename ForceOf>
  DistributedVector sum_over_faces(unsigned int condition, const ForceOf &force_of) const;
};
} // namespace Continua

#endif
