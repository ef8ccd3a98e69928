#ifndef continua_continuum_state_vectors_h
#define continua_continuum_state_vectors_h

#include <continua/continuum/state_visitor.h>

#include <vector>

namespace Continua
{
/// Gives the vectors of the state the layout of the present mesh, and zeros. Histories must know
/// the mesh already.
class StateSizes : public StateVisitor
{
public:
  /// Vectors of either kind on the present mesh.
  StateSizes(const DistributedVector &velocity, const DistributedVector &pressure)
      : velocity(velocity), pressure(pressure)
  {
  }
  bool takes_vectors() const override { return true; }
  void levels(const StateName &name,
              StateKind kind,
              DistributedVector &present,
              DistributedVector &older) override;
  void vector(const StateName &name, StateKind kind, DistributedVector &vector) override;
  void levels(const StateName &, double *, double *, std::size_t) override {}
  using StateVisitor::value;
  void value(const StateName &, double &) override {}

private:
  const DistributedVector &velocity, &pressure;
};

/// The vectors of the state, which a change of the mesh carries over.
class StateVectors : public StateVisitor
{
public:
  std::vector<DistributedVector *> velocities, pressures;

  bool takes_vectors() const override { return true; }
  void levels(const StateName &name,
              StateKind kind,
              DistributedVector &present,
              DistributedVector &older) override;
  void vector(const StateName &name, StateKind kind, DistributedVector &vector) override;
  void levels(const StateName &, double *, double *, std::size_t) override {}
  using StateVisitor::value;
  void value(const StateName &, double &) override {}
};
} // namespace Continua

#endif
