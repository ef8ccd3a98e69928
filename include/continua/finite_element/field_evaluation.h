#ifndef continua_finite_element_field_evaluation_h
#define continua_finite_element_field_evaluation_h

#include <continua/continuum/field_probes.h>
#include <continua/continuum/problem.h>
#include <continua/continuum/state.h>
#include <continua/continuum/stress_and_strain.h>
#include <continua/finite_element/space.h>

#include <deal.II/fe/fe_values.h>

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
  FieldEvaluation(const Space<dim> &space, const Problem &problem);

  /// The mixture eta U + sum_k mu_k D_k of a material with ghosts, for evaluation on cells [Pa m].
  DistributedVector ghosted_mixture(const State &state, unsigned int region) const;
  /// L2 norm of the difference to functions; see ContinuumSolver::error_norm.
  double error_norm(const State &state,
                    const std::string &field,
                    const std::vector<Expression> &exact,
                    double time) const;

private:
  using Collector = ProbeWeights::Collector;
  using Source = ProbeWeights::Source;
  using CellIterator = typename dealii::Triangulation<dim>::cell_iterator;

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
  /// Adds the field at points of the unit cell, and at a quadrature point, times weights.
  void add_values(const FieldDefinition<dim> &field,
                  const CellIterator &cell,
                  const dealii::Quadrature<dim> &points,
                  const std::vector<double> &weights,
                  Collector &collector) const;
  void add_value(const FieldDefinition<dim> &field,
                 const CellIterator &cell,
                 const dealii::FEValuesBase<dim> &values,
                 const dealii::FEValuesBase<dim> &pressure_values,
                 unsigned int q,
                 double weight,
                 Collector &collector) const;

  using FieldProbes<dim>::problem;
  const Space<dim> &space;
};
} // namespace Continua

#endif
