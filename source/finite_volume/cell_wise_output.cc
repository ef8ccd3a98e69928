#include <continua/finite_volume/cell_wise_output.h>

#include <continua/continuum/stress_and_strain.h>

#include <deal.II/base/mpi.h>

#include <array>
#include <vector>

namespace Continua
{
using namespace dealii;

namespace
{
using Interpretation = DataComponentInterpretation::DataComponentInterpretation;

/// As FieldOutput calls them.
const std::array<const char *, 6> stress_names = {
    {"stress_xx", "stress_yy", "stress_zz", "stress_xy", "stress_xz", "stress_yz"}};
} // namespace

template <int dim>
CellWiseOutput<dim>::CellWiseOutput(const CellWiseSpace<dim> &space,
                                    const Problem &problem,
                                    const CellWiseEvaluation<dim> &evaluation)
    : space(space),
      problem(problem),
      evaluation(evaluation),
      element(FE_DGQ<dim>(0), 2 * dim + 1 + n_stresses<dim>()),
      dofs(space.mesh.triangulation)
{
}

template <int dim>
std::map<std::string, std::string> CellWiseOutput<dim>::add(const State &state,
                                                            DataOut<dim> &data_out)
{
  const DistributedVector pressure = evaluation.reconstruction().ghosted_pressure(state.pressure);
  std::vector<DistributedVector> mixtures;
  for (unsigned int region = 0; region < problem.regions.size(); ++region)
    mixtures.push_back(evaluation.ghosted_mixture(state, region));

  dofs.distribute_dofs(element);
  fields.reinit(dofs.locally_owned_dofs(), space.communicator);
  const unsigned int n_cells = space.mesh.triangulation.n_active_cells();
  phase.reinit(n_cells);
  material_id.reinit(n_cells);
  rank.reinit(n_cells);
  std::vector<types::global_dof_index> indices(element.n_dofs_per_cell());
  for (unsigned int number = 0; number < space.mesh.n_owned_cells(); ++number)
  {
    const FiniteVolume<dim> &volume = space.mesh.cells()[number];
    const Material &material = problem.materials[volume.material_id];
    const unsigned int place = volume.iterator->active_cell_index();
    phase[place] = material.phase();
    material_id[place] = volume.material_id;
    rank[place] = Utilities::MPI::this_mpi_process(space.communicator);

    std::vector<double> values;
    const unsigned int first = space.local_velocity(space.velocities.of_cell(number));
    for (const DistributedVector *vector : {&state.velocity, &state.history.displacement()})
      for (unsigned int c = 0; c < dim; ++c)
        values.push_back(vector->begin()[first + c]);
    values.push_back(problem.plane_stress(volume.material_id).pressure_factor *
                     state.pressure.begin()[space.local_pressure(space.pressures.of_cell(number))]);
    const std::array<double, 6> stress = evaluation.stress_at(
        {number, CellPlace::none}, volume.centre, mixtures[volume.material_id], pressure);
    values.insert(values.end(), stress.begin(), stress.begin() + n_stresses<dim>());

    typename DoFHandler<dim>::active_cell_iterator(
        &space.mesh.triangulation, volume.iterator->level(), volume.iterator->index(), &dofs)
        ->get_dof_indices(indices);
    for (unsigned int i = 0; i < indices.size(); ++i)
      fields[indices[i]] = values[element.system_to_component_index(i).first];
  }
  fields.compress(VectorOperation::insert);

  std::vector<std::string> names(dim, "velocity");
  names.insert(names.end(), dim, "displacement");
  names.emplace_back("pressure");
  names.insert(names.end(), stress_names.begin(), stress_names.begin() + n_stresses<dim>());
  std::vector<Interpretation> interpretation(
      2 * dim, DataComponentInterpretation::component_is_part_of_vector);
  interpretation.resize(names.size(), DataComponentInterpretation::component_is_scalar);
  data_out.add_data_vector(dofs, fields, names, interpretation);
  data_out.add_data_vector(phase, "phase");
  data_out.add_data_vector(material_id, "material_id");
  data_out.add_data_vector(rank, "rank");

  std::map<std::string, std::string> units = {{"velocity", "m/s"},  {"displacement", "m"},
                                              {"pressure", "Pa"},   {"phase", "1"},
                                              {"material_id", "1"}, {"rank", "1"}};
  for (unsigned int k = 0; k < n_stresses<dim>(); ++k)
    units[stress_names[k]] = "Pa";
  return units;
}

template class CellWiseOutput<2>;
template class CellWiseOutput<3>;
} // namespace Continua
