#include <continua/finite_element/looking/field_output.h>

#include <continua/continuum/stress_and_strain.h>
#include <continua/continuum/stress_free_state.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/hp/fe_values.h>

#include <utility>

namespace Continua
{
using namespace dealii;

namespace
{
const char *const wall_axis = "wall_axis", *const wall_circumference = "wall_circumference";

template <int dim>
std::vector<std::string> cell_field_names()
{
  if constexpr (dim == 2)
    return {"pressure", "stress_xx", "stress_yy", "stress_zz", "stress_xy"};
  else
    return {"pressure",  "stress_xx", "stress_yy", "stress_zz",
            "stress_xy", "stress_xz", "stress_yz"};
}

/// Names and units of the fields that are asked for beside these; a vector has its name `dim`
/// times.
template <int dim>
std::vector<std::pair<std::string, std::string>> further_cell_fields(const Problem &problem)
{
  std::vector<std::pair<std::string, std::string>> fields;
  if (problem.further_fields.vorticity)
    fields.resize(dim == 2 ? 1 : 3, {"vorticity", "1/s"});
  if (problem.further_fields.q_criterion)
    fields.emplace_back("Q_criterion", "1/s^2");
  // In two dimensions one of them is across the plane.
  if (dim == 3 && problem.wall_directions.type != WallDirectionsParameters::Type::straight_axis)
    for (const char *const name : {wall_axis, wall_circumference})
      fields.resize(fields.size() + 3, {name, "1"});
  return fields;
}

bool is_vector(const std::string &name)
{
  return name == "vorticity" || name == wall_axis || name == wall_circumference;
}
} // namespace

template <int dim>
FieldOutput<dim>::FieldOutput(const Space<dim> &space,
                              const Problem &problem,
                              const FieldEvaluation<dim> &evaluation,
                              WallShearStress<dim> &wall_shear,
                              const MetricHistory<dim> *const metrics)
    : space(space),
      problem(problem),
      evaluation(evaluation),
      wall_shear(wall_shear),
      metrics(metrics),
      names(cell_field_names<dim>()),
      units(names.size(), "Pa"),
      cell_element(space.broken_element(space.degree() - 1,
                                        names.size() + further_cell_fields<dim>(problem).size())),
      cell_dofs(space.triangulation),
      node_dofs(space.triangulation)
{
  for (const auto &[name, unit] : further_cell_fields<dim>(problem))
  {
    names.push_back(name);
    units.push_back(unit);
  }
}

template <int dim>
std::map<std::string, std::string> FieldOutput<dim>::add(const State &state, DataOut<dim> &data_out)
{
  velocity = space.ghosted_velocity(state.velocity);
  displacement = space.ghosted_velocity(state.displacement_of_shape());
  if (state.unloaded_displacement != nullptr)
    unloaded_displacement = space.ghosted_velocity(*state.unloaded_displacement);
  if (state.wall_potentials != nullptr)
    wall_potentials = space.ghosted_velocity(*state.wall_potentials);
  const DistributedVector pressure = space.ghosted_pressure(state.pressure);
  std::vector<DistributedVector> mixtures;
  for (unsigned int region = 0; region < problem.regions.size(); ++region)
    mixtures.push_back(evaluation.ghosted_mixture(state, region));

  cell_dofs.distribute_dofs(cell_element);
  cell_fields.reinit(cell_dofs.locally_owned_dofs(), space.communicator);
  const Quadrature<dim> nodes(cell_element.base_element(0).get_unit_support_points());
  FEValues<dim> values(space.mapping, space.velocity_element, nodes,
                       update_values | update_gradients | update_quadrature_points);
  hp::FEValues<dim> hp_pressure_values(space.mappings, space.pressure_elements,
                                       hp::QCollection<dim>(nodes), update_values);
  std::vector<Vector<double>> mixture_values(nodes.size(), Vector<double>(dim));
  std::vector<std::vector<Tensor<1, dim>>> gradients(nodes.size(),
                                                     std::vector<Tensor<1, dim>>(dim));
  // Gradients of the velocity, for fields that are asked for.
  const unsigned int n_always = cell_field_names<dim>().size();
  const bool has_further = names.size() > n_always;
  std::vector<Tensor<2, 3>> velocity_gradients(nodes.size());
  std::vector<Vector<double>> pressures(nodes.size(),
                                        Vector<double>(space.pressure_elements.n_components()));
  std::vector<types::global_dof_index> indices(cell_element.n_dofs_per_cell());
  std::vector<std::array<double, 6>> finite_stresses(nodes.size());
  std::vector<TubeDirections> directions(nodes.size());
  const DistributedVector metric_mixture =
      metrics != nullptr ? metrics->ghosted_mixture() : DistributedVector();

  const unsigned int n_cells = space.triangulation.n_active_cells();
  phase.reinit(n_cells);
  material_id.reinit(n_cells);
  rank.reinit(n_cells);
  for (const auto &cell : space.velocity_dofs.active_cell_iterators())
    if (cell->is_locally_owned())
    {
      const unsigned int region = cell->material_id();
      const Material &material = problem.materials[region];
      phase[cell->active_cell_index()] = material.phase();
      material_id[cell->active_cell_index()] = region;
      rank[cell->active_cell_index()] = Utilities::MPI::this_mpi_process(space.communicator);
      values.reinit(cell);
      values.get_function_values(mixtures[region], mixture_values);
      values.get_function_gradients(mixtures[region], gradients);
      if (has_further)
        set_velocity_gradients(values, problem.is_deformed(region), velocity_gradients);
      hp_pressure_values.reinit(typename DoFHandler<dim>::active_cell_iterator(
          &space.triangulation, cell->level(), cell->index(), &space.pressure_dofs));
      hp_pressure_values.get_present_fe_values().get_function_values(pressure, pressures);
      const bool is_finite = problem.is_deformed(region);
      if (is_finite)
      {
        if (has_directions(material))
          set_directions(values, directions);
        else
          directions.assign(directions.size(), TubeDirections());
        set_finite_stresses(values, pressures, region, metric_mixture, directions, finite_stresses);
      }
      typename DoFHandler<dim>::active_cell_iterator(&space.triangulation, cell->level(),
                                                     cell->index(), &cell_dofs)
          ->get_dof_indices(indices);
      for (unsigned int i = 0; i < indices.size(); ++i)
      {
        const auto [component, q] = cell_element.system_to_component_index(i);
        const double p = pressures[q][space.pressure_component(region)];
        if (component == 0)
        {
          cell_fields[indices[i]] = problem.plane_stress(region).pressure_factor * p;
          continue;
        }
        if (names[component] == wall_axis || names[component] == wall_circumference)
        {
          const Tensor<1, 3> &direction =
              names[component] == wall_axis ? directions[q].axis : directions[q].circumference;
          // Each of them has three components, one after the other, at the end of the list.
          cell_fields[indices[i]] = direction[2 - (names.size() - 1 - component) % 3];
          continue;
        }
        Tensor<2, dim> gradient;
        if (component >= n_always)
        {
          for (unsigned int c = 0; c < dim; ++c)
            for (unsigned int d = 0; d < dim; ++d)
              gradient[c][d] = velocity_gradients[q][c][d];
          const bool is_vorticity = names[component] == "vorticity";
          cell_fields[indices[i]] =
              is_vorticity ? vorticity<dim>(gradient)[dim == 2 ? 2 : component - n_always]
                           : q_criterion<dim>(gradient, velocity_gradients[q][2][2], problem.model);
          continue;
        }
        if (is_finite)
        {
          cell_fields[indices[i]] = finite_stresses[q][component - 1];
          continue;
        }
        for (unsigned int c = 0; c < dim; ++c)
          gradient[c] = gradients[q][c];
        const double r = values.quadrature_point(q)[1];
        // On the axis the hoop strain is the radial one.
        double hoop = 0.;
        if (space.is_axisymmetric())
          hoop = r > 0. ? mixture_values[q][1] / r : gradient[1][1];
        if (material.shear.flow_curve)
        {
          const double factor =
              thinning<dim>(*material.shear.flow_curve, gradient, hoop, problem.model);
          gradient *= factor;
          hoop *= factor;
        }
        cell_fields[indices[i]] = stress<dim>(gradient, hoop, p, problem.model)[component - 1];
      }
    }
  cell_fields.compress(VectorOperation::insert);

  const std::vector<DataComponentInterpretation::DataComponentInterpretation> vector_components(
      dim, DataComponentInterpretation::component_is_part_of_vector);
  data_out.add_data_vector(space.velocity_dofs, velocity, std::vector<std::string>(dim, "velocity"),
                           vector_components);
  data_out.add_data_vector(space.velocity_dofs, displacement,
                           std::vector<std::string>(dim, "displacement"), vector_components);
  if (state.unloaded_displacement != nullptr)
    data_out.add_data_vector(space.velocity_dofs, unloaded_displacement,
                             std::vector<std::string>(dim, "unloaded_displacement"),
                             vector_components);
  std::vector<DataComponentInterpretation::DataComponentInterpretation> cell_components;
  for (const std::string &name : names)
    cell_components.push_back(dim == 3 && is_vector(name)
                                  ? DataComponentInterpretation::component_is_part_of_vector
                                  : DataComponentInterpretation::component_is_scalar);
  data_out.add_data_vector(cell_dofs, cell_fields, names, cell_components);
  data_out.add_data_vector(phase, "phase");
  data_out.add_data_vector(material_id, "material_id");
  data_out.add_data_vector(rank, "rank");

  std::map<std::string, std::string> units_of_fields = {{"velocity", "m/s"},
                                                        {"displacement", "m"},
                                                        {"phase", "1"},
                                                        {"material_id", "1"},
                                                        {"rank", "1"}};
  for (unsigned int i = 0; i < names.size(); ++i)
    units_of_fields[names[i]] = units[i];
  if (state.unloaded_displacement != nullptr)
    units_of_fields["unloaded_displacement"] = "m";
  add_wall_fields(state, data_out, units_of_fields);
  return units_of_fields;
}

template <int dim>
void FieldOutput<dim>::set_gradients(const FEValues<dim> &values,
                                     const DistributedVector &vector,
                                     std::vector<Tensor<2, 3>> &target) const
{
  std::vector<std::vector<Tensor<1, dim>>> gradients(target.size(),
                                                     std::vector<Tensor<1, dim>>(dim));
  std::vector<Vector<double>> entries(target.size(), Vector<double>(dim));
  values.get_function_values(vector, entries);
  values.get_function_gradients(vector, gradients);
  for (unsigned int q = 0; q < target.size(); ++q)
  {
    Tensor<2, dim> gradient;
    for (unsigned int c = 0; c < dim; ++c)
      gradient[c] = gradients[q][c];
    const double r = values.quadrature_point(q)[1];
    double hoop = 0.;
    // On the axis the hoop strain is the radial one.
    if (space.is_axisymmetric())
      hoop = r > 0. ? entries[q][1] / r : gradient[1][1];
    target[q] = whole_gradient<dim>(gradient, hoop);
  }
}

template <int dim>
void FieldOutput<dim>::set_velocity_gradients(const FEValues<dim> &values,
                                              const bool is_deformed,
                                              std::vector<Tensor<2, 3>> &target) const
{
  set_gradients(values, velocity, target);
  if (!is_deformed)
    return;
  std::vector<Tensor<2, 3>> of_displacement(target.size());
  set_gradients(values, displacement, of_displacement);
  for (unsigned int q = 0; q < target.size(); ++q)
    target[q] = Kinematics(of_displacement[q]).gradient(target[q]);
}

template <int dim>
void FieldOutput<dim>::set_directions(const FEValues<dim> &values,
                                      std::vector<TubeDirections> &directions) const
{
  std::vector<Tensor<2, 3>> slopes(directions.size());
  if (problem.wall_directions.has_potentials())
    set_gradients(values, wall_potentials, slopes);
  for (unsigned int q = 0; q < directions.size(); ++q)
    directions[q] =
        problem.wall_directions.find(problem.model, values.quadrature_point(q), slopes[q]);
}

template <int dim>
void FieldOutput<dim>::set_finite_stresses(const FEValues<dim> &values,
                                           const std::vector<Vector<double>> &pressures,
                                           const unsigned int region,
                                           const DistributedVector &metric_mixture,
                                           const std::vector<TubeDirections> &directions,
                                           std::vector<std::array<double, 6>> &stresses) const
{
  const Material &material = problem.materials[region];
  std::vector<Tensor<2, 3>> of_displacement(stresses.size()), of_velocity(stresses.size()),
      of_unloaded(stresses.size());
  set_gradients(values, displacement, of_displacement);
  set_gradients(values, velocity, of_velocity);
  if (problem.finds_unloaded_shape())
    set_gradients(values, unloaded_displacement, of_unloaded);
  for (unsigned int q = 0; q < stresses.size(); ++q)
  {
    SymmetricTensor<2, 3> of_branches;
    if (metrics != nullptr)
      of_branches = MetricHistory<dim>::mixture_at(
          metrics->weights_at(values.get_cell(), values.get_quadrature().point(q)), metric_mixture);
    stresses[q] =
        finite_stress(material, stress_free_state_at(material, directions[q], 1., of_unloaded[q]),
                      Kinematics(of_displacement[q]), of_velocity[q],
                      pressures[q][space.pressure_component(region)], of_branches);
  }
}

template <int dim>
void FieldOutput<dim>::add_wall_fields(const State &state,
                                       DataOut<dim> &data_out,
                                       std::map<std::string, std::string> &units_of_fields)
{
  const std::vector<DataComponentInterpretation::DataComponentInterpretation> vector_components(
      dim, DataComponentInterpretation::component_is_part_of_vector);
  DistributedVector owned = space.velocity_vector();
  if (problem.further_fields.wall_shear_stress)
  {
    wall_shear.set(state, owned);
    shear = space.ghosted_velocity(owned);
    data_out.add_data_vector(space.velocity_dofs, shear,
                             std::vector<std::string>(dim, "wall_shear_stress"), vector_components);
    units_of_fields["wall_shear_stress"] = "Pa";
  }
  if (!problem.further_fields.wall_shear_averages || state.wall_shear == nullptr)
    return;
  // The vectors have a number in each component of a node.
  const WallShearAverage &average = *state.wall_shear;
  const DistributedVector &magnitude = average.integral_of_magnitude();
  node_dofs.distribute_dofs(space.velocity_element.base_element(0));
  owned.equ(average.duration() > 0. ? 1. / average.duration() : 0., magnitude);
  set_numbers(owned, average_shear);
  wall_shear.set_magnitudes(average.integral(), owned);
  for (unsigned int i = 0; i < owned.locally_owned_size(); ++i)
    owned.begin()[i] =
        magnitude.begin()[i] > 0. ? 0.5 * (1. - owned.begin()[i] / magnitude.begin()[i]) : 0.;
  set_numbers(owned, oscillation);
  data_out.add_data_vector(node_dofs, average_shear, "time_averaged_wall_shear_stress");
  data_out.add_data_vector(node_dofs, oscillation, "oscillatory_shear_index");
  units_of_fields["time_averaged_wall_shear_stress"] = "Pa";
  units_of_fields["oscillatory_shear_index"] = "1";
}

template <int dim>
void FieldOutput<dim>::set_numbers(const DistributedVector &vectors, DistributedVector &numbers)
{
  const DistributedVector ghosted = space.ghosted_velocity(vectors);
  const IndexSet &owned = node_dofs.locally_owned_dofs();
  IndexSet relevant;
  DoFTools::extract_locally_relevant_dofs(node_dofs, relevant);
  DistributedVector values(owned, space.communicator);
  std::vector<types::global_dof_index> nodes(node_dofs.get_fe().n_dofs_per_cell()),
      indices(space.velocity_element.n_dofs_per_cell());
  for (const auto &cell : space.velocity_dofs.active_cell_iterators())
  {
    if (cell->is_artificial())
      continue;
    cell->get_dof_indices(indices);
    typename DoFHandler<dim>::active_cell_iterator(&space.triangulation, cell->level(),
                                                   cell->index(), &node_dofs)
        ->get_dof_indices(nodes);
    for (unsigned int i = 0; i < indices.size(); ++i)
    {
      const auto [component, node] = space.velocity_element.system_to_component_index(i);
      if (component == 0 && owned.is_element(nodes[node]))
        values[nodes[node]] = ghosted(indices[i]);
    }
  }
  values.compress(VectorOperation::insert);
  numbers.reinit(owned, relevant, space.communicator);
  numbers = values;
}

template class FieldOutput<2>;
template class FieldOutput<3>;
} // namespace Continua
