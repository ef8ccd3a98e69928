#include <continua/finite_element/space/quadrature_cells.h>

#include <continua/continuum/kinematics.h>
#include <continua/mesh/cells_in_tree_order.h>

#include <deal.II/fe/fe_values.h>

#include <Epetra_BlockMap.h>

#include <cmath>

namespace Continua
{
using namespace dealii;

namespace
{
std::vector<int> places_of(const std::vector<types::global_dof_index> &indices,
                           const DistributedVector &ghosted)
{
  std::vector<int> places;
  places.reserve(indices.size());
  for (const types::global_dof_index index : indices)
    places.push_back(
        ghosted.trilinos_partitioner().LID(static_cast<TrilinosWrappers::types::int_type>(index)));
  return places;
}
} // namespace

void set_entries(const std::vector<int> &places,
                 const DistributedVector &from,
                 Vector<double> &values)
{
  const double *const entries = from.begin();
  for (std::size_t i = 0; i < places.size(); ++i)
    values[i] = entries[places[i]];
}

template <int dim>
QuadratureCells<dim>::QuadratureCells(const Space<dim> &space,
                                      const Problem &problem,
                                      const Quadrature<dim> &quadrature,
                                      const RegionModel model)
    : QuadratureCells(space,
                      quadrature,
                      [&problem, model](const unsigned int region)
                      { return problem.region_model(region) == model; })
{
}

template <int dim>
QuadratureCells<dim>::QuadratureCells(const Space<dim> &space,
                                      const Quadrature<dim> &quadrature,
                                      const std::function<bool(unsigned int)> &takes)
    : space(space), quadrature(quadrature), takes(takes)
{
  const auto set = [&](const FiniteElement<dim> &element, Table<2, double> &values,
                       Table<2, Tensor<1, dim>> &gradients, Table<2, double> &both)
  {
    const unsigned int n_functions = element.n_dofs_per_cell();
    values.reinit(quadrature.size(), n_functions);
    gradients.reinit(quadrature.size(), n_functions);
    both.reinit(quadrature.size(), (dim + 1) * n_functions);
    for (unsigned int q = 0; q < quadrature.size(); ++q)
      for (unsigned int a = 0; a < n_functions; ++a)
      {
        values(q, a) = element.shape_value(a, quadrature.point(q));
        gradients(q, a) = element.shape_grad(a, quadrature.point(q));
        both(q, a) = values(q, a);
        for (unsigned int c = 0; c < dim; ++c)
          both(q, (c + 1) * n_functions + a) = gradients(q, a)[c];
      }
  };
  set(space.scalar_element(), shapes, slopes, values_and_slopes);
  set(space.scalar_pressure_element(), pressure_shapes, pressure_slopes,
      pressure_values_and_slopes);
}

template <int dim>
void QuadratureCells<dim>::reinit()
{
  const DistributedVector velocity(space.velocity_owned, space.velocity_relevant,
                                   space.communicator),
      pressure(space.pressure_owned, space.pressure_relevant, space.communicator);
  FEValues<dim> geometry(space.mapping, space.scalar_element(), quadrature,
                         update_quadrature_points | update_JxW_values | update_inverse_jacobians);
  std::vector<types::global_dof_index> indices(space.velocity_element.n_dofs_per_cell());
  cells.clear();
  for (const auto &cell : cells_in_tree_order(space.velocity_dofs))
  {
    if (!cell->is_locally_owned() || !takes(cell->material_id()))
      continue;
    cells.emplace_back();
    QuadratureCell<dim> &kept = cells.back();
    kept.velocity_cell = cell;
    kept.pressure_cell = typename DoFHandler<dim>::active_cell_iterator(
        &space.triangulation, cell->level(), cell->index(), &space.pressure_dofs);
    kept.region = cell->material_id();
    kept.size = Convection::cell_size<dim>(cell->diameter(), space.degree());

    cell->get_dof_indices(indices);
    kept.velocity_indices.resize(indices.size());
    for (unsigned int i = 0; i < indices.size(); ++i)
    {
      const auto [component, function] = space.velocity_element.system_to_component_index(i);
      kept.velocity_indices[component * n_functions() + function] = indices[i];
    }
    kept.pressure_indices.resize(n_pressures());
    kept.pressure_cell->get_dof_indices(kept.pressure_indices);
    kept.velocity_places = places_of(kept.velocity_indices, velocity);
    kept.pressure_places = places_of(kept.pressure_indices, pressure);

    geometry.reinit(static_cast<typename Triangulation<dim>::active_cell_iterator>(cell));
    kept.points.resize(quadrature.size());
    for (unsigned int q = 0; q < quadrature.size(); ++q)
    {
      const Point<dim> &place = geometry.quadrature_point(q);
      kept.points[q].weight = geometry.JxW(q) * space.circumference(place);
      kept.points[q].hoop = space.is_axisymmetric() ? 1. / place[1] : 0.;
      kept.points[q].inverse_jacobian = Tensor<2, dim>(geometry.inverse_jacobian(q));
    }
  }
}

template <int dim>
Tensor<2, 3> QuadratureCells<dim>::gradient(const QuadratureCell<dim> &cell,
                                            const Vector<double> &entries,
                                            const unsigned int q) const
{
  const typename QuadratureCell<dim>::Point &geometry = cell.points[q];
  const std::size_t n = n_functions();
  const Tensor<1, dim> *const of_functions = gradients(q);
  Tensor<2, dim> result;
  for (unsigned int c = 0; c < dim; ++c)
  {
    const double *const of_component = entries.begin() + c * n;
    Tensor<1, dim> slope; // on the reference cell
    for (unsigned int a = 0; a < n; ++a)
      slope += of_component[a] * of_functions[a];
    result[c] = slope * geometry.inverse_jacobian;
  }
  double radial = 0.;
  for (unsigned int a = 0; geometry.hoop != 0. && a < n; ++a)
    radial += entries[n + a] * values(q)[a];
  // On the axis the hoop strain is the radial one.
  return whole_gradient<dim>(result,
                             std::isfinite(geometry.hoop) ? radial * geometry.hoop : result[1][1]);
}

template class QuadratureCells<2>;
template class QuadratureCells<3>;
} // namespace Continua
