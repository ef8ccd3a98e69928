#include <continua/finite_element/field_output.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature.h>
#include <deal.II/fe/fe_dgq.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/hp/fe_values.h>

namespace Continua
{
using namespace dealii;

namespace
{
template <int dim>
std::vector<std::string> cell_field_names()
{
  if constexpr (dim == 2)
    return {"pressure", "stress_xx", "stress_yy", "stress_zz", "stress_xy"};
  else
    return {"pressure",  "stress_xx", "stress_yy", "stress_zz",
            "stress_xy", "stress_xz", "stress_yz"};
}
} // namespace

template <int dim>
FieldOutput<dim>::FieldOutput(const Space<dim> &space,
                              const Problem &problem,
                              const FieldEvaluation<dim> &evaluation)
    : space(space),
      problem(problem),
      evaluation(evaluation),
      cell_element(FE_DGQ<dim>(space.degree() - 1), cell_field_names<dim>().size()),
      cell_dofs(space.triangulation)
{
}

template <int dim>
std::map<std::string, std::string> FieldOutput<dim>::add(const State &state, DataOut<dim> &data_out)
{
  velocity = space.ghosted_velocity(state.velocity);
  displacement = space.ghosted_velocity(state.history.displacement());
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
  std::vector<Vector<double>> pressures(nodes.size(),
                                        Vector<double>(space.pressure_elements.n_components()));
  std::vector<types::global_dof_index> indices(cell_element.n_dofs_per_cell());

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
      hp_pressure_values.reinit(typename DoFHandler<dim>::active_cell_iterator(
          &space.triangulation, cell->level(), cell->index(), &space.pressure_dofs));
      hp_pressure_values.get_present_fe_values().get_function_values(pressure, pressures);
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
        Tensor<2, dim> gradient;
        for (unsigned int c = 0; c < dim; ++c)
          gradient[c] = gradients[q][c];
        const double r = values.quadrature_point(q)[1];
        // On the axis the hoop strain is the radial one.
        double hoop =
            space.is_axisymmetric() ? (r > 0. ? mixture_values[q][1] / r : gradient[1][1]) : 0.;
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
  data_out.add_data_vector(cell_dofs, cell_fields, cell_field_names<dim>());
  data_out.add_data_vector(phase, "phase");
  data_out.add_data_vector(material_id, "material_id");
  data_out.add_data_vector(rank, "rank");

  std::map<std::string, std::string> units = {{"velocity", "m/s"},
                                              {"displacement", "m"},
                                              {"phase", "1"},
                                              {"material_id", "1"},
                                              {"rank", "1"}};
  for (const std::string &name : cell_field_names<dim>())
    units[name] = "Pa";
  return units;
}

template class FieldOutput<2>;
template class FieldOutput<3>;
} // namespace Continua
