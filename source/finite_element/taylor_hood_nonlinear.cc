#include <continua/finite_element/taylor_hood_nonlinear.h>

#include <continua/finite_element/space/place_of_entry.h>

namespace Continua
{
template <int dim>
TaylorHoodNonlinear<dim>::TaylorHoodNonlinear(const Space<dim> &space,
                                              const Problem &problem,
                                              const LinearProducts<dim> &products,
                                              RegionTerms<dim> &terms,
                                              LinearSystems<dim> &systems,
                                              MovingMesh<dim> *const moving_mesh)
    : space(space),
      problem(problem),
      products(products),
      terms(terms),
      systems(systems),
      moving_mesh(moving_mesh)
{
}

template <int dim>
bool TaylorHoodNonlinear<dim>::is_in(const unsigned int region) const
{
  return problem.region_model(region) != RegionModel::linear;
}

template <int dim>
void TaylorHoodNonlinear<dim>::move_mesh(StepSolution &state)
{
  if (moving_mesh != nullptr)
    moving_mesh->move(state);
}

template <int dim>
void TaylorHoodNonlinear<dim>::set_mesh_change(const Step &step,
                                               const DistributedVector &of_velocity,
                                               DistributedVector &of_mesh_displacement)
{
  if (moving_mesh != nullptr)
    moving_mesh->set_change(step, of_velocity, of_mesh_displacement);
}

template <int dim>
void TaylorHoodNonlinear<dim>::check_mesh(const StepSolution &state)
{
  if (moving_mesh != nullptr)
    moving_mesh->check(state);
}

template <int dim>
ResidualScales TaylorHoodNonlinear<dim>::residual_scales(const DistributedVector &velocity,
                                                         const DistributedVector &pressure) const
{
  // B U of a motion without change of volume and B^T p of a uniform pressure are nothing but
  // round-off of their terms.
  typename NonlinearCellTerms<dim>::Sizes sizes{pressure.linfty_norm(), velocity.linfty_norm()};
  terms.raise_sizes(sizes);
  return products.scales(sizes.stress, sizes.velocity);
}

template <int dim>
std::string TaylorHoodNonlinear<dim>::place_of_largest(const DistributedVector &momentum,
                                                       const DistributedVector &mass,
                                                       const bool of_momentum) const
{
  return of_momentum ? place_of_largest_entry(space, space.velocity_dofs, momentum, problem.regions)
                     : place_of_largest_entry(space, space.pressure_dofs, mass, problem.regions);
}

template <int dim>
void TaylorHoodNonlinear<dim>::forget_linearisation()
{
  systems.forget_linearisation();
  if (moving_mesh != nullptr)
    moving_mesh->forget_solver();
}

template class TaylorHoodNonlinear<2>;
template class TaylorHoodNonlinear<3>;
} // namespace Continua
