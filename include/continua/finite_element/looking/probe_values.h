#ifndef continua_finite_element_looking_probe_values_h
#define continua_finite_element_looking_probe_values_h

#include <continua/continuum/field_probes.h>
#include <continua/continuum/problem.h>
#include <continua/finite_element/looking/field_samples.h>
#include <continua/finite_element/space/space.h>
#include <continua/linear_algebra/distributed_vector.h>

#include <deal.II/base/quadrature.h>
#include <deal.II/base/tensor.h>
#include <deal.II/fe/fe_values.h>

#include <array>
#include <vector>

namespace Continua
{
/// Adds the value of a field at points of cells to a probe: as weights of the unknowns, with
/// hanging nodes resolved, or as samples.
template <int dim>
class ProbeValues
{
public:
  using Collector = ProbeWeights::Collector;
  using CellIterator = typename dealii::Triangulation<dim>::cell_iterator;

  /// Both must outlive it.
  ProbeValues(const Space<dim> &space, const Problem &problem) : space(space), problem(problem) {}

  /// Values become samples of these, which must outlive their use; null: weights.
  void fill(FieldSamples<dim> *samples) { samples_to_fill = samples; }

  /// Adds the field at points of the unit cell times weights.
  void add_at(const FieldDefinition<dim> &field,
              const CellIterator &cell,
              const dealii::Quadrature<dim> &points,
              const std::vector<double> &weights,
              Collector &collector,
              const std::vector<SampledShare> &shares) const;
  /// Adds the field at a quadrature point times a weight; `normal`: out of the cell, for fields of
  /// walls.
  void add(const FieldDefinition<dim> &field,
           const CellIterator &cell,
           const dealii::FEValuesBase<dim> &values,
           const dealii::FEValuesBase<dim> &pressure_values,
           unsigned int q,
           double weight,
           Collector &collector,
           const SampledShare &share,
           const dealii::Tensor<1, dim> &normal = dealii::Tensor<1, dim>()) const;

private:
  using Source = ProbeWeights::Source;
  using Quantity = typename FieldDefinition<dim>::Quantity;
  /// Of the components of a field.
  using Factors = std::array<double, 6>;

  const Space<dim> &space;
  const Problem &problem;
  FieldSamples<dim> *samples_to_fill = nullptr;

  /// A velocity or a displacement.
  void add_vector(Quantity quantity,
                  const CellIterator &cell,
                  const dealii::FEValuesBase<dim> &values,
                  unsigned int q,
                  double weight,
                  const Factors &factors,
                  Collector &collector) const;
  /// What is linear in a gradient: strain, vorticity, and the part of the stress besides the
  /// pressure.
  void add_gradient(Quantity quantity,
                    const CellIterator &cell,
                    const dealii::FEValuesBase<dim> &values,
                    unsigned int q,
                    double weight,
                    const Factors &factors,
                    Collector &collector) const;
  void add_pressure(const CellIterator &cell,
                    const dealii::FEValuesBase<dim> &pressure_values,
                    unsigned int q,
                    double weight,
                    Collector &collector) const;
  std::vector<dealii::types::global_dof_index> velocity_indices(const CellIterator &cell) const;
};
} // namespace Continua

#endif
