// A field that the elements have exactly, at the points of a quadrature and at the vertices:
// values, gradients, and in axisymmetry the hoop strain, on the axis too.

#include <continua/finite_element/space/values_at_points.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "../unit_test.h"
#include "small_problem.h"

namespace test_of_values_at_points
{
using namespace Continua;
using namespace dealii;

namespace
{
/// Component c is x_c (1 + 2 x_0 - 3 x_last), and its gradient.
template <int dim>
Tensor<1, dim> velocity(const Point<dim> &x)
{
  return (1. + 2. * x[0] - 3. * x[dim - 1]) * x;
}
template <int dim>
Tensor<2, dim> velocity_gradient(const Point<dim> &x)
{
  Tensor<2, dim> result;
  for (unsigned int c = 0; c < dim; ++c)
  {
    result[c][c] += 1. + 2. * x[0] - 3. * x[dim - 1];
    result[c][0] += 2. * x[c];
    result[c][dim - 1] -= 3. * x[c];
  }
  return result;
}

template <int dim>
void check_points(const std::string &name, const Space<dim> &space, const Quadrature<dim> &points)
{
  QuadratureCells<dim> cells(space, points, [](unsigned int) { return true; });
  cells.reinit();
  const DistributedVector of_velocity = small_problem::interpolated<dim>(space, velocity<dim>),
                          of_pressure = small_problem::interpolated_pressure<dim>(
                              space, [](const Point<dim> &x, unsigned int) { return 2. + x[0]; });
  using Field = typename ValuesAtPoints<dim>::Field;
  ValuesAtPoints<dim> alone(cells, Field::velocity, false), both(cells, Field::velocity, true),
      pressure(cells, Field::pressure, true);
  FEValues<dim> geometry(space.mapping, space.scalar_element(), points, update_quadrature_points);
  Vector<double> velocities(dim * cells.n_functions()), pressures(cells.n_pressures());
  double of_values = 0., of_slopes = 0., of_hoop = 0., of_pressures = 0.;
  for (const auto &cell : cells.all())
  {
    set_entries(cell.velocity_places, of_velocity, velocities);
    set_entries(cell.pressure_places, of_pressure, pressures);
    alone.set(velocities);
    both.set(velocities);
    pressure.set(pressures);
    geometry.reinit(
        static_cast<typename Triangulation<dim>::active_cell_iterator>(cell.velocity_cell));
    for (unsigned int q = 0; q < points.size(); ++q)
    {
      const Point<dim> &x = geometry.quadrature_point(q);
      const Tensor<2, dim> exact = velocity_gradient(x);
      const Tensor<2, dim> &inverse_jacobian = cell.points[q].inverse_jacobian;
      for (unsigned int c = 0; c < dim; ++c)
      {
        of_values = std::max({of_values, std::abs(alone.value(c, q) - velocity(x)[c]),
                              std::abs(both.value(c, q) - velocity(x)[c])});
        of_slopes = std::max(of_slopes, (both.gradient(c, q, inverse_jacobian) - exact[c]).norm());
      }
      // u_r/r is the factor of x_c; in the plane there is none.
      const double hoop = dim == 3                  ? exact[2][2]
                          : space.is_axisymmetric() ? 1. + 2. * x[0] - 3. * x[1]
                                                    : 0.;
      of_hoop = std::max(of_hoop, std::abs(both.space_gradient(q, cell.points[q])[2][2] - hoop));
      const Tensor<1, dim> slope = pressure.gradient(0, q, inverse_jacobian);
      of_pressures = std::max({of_pressures, std::abs(pressure.value(0, q) - 2. - x[0]),
                               (slope - Point<dim>::unit_vector(0)).norm()});
    }
  }
  check::absolute(name + ", values", of_values, 0., 1e-12);
  check::absolute(name + ", gradients", of_slopes, 0., 1e-12);
  check::absolute(name + ", across the plane", of_hoop, 0., 1e-12);
  check::absolute(name + ", pressure", of_pressures, 0., 1e-12);
}
} // namespace

UNIT_TEST(values_at_points)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  small_problem::Mesh<2> mesh(MPI_COMM_WORLD);
  small_problem::make_box<2>(mesh, {2, 2});
  for (const Model model : {Model::plane_strain, Model::axisymmetric})
  {
    const std::string name = model == Model::plane_strain ? "plane" : "ring from the axis on";
    Space<2> space(mesh, SpaceParameters(), model, 1);
    space.distribute();
    check_points<2>(name, space, QGauss<2>(4));
    check_points<2>(name + ", vertices", space, QTrapezoid<2>());
  }
  small_problem::Mesh<3> solid_mesh(MPI_COMM_WORLD);
  small_problem::make_box<3>(solid_mesh, {1, 2, 1});
  Space<3> space(solid_mesh, SpaceParameters(), Model::three_dimensional, 1);
  space.distribute();
  check_points<3>("space", space, QGauss<3>(3));
}
} // namespace test_of_values_at_points
