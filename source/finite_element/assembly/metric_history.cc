#include <continua/finite_element/assembly/metric_history.h>

#include <continua/continuum/stress_and_strain.h>

#include <deal.II/dofs/dof_renumbering.h>
#include <deal.II/dofs/dof_tools.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Continua
{
using namespace dealii;

namespace
{
bool is_positive_definite(const SymmetricTensor<2, 3> &tensor)
{
  // What is no number fails the comparisons.
  return first_invariant(tensor) > 0. && second_invariant(tensor) > 0. &&
         third_invariant(tensor) > 0.;
}
} // namespace

template <int dim>
std::unique_ptr<MetricHistory<dim>> MetricHistory<dim>::make(const Space<dim> &space,
                                                             const Problem &problem)
{
  const bool is_needed =
      problem.has_regions_of(RegionModel::finite_solid) &&
      std::any_of(problem.materials.begin(), problem.materials.end(),
                  [](const Material &material) { return material.shear.relaxes(); });
  return std::unique_ptr<MetricHistory>(is_needed ? new MetricHistory(space, problem) : nullptr);
}

template <int dim>
MetricHistory<dim>::MetricHistory(const Space<dim> &space, const Problem &problem)
    : space(space),
      n_points(space.quadrature(space.n_quadrature_points()).size()),
      dof_handler(space.triangulation)
{
  std::size_t n_branches = 0;
  for (const Material &material : problem.materials)
  {
    branches.emplace_back();
    for (const Branch &branch : material.shear.branches)
      if (!std::isinf(branch.relaxation_time))
        branches.back().push_back(branch);
    n_branches = std::max(n_branches, branches.back().size());
    balanced_weights.emplace_back(branches.back().size(), MetricWeights(0.));
  }
  step_weights = balanced_weights;
  metrics.resize(n_branches);
  elements.push_back(space.no_element(n_stresses<dim>()));
  elements.push_back(space.element_at_points(space.n_quadrature_points(), n_stresses<dim>()));
}

template <int dim>
void MetricHistory<dim>::reinit()
{
  for (const auto &cell : dof_handler.active_cell_iterators())
    if (cell->is_locally_owned())
      cell->set_active_fe_index(relaxes(cell->material_id()) ? 1 : 0);
  dof_handler.distribute_dofs(elements);
  DoFRenumbering::hierarchical(dof_handler);
  owned = dof_handler.locally_owned_dofs();
  DoFTools::extract_locally_relevant_dofs(dof_handler, relevant);

  const unsigned int n_cells = space.triangulation.n_active_cells();
  places.assign(n_cells, {});
  predictions.assign(n_cells, {});
  std::vector<types::global_dof_index> indices;
  for (const auto &cell : dof_handler.active_cell_iterators())
    if (cell->is_locally_owned() && relaxes(cell->material_id()))
    {
      const FiniteElement<dim> &element = cell->get_fe();
      indices.resize(element.n_dofs_per_cell());
      cell->get_dof_indices(indices);
      std::vector<unsigned int> &of_cell = places[cell->active_cell_index()];
      of_cell.resize(indices.size());
      for (unsigned int i = 0; i < indices.size(); ++i)
      {
        const auto [component, q] = element.system_to_component_index(i);
        of_cell[q * n_stresses<dim>() + component] = owned.index_within_set(indices[i]);
      }
      predictions[cell->active_cell_index()].resize(n_points);
    }
}

template <int dim>
DistributedVector MetricHistory<dim>::vector() const
{
  return DistributedVector(owned, space.communicator);
}

template <int dim>
VectorNumbering MetricHistory<dim>::numbering() const
{
  return VectorNumbering(space.communicator, "internal metric", numbers_of_dofs(dof_handler));
}

template <int dim>
void MetricHistory<dim>::visit(StateVisitor &visitor)
{
  for (unsigned int k = 0; k < metrics.size(); ++k)
    visitor.vector({"internal metric", k}, StateKind::internal_metric, metrics[k]);
  visitor.vector("inverse of the last metric", StateKind::internal_metric, inverses);
}

template <int dim>
SymmetricTensor<2, 3> MetricHistory<dim>::get(const DistributedVector &vector,
                                              const unsigned int cell,
                                              const unsigned int q) const
{
  const double *const entries = vector.begin();
  const unsigned int *const of_point = places[cell].data() + q * n_stresses<dim>();
  Tensor tensor;
  for (unsigned int k = 0; k < n_stresses<dim>(); ++k)
    tensor[stress_pairs[k][0]][stress_pairs[k][1]] = entries[of_point[k]];
  return tensor;
}

template <int dim>
void MetricHistory<dim>::set(DistributedVector &vector,
                             const unsigned int cell,
                             const unsigned int q,
                             const Tensor &tensor) const
{
  double *const entries = vector.begin();
  const unsigned int *const of_point = places[cell].data() + q * n_stresses<dim>();
  for (unsigned int k = 0; k < n_stresses<dim>(); ++k)
    entries[of_point[k]] = tensor[stress_pairs[k][0]][stress_pairs[k][1]];
}

template <int dim>
void MetricHistory<dim>::start(const unsigned int cell, const unsigned int q, const Tensor &inverse)
{
  for (DistributedVector &metric : metrics)
    set(metric, cell, q, inverse);
  set(inverses, cell, q, inverse);
}

template <int dim>
void MetricHistory<dim>::predict(const Step &step)
{
  // What the body comes to at rest does not depend on how long the steps on the way there are.
  const double size =
      step.finds_steady_state ? std::numeric_limits<double>::infinity() : step.size();
  for (std::size_t region = 0; region < branches.size(); ++region)
    for (std::size_t k = 0; k < branches[region].size(); ++k)
    {
      const double ratio = size / branches[region][k].relaxation_time;
      balanced_weights[region][k] = MetricWeights(step.extrapolate ? 0.5 * ratio : ratio);
      step_weights[region][k] = MetricWeights(ratio);
    }
  for (const auto &cell : space.triangulation.active_cell_iterators())
  {
    const unsigned int number = cell->active_cell_index();
    if (places[number].empty())
      continue;
    const unsigned int region = cell->material_id();
    for (unsigned int q = 0; q < n_points; ++q)
    {
      const Tensor inverse = get(inverses, number, q);
      Tensor &sum = predictions[number][q];
      sum = 0.;
      for (std::size_t k = 0; k < branches[region].size(); ++k)
        sum += branches[region][k].shear_modulus *
               kept_metric(balanced_weights[region][k], get(metrics[k], number, q), inverse);
    }
  }
}

template <int dim>
double MetricHistory<dim>::dissipation(const unsigned int region,
                                       const unsigned int cell,
                                       const unsigned int q,
                                       const PointStrain &strain) const
{
  const Tensor old_inverse = get(inverses, cell, q), inverse = inverse_isochoric_metric(strain);
  double sum = 0.;
  for (std::size_t k = 0; k < branches[region].size(); ++k)
  {
    const MetricWeights &weights = balanced_weights[region][k];
    const Tensor metric =
        new_metric(weights, kept_metric(weights, get(metrics[k], cell, q), old_inverse), inverse);
    sum += metric_dissipation(branches[region][k].shear_modulus,
                              branches[region][k].relaxation_time, strain, metric);
  }
  return sum;
}

template <int dim>
void MetricHistory<dim>::advance(const unsigned int region,
                                 const unsigned int cell,
                                 const unsigned int q,
                                 const Tensor &inverse)
{
  const Tensor old_inverse = get(inverses, cell, q);
  for (std::size_t k = 0; k < branches[region].size(); ++k)
  {
    const MetricWeights &weights = step_weights[region][k];
    set(metrics[k], cell, q,
        new_metric(weights, kept_metric(weights, get(metrics[k], cell, q), old_inverse), inverse));
  }
  set(inverses, cell, q, inverse);
}

template <int dim>
double MetricHistory<dim>::energy(const unsigned int region,
                                  const unsigned int cell,
                                  const unsigned int q,
                                  const PointStrain &strain) const
{
  double sum = 0.;
  for (std::size_t k = 0; k < branches[region].size(); ++k)
    sum += metric_energy(branches[region][k].shear_modulus, strain, get(metrics[k], cell, q));
  return sum;
}

template <int dim>
void MetricHistory<dim>::prepare_transfer(const std::vector<DistributedVector *> &vectors)
{
  old_vectors.clear();
  for (const DistributedVector *const vector : vectors)
    old_vectors.push_back(*vector);
  std::vector<const DistributedVector *> pointers;
  for (const DistributedVector &vector : old_vectors)
    pointers.push_back(&vector);
  transfer = std::make_unique<Transfer>(dof_handler);
  transfer->prepare_for_coarsening_and_refinement(pointers);
}

template <int dim>
void MetricHistory<dim>::finish_transfer(const std::vector<DistributedVector *> &vectors)
{
  std::vector<DistributedVector *> targets = vectors;
  transfer->interpolate(targets);
  transfer.reset();
  old_vectors.clear();
  for (DistributedVector *const vector : vectors)
    restore_positivity(*vector);
}

template <int dim>
void MetricHistory<dim>::restore_positivity(DistributedVector &vector) const
{
  const Quadrature<dim> quadrature = space.quadrature(space.n_quadrature_points());
  for (unsigned int cell = 0; cell < places.size(); ++cell)
  {
    if (places[cell].empty())
      continue;
    Tensor mean;
    bool is_positive = true;
    for (unsigned int q = 0; q < n_points; ++q)
    {
      const Tensor tensor = get(vector, cell, q);
      is_positive = is_positive && is_positive_definite(tensor);
      mean += quadrature.weight(q) * tensor;
    }
    if (is_positive)
      continue;
    if (!is_positive_definite(mean))
      mean = unit_symmetric_tensor<3>();
    for (unsigned int q = 0; q < n_points; ++q)
      set(vector, cell, q, mean);
  }
}

template <int dim>
DistributedVector MetricHistory<dim>::ghosted_mixture() const
{
  DistributedVector mixture = vector();
  for (const auto &cell : space.triangulation.active_cell_iterators())
  {
    const unsigned int number = cell->active_cell_index();
    if (places[number].empty())
      continue;
    for (unsigned int q = 0; q < n_points; ++q)
    {
      const std::vector<Branch> &of_region = branches[cell->material_id()];
      Tensor sum;
      for (std::size_t k = 0; k < of_region.size(); ++k)
        sum += of_region[k].shear_modulus * get(metrics[k], number, q);
      set(mixture, number, q, sum);
    }
  }
  DistributedVector ghosted(owned, relevant, space.communicator);
  ghosted = mixture;
  return ghosted;
}

template <int dim>
typename MetricHistory<dim>::PointWeights
MetricHistory<dim>::weights_at(const typename Triangulation<dim>::cell_iterator &cell,
                               const Point<dim> &unit_point) const
{
  PointWeights result;
  if (!relaxes(cell->material_id()))
    return result;
  const typename DoFHandler<dim>::active_cell_iterator own_cell(&space.triangulation, cell->level(),
                                                                cell->index(), &dof_handler);
  const FiniteElement<dim> &element = own_cell->get_fe();
  std::vector<types::global_dof_index> indices(element.n_dofs_per_cell());
  own_cell->get_dof_indices(indices);
  result.indices.resize(n_stresses<dim>(), std::vector<types::global_dof_index>(n_points));
  result.weights.resize(n_points);
  for (unsigned int i = 0; i < indices.size(); ++i)
  {
    const auto [component, q] = element.system_to_component_index(i);
    result.indices[component][q] = indices[i];
    if (component == 0)
      result.weights[q] = element.shape_value(i, unit_point);
  }
  return result;
}

template <int dim>
SymmetricTensor<2, 3> MetricHistory<dim>::mixture_at(const PointWeights &weights,
                                                     const DistributedVector &mixture)
{
  Tensor tensor;
  for (unsigned int k = 0; k < weights.indices.size(); ++k)
  {
    double sum = 0.;
    for (unsigned int q = 0; q < weights.weights.size(); ++q)
      sum += weights.weights[q] * mixture(weights.indices[k][q]);
    tensor[stress_pairs[k][0]][stress_pairs[k][1]] = sum;
  }
  return tensor;
}

template class MetricHistory<2>;
template class MetricHistory<3>;
} // namespace Continua
