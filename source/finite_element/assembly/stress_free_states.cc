#include <continua/finite_element/assembly/stress_free_states.h>

#include <deal.II/fe/fe_values.h>

#include <algorithm>

namespace Continua
{
using namespace dealii;

template <int dim>
StressFreeStates<dim>::StressFreeStates(const Space<dim> &space,
                                        const Problem &problem,
                                        const Quadrature<dim> &quadrature,
                                        const QuadratureCells<dim> &cells)
    : space(space),
      problem(problem),
      quadrature(quadrature),
      cells(cells),
      potentials(space, problem.wall_directions),
      has_other_volume(problem.finds_unloaded_shape() ||
                       std::any_of(problem.materials.begin(),
                                   problem.materials.end(),
                                   [](const Material &of_region)
                                   { return of_region.prestretch.exists(); }))
{
}

template <int dim>
void StressFreeStates<dim>::reinit()
{
  velocity_work = space.velocity_vector();
  if (problem.finds_unloaded_shape())
    ghosted_unloaded.reinit(space.velocity_owned, space.velocity_relevant, space.communicator);
  potentials.reinit();
  share = 1.;
  set_states();
}

template <int dim>
void StressFreeStates<dim>::set_share(const double of_prestretch)
{
  if (!has_other_volume || of_prestretch == share)
    return;
  share = of_prestretch;
  set_states();
}

template <int dim>
void StressFreeStates<dim>::set_unloaded_displacement(const DistributedVector &of_unloaded)
{
  unloaded.equ(1., of_unloaded);
  take_state();
}

template <int dim>
void StressFreeStates<dim>::unload_by(const DistributedVector &displacement)
{
  velocity_work.equ(-1., displacement);
  space.copy_velocity(velocity_work, ghosted_unloaded);
  set_states();
}

template <int dim>
void StressFreeStates<dim>::visit_state(StateVisitor &visitor)
{
  if (problem.finds_unloaded_shape())
    visitor.vector("unloaded displacement", StateKind::velocity, unloaded);
}

template <int dim>
void StressFreeStates<dim>::take_state()
{
  if (!problem.finds_unloaded_shape())
    return;
  space.copy_velocity(unloaded, ghosted_unloaded);
  set_states();
}

template <int dim>
void StressFreeStates<dim>::set_states()
{
  states.clear();
  if (!has_other_volume && std::none_of(problem.materials.begin(), problem.materials.end(),
                                        [](const Material &of_region)
                                        { return of_region.strain_law_parameters.has_fibres(); }))
    return;
  const DistributedVector ghosted_potentials =
      potentials.exist() ? space.ghosted_velocity(potentials.potentials()) : DistributedVector();
  FEValues<dim> places(space.mapping, space.scalar_element(), quadrature, update_quadrature_points);
  Vector<double> cell_unloaded(dim * cells.n_functions()), cell_potentials(cell_unloaded.size());
  for (const Cell &cell : cells.all())
  {
    places.reinit(
        static_cast<typename Triangulation<dim>::active_cell_iterator>(cell.velocity_cell));
    states.emplace_back();
    if (problem.finds_unloaded_shape())
      set_unloaded(cell, cell_unloaded);
    if (potentials.exist())
      set_entries(cell.velocity_places, ghosted_potentials, cell_potentials);
    const Material &of_region = problem.materials[cell.region];
    for (unsigned int q = 0; q < cells.n_points(); ++q)
    {
      const Tensor<2, 3> of_potentials =
          potentials.exist() ? cells.gradient(cell, cell_potentials, q) : Tensor<2, 3>();
      states.back().push_back(stress_free_state_at(
          of_region,
          has_directions(of_region)
              ? problem.wall_directions.at(problem.model, places.quadrature_point(q), of_potentials)
              : TubeDirections(),
          share,
          problem.finds_unloaded_shape() ? cells.gradient(cell, cell_unloaded, q)
                                         : Tensor<2, 3>()));
    }
  }
}

template class StressFreeStates<2>;
template class StressFreeStates<3>;
} // namespace Continua
