#include <continua/finite_element/field_evaluation.h>

#include <continua/mesh/cell_point.h>
#include <continua/mesh/plane_section.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/cell_id.h>
#include <deal.II/hp/fe_values.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace Continua
{
using namespace dealii;

template <int dim>
std::array<double, 6>
stress(const Tensor<2, dim> &gradient, const double hoop, const double pressure, const Model model)
{
  std::array<double, 6> result = {{0., 0., 0., 0., 0., 0.}};
  double diagonal[3] = {0., 0., 0.};
  for (unsigned int c = 0; c < dim; ++c)
    diagonal[c] = gradient[c][c];
  if (model == Model::axisymmetric)
    diagonal[2] = hoop;
  const double mean = (diagonal[0] + diagonal[1] + diagonal[2]) / 3.;
  for (unsigned int c = 0; c < 3; ++c)
    result[c] = 2. * (diagonal[c] - mean) - pressure;
  if (model == Model::plane_stress)
    result[2] = 0.;
  for (unsigned int k = 3; k < n_stresses<dim>(); ++k)
    result[k] = gradient[stress_pairs[k][0]][stress_pairs[k][1]] +
                gradient[stress_pairs[k][1]][stress_pairs[k][0]];
  return result;
}

template <int dim>
std::array<double, 6> strain(const Tensor<2, dim> &gradient,
                             const double hoop,
                             const Model model,
                             const Material &material)
{
  std::array<double, 6> result = {{0., 0., 0., 0., 0., 0.}};
  for (unsigned int c = 0; c < dim; ++c)
    result[c] = gradient[c][c];
  if (model == Model::axisymmetric)
    result[2] = hoop;
  if (model == Model::plane_stress)
    result[2] = material.thickness_strain_factor * (result[0] + result[1]);
  for (unsigned int k = 3; k < n_stresses<dim>(); ++k)
    result[k] = 0.5 * (gradient[stress_pairs[k][0]][stress_pairs[k][1]] +
                       gradient[stress_pairs[k][1]][stress_pairs[k][0]]);
  return result;
}

template <int dim>
Tensor<1, dim> traction(const std::array<double, 6> &stress, const Tensor<1, dim> &normal)
{
  Tensor<1, dim> result;
  for (unsigned int k = 0; k < 6; ++k)
  {
    const unsigned int i = stress_pairs[k][0], j = stress_pairs[k][1];
    if (i >= dim || j >= dim)
      continue;
    result[i] += stress[k] * normal[j];
    if (i != j)
      result[j] += stress[k] * normal[i];
  }
  return result;
}

/// Sums weights of any dofs over the ranks and keeps the owned ones.
template <int dim>
class FieldEvaluation<dim>::Collector
{
public:
  Collector(const Space<dim> &space, const unsigned int n_regions)
      : space(space),
        velocity(space.velocity_vector()),
        displacement(velocity),
        pressure(space.pressure_vector()),
        mixtures(n_regions, velocity)
  {
  }

  void add_velocity(const Source source,
                    const unsigned int region,
                    const types::global_dof_index dof,
                    const double weight)
  {
    DistributedVector &target =
        source == Source::velocity
            ? velocity
            : (source == Source::displacement ? displacement : mixtures[region]);
    space.velocity_hanging.distribute_local_to_global(dof, weight, target);
  }
  void add_pressure(const types::global_dof_index dof, const double weight)
  {
    space.pressure_hanging.distribute_local_to_global(dof, weight, pressure);
  }
  std::vector<Weights> finish(const double factor)
  {
    std::vector<Weights> all;
    const auto keep = [&](const Source source, const unsigned int region, DistributedVector &vector)
    {
      vector.compress(VectorOperation::add);
      Weights weights{source, region, {}, {}};
      for (unsigned int i = 0; i < vector.locally_owned_size(); ++i)
        if (vector.begin()[i] != 0.)
        {
          weights.indices.push_back(i);
          weights.values.push_back(factor * vector.begin()[i]);
        }
      if (!weights.indices.empty())
        all.push_back(weights);
    };
    keep(Source::velocity, 0, velocity);
    keep(Source::displacement, 0, displacement);
    keep(Source::pressure, 0, pressure);
    for (unsigned int region = 0; region < mixtures.size(); ++region)
      keep(Source::mixture, region, mixtures[region]);
    return all;
  }

private:
  const Space<dim> &space;
  DistributedVector velocity, displacement, pressure;
  std::vector<DistributedVector> mixtures;
};

template <int dim>
FieldEvaluation<dim>::FieldEvaluation(const Space<dim> &space, const Problem &problem)
    : space(space), problem(problem), definitions(field_list<dim>(problem.model))
{
}

template <int dim>
std::vector<FieldComponent> FieldEvaluation<dim>::fields(const Model model)
{
  std::vector<FieldComponent> list;
  for (const FieldDefinition<dim> &field : field_list<dim>(model))
    list.push_back(field.name);
  return list;
}

template <int dim>
unsigned int FieldEvaluation<dim>::add(const ProbeRequest<dim> &request)
{
  const auto field = std::find_if(definitions.begin(), definitions.end(),
                                  [&](const FieldDefinition<dim> &candidate)
                                  { return candidate.name.name == request.field; });
  if (field == definitions.end())
    throw std::invalid_argument("there is no field '" + request.field + "'");
  Probe probe{request, *field, {}};
  build(probe);
  probes.push_back(probe);
  return probes.size() - 1;
}

template <int dim>
void FieldEvaluation<dim>::rebuild()
{
  for (Probe &probe : probes)
    build(probe);
}

template <int dim>
void FieldEvaluation<dim>::build(Probe &probe) const
{
  using Kind = typename ProbeRequest<dim>::Kind;
  Collector collector(space, problem.regions.size());
  double measure = 0.;
  switch (probe.request.kind)
  {
  case Kind::point:
    measure = add_point(probe, collector);
    if (measure == 0.)
      throw std::invalid_argument("the point is not inside the mesh");
    break;
  case Kind::boundary_mean:
  case Kind::boundary_integral:
    measure = add_boundary(probe, collector);
    if (measure == 0.)
      throw std::invalid_argument("the boundary has no faces there");
    break;
  case Kind::section_mean:
  case Kind::section_integral:
  case Kind::rim_mean:
    measure = add_section(probe, collector);
    if (measure == 0.)
      throw std::invalid_argument("a section without area");
    break;
  }
  const bool integral =
      probe.request.kind == Kind::boundary_integral || probe.request.kind == Kind::section_integral;
  probe.weights = collector.finish(integral ? 1. : 1. / measure);
}

template <int dim>
bool FieldEvaluation<dim>::counts(const ProbeRequest<dim> &request, const CellIterator &cell) const
{
  return request.region_ids.empty() || request.region_ids.count(cell->material_id()) > 0;
}

template <int dim>
double FieldEvaluation<dim>::add_point(const Probe &probe, Collector &collector) const
{
  // Of all cells that hold the point, on whatever rank, the first by its identity: stress and
  // pressure do not depend on the partition.
  CellIterator chosen;
  Point<dim> unit_point;
  CellId chosen_id;
  bool found = false;
  for (const auto &cell : space.triangulation.active_cell_iterators())
    if (cell->is_locally_owned() && counts(probe.request, cell))
    {
      Point<dim> candidate;
      if (cell_holds_point<dim>(space.mapping, cell, probe.request.point, candidate) &&
          (!found || cell->id() < chosen_id))
      {
        found = true;
        chosen = cell;
        chosen_id = cell->id();
        unit_point = candidate;
      }
    }
  const auto all = Utilities::MPI::all_gather(
      space.communicator, std::make_pair(found, found ? chosen_id.to_string() : std::string()));
  bool anywhere = false, mine = found;
  for (const auto &other : all)
  {
    anywhere = anywhere || other.first;
    if (mine && other.first && CellId(other.second) < chosen_id)
      mine = false;
  }
  if (mine)
    add_values(probe.field, chosen, Quadrature<dim>(unit_point), {1.}, collector);
  return anywhere ? 1. : 0.;
}

template <int dim>
double FieldEvaluation<dim>::add_boundary(const Probe &probe, Collector &collector) const
{
  const QGauss<dim - 1> quadrature(space.n_quadrature_points());
  FEFaceValues<dim> values(space.mapping, space.velocity_element, quadrature,
                           update_values | update_gradients | update_quadrature_points |
                               update_JxW_values);
  hp::FEFaceValues<dim> pressure_values(space.mappings, space.pressure_elements,
                                        hp::QCollection<dim - 1>(quadrature), update_values);
  double area = 0.;
  for (const auto &cell : space.velocity_dofs.active_cell_iterators())
    if (cell->is_locally_owned() && counts(probe.request, cell))
      for (const unsigned int f : cell->face_indices())
        if (cell->face(f)->at_boundary() &&
            cell->face(f)->boundary_id() == probe.request.boundary_id)
        {
          values.reinit(cell, f);
          pressure_values.reinit(
              typename DoFHandler<dim>::active_cell_iterator(&space.triangulation, cell->level(),
                                                             cell->index(), &space.pressure_dofs),
              f);
          for (const unsigned int q : values.quadrature_point_indices())
          {
            const double weight = values.JxW(q) * space.measure(values.quadrature_point(q));
            area += weight;
            add_value(probe.field, cell, values, pressure_values.get_present_fe_values(), q, weight,
                      collector);
          }
        }
  return Utilities::MPI::sum(area, space.communicator);
}

template <int dim>
double FieldEvaluation<dim>::add_section(const Probe &probe, Collector &collector) const
{
  const ProbeRequest<dim> &request = probe.request;
  // One more Gauss point than on cells, since the integrand is not a polynomial in the plane.
  const PlaneSection<dim> section(space.mapping, space.triangulation,
                                  PlaneSection<dim>::Cells::active, request.region_ids,
                                  request.point, request.normal, space.n_quadrature_points() + 1);
  const auto parts =
      request.kind == ProbeRequest<dim>::Kind::rim_mean ? section.outer_rim() : section.parts();
  double area = 0.;
  for (const auto &part : parts)
  {
    std::vector<double> weights = part.quadrature.get_weights();
    for (unsigned int q = 0; q < weights.size(); ++q)
    {
      weights[q] *= space.measure(part.points[q]);
      area += weights[q];
    }
    add_values(probe.field, part.cell, part.quadrature, weights, collector);
  }
  return Utilities::MPI::sum(area, space.communicator);
}

template <int dim>
void FieldEvaluation<dim>::add_values(const FieldDefinition<dim> &field,
                                      const CellIterator &cell,
                                      const Quadrature<dim> &points,
                                      const std::vector<double> &weights,
                                      Collector &collector) const
{
  FEValues<dim> values(space.mapping, space.velocity_element, points,
                       update_values | update_gradients | update_quadrature_points);
  values.reinit(typename DoFHandler<dim>::active_cell_iterator(
      &space.triangulation, cell->level(), cell->index(), &space.velocity_dofs));
  hp::FEValues<dim> pressure_values(space.mappings, space.pressure_elements,
                                    hp::QCollection<dim>(points), update_values);
  pressure_values.reinit(typename DoFHandler<dim>::active_cell_iterator(
      &space.triangulation, cell->level(), cell->index(), &space.pressure_dofs));
  for (unsigned int q = 0; q < weights.size(); ++q)
    add_value(field, cell, values, pressure_values.get_present_fe_values(), q, weights[q],
              collector);
}

template <int dim>
void FieldEvaluation<dim>::add_value(const FieldDefinition<dim> &field,
                                     const CellIterator &cell,
                                     const FEValuesBase<dim> &values,
                                     const FEValuesBase<dim> &pressure_values,
                                     const unsigned int q,
                                     const double weight,
                                     Collector &collector) const
{
  using Quantity = typename FieldDefinition<dim>::Quantity;
  const unsigned int region = cell->material_id();
  const std::array<double, 6> factors = field.factors(values.quadrature_point(q));
  const auto combine = [&factors](const std::array<double, 6> &components)
  { return std::inner_product(factors.begin(), factors.end(), components.begin(), 0.); };

  std::vector<types::global_dof_index> indices(space.velocity_element.n_dofs_per_cell());
  typename DoFHandler<dim>::active_cell_iterator(&space.triangulation, cell->level(), cell->index(),
                                                 &space.velocity_dofs)
      ->get_dof_indices(indices);
  if (field.quantity == Quantity::velocity || field.quantity == Quantity::displacement)
  {
    const Source source =
        field.quantity == Quantity::velocity ? Source::velocity : Source::displacement;
    for (unsigned int i = 0; i < indices.size(); ++i)
    {
      const double factor = factors[space.velocity_element.system_to_component_index(i).first];
      if (factor != 0.)
        collector.add_velocity(source, region, indices[i],
                               weight * factor * values.shape_value(i, q));
    }
    return;
  }
  double pressure_weight = problem.materials[region].pressure_factor;
  if (field.quantity != Quantity::pressure)
  {
    // The stress is linear in the mixture and the pressure, the strain in the displacement, so
    // the weights are the stresses or strains of unit entries.
    const bool is_strain = field.quantity == Quantity::strain;
    const double r = space.is_axisymmetric() ? values.quadrature_point(q)[1] : 1.;
    for (unsigned int i = 0; i < indices.size(); ++i)
    {
      const unsigned int c = space.velocity_element.system_to_component_index(i).first;
      Tensor<2, dim> gradient;
      gradient[c] = values.shape_grad(i, q);
      double hoop = 0.;
      if (space.is_axisymmetric() && c == 1)
        hoop = r > 0. ? values.shape_value(i, q) / r : gradient[1][1];
      const double unit =
          combine(is_strain ? strain<dim>(gradient, hoop, problem.model, problem.materials[region])
                            : stress<dim>(gradient, hoop, 0., problem.model));
      if (unit != 0.)
        collector.add_velocity(is_strain ? Source::displacement : Source::mixture, region,
                               indices[i], weight * unit);
    }
    if (is_strain)
      return;
    pressure_weight = combine(stress<dim>(Tensor<2, dim>(), 0., 1., problem.model));
  }
  const typename DoFHandler<dim>::active_cell_iterator pressure_cell(
      &space.triangulation, cell->level(), cell->index(), &space.pressure_dofs);
  indices.resize(pressure_cell->get_fe().n_dofs_per_cell());
  pressure_cell->get_dof_indices(indices);
  for (unsigned int i = 0; i < indices.size(); ++i)
    collector.add_pressure(indices[i],
                           weight * pressure_weight * pressure_values.shape_value(i, q));
}

template <int dim>
void FieldEvaluation<dim>::evaluate(const State<dim> &state, std::vector<double> &values) const
{
  sums.assign(probes.size(), 0.);
  for (unsigned int p = 0; p < probes.size(); ++p)
    for (const Weights &weights : probes[p].weights)
    {
      const auto add = [&](const double factor, const DistributedVector &vector)
      {
        const double *const entries = vector.begin();
        double sum = 0.;
        for (unsigned int i = 0; i < weights.indices.size(); ++i)
          sum += weights.values[i] * entries[weights.indices[i]];
        sums[p] += factor * sum;
      };
      switch (weights.source)
      {
      case Source::velocity:
        add(1., state.velocity);
        break;
      case Source::displacement:
        add(1., state.history.displacement());
        break;
      case Source::pressure:
        add(1., state.pressure);
        break;
      case Source::mixture:
        const Material &material = problem.materials[weights.region];
        if (material.viscosity != 0.)
          add(material.viscosity, state.velocity);
        for (const Branch &branch : material.branches)
          add(branch.shear_modulus, state.history.internal_displacement(branch.relaxation_time));
        break;
      }
    }
  values.resize(probes.size());
  Utilities::MPI::sum(sums, space.communicator, values);
}

template <int dim>
DistributedVector FieldEvaluation<dim>::ghosted_mixture(const State<dim> &state,
                                                        const unsigned int region) const
{
  const Material &material = problem.materials[region];
  DistributedVector mixture = space.velocity_vector();
  state.history.mix(region, mixture);
  if (material.viscosity != 0.)
    mixture.add(material.viscosity, state.velocity);
  return space.ghosted_velocity(mixture);
}

template <int dim>
double FieldEvaluation<dim>::error_norm(const State<dim> &state,
                                        const std::string &field,
                                        const std::vector<Expression> &exact,
                                        const double time) const
{
  const bool is_pressure = field == "pressure";
  const bool is_stress = field == "stress";
  if (!is_pressure && !is_stress && field != "velocity" && field != "displacement")
    throw std::invalid_argument("there is no field '" + field + "'");
  const DistributedVector pressure = space.ghosted_pressure(state.pressure);
  std::vector<DistributedVector> vectors;
  if (is_stress)
    for (unsigned int region = 0; region < problem.regions.size(); ++region)
      vectors.push_back(ghosted_mixture(state, region));
  else if (!is_pressure)
    vectors.push_back(space.ghosted_velocity(field == "velocity" ? state.velocity
                                                                 : state.history.displacement()));

  // Well above the degree of the fields, so that the number is the error and not the quadrature's.
  const QGauss<dim> quadrature(space.degree() + 3);
  FEValues<dim> values(space.mapping, space.velocity_element, quadrature,
                       update_values | update_gradients | update_quadrature_points |
                           update_JxW_values);
  hp::FEValues<dim> hp_pressure_values(space.mappings, space.pressure_elements,
                                       hp::QCollection<dim>(quadrature), update_values);
  std::vector<Vector<double>> vector_values(quadrature.size(), Vector<double>(dim));
  std::vector<std::vector<Tensor<1, dim>>> gradients(quadrature.size(),
                                                     std::vector<Tensor<1, dim>>(dim));
  std::vector<Vector<double>> pressures(quadrature.size(),
                                        Vector<double>(space.pressure_elements.n_components()));
  double sum = 0.;
  for (const auto &cell : space.velocity_dofs.active_cell_iterators())
    if (cell->is_locally_owned())
    {
      const unsigned int region = cell->material_id();
      values.reinit(cell);
      if (is_pressure || is_stress)
      {
        hp_pressure_values.reinit(typename DoFHandler<dim>::active_cell_iterator(
            &space.triangulation, cell->level(), cell->index(), &space.pressure_dofs));
        hp_pressure_values.get_present_fe_values().get_function_values(pressure, pressures);
      }
      if (!is_pressure)
        values.get_function_values(vectors[is_stress ? region : 0], vector_values);
      if (is_stress)
        values.get_function_gradients(vectors[region], gradients);
      for (const unsigned int q : values.quadrature_point_indices())
      {
        const Point<dim> &point = values.quadrature_point(q);
        double coordinates[3] = {0., 0., 0.};
        for (unsigned int c = 0; c < dim; ++c)
          coordinates[c] = point[c];
        std::array<double, 6> present = {{0., 0., 0., 0., 0., 0.}};
        const double p = pressures[q][space.pressure_component(region)];
        if (is_pressure)
          present[0] = problem.materials[region].pressure_factor * p;
        else if (is_stress)
        {
          Tensor<2, dim> gradient;
          for (unsigned int c = 0; c < dim; ++c)
            gradient[c] = gradients[q][c];
          const double hoop = space.is_axisymmetric() ? vector_values[q][1] / point[1] : 0.;
          present = stress<dim>(gradient, hoop, p, problem.model);
        }
        else
          for (unsigned int c = 0; c < dim; ++c)
            present[c] = vector_values[q][c];
        double square = 0.;
        for (unsigned int c = 0; c < exact.size(); ++c)
        {
          const double difference = present[c] - exact[c](coordinates, time);
          square += difference * difference;
        }
        sum += square * values.JxW(q) * space.measure(point);
      }
    }
  return std::sqrt(Utilities::MPI::sum(sum, space.communicator));
}

template std::array<double, 6> stress(const Tensor<2, 2> &, double, double, Model);
template std::array<double, 6> stress(const Tensor<2, 3> &, double, double, Model);
template Tensor<1, 2> traction(const std::array<double, 6> &, const Tensor<1, 2> &);
template Tensor<1, 3> traction(const std::array<double, 6> &, const Tensor<1, 3> &);
template class FieldEvaluation<2>;
template class FieldEvaluation<3>;
} // namespace Continua
