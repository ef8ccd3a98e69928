// The pressure equation's matrix by hand: compressibility alone between walls, the Laplacian of a
// quadratic function with the inverse of the momentum equations' diagonal or of the correction,
// free boundaries, two materials; its factor is the inverse, and the faces' pressures follow or
// stay.

#include <continua/finite_volume/pressure_equation.h>

#include "cell_wise_step.h"

#include "../unit_test.h"

#include <algorithm>

namespace test_of_pressure_equation
{
namespace
{
using namespace cell_wise_meshes;

CellWiseCoefficients with_mobility(const double mobility)
{
  CellWiseCoefficients coefficients = make_coefficients();
  coefficients.increment_mobility = {mobility, mobility};
  return coefficients;
}

template <int dim>
struct Pressures : public CellWiseStep<dim>
{
  using Vector = typename SplitEquations<dim>::Vector;

  Pressures(
      const std::function<void(Triangulation<dim> &)> &make_mesh,
      const Model model,
      const double mobility,
      const std::function<void(Problem &)> &change = [](Problem &) {})
      : CellWiseStep<dim>(make_mesh, model, with_mobility(mobility), change),
        equations(this->system),
        links(this->system, equations),
        faces(this->system, equations, links),
        equation(this->system, equations, links, faces)
  {
    equations.reinit();
    links.reinit(false);
    faces.reinit();
    equation.reinit();
    first = equations.cell_mass().first;
  }
  Vector product(const std::function<double(const dealii::Point<dim> &)> &function) const
  {
    Vector x = equations.vector(), y = equations.vector();
    for (unsigned int cell = 0; cell < this->space.mesh.n_owned_cells(); ++cell)
      x.begin()[first + cell] = function(this->space.mesh.cells()[cell].centre);
    x.update_ghost_values();
    equation.multiply(x, y);
    return y;
  }

