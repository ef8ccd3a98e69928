#ifndef continua_continuum_state_vectors_h
#define continua_continuum_state_vectors_h

#include <continua/continuum/state_visitor.h>

#include <vector>

namespace Continua
{
/// A visitor to whom the state is its vectors, all alike; numbers are left as they are.
class VectorsVisitor : public StateVisitor
{
public:
  bool takes_vectors() const final { return true; }
  void levels(const StateName &name,
              const StateKind kind,
              DistributedVector &present,
              DistributedVector &older) final
  {
    vector(name, kind, present);
    vector(name, kind, older);
  }
  void levels(const StateName &, double *, double *, std::size_t) final {}
  using StateVisitor::value;
  void value(const StateName &, double &) final {}
};

/// Gives the vectors of the state the layout of the present mesh, and zeros. Histories must know
/// the mesh already.
class StateSizes : public VectorsVisitor
{
public:
  /// Vectors of each kind on the present mesh.
  StateSizes(const DistributedVector &velocity,
             const DistributedVector &pressure,
             const DistributedVector &internal_metric,
             const DistributedVector &mesh_vertex)
      : velocity(velocity),
        pressure(pressure),
        internal_metric(internal_metric),
        mesh_vertex(mesh_vertex)
  {
  }
  void vector(const StateName &name, StateKind kind, DistributedVector &vector) override;

private:
  const DistributedVector &velocity, &pressure, &internal_metric, &mesh_vertex;
};

/// The vectors of the state, which a change of the mesh carries over.
class StateVectors : public VectorsVisitor
{
public:
  std::vector<DistributedVector *> velocities, pressures, internal_metrics, mesh_vertices;

  void vector(const StateName &name, StateKind kind, DistributedVector &vector) override;
};
} // namespace Continua

#endif
