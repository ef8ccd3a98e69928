// The equations of a step: their products with linear fields, that the list of their entries is the
// same matrix, diagonals and the correction of the fluxes on squares and cubes by hand, and what
// stands in the rows of prescribed velocities.

#include "cell_wise_step.h"

#include "../unit_test.h"

#include <algorithm>

namespace test_of_cell_wise_system
{
namespace
{
using namespace cell_wise_meshes;

std::string kind_of(const Model model)
{
  return model == Model::axisymmetric   ? "axisymmetric: "
         : model == Model::plane_strain ? "2-D: "
                                        : "3-D: ";
}

/// U = (2 x, 3 y, -z), in axisymmetry (2 x, 3 r), and p = 1 + 2 x + 3 y + 4 z.
template <int dim>
dealii::Tensor<1, dim> linear_velocity(const dealii::Point<dim> &p)
{
  dealii::Tensor<1, dim> u;
  u[0] = 2. * p[0];
  u[1] = 3. * p[1];
  if (dim == 3)
    u[dim - 1] = -p[dim - 1];
  return u;
}

/// mass V U + V grad p in a cell, and V (p/(K b) + div U): stresses are constant, and the
/// correction of the fluxes does nothing to a linear pressure. (In axisymmetry on meshes whose
/// faces are along the coordinates and do not hang.)
template <int dim>
void check_linear_fields(const Model model)
{
  const bool axisymmetric = model == Model::axisymmetric;
  const CellWiseStep<dim> step(
      [axisymmetric](Triangulation<dim> &mesh)
      {
        make_box(mesh, 4);
        if (axisymmetric)
        {
          grade(mesh);
          return;
        }
        refine_corner(mesh);
        if (dim == 2)
          project(mesh);
      },
      model, make_coefficients(),
      [](Problem &problem) { problem.materials[1] = problem.materials[0]; });
  const CellWiseSpace<dim> &space = step.space;
  const DistributedVector velocity = velocity_field<dim>(space, linear_velocity<dim>);
  const DistributedVector pressure = pressure_field<dim>(
      space, [](const dealii::Point<dim> &p, const unsigned int) { return linear<dim>(p); });
  DistributedVector momentum = space.velocity_vector(), mass = space.pressure_vector();
  step.system.multiply(velocity, pressure, momentum, mass);
  const CellWiseCoefficients &coefficients = step.system.coefficients();
  const double divergence = dim == 3 ? 4. : axisymmetric ? 8. : 5.;
  double momentum_error = 0., mass_error = 0.;
  for (unsigned int cell = 0; cell < space.mesh.n_owned_cells(); ++cell)
  {
    const auto &volume = space.mesh.cells()[cell];
    const dealii::Tensor<1, dim> u = linear_velocity<dim>(volume.centre);
    for (unsigned int c = 0; c < dim; ++c)
      momentum_error = std::max(
          momentum_error, std::abs(momentum.begin()[step.cell_row(cell) + c] -
                                   volume.volume * (coefficients.mass[volume.material_id] * u[c] +
                                                    slope<dim>()[c])));
    mass_error = std::max(
        mass_error, std::abs(mass.begin()[step.cell_pressure_row(cell)] -
                             volume.volume * (coefficients.compressibility[volume.material_id] *
                                                  linear<dim>(volume.centre) +
                                              divergence)));
  }
  check::absolute(kind_of(model) + "momentum", largest(momentum_error), 0., 1e-12);
  check::absolute(kind_of(model) + "mass", largest(mass_error), 0., 1e-12);

  // The correction only moves volume from one cell to the next.
  DistributedVector rough = space.pressure_vector(), moved = rough;
  fill_at_random(rough, 1);
  step.system.add_pressure_correction(1., rough, moved);
  double total = 0., size = 0.;
  for (const double value : moved)
  {
    total += value;
    size = std::max(size, std::abs(value));
  }
  check::absolute(kind_of(model) + "the correction keeps the volume", sum(total) / largest(size),
                  0., 1e-12);
}

/// The list of entries is the same matrix as multiply(), but for the rows of prescribed directions.
template <int dim>
void check_entries(const Model model)
{
  const CellWiseStep<dim> step(
      [](Triangulation<dim> &mesh)
      {
        make_box(mesh, 4);
        shear(mesh);
      },
      model, make_coefficients(),
      [](Problem &problem)
      {
        set_roller(problem.conditions[0]);
        set_free(problem.conditions[1]);
      });
  const CellWiseSpace<dim> &space = step.space;
  DistributedVector velocity = space.velocity_vector(), pressure = space.pressure_vector(),
                    momentum = velocity, mass = pressure;
  fill_at_random(velocity, 1);
  fill_at_random(pressure, 2);
  step.system.multiply(velocity, pressure, momentum, mass);
  // With the velocities as what is prescribed, the right side is the product.
  step.system.set_prescribed(velocity, momentum);
  const std::vector<double> x = all_unknowns<dim>(space, velocity, pressure);
  std::vector<double> product(x.size(), 0.);
  step.system.for_entries([&](const int row, const int column, const double value)
                          { product[row] += value * x[column]; });
  dealii::Utilities::MPI::sum(product, MPI_COMM_WORLD, product);
  const std::vector<double> expected = all_unknowns<dim>(space, momentum, mass);
  double error = 0., size = 0.;
  for (unsigned int i = 0; i < x.size(); ++i)
  {
    error = std::max(error, std::abs(product[i] - expected[i]));
    size = std::max(size, std::abs(expected[i]));
  }
  check::absolute(kind_of(model) + "entries and product", error / size, 0., 1e-13);

  // Prescribed directions: the velocity times mass V + stiffness A/d.
  double scale_error = 0., row_error = 0.;
  const CellWiseCoefficients &coefficients = step.system.coefficients();
  for (const auto &face : step.conditions.faces())
  {
    const auto &surface = space.mesh.faces()[face.face];
    const auto &cell = space.mesh.cells()[surface.owner];
    const double scale = coefficients.mass[cell.material_id] * cell.volume +
                         coefficients.stiffness[cell.material_id] * face.weight /
                             ((surface.centre - cell.centre) * surface.normal);
    scale_error = std::max(scale_error, std::abs(step.system.scale(face) / scale - 1.));
    dealii::Tensor<1, dim> row, u;
    for (unsigned int c = 0; c < dim; ++c)
    {
      row[c] = product[dim * space.velocities.first_owned() + face.index + c];
      u[c] = velocity.begin()[face.index + c];
    }
    row_error = std::max(row_error, (face.prescribed * (row - scale * u)).norm());
  }
  check::absolute(kind_of(model) + "scale", largest(scale_error), 0., 1e-13);
  check::absolute(kind_of(model) + "prescribed rows", largest(row_error) / size, 0., 1e-13);
}

/// One region in cells of h = 1/8 or, in 3-D, 1/6. A checkerboard of pressures makes compact normal
/// gradients of -2 p/h and no gradients of cells.
template <int dim>
void check_numbers(const double mobility)
{
  CellWiseCoefficients coefficients = make_coefficients();
  coefficients.increment_mobility = {mobility, mobility};
  constexpr unsigned int n = dim == 2 ? 8 : 6;
  const double h = 1. / n;
  CellWiseStep<dim> step([](Triangulation<dim> &mesh) { make_uniform_box(mesh, n); },
                         dim == 2 ? Model::plane_strain : Model::three_dimensional, coefficients);
  const CellWiseSpace<dim> &space = step.space;
  const auto sign = [](const dealii::Point<dim> &p)
  {
    int place = 0;
    for (unsigned int c = 0; c < dim; ++c)
      place += static_cast<int>(std::floor(n * p[c]));
    return place % 2 == 0 ? 1. : -1.;
  };
  const DistributedVector pressure = pressure_field<dim>(
      space, [&](const dealii::Point<dim> &p, const unsigned int) { return sign(p); });
  DistributedVector of_pressure = space.pressure_vector(), of_increment = of_pressure;
  step.system.add_pressure_correction(1., pressure, of_pressure);
  step.system.add_increment_correction(1., pressure, of_increment);
  // a_P/V: 10 + 3 (4/3) 2 dim/h^2; a wall beside the cell is half as far away: once more 1/h^2.
  const double inside = 10. + 4. * 2. * dim / (h * h);
  double diagonal = 0., correction = 0., other = 0.;
  for (unsigned int cell = 0; cell < space.mesh.n_owned_cells(); ++cell)
  {
    const auto &volume = space.mesh.cells()[cell];
    unsigned int n_walls = 0;
    for (const unsigned int f : volume.faces)
      n_walls += space.mesh.faces()[f].at_boundary();
    diagonal = std::max(diagonal, std::abs(step.system.momentum_diagonal()[cell] - inside -
                                           4. * n_walls / (h * h)));
    if (!is_deep_inside<dim>(volume.centre, 2. * h))
      continue;
    // Through 2 dim faces of h^(dim-1), tau (-2 p/h); tau = V/a_P, or h^2/4 times the mobility.
    const double tau = mobility > 0. ? 0.25 * h * h * mobility : 1. / inside;
    const double expected = -4. * dim * std::pow(h, dim - 2.) * tau * sign(volume.centre);
    const unsigned int row = step.cell_pressure_row(cell);
    correction = std::max(
        correction, std::abs((mobility > 0. ? of_increment : of_pressure).begin()[row] - expected));
    other = std::max(other, std::abs((mobility > 0. ? of_pressure : of_increment).begin()[row]));
  }
  const std::string kind = std::string(dim == 2 ? "squares, " : "cubes, ") +
                           (mobility > 0. ? "increment: " : "pressure: ");
  check::absolute(kind + "diagonal", largest(diagonal), 0., 1e-9);
  check::absolute(kind + "checkerboard", largest(correction), 0., 1e-14);
  check::absolute(kind + "nothing else", largest(other), 0., 0.);
  check::is_true(kind + "one matrix",
                 (step.system.pressure_correction() == nullptr) == (mobility > 0.) &&
                     (step.system.increment_correction() == nullptr) == (mobility == 0.));
  check::is_true(kind + "the same again", !step.system.prepare(coefficients));
  coefficients.mass[0] *= 1.001;
  check::is_true(kind + "a new one", step.system.prepare(coefficients));
  coefficients.correct_fluxes = false;
  step.system.prepare(coefficients);
  check::is_true(kind + "without correction", step.system.pressure_correction() == nullptr &&
                                                  step.system.increment_correction() == nullptr);
}
} // namespace

UNIT_TEST(cell_wise_system)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  quiet_other_ranks();
  check_linear_fields<2>(Model::plane_strain);
  check_linear_fields<2>(Model::axisymmetric);
  check_linear_fields<3>(Model::three_dimensional);
  check_entries<2>(Model::plane_strain);
  check_entries<2>(Model::axisymmetric);
  check_entries<3>(Model::three_dimensional);
  check_numbers<2>(0.);
  check_numbers<2>(0.7);
  check_numbers<3>(0.);
}
} // namespace test_of_cell_wise_system
