#ifndef continua_finite_element_looking_field_evaluation_h
#define continua_finite_element_looking_field_evaluation_h

#include <continua/continuum/field_probes.h>
#include <continua/continuum/problem.h>
#include <continua/continuum/state.h>
#include <continua/continuum/stress_and_strain.h>
#include <continua/finite_element/looking/field_samples.h>
#include <continua/finite_element/looking/probe_values.h>
#include <continua/finite_element/looking/section_flow.h>
#include <continua/finite_element/space/space.h>
#include <continua/mesh/plane_section.h>

#include <deal.II/fe/fe_values.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace Continua
{
/// The probes of the Taylor-Hood discretisation, with hanging nodes resolved, and other values of
/// its fields.
template <int dim>
class FieldEvaluation : public FieldProbes<dim>
{
public:
  /// As for SampledState.
  FieldEvaluation(const Space<dim> &space,
                  const Problem &problem,
                  const MetricHistory<dim> *metrics = nullptr);

  /// The mixture eta U + sum_k mu_k D_k of a material with ghosts, for evaluation on cells [Pa m].
  DistributedVector ghosted_mixture(const State &state, unsigned int region) const;
  /// L2 norm of the difference to functions; see ContinuumSolver::error_norm.
  double error_norm(const State &state,
                    ComparedField field,
                    const std::vector<Expression> &exact,
                    double time) const;

private:
  using Collector = ProbeWeights::Collector;
  using Source = ProbeWeights::Source;
  using CellIterator = typename dealii::Triangulation<dim>::cell_iterator;
  using Sample = typename FieldProbes<dim>::Sample;

  Collector collector() const override;
  double add_point(const ProbeRequest<dim> &request,
                   const FieldDefinition<dim> &field,
                   Collector &collector) const override;
  double add_boundary(const ProbeRequest<dim> &request,
                      const FieldDefinition<dim> &field,
                      Collector &collector) const override;
  double add_section(const ProbeRequest<dim> &request,
                     const FieldDefinition<dim> &field,
                     Collector &collector) const override;
  double add_volume(const ProbeRequest<dim> &request,
                    const FieldDefinition<dim> &field,
                    Collector &collector) const override;
  double add_interface(const ProbeRequest<dim> &request, Collector &collector) const override;
  double add_force(const ProbeRequest<dim> &request, Collector &collector) const override;
  double add_flow(const ProbeRequest<dim> &request, Collector &collector) const override;
  bool needs_samples(const ProbeRequest<dim> &request,
                     const FieldDefinition<dim> &field) const override;
  void begin_samples(unsigned int probe) override;
  void end_samples() override { probe_values.fill(nullptr); }
  bool follows_mesh(const ProbeRequest<dim> &request,
                    const FieldDefinition<dim> &field) const override;
  void take_state(const State &state) override;
  void sample(unsigned int probe, std::vector<Sample> &samples) const override;
  /// Forgets what belongs to the mesh before.
  void forget_mesh() override;
  /// Whether the face of the cell is one of the boundaries or of the interface.
  bool
  has_face(const ProbeRequest<dim> &request, const CellIterator &cell, unsigned int face) const;
  /// Of a probe that follows the mesh, else at rest; of a line the direction is that of the rim's
  /// normal in its plane.
  SampledShare share(const ProbeRequest<dim> &request,
                     const FieldDefinition<dim> &field,
                     const dealii::Tensor<1, dim> &direction) const;

  /// The samples of a probe.
  struct Samples
  {
    FieldDefinition<dim> field;
    unsigned int coordinate;
    FieldSamples<dim> points;
  };

  using FieldProbes<dim>::problem;
  const Space<dim> &space;
  const MetricHistory<dim> *metrics;
  ProbeValues<dim> probe_values; ///< with samples while a probe that has them is set up
  SampledState<dim> sampled_state;
  bool has_sampled_state = false; ///< with vectors of the present mesh
  /// Of a mesh that moves, with ghosts; empty before a state is taken [m].
  DistributedVector mesh_displacement;
  /// By probe: on a mesh that moves they are asked for again and again.
  mutable std::map<unsigned int, std::unique_ptr<SectionFlow<dim>>> flows_of_probes;
  std::map<unsigned int, Samples> samples_of_probes;
};
} // namespace Continua

#endif
