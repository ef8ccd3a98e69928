#ifndef continua_continuum_solid_nodes_h
#define continua_continuum_solid_nodes_h

#include <continua/continuum/operators.h>
#include <continua/continuum/problem.h>

#include <vector>

namespace Continua
{
/// The velocity nodes of solids on the present mesh.
class SolidNodes
{
public:
  /// Both must outlive it.
  SolidNodes(const Problem &problem, const Operators &operators);

  /// Sets the entries of an owned vector at nodes of materials with branches to zero, or at all
  /// other nodes, or at nodes of solids in finite deformation.
  void clear(DistributedVector &vector) const;
  void clear_others(DistributedVector &vector) const;
  void clear_finite(DistributedVector &vector) const;

private:
  const Problem &problem;
  const Operators &operators;

  /// Of each owned entry: whether a material with branches has it.
  std::vector<bool> have_branches(const DistributedVector &vector) const;
};
} // namespace Continua

#endif
