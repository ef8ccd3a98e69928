#include <continua/finite_element/loads.h>

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

template <int dim>
std::array<double, 3> coordinates(const Point<dim> &point)
{
  std::array<double, 3> result = {{0., 0., 0.}};
  for (unsigned int c = 0; c < dim; ++c)
    result[c] = point[c];
  return result;
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
    all.push_back({&problem.interior.body_force[c], -1, false, static_cast<int>(c), 1., {}});
  for (unsigned int i = 0; i < problem.conditions.size(); ++i)
    for (const bool normal_part : {true, false})
    {
      const BoundaryPart &part =
          normal_part ? problem.conditions[i].normal : problem.conditions[i].tangential;
      if (part.kind != BoundaryPart::Kind::traction)
        continue;
      for (unsigned int c = 0; c < part.vector.size(); ++c)
        all.push_back(
            {&part.vector[c], static_cast<int>(i), normal_part, static_cast<int>(c), 1., {}});
      if (normal_part)
        all.push_back(
            {&part.along_normal, static_cast<int>(i), true, -1, part.negative ? -1. : 1., {}});
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
  FEValues<dim> cell_values(space.velocity_element, cell_quadrature, flags);
  FEFaceValues<dim> face_values(space.velocity_element, face_quadrature,
                                flags | update_normal_vectors);
  Vector<double> local(n_velocity);
  std::vector<types::global_dof_index> indices(n_velocity);

  // Adds the integral over what `values` is initialised to.
  const auto integrate = [&](const FEValuesBase<dim> &values)
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
      direction *= item.sign * amplitude * values.JxW(q) * space.measure(point);
      for (unsigned int i = 0; i < n_velocity; ++i)
        local[i] += values.shape_value(i, q) *
                    direction[space.velocity_element.system_to_component_index(i).first];
    }
  };
  for (const auto &cell : space.velocity_dofs.active_cell_iterators())
    if (cell->is_locally_owned())
    {
      bool touched = false;
      if (item.condition < 0)
      {
        local = 0.;
        cell_values.reinit(cell);
        integrate(cell_values);
        touched = true;
      }
      else if (cell->at_boundary())
      {
        const BoundaryCondition &condition = problem.conditions[item.condition];
        local = 0.;
        for (const unsigned int f : cell->face_indices())
          if (cell->face(f)->at_boundary() &&
              cell->face(f)->boundary_id() == condition.boundary_id &&
              condition.region_ids.count(cell->material_id()) > 0)
          {
            face_values.reinit(cell, f);
            integrate(face_values);
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
bool Loads<dim>::jumps(const double time, const double step_size) const
{
  const double origin[3] = {0., 0., 0.};
  for (const Item &item : items)
  {
    if (item.waveform->depends_on_space())
    {
      DistributedVector before = space.velocity_vector(), after = before, earlier = before,
                        later = before;
      assemble(item, item.waveform, time - 1e-6 * step_size, before);
      assemble(item, item.waveform, time + 1e-6 * step_size, after);
      assemble(item, item.waveform, time - step_size, earlier);
      assemble(item, item.waveform, time + step_size, later);
      after.add(-1., before);
      if (after.linfty_norm() > 1e-2 * std::max(earlier.linfty_norm(), later.linfty_norm()))
        return true;
    }
    else
    {
      const Waveform &waveform = *item.waveform;
      const double change = std::abs(waveform(origin, time + 1e-6 * step_size) -
                                     waveform(origin, time - 1e-6 * step_size));
      if (change > 1e-2 * std::max(std::abs(waveform(origin, time - step_size)),
                                   std::abs(waveform(origin, time + step_size))))
        return true;
    }
  }
  return false;
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