  SplitEquations<dim> equations;
  FaceLinks<dim> links;
  FaceBalance<dim> faces;
  PressureEquation<dim> equation;
  unsigned int first; ///< row of the cells' pressures
};

/// Cells of width h; y = 1 is free, the rest are walls. The diagonal of the momentum equations over
/// the volume is 10 + 4 (2 dim + number of boundary faces)/h^2.
template <int dim>
void check_one_material(const Model model, const double mobility)
{
  const std::string name = std::string(model == Model::axisymmetric ? "axisymmetric"
                                       : dim == 2                   ? "2-D"
                                                                    : "3-D") +
                           (mobility > 0. ? ", increment: " : ": ");
  constexpr unsigned int n = dim == 2 ? 6 : 4;
  const double h = 1. / n;
  Pressures<dim> body([](Triangulation<dim> &mesh) { make_uniform_box(mesh, n); }, model, mobility,
                      [](Problem &problem) { set_free(problem.conditions[3]); });
  const auto &mesh = body.space.mesh;
  const auto ones = body.product([](const dealii::Point<dim> &) { return 1.; });
  const auto squares = body.product([](const dealii::Point<dim> &p) { return p[0] * p[0]; });
  double constant = 0., quadratic = 0., inverse = 0.;
  unsigned int n_deep = 0;
  for (unsigned int cell = 0; cell < mesh.n_owned_cells(); ++cell)
  {
    const auto &volume = mesh.cells()[cell];
    unsigned int n_boundary = 0;
    double free_area = 0.;
    for (const unsigned int f : volume.faces)
    {
      n_boundary += mesh.faces()[f].at_boundary();
      if (mesh.faces()[f].at_boundary() && mesh.faces()[f].boundary_id == 3)
        free_area = mesh.faces()[f].area;
    }
    double diagonal = 10. + 4. * (2. * dim + n_boundary) / (h * h);
    if (model == Model::axisymmetric)
    {
      // Faces outside and inside are larger and smaller by h/(2 r); there is none on the axis.
      const double r = volume.centre[1];
      const bool at_rim = r > 1. - h, at_end = volume.centre[0] < h || volume.centre[0] > 1. - h;
      diagonal = 10. + 4. *
                           (2. + (at_end ? 1. : 0.) + (1. + 0.5 * h / r) * (at_rim ? 2. : 1.) +
                            (1. - 0.5 * h / r)) /
                           (h * h);
    }
    inverse = std::max(
        inverse, std::abs(body.equation.inverse_momentum()[cell] * diagonal * volume.volume - 1.));
    // A free face is h/2 away.
    const double at_free =
        std::max(1. / diagonal, 0.25 * 0.25 * h * h * mobility) * free_area / (0.5 * h);
    constant = std::max(constant,
                        std::abs(ones.begin()[body.first + cell] - 0.5 * volume.volume - at_free) /
                            volume.volume);
    if (!is_deep_inside<dim>(volume.centre, 2. * h) || model == Model::axisymmetric)
      continue;
    ++n_deep;
    const double tau = std::max(1. / diagonal, 0.25 * h * h * mobility);
    quadratic = std::max(quadratic, std::abs(squares.begin()[body.first + cell] / volume.volume -
                                             0.5 * volume.centre[0] * volume.centre[0] + 2. * tau));
  }
  check::absolute(name + "a constant", largest(constant), 0., 1e-11);
  check::absolute(name + "1/a_P", largest(inverse), 0., 1e-12);
  if (n > 4 && model != Model::axisymmetric)
  {
    check::is_true(name + "cells inside", sum(n_deep) > 0.);
    check::absolute(name + "a quadratic function", largest(quadratic), 0., 1e-12);
  }

  auto x = body.equations.vector(), y = x, z = x;
  std::mt19937 generator(1 + dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD));
  std::uniform_real_distribution<double> distribution(-1., 1.);
  for (unsigned int cell = 0; cell < mesh.n_owned_cells(); ++cell)
    x.begin()[body.first + cell] = distribution(generator);
  x.update_ghost_values();
  body.equation.multiply(x, y);
  z = 9.;
  body.equation.solve(y, z);
  double error = 0., faces = 0.;
  for (unsigned int cell = 0; cell < mesh.n_owned_cells(); ++cell)
    error = std::max(error, std::abs(z.begin()[body.first + cell] - x.begin()[body.first + cell]));
  for (unsigned int f = 0; f < mesh.faces().size(); ++f)
    if (mesh.faces()[f].at_boundary())
    {
      const double of_face =
          z.begin()[body.equations.pressure_index(body.space.pressures.of_face(f, 0))];
      const double of_cell = z.begin()[body.equations.pressure_index(
          body.space.pressures.of_cell(mesh.faces()[f].owner))];
      faces =
          std::max(faces, std::abs(of_face - (mesh.faces()[f].boundary_id == 3 ? 0. : of_cell)));
    }
  check::absolute(name + "the factor is the inverse", largest(error), 0., 1e-12);
  check::absolute(name + "faces follow, or stay where they are free", largest(faces), 0., 0.);
}

/// Springs of 8 and 4 at the face between two squares; the diagonals are 10 + 4 (8/0.25) = 138 and
/// 20 + 2 (8/0.25) = 84. The face, of area 1/2, yields by 1/12 and by the cells', 1/2 apart.
void check_two_materials()
{
  Pressures<2> body(make_two_squares, Model::plane_strain, 0.);
  const auto product = body.product([](const dealii::Point<2> &p) { return p[0] < 0.5 ? 0. : 1.; });
  const double conductance = 0.5 * (0.5 / 12. + (2. / 3. / 138. + 1. / 3. / 84.) / 0.5);
  double left = 0., right = 0.;
  for (unsigned int cell = 0; cell < body.space.mesh.n_owned_cells(); ++cell)
    (body.space.mesh.cells()[cell].material_id == 0 ? left : right) =
        product.begin()[body.first + cell];
  check::absolute("two materials: first", sum(left), -conductance, 1e-14);
  // 1/(K b) of the second is 1/4, its volume 1/4.
  check::absolute("two materials: second", sum(right), 0.0625 + conductance, 1e-14);
}
} // namespace

UNIT_TEST(pressure_equation)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  quiet_other_ranks();
  check_one_material<2>(Model::plane_strain, 0.);
  check_one_material<2>(Model::plane_strain, 5.);
  check_one_material<2>(Model::axisymmetric, 0.);
  check_one_material<3>(Model::three_dimensional, 0.);
  check_two_materials();
}
} // namespace test_of_pressure_equation
