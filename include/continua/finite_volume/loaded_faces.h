#ifndef continua_finite_volume_loaded_faces_h
#define continua_finite_volume_loaded_faces_h

#include <continua/finite_volume/cell_wise_system.h>
#include <continua/finite_volume/held_cells.h>

#include <memory>
#include <vector>

namespace Continua
{
/**
 * What faces with values of their own do at once when the forces on them jump. They have no mass:
 * with the cells where they are, a displacement of the faces of springs, and the pressures that go
 * with it, take up the jump. A jump that is left to the next step instead makes their velocities
 * ring for ever under the trapezoidal rule. A solid with a dash pot does not deform at once, nor
 * does a fluid.
 */
template <int dim>
class LoadedFaces
{
public:
  LoadedFaces(const CellWiseSpace<dim> &space,
              const Problem &problem,
              const FaceConditions<dim> &conditions,
              const std::vector<CellWiseOperators> &operators,
              const PressureClosure &closure,
              const CellWiseParameters &parameters);

  /// The mesh has changed.
  void reinit();
  /// Whether there is anything that deforms at once.
  bool exist() const;
  /// The displacement of faces [m] and the change of pressures [Pa] that take up forces on the
  /// faces [N]; forces on cells, and in directions of prescribed velocity, do not count. `forces`
  /// is changed.
  void
  respond(DistributedVector &forces, DistributedVector &displacement, DistributedVector &pressure);

private:
  const CellWiseSpace<dim> &space;
  const Problem &problem;
  const FaceConditions<dim> &conditions;
  const PressureClosure &closure;
  CellWiseSystem<dim> system;           ///< of the body at rest, by instantaneous moduli
  std::unique_ptr<HeldCells<dim>> held; ///< made when it is asked for

  bool deforms_at_once(unsigned int region) const;
  void make();
};
} // namespace Continua

#endif
