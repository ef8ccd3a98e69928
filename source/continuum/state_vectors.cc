#include <continua/continuum/state_vectors.h>

namespace Continua
{
void StateSizes::vector(const StateName &, const StateKind kind, DistributedVector &vector)
{
  switch (kind)
  {
  case StateKind::velocity:
    vector.reinit(velocity);
    break;
  case StateKind::pressure:
    vector.reinit(pressure);
    break;
  case StateKind::internal_metric:
    vector.reinit(internal_metric);
    break;
  case StateKind::mesh_vertex:
    vector.reinit(mesh_vertex);
    break;
  }
}

void StateVectors::vector(const StateName &, const StateKind kind, DistributedVector &vector)
{
  switch (kind)
  {
  case StateKind::velocity:
    velocities.push_back(&vector);
    break;
  case StateKind::pressure:
    pressures.push_back(&vector);
    break;
  case StateKind::internal_metric:
    internal_metrics.push_back(&vector);
    break;
  case StateKind::mesh_vertex:
    mesh_vertices.push_back(&vector);
    break;
  }
}
} // namespace Continua
