// Vectors over a change of the mesh that divides cells and puts others together, on boundaries and
// interfaces too: linear functions stay what they are, sums over the volumes are kept, and what a
// boundary holds stays held.

#include <continua/finite_volume/cell_wise_transfer.h>

#include "../unit_test.h"
#include "cell_wise_body.h"

#include <algorithm>

namespace test_of_cell_wise_transfer
{
using namespace cell_wise_meshes;
using dealii::Point;
using dealii::Tensor;

namespace
{
/// Divides coarse cells far from the origin, and puts fine ones together; whether there are both.
template <int dim>
bool flag(Triangulation<dim> &mesh)
{
  double radius = 0.;
  for (const Point<dim> &vertex : mesh.get_vertices())
    radius = std::max(radius, vertex.norm());
  radius = largest(radius);
  for (const auto &cell : mesh.active_cell_iterators())
    if (cell->is_locally_owned())
    {
      if (cell->level() > 0)
        cell->set_coarsen_flag();
      else if (cell->center().norm() > 0.5 * radius)
        cell->set_refine_flag();
    }
  mesh.prepare_coarsening_and_refinement();
  std::array<double, 2> n_flagged = {{0., 0.}};
  for (const auto &cell : mesh.active_cell_iterators())
    if (cell->is_locally_owned())
    {
      n_flagged[0] += cell->refine_flag_set() ? 1. : 0.;
      n_flagged[1] += cell->coarsen_flag_set() ? 1. : 0.;
    }
  return sum(n_flagged[0]) > 0. && sum(n_flagged[1]) > 0.;
}

/// Carries a velocity and a pressure over; `held`: the conditions hold all boundaries.
template <int dim>
class Transfer
{
public:
  Transfer(const std::function<void(Triangulation<dim> &)> &make_mesh,
           const Model model,
           const bool held)
      : body(make_mesh, model), conditions(body.space, body.problem.conditions)
  {
    for (BoundaryCondition &condition : body.problem.conditions)
    {
      if (held)
        continue;
      if (condition.boundary_id % 2 == 0)
        condition.normal.kind = condition.tangential.kind = BoundaryPart::Kind::traction;
      // Else a velocity that is not zero.
      for (unsigned int c = 0; c < dim; ++c)
      {
        condition.normal.vector.emplace_back(Expression("1 + x + y", Dimensions::none));
        condition.tangential.vector.emplace_back(Expression("1 + x + y", Dimensions::none));
      }
    }
    conditions.build();
  }
  /// Whether cells are divided and others put together.
  bool carry()
  {
    CellWiseTransfer<dim> transfer(body.space, conditions, body.problem.conditions,
                                   body.evaluation.reconstruction());
    const bool both = flag(body.triangulation);
    transfer.prepare({&body.velocity}, {&body.pressure});
    body.triangulation.execute_coarsening_and_refinement();
    body.space.distribute();
    conditions.build();
    body.evaluation.build();
    body.velocity = body.space.velocity_vector();
    body.pressure = body.space.pressure_vector();
    transfer.finish({&body.velocity}, {&body.pressure});
    return both;
  }
  /// Sums over the volumes of the cells: velocity x and pressure.
  std::array<double, 2> sums() const
  {
    std::array<double, 2> result = {{0., 0.}};
    for (unsigned int cell = 0; cell < body.space.mesh.n_owned_cells(); ++cell)
    {
      const double volume = body.space.mesh.cells()[cell].volume;
      result[0] +=
          volume *
          body.velocity.begin()[body.space.local_velocity(body.space.velocities.of_cell(cell))];
      result[1] +=
          volume *
          body.pressure.begin()[body.space.local_pressure(body.space.pressures.of_cell(cell))];
    }
    return {{sum(result[0]), sum(result[1])}};
  }
  Body<dim> body;
  FaceConditions<dim> conditions;
};

template <int dim>
void test_linear(const std::string &name, const std::function<void(Triangulation<dim> &)> &make)
{
  Transfer<dim> transfer(make, dim == 2 ? Model::plane_strain : Model::three_dimensional, false);
  Body<dim> &body = transfer.body;
  const VectorFunction<dim> velocity = [](const Point<dim> &x)
  {
    Tensor<1, dim> result;
    for (unsigned int c = 0; c < dim; ++c)
      result[c] = linear<dim>(x) - c * x[0];
    return result;
  };
  const PressureFunction<dim> pressure = [](const Point<dim> &x, const unsigned int region)
  { return linear<dim>(x) + 100. * region; };
  body.velocity = velocity_field<dim>(body.space, velocity);
  body.pressure = pressure_field<dim>(body.space, pressure);
  const std::array<double, 2> before = transfer.sums();
  check::is_true(name + ": cells are divided and put together", transfer.carry());
  DistributedVector exact = velocity_field<dim>(body.space, velocity);
  exact -= body.velocity;
  check::absolute(name + ": velocity", exact.linfty_norm(), 0., 1e-12);
  exact = pressure_field<dim>(body.space, pressure);
  exact -= body.pressure;
  check::absolute(name + ": pressure", exact.linfty_norm(), 0., 1e-11);
  check::relative(name + ": momentum", transfer.sums()[0], before[0], 1e-12);
  check::relative(name + ": volume", transfer.sums()[1], before[1], 1e-12);
}

/// The way that a liquid's cells have gone leaves the wall where it is.
template <int dim>
void test_interface(const std::string &name)
{
  Transfer<dim> transfer(
      [](Triangulation<dim> &mesh)
      {
        make_box(mesh, 4);
        refine_corner(mesh);
      },
      dim == 2 ? Model::plane_strain : Model::three_dimensional, false);
  Body<dim> &body = transfer.body;
  const VectorFunction<dim> displacement = [](const Point<dim> &x)
  {
    Tensor<1, dim> result;
    result[0] = linear<dim>(x);
    return result;
  };
  body.velocity = velocity_field<dim>(body.space, displacement);
  for (unsigned int cell = 0; cell < body.space.mesh.n_owned_cells(); ++cell)
    if (const auto &volume = body.space.mesh.cells()[cell]; volume.material_id == 1)
      body.velocity.begin()[body.space.local_velocity(body.space.velocities.of_cell(cell))] +=
          50. * (volume.centre[0] + volume.centre[1]);
  check::is_true(name + ", interface: cells are divided and put together", transfer.carry());
  double largest_error = 0., n_found = 0.;
  for (unsigned int face = 0; face < body.space.mesh.faces().size(); ++face)
  {
    const VolumeFace<dim> &surface = body.space.mesh.faces()[face];
    if (!surface.is_interface || !body.space.velocities.owns_face(face, 0))
      continue;
    const double value =
        body.velocity.begin()[body.space.local_velocity(body.space.velocities.of_face(face, 0))];
    largest_error = std::max(largest_error, std::abs(value - displacement(surface.centre)[0]));
    n_found += 1.;
  }
  check::is_true(name + ", interface: there is one", sum(n_found) > 0.);
  check::absolute(name + ", interface: displacement", largest(largest_error), 0., 1e-12);
}

/// Cells put together in axisymmetry keep the sums of any field; those that are divided are exact
/// for linear functions only.
void test_axisymmetric()
{
  Transfer<2> transfer(
      [](Triangulation<2> &mesh)
      {
        make_box(mesh, 4);
        refine(mesh);
      },
      Model::axisymmetric, true);
  Body<2> &body = transfer.body;
  const VectorFunction<2> velocity = [](const Point<2> &x) {
    return Tensor<1, 2>({x[0] * x[1], std::sin(7. * x[0]) * x[1]});
  };
  body.velocity = velocity_field<2>(body.space, velocity);
  body.pressure = pressure_field<2>(body.space, [](const Point<2> &x, unsigned int)
                                    { return std::exp(x[0] + x[1]); });
  const std::array<double, 2> before = transfer.sums();
  // Of all cells four make one.
  for (const auto &cell : body.triangulation.active_cell_iterators())
    if (cell->is_locally_owned())
      cell->set_coarsen_flag();
  CellWiseTransfer<2> cell_transfer(body.space, transfer.conditions, body.problem.conditions,
                                    body.evaluation.reconstruction());
  body.triangulation.prepare_coarsening_and_refinement();
  cell_transfer.prepare({&body.velocity}, {&body.pressure});
  body.triangulation.execute_coarsening_and_refinement();
  body.space.distribute();
  transfer.conditions.build();
  body.velocity = body.space.velocity_vector();
  body.pressure = body.space.pressure_vector();
  cell_transfer.finish({&body.velocity}, {&body.pressure});
  check::absolute("axisymmetric: a quarter of the cells",
                  body.triangulation.n_global_active_cells(), 16., 0.);
  check::relative("axisymmetric: momentum", transfer.sums()[0], before[0], 1e-13);
  check::relative("axisymmetric: volume", transfer.sums()[1], before[1], 1e-13);
}

void test_held()
{
  Transfer<2> transfer(
      [](Triangulation<2> &mesh)
      {
        make_box(mesh, 4);
        refine_corner(mesh);
      },
      Model::plane_strain, true);
  Body<2> &body = transfer.body;
  body.velocity = velocity_field<2>(body.space,
                                    [](const Point<2> &x) {
                                      return Tensor<1, 2>({x[0] * x[1], x[0] * (1. + x[1])});
                                    });
  for (unsigned int i = 0; i < 2; ++i)
    transfer.carry();
  double largest_value = 0.;
  for (unsigned int face = 0; face < body.space.mesh.faces().size(); ++face)
  {
    const VolumeFace<2> &surface = body.space.mesh.faces()[face];
    if (surface.at_boundary() && surface.boundary_id == 0)
      for (unsigned int c = 0; c < 2; ++c)
        largest_value =
            std::max(largest_value,
                     std::abs(body.velocity.begin()[body.space.local_velocity(
                                                        body.space.velocities.of_face(face, 0)) +
                                                    c]));
  }
  check::absolute("what is held", largest(largest_value), 0., 0.);
}
} // namespace

UNIT_TEST(cell_wise_transfer)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  quiet_other_ranks();
  test_linear<2>("2-D, Cartesian",
                 [](Triangulation<2> &mesh)
                 {
                   make_box(mesh, 4);
                   refine_corner(mesh);
                 });
  test_linear<2>("2-D, projective",
                 [](Triangulation<2> &mesh)
                 {
                   make_box(mesh, 4);
                   project(mesh);
                   refine_corner(mesh);
                 });
  test_linear<3>("3-D, sheared",
                 [](Triangulation<3> &mesh)
                 {
                   make_box(mesh, 4);
                   shear(mesh);
                   refine_corner(mesh);
                 });
  test_interface<2>("2-D");
  test_interface<3>("3-D");
  test_axisymmetric();
  test_held();
}
} // namespace test_of_cell_wise_transfer
