#ifndef continua_finite_volume_cell_wise_prescribed_h
#define continua_finite_volume_cell_wise_prescribed_h

#include <continua/continuum/prescribed_velocities.h>
#include <continua/finite_volume/face_conditions.h>
#include <continua/finite_volume/swept_volumes.h>

namespace Continua
{
/// The prescribed velocities of boundary faces. On a mesh that moves a liquid at a wall has the
/// velocity by which the wall's face sweeps its volume.
template <int dim>
class CellWisePrescribed : public PrescribedVelocities
{
public:
  /// Both must outlive it.
  CellWisePrescribed(const FaceConditions<dim> &conditions, const SweptVolumes<dim> &swept_volumes)
      : conditions(conditions), swept_volumes(swept_volumes)
  {
  }

  bool jumps(const double begin, const double end) const override
  {
    return conditions.jumps(begin, end);
  }
  bool is_homogeneous() const override { return conditions.is_homogeneous(); }
  void evaluate(const double time, DistributedVector &values) const override
  {
    conditions.evaluate(time, values);
    conditions.follow(swept_volumes, values);
  }
  void prescribed_part(const DistributedVector &velocity, DistributedVector &values) const override
  {
    conditions.prescribed_part(velocity, values);
  }
  void clear_prescribed(DistributedVector &velocity) const override
  {
    conditions.clear_prescribed(velocity);
  }
  void set_prescribed(const DistributedVector &prescribed,
                      DistributedVector &velocity) const override
  {
    conditions.set_prescribed(prescribed, velocity);
  }

private:
  const FaceConditions<dim> &conditions;
  const SweptVolumes<dim> &swept_volumes;
};
} // namespace Continua

#endif
