#ifndef continua_finite_element_assembly_wall_potentials_h
#define continua_finite_element_assembly_wall_potentials_h

#include <continua/continuum/wall_directions_parameters.h>
#include <continua/finite_element/space/space.h>
#include <continua/linear_algebra/distributed_vector.h>

namespace Continua
{
/**
 * Two solutions of Laplace's equation on the mesh, whose slopes show what is along a wall and what
 * is across it: from 0 where the wall begins to 1 where it ends, and from 0 at its inside to 1 at
 * its outside; no flux through other boundaries. They are the components x and y of a vector of the
 * velocity's elements, so that it is evaluated as any vector.
 */
template <int dim>
class WallPotentials
{
public:
  /// Both must outlive it.
  WallPotentials(const Space<dim> &space, const WallDirectionsParameters &parameters);

  /// Solves on the present mesh, if the parameters ask for potentials. Throws RunError. Collective.
  void reinit();
  bool exist() const { return parameters.has_potentials(); }
  /// Both [1]; owned entries.
  const DistributedVector &potentials() const { return solution; }

private:
  const Space<dim> &space;
  const WallDirectionsParameters &parameters;
  DistributedVector solution;

  void set_constraints(dealii::AffineConstraints<double> &constraints) const;
};
} // namespace Continua

#endif
