#ifndef continua_continuum_prescribed_velocities_h
#define continua_continuum_prescribed_velocities_h

#include <continua/linear_algebra/distributed_vector.h>

namespace Continua
{
/// The velocities that boundary conditions prescribe, on the present mesh. Vectors are the owned
/// entries of velocities [m/s].
class PrescribedVelocities
{
public:
  virtual ~PrescribedVelocities() = default;

  /// Whether a prescribed velocity jumps between the two times [s].
  virtual bool jumps(double begin, double end) const = 0;
  /// Whether every prescribed velocity is zero for ever.
  virtual bool is_homogeneous() const = 0;
  /// The prescribed velocities at this time [s], 0 elsewhere; `values` keeps what does not depend
  /// on time.
  virtual void evaluate(double time, DistributedVector &values) const = 0;
  /// Copies the prescribed entries of a velocity that obeys the conditions into `values`; others
  /// stay as they are.
  virtual void prescribed_part(const DistributedVector &velocity,
                               DistributedVector &values) const = 0;
  /// Sets what is prescribed of a velocity to zero, as the error of a velocity has it.
  virtual void clear_prescribed(DistributedVector &velocity) const = 0;
  /// Sets what is prescribed of a velocity; for equations that are not linear.
  virtual void set_prescribed(const DistributedVector &prescribed,
                              DistributedVector &velocity) const = 0;
};
} // namespace Continua

#endif
