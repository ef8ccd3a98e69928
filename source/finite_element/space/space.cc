#include <continua/finite_element/space/space.h>

#include <continua/base/words.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_renumbering.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_dgq.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_q.h>

namespace Continua
{
using namespace dealii;

namespace
{
/// Local indices of the owned dofs that have a constraint.
std::vector<unsigned int> owned_and_constrained(const IndexSet &owned,
                                                const AffineConstraints<double> &constraints)
{
  std::vector<unsigned int> indices;
  for (const auto index : owned)
    if (constraints.is_constrained(index))
      indices.push_back(owned.index_within_set(index));
  return indices;
}
} // namespace

void SpaceParameters::read(ParameterSection section)
{
  section.add("Velocity degree", velocity_degree,
              "Polynomial degree k of the velocity; the pressure has degree k - 1 [1].", 2, 5);
  add_choice(section, "Pressure space", pressure_space,
             {{"broken", PressureSpace::broken}, {"continuous", PressureSpace::continuous}},
             "Whether the pressure may jump between regions (broken), as it does at a "
             "loaded wall, or is one "
             "continuous field.");
}

template <int dim>
Space<dim>::Space(parallel::TriangulationBase<dim> &triangulation,
                  const SpaceParameters &parameters,
                  const Model model,
                  const unsigned int n_regions)
    : communicator(triangulation.get_communicator()),
      triangulation(triangulation),
      mapping(parameters.velocity_degree, triangulation),
      mappings(mapping),
      velocity_element(FE_Q<dim>(parameters.velocity_degree), dim),
      velocity_dofs(triangulation),
      pressure_dofs(triangulation),
      broken(parameters.pressure_space == PressureSpace::broken),
      axisymmetric(model == Model::axisymmetric)
{
  const FE_Q<dim> pressure(parameters.velocity_degree - 1);
  const FE_Nothing<dim> nothing;
  if (broken)
    for (unsigned int region = 0; region < n_regions; ++region)
    {
      std::vector<const FiniteElement<dim> *> elements(n_regions, &nothing);
      elements[region] = &pressure;
      pressure_elements.push_back(FESystem<dim>(elements, std::vector<unsigned int>(n_regions, 1)));
    }
  else
    pressure_elements.push_back(FESystem<dim>(pressure, 1));
}

template <int dim>
void Space<dim>::distribute()
{
  mapping.keep_points();
  // Numbers that follow the cells' places in the tree: deal.II's own follow the order in which
  // cells were made, so that a mesh read from a checkpoint would have others than the run that
  // wrote it.
  velocity_dofs.distribute_dofs(velocity_element);
  DoFRenumbering::hierarchical(velocity_dofs);
  velocity_owned = velocity_dofs.locally_owned_dofs();
  DoFTools::extract_locally_relevant_dofs(velocity_dofs, velocity_relevant);
  velocity_hanging.reinit(velocity_relevant);
  DoFTools::make_hanging_node_constraints(velocity_dofs, velocity_hanging);
  velocity_hanging.close();
  velocity_copy.reinit(velocity_owned, velocity_relevant, velocity_hanging, communicator);

  if (broken)
    for (const auto &cell : pressure_dofs.active_cell_iterators())
      if (cell->is_locally_owned())
        cell->set_active_fe_index(cell->material_id());
  pressure_dofs.distribute_dofs(pressure_elements);
  DoFRenumbering::hierarchical(pressure_dofs);
  pressure_owned = pressure_dofs.locally_owned_dofs();
  DoFTools::extract_locally_relevant_dofs(pressure_dofs, pressure_relevant);
  pressure_hanging.reinit(pressure_relevant);
  DoFTools::make_hanging_node_constraints(pressure_dofs, pressure_hanging);
  pressure_hanging.close();
  pressure_copy.reinit(pressure_owned, pressure_relevant, pressure_hanging, communicator);

  hanging_velocities = owned_and_constrained(velocity_owned, velocity_hanging);
  hanging_pressures = owned_and_constrained(pressure_owned, pressure_hanging);
}

template <int dim>
FESystem<dim> Space<dim>::linear_element() const
{
  return FESystem<dim>(FE_Q<dim>(1), dim);
}

template <int dim>
FESystem<dim> Space<dim>::broken_element(const unsigned int degree,
                                         const unsigned int n_components) const
{
  return FESystem<dim>(FE_DGQ<dim>(degree), n_components);
}

template <int dim>
FESystem<dim> Space<dim>::element_at_points(const unsigned int n_points,
                                            const unsigned int n_components) const
{
  return FESystem<dim>(FE_DGQArbitraryNodes<dim>(QGauss<1>(n_points)), n_components);
}

template <int dim>
FESystem<dim> Space<dim>::no_element(const unsigned int n_components) const
{
  return FESystem<dim>(FE_Nothing<dim>(), n_components);
}

template <int dim>
Quadrature<dim> Space<dim>::quadrature(const unsigned int n_points) const
{
  return QGauss<dim>(n_points);
}

template <int dim>
Quadrature<dim - 1> Space<dim>::face_quadrature(const unsigned int n_points) const
{
  return QGauss<dim - 1>(n_points);
}

template <int dim>
DistributedVector Space<dim>::ghosted_velocity(const DistributedVector &owned) const
{
  DistributedVector ghosted(velocity_owned, velocity_relevant, communicator);
  copy_velocity(owned, ghosted);
  return ghosted;
}

template <int dim>
DistributedVector Space<dim>::ghosted_pressure(const DistributedVector &owned) const
{
  DistributedVector ghosted(pressure_owned, pressure_relevant, communicator);
  copy_pressure(owned, ghosted);
  return ghosted;
}

template <int dim>
void Space<dim>::set_hanging_velocities_to_zero(DistributedVector &owned) const
{
  for (const unsigned int index : hanging_velocities)
    owned.begin()[index] = 0.;
}

template <int dim>
void Space<dim>::set_hanging_pressures_to_zero(DistributedVector &owned) const
{
  for (const unsigned int index : hanging_pressures)
    owned.begin()[index] = 0.;
}

template <int dim>
double Space<dim>::circumference(const Point<dim> &point) const
{
  return axisymmetric ? 2. * numbers::PI * point[1] : 1.;
}

template class Space<2>;
template class Space<3>;
} // namespace Continua
