#include <continua/continuum/state_vectors.h>

namespace Continua
{
void StateSizes::vector(const StateName &, const StateKind kind, DistributedVector &vector)
{
  vector.reinit(kind == StateKind::velocity ? velocity : pressure);
}

void StateVectors::vector(const StateName &, const StateKind kind, DistributedVector &vector)
{
  (kind == StateKind::velocity ? velocities : pressures).push_back(&vector);
}
} // namespace Continua
