#ifndef continua_continuum_field_probes_h
#define continua_continuum_field_probes_h

#include <continua/continuum/continuum_solver.h>
#include <continua/continuum/field_list.h>
#include <continua/continuum/probe_weights.h>
#include <continua/continuum/problem.h>

#include <functional>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace Continua
{
/**
 * The probes of a discretisation. Most are linear in the state: such a one is set up once on a
 * mesh, by what the discretisation says of its fields at points, and read by a short sum. Others
 * have samples: the discretisation keeps their points, and evaluates the field there each time, on
 * a mesh that moves also their weights. The weights of a flow rate through a mesh that moves are
 * made anew for each state.
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
  /// The weights of a probe that is linear in the state, on a mesh that stays. Throws
  /// std::invalid_argument for another one, and for a force.
  const ProbeWeights &weights_of(unsigned int probe) const;
  /// Whether any is a force.
  bool asks_for_forces() const;
  /// The regions of which forces on an interface are asked for.
  std::set<unsigned int> regions_of_forces() const;
  /// The values of all, in the order in which they were added, on every rank. `forces`: what the
  /// equations leave at the nodes, of the body, or of a region.
  void evaluate(
      const State &state,
      const std::function<const DistributedVector &(std::optional<unsigned int> region)> &forces,
      std::vector<double> &values);

protected:
  using Collector = ProbeWeights::Collector;

  const Problem &problem;

  /// A field at one of this rank's points of a probe.
  struct Sample
  {
    double weight;     ///< of the present shape if the probe follows the mesh
    double coordinate; ///< where changes of sign are looked for [m]
    double value;
  };

  /// What a probe is asked for, and its field.
  std::pair<const ProbeRequest<dim> &, const FieldDefinition<dim> &>
  definition(const unsigned int probe) const
  {
    return {probes[probe].request, probes[probe].field};
  }
  /// Whether the request counts that region's side.
  static bool counts(const ProbeRequest<dim> &request, unsigned int region);
  /// The number of the probe that is set up.
  unsigned int present_probe() const { return probe_being_built; }

private:
  struct Probe
  {
    ProbeRequest<dim> request;
    FieldDefinition<dim> field;
    ProbeWeights weights;
    bool is_sampled = false, follows_mesh = false;
    double factor = 1.; ///< of the sum over the samples of the undeformed body
    unsigned int cavity = 0;
  };

  /// The mesh is another one.
  virtual void forget_mesh() {}
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
  /// Of forces, which have no field: the nodes or the faces of the boundaries; returns a number or
  /// an area of them.
  virtual double add_force(const ProbeRequest<dim> &request, Collector &collector) const = 0;
  /// The flow rate; 0 if the plane misses the regions.
  virtual double add_flow(const ProbeRequest<dim> &request, Collector &collector) const = 0;

  /// Whether areas, volumes or weights are those of the present shape of a mesh that moves.
  virtual bool follows_mesh(const ProbeRequest<dim> &, const FieldDefinition<dim> &) const
  {
    return false;
  }

  // Samples; for discretisations that have them.
  /// Whether the number is no linear function of the state.
  virtual bool needs_samples(const ProbeRequest<dim> &, const FieldDefinition<dim> &) const
  {
    return false;
  }
  /// The functions above keep the points of this probe as samples, until end_samples(). Those of
  /// points that are fixed in space are found anew in each state that was taken.
  virtual void begin_samples(unsigned int /*probe*/) {}
  virtual void end_samples() {}
  /// A new state is to be sampled. Collective.
  virtual void take_state(const State &) {}
  /// This rank's samples of a probe in that state.
  virtual void sample(unsigned int /*probe*/, std::vector<Sample> & /*samples*/) const {}

  void build(unsigned int number);
  /// The number of the one cavity that the boundaries of a request enclose.
  unsigned int cavity_of(const ProbeRequest<dim> &request) const;
  /// Sets the weights or the samples up; returns what the weights of the points add up to.
  double set_points(unsigned int number, Collector &collector);
  double add_points(const Probe &probe, Collector &collector) const;
  /// The coordinate that is asked for, on all ranks.
  double sign_change(const ProbeRequest<dim> &request, const std::vector<Sample> &samples) const;

  const std::vector<FieldDefinition<dim>> definitions;
  std::vector<Probe> probes;
  unsigned int probe_being_built = 0;
  std::vector<double> sums; ///< work space
  std::vector<Sample> samples;
};
} // namespace Continua

#endif
