#ifndef continua_continuum_field_probes_h
#define continua_continuum_field_probes_h

#include <continua/continuum/continuum_solver.h>
#include <continua/continuum/field_list.h>
#include <continua/continuum/probe_weights.h>
#include <continua/continuum/problem.h>

#include <vector>

namespace Continua
{
/**
 * The probes of a discretisation. Each is linear in the state, so it is set up once on a mesh, by
 * what the discretisation says of its fields at points, and read by a short sum.
 */
template <int dim>
class FieldProbes
{
public:
  explicit FieldProbes(const Problem &problem);
  virtual ~FieldProbes() = default;

  /// See ContinuumSolver::add_probe.
  unsigned int add(const ProbeRequest<dim> &request);
  /// Sets the probes up again on a new mesh.
  void rebuild();
  /// Whether any is a force.
  bool asks_for_forces() const;
  /// The values of all, in the order in which they were added, on every rank. `forces`: what the
  /// equations leave at the nodes; null if no probe asks for them.
  void
  evaluate(const State &state, const DistributedVector *forces, std::vector<double> &values) const;

protected:
  using Collector = ProbeWeights::Collector;

  const Problem &problem;

  /// Whether the request counts that region's side.
  static bool counts(const ProbeRequest<dim> &request, unsigned int region);

private:
  struct Probe
  {
    ProbeRequest<dim> request;
    FieldDefinition<dim> field;
    ProbeWeights weights;
  };

  virtual Collector collector() const = 0;
  /// Each adds the values of the field at points times their weights; returns what the weights add
  /// up to over all ranks, 0 if there is no point.
  virtual double add_point(const ProbeRequest<dim> &request,
                           const FieldDefinition<dim> &field,
                           Collector &collector) const = 0;
  virtual double add_boundary(const ProbeRequest<dim> &request,
                              const FieldDefinition<dim> &field,
                              Collector &collector) const = 0;
  virtual double add_section(const ProbeRequest<dim> &request,
                             const FieldDefinition<dim> &field,
                             Collector &collector) const = 0;
  virtual double add_volume(const ProbeRequest<dim> &request,
                            const FieldDefinition<dim> &field,
                            Collector &collector) const = 0;
  /// Of a field that has a direction: the displacement along the normal that points out of the
  /// regions, on their surface with other regions.
  virtual double add_interface(const ProbeRequest<dim> &request, Collector &collector) const = 0;
  /// Of forces, which have no field: the nodes of the boundaries; returns their number.
  virtual double add_force(const ProbeRequest<dim> &request, Collector &collector) const = 0;
  /// The flow rate; 0 if the plane misses the regions.
  virtual double add_flow(const ProbeRequest<dim> &request, Collector &collector) const = 0;
  void build(Probe &probe) const;

  const std::vector<FieldDefinition<dim>> definitions;
  std::vector<Probe> probes;
  mutable std::vector<double> sums; ///< work space
};
} // namespace Continua

#endif
