#ifndef continua_finite_volume_held_cells_h
#define continua_finite_volume_held_cells_h

#include <continua/finite_volume/cell_wise_system.h>
#include <continua/linear_algebra/unsymmetric_factor.h>

#include <memory>
#include <vector>

namespace Continua
{
/**
 * The equations of CellWiseSystem with the velocities of all cells given: what the faces with
 * values of their own, and the pressures, are when the cells are where they are. Other values may
 * be held, too.
 */
template <int dim>
class HeldCells
{
public:
  explicit HeldCells(const CellWiseSystem<dim> &system) : system(system) {}

  /// Makes the factor. By local value: the faces' velocities and the pressures that are held
  /// besides; empty is none. Throws RunError if the equations are singular.
  void reinit(const std::vector<bool> &velocity_is_held, const std::vector<bool> &pressure_is_held);
  /// In: right sides, and in `velocity` and `pressure` what is held. Out: all values.
  void solve(const DistributedVector &momentum,
             const DistributedVector &mass,
             DistributedVector &velocity,
             DistributedVector &pressure);

private:
  const CellWiseSystem<dim> &system;
  std::unique_ptr<UnsymmetricFactor> factor;
  std::vector<bool> is_held; ///< by local row
  std::vector<double> packed;
};
} // namespace Continua

#endif
