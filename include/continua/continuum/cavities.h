#ifndef continua_continuum_cavities_h
#define continua_continuum_cavities_h

#include <continua/linear_algebra/distributed_vector.h>

#include <vector>

namespace Continua
{
/// The cavities that the walls of the problem enclose.
class Cavities
{
public:
  virtual ~Cavities() = default;

  /// Their volumes at this displacement [m^3].
  virtual std::vector<double> volumes(const DistributedVector &displacement) = 0;
  /// Sets the derivative of the volume of a cavity by the displacement and the forces of a pressure
  /// of 1 Pa in it, both [m^2].
  virtual void linearise(unsigned int cavity,
                         const DistributedVector &displacement,
                         DistributedVector &derivative,
                         DistributedVector &force) = 0;
};
} // namespace Continua

#endif
