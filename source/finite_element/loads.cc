#include <continua/finite_element/loads.h>
#include <continua/mesh/cells_in_tree_order.h>
#include <continua/mesh/coordinates.h>
#include <continua/signal/jump.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <cmath>

namespace Continua
{
using namespace dealii;

namespace
{
/// The part of a Cartesian vector that one half of a condition uses.
template <int dim>
Tensor<1, dim>
own_part(const Tensor<1, dim> &vector, const Tensor<1, dim> &normal, const bool normal_part)
{
  const Tensor<1, dim> along = (vector * normal) * normal;
  return normal_part ? along : vector - along;
}

template <typename Cell>
bool has_condition(const Cell &cell, const unsigned int face, const BoundaryCondition &condition)
{
  return cell->face(face)->at_boundary() &&
         cell->face(face)->boundary_id() == condition.boundary_id &&
         condition.region_ids.count(cell->material_id()) > 0;
}
} // namespace

template <int dim>
Loads<dim>::Loads(const Space<dim> &space, const Problem &problem) : space(space), problem(problem)
{
}

template <int dim>
void Loads<dim>::build()
{
  items.clear();
  std::vector<Item> all;
  for (unsigned int c = 0; c < problem.interior.body_force.size(); ++c)
    all.push_back(
        {&problem.interior.body_force[c], -1, false, static_cast<int>(c), 1., false, {}, {}});
  for (unsigned int c = 0; c < problem.interior.acceleration.size(); ++c)
    all.push_back(
        {&problem.interior.acceleration[c], -1, false, static_cast<int>(c), 1., true, {}, {}});
  for (unsigned int i = 0; i < problem.conditions.size(); ++i)
    for (const bool normal_part : {true, false})
    {
      const BoundaryPart &part =
          normal_part ? problem.conditions[i].normal : problem.conditions[i].tangential;
      if (part.kind != BoundaryPart::Kind::traction)
        continue;
      for (unsigned int c = 0; c < part.vector.size(); ++c)
        all.push_back({&part.vector[c],
                       static_cast<int>(i),
                       normal_part,
                       static_cast<int>(c),
                       1.,
                       false,
                       {},
                       {}});
      if (normal_part)
        all.push_back({&part.along_normal,
                       static_cast<int>(i),
                       true,
                       -1,
                       part.negative ? -1. : 1.,
                       false,
                       {},
                       {}});
    }

  constant = space.velocity_vector();
  for (Item &item : all)
  {
    if (item.waveform->is_zero())
      continue;
    if (!item.waveform->depends_on_time())
      assemble(item, item.waveform, 0., constant);
    else
    {
      if (!item.waveform->depends_on_space())
      {
        item.unit = space.velocity_vector();
        assemble(item, nullptr, 0., item.unit);
      }
      watch_points(item);
      items.push_back(item);
    }
  }
}

template <int dim>
void Loads<dim>::assemble(const Item &item,
                          const Waveform *waveform,
                          const double time,
                          DistributedVector &target) const
{
  const unsigned int n_velocity = space.velocity_element.n_dofs_per_cell();
  // Loads are given functions, so one point more than the operators have.
  const QGauss<dim> cell_quadrature(space.n_quadrature_points() + 1);
  const QGauss<dim - 1> face_quadrature(space.n_quadrature_points() + 1);
  const UpdateFlags flags = update_values | update_quadrature_points | update_JxW_values;
  FEValues<dim> cell_values(space.mapping, space.velocity_element, cell_quadrature, flags);
  FEFaceValues<dim> face_values(space.mapping, space.velocity_element, face_quadrature,
                                flags | update_normal_vectors);
  Vector<double> local(n_velocity);
  std::vector<types::global_dof_index> indices(n_velocity);

  // Adds the integral over what `values` is initialised to.
  const auto integrate = [&](const FEValuesBase<dim> &values, const double density)
  {
    for (const unsigned int q : values.quadrature_point_indices())
    {
      Tensor<1, dim> direction;
      if (item.component >= 0)
        direction[item.component] = 1.;
      if (item.condition >= 0)
        direction = item.component < 0
                        ? values.normal_vector(q)
                        : own_part(direction, values.normal_vector(q), item.normal_part);
      const Point<dim> &point = values.quadrature_point(q);
      const double amplitude =
          waveform == nullptr ? 1. : (*waveform)(coordinates(point).data(), time);
      direction *= item.sign * density * amplitude * values.JxW(q) * space.measure(point);
      for (unsigned int i = 0; i < n_velocity; ++i)
        local[i] += values.shape_value(i, q) *
                    direction[space.velocity_element.system_to_component_index(i).first];
    }
  };
  for (const auto &cell : cells_in_tree_order(space.velocity_dofs))
    if (cell->is_locally_owned())
    {
      bool touched = false;
      if (item.condition < 0)
      {
        local = 0.;
        cell_values.reinit(cell);
        integrate(cell_values,
                  item.times_density ? problem.materials[cell->material_id()].density : 1.);
        touched = true;
      }
      else if (cell->at_boundary())
      {
        const BoundaryCondition &condition = problem.conditions[item.condition];
        local = 0.;
        for (const unsigned int f : cell->face_indices())
          if (has_condition(cell, f, condition))
          {
            face_values.reinit(cell, f);
            integrate(face_values, 1.);
            touched = true;
          }
      }
      if (touched)
      {
        cell->get_dof_indices(indices);
        space.velocity_hanging.distribute_local_to_global(local, indices, target);
      }
    }
  target.compress(VectorOperation::add);
}

template <int dim>
void Loads<dim>::add(const double time, DistributedVector &residual) const
{
  residual.add(1., constant);
  const double origin[3] = {0., 0., 0.};
  for (const Item &item : items)
    if (item.waveform->depends_on_space())
      assemble(item, item.waveform, time, residual);
    else
      residual.add((*item.waveform)(origin, time), item.unit);
}

template <int dim>
DistributedVector Loads<dim>::flow_of_velocities(const unsigned int condition) const
{
  DistributedVector flow = space.velocity_vector();
  assemble({nullptr, static_cast<int>(condition), true, -1, 1., false, {}, {}}, nullptr, 0., flow);
  return flow;
}

template <int dim>
bool Loads<dim>::jumps(const double begin, const double end) const
{
  bool found = false;
  for (const Item &item : items)
    for (const std::array<double, 3> &point : item.watched_points)
      found = found ||
              jumps_within([&](const double time) { return (*item.waveform)(point.data(), time); },
                           begin, end);
  return Utilities::MPI::max(found ? 1 : 0, space.communicator) == 1;
}

template <int dim>
void Loads<dim>::watch_points(Item &item) const
{
  if (!item.waveform->depends_on_space())
  {
    item.watched_points.push_back({{0., 0., 0.}});
    return;
  }
  constexpr unsigned int n_watched = 8;
  std::vector<std::array<double, 3>> points;
  for (const auto &cell : cells_in_tree_order(space.velocity_dofs))
    if (cell->is_locally_owned())
    {
      if (item.condition < 0)
        points.push_back(coordinates(cell->center()));
      else
        for (const unsigned int f : cell->face_indices())
          if (has_condition(cell, f, problem.conditions[item.condition]))
            points.push_back(coordinates(cell->face(f)->center()));
    }
  const std::size_t n_points = std::min<std::size_t>(n_watched, points.size());
  for (std::size_t i = 0; i < n_points; ++i)
    item.watched_points.push_back(points[i * points.size() / n_points]);
}

template <int dim>
Tensor<1, dim> Loads<dim>::prescribed_traction(const BoundaryCondition &condition,
                                               const Point<dim> &point,
                                               const Tensor<1, dim> &normal,
                                               const double time)
{
  Tensor<1, dim> traction;
  const auto x = coordinates(point);
  for (const bool normal_part : {true, false})
  {
    const BoundaryPart &part = normal_part ? condition.normal : condition.tangential;
    if (part.kind != BoundaryPart::Kind::traction)
      continue;
    Tensor<1, dim> vector;
    for (unsigned int c = 0; c < part.vector.size(); ++c)
      vector[c] = part.vector[c](x.data(), time);
    traction += own_part(vector, normal, normal_part);
    if (normal_part)
      traction += (part.negative ? -1. : 1.) * part.along_normal(x.data(), time) * normal;
  }
  return traction;
}

template class Loads<2>;
template class Loads<3>;
} // namespace Continua
