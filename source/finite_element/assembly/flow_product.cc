#include <continua/finite_element/assembly/flow_product.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cstddef>

namespace Continua
{
using namespace dealii;

template <int dim>
FlowProduct<dim>::FlowProduct(const Space<dim> &space,
                              const Problem &problem,
                              const std::optional<InstructionSet> instruction_set)
    : space(space), problem(problem), instruction_set(instruction_set)
{
}

template <int dim>
typename FlowProduct<dim>::Product::Input FlowProduct<dim>::input() const
{
  typename Product::Input result(space.mapping, space.velocity_dofs, space.velocity_hanging);
  result.is_axisymmetric = space.is_axisymmetric();
  result.mesh_moves = problem.mesh_moves;
  result.carries = problem.convection.is_on ? 1. : 0.;
  result.is_skew = problem.convection.is_on && problem.convection.term == ConvectiveTerm::skew;
  result.constant_viscosity = problem.convection.constant_viscosity();
  for (const Material &of_region : problem.materials)
  {
    typename Product::Liquid liquid;
    liquid.density = of_region.density;
    liquid.viscosity = of_region.shear.viscosity;
    liquid.volume_law = of_region.volume_law();
    liquid.flow_curve = of_region.shear.flow_curve;
    result.liquids.push_back(liquid);
  }
  const unsigned int n_cells = space.triangulation.n_active_cells();
  result.has_cell.resize(n_cells);
  result.viscosity_over_speed.resize(n_cells);
  result.pressure_places.resize(std::size_t(n_cells) * Product::n_pressures);
  return result;
}

template <int dim>
void FlowProduct<dim>::make(const QuadratureCells<dim> &cells,
                            const std::function<bool(const Cell &)> &takes)
{
  if (!instruction_set || product != nullptr)
    return;
  typename Product::Input of_product = input();
  bool leaves_one = false;
  has_compressible_liquid = false;
  for (unsigned int region = 0; region < problem.materials.size(); ++region)
    if (problem.region_model(region) == RegionModel::flow &&
        !problem.materials[region].is_incompressible())
      has_compressible_liquid = true;
  for (const Cell &cell : cells.all())
  {
    if (!takes(cell))
    {
      leaves_one = true;
      continue;
    }
    const unsigned int index = cell.velocity_cell->active_cell_index();
    of_product.has_cell[index] = true;
    of_product.viscosity_over_speed[index] =
        problem.convection.viscosity_over_speed(problem.materials[cell.region].density, cell.size);
    std::copy(cell.pressure_places.begin(), cell.pressure_places.end(),
              of_product.pressure_places.begin() + std::size_t(index) * Product::n_pressures);
  }
  some_are_left = Utilities::MPI::max(leaves_one ? 1 : 0, space.communicator) > 0;
  has_cell = of_product.has_cell;
  product = make_matrix_free_convection<dim>(*instruction_set, of_product);
  volume.assign(of_product.pressure_places.size(), 0.);
  cell_volume.reinit(Product::n_pressures);
  volume_sums.reinit(
      DistributedVector(space.pressure_owned, space.pressure_relevant, space.communicator),
      space.pressure_owned, space.pressure_hanging);
  for (typename Product::Vector *const vector :
       {&state.velocity, &state.acceleration, &velocity, &momentum})
    product->initialise(*vector);
  if (problem.mesh_moves)
    for (typename Product::Vector *const vector : {&state.mesh_displacement, &state.mesh_velocity})
      product->initialise(*vector);
}

template <int dim>
void FlowProduct<dim>::set(const StepSolution &solution,
                           const DistributedVector &pressure,
                           const DistributedVector &pressure_rate)
{
  const auto take = [](const DistributedVector &from, typename Product::Vector &to)
  {
    std::copy(from.begin(), from.end(), to.begin());
    to.update_ghost_values();
  };
  take(solution.velocity, state.velocity);
  if (problem.mesh_moves)
  {
    take(solution.mesh_displacement, state.mesh_displacement);
    take(solution.mesh_velocity, state.mesh_velocity);
  }
  if (has_compressible_liquid)
  {
    take(solution.acceleration, state.acceleration);
    // With the ghost entries, which end() leaves out.
    const unsigned int n_entries = pressure.trilinos_vector().MyLength();
    state.pressure.assign(pressure.begin(), pressure.begin() + n_entries);
    state.pressure_rate.assign(pressure_rate.begin(), pressure_rate.begin() + n_entries);
  }
  state.acceleration_by_velocity = solution.step.a0;
  state.pressure_rate_by_pressure = 1. / solution.step.pressure_time;
  product->set(&state);
}

template <int dim>
void FlowProduct<dim>::add(const DistributedVector &of_velocity,
                           const DistributedVector &of_pressure,
                           const QuadratureCells<dim> &cells,
                           DistributedVector &of_momentum,
                           DistributedVector &of_volume)
{
  std::copy(of_velocity.begin(), of_velocity.end(), velocity.begin());
  product->multiply(momentum, volume, velocity, of_pressure.begin());
  for (unsigned int i = 0; i < of_momentum.locally_owned_size(); ++i)
    of_momentum.begin()[i] += momentum.local_element(i);
  for (const Cell &cell : cells.all())
  {
    const unsigned int index = cell.velocity_cell->active_cell_index();
    if (!has_cell[index])
      continue;
    const double *const rows = &volume[std::size_t(index) * Product::n_pressures];
    std::copy(rows, rows + Product::n_pressures, cell_volume.begin());
    volume_sums.add(cell.pressure_places, cell_volume);
  }
  volume_sums.add_to(of_volume);
}

template class FlowProduct<2>;
template class FlowProduct<3>;
} // namespace Continua
