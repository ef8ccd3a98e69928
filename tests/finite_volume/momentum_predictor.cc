// The predictor's matrices: mass alone on what moves as one, the Laplacian of a quadratic function,
// links of two materials in series, walls that hold, the hoop term; they are symmetric, and the
// factor is their inverse.

#include <continua/finite_volume/momentum_predictor.h>

#include "cell_wise_step.h"

#include "../unit_test.h"

#include <algorithm>

namespace test_of_momentum_predictor
{
namespace
{
using namespace cell_wise_meshes;

template <int dim>
struct Predictor : public CellWiseStep<dim>
{
  using Vector = typename SplitEquations<dim>::Vector;

  Predictor(const std::function<void(Triangulation<dim> &)> &make_mesh,
            const Model model,
            const std::function<void(Problem &)> &change)
      : CellWiseStep<dim>(make_mesh, model, make_coefficients(), change),
        equations(this->system),
        links(this->system, equations),
        predictor(this->system, equations, links)
  {
    equations.reinit();
    links.reinit(false);
    predictor.reinit();
  }
  /// Values at the centres of the cells; of all components the same.
  Vector cell_values(const std::function<double(const dealii::Point<dim> &)> &function) const
  {
    Vector result = equations.vector();
    for (unsigned int cell = 0; cell < this->space.mesh.n_owned_cells(); ++cell)
      for (unsigned int c = 0; c < dim; ++c)
        result.begin()[dim * cell + c] = function(this->space.mesh.cells()[cell].centre);
    result.update_ghost_values();
    return result;
  }
  Vector product(const Vector &x) const
  {
    Vector y = equations.vector();
    predictor.multiply(x, y);
    return y;
  }

  SplitEquations<dim> equations;
  FaceLinks<dim> links;
  MomentumPredictor<dim> predictor;
};

/// One material of mass 10 and stiffness 3 (4/3), in cells of width h; x = 0 is a wall, the other
/// boundaries are free.
template <int dim>
void check_one_material(const Model model)
{
  const bool axisymmetric = model == Model::axisymmetric;
  const std::string name = axisymmetric ? "axisymmetric: " : dim == 2 ? "2-D: " : "3-D: ";
  constexpr unsigned int n = dim == 2 ? 6 : 4;
  const double h = 1. / n;
  Predictor<dim> body([](Triangulation<dim> &mesh) { make_uniform_box(mesh, n); }, model,
                      [](Problem &problem)
                      {
                        for (unsigned int b = 1; b < problem.conditions.size(); ++b)
                          set_free(problem.conditions[b]);
                      });
  const auto &cells = body.space.mesh.cells();
  const unsigned int n_rows = dim * body.space.mesh.n_owned_cells();
  // Away from boundaries the Laplacian of x^2 is 2.
  const auto ones = body.product(body.cell_values([](const dealii::Point<dim> &) { return 1.; }));
  const auto squares =
      body.product(body.cell_values([](const dealii::Point<dim> &p) { return p[0] * p[0]; }));
  double constant = 0., quadratic = 0., sums = 0.;
  for (unsigned int row = 0; row < n_rows; ++row)
  {
    const auto &cell = cells[row / dim];
    double expected = 10. * cell.volume;
    // The wall is h/2 away. (Its pressure adds K to what holds the cell along the normal.)
    const bool beside_wall = cell.centre[0] < h;
    const double area = cell.volume / h;
    if (beside_wall && row % dim > 0)
      expected += 4. * area / (0.5 * h);
    const bool has_hoop_term = axisymmetric && row % dim == 1;
    if (has_hoop_term)
      expected += 4. * cell.volume / (cell.radius * cell.radius);
    if (!(beside_wall && row % dim == 0))
      constant = std::max(constant, std::abs(ones.begin()[row] - expected));
    else
      // K = 2 and 4/3 mu = 4.
      constant = std::max(
          constant, std::abs(ones.begin()[row] - 10. * cell.volume - (4. + 2.) * area / (0.5 * h)));
    sums = std::max(sums, std::abs(ones.begin()[row] - body.predictor.row_sums()[row]));
    if (cell.centre[0] > h && cell.centre[0] < 1. - h && !has_hoop_term)
      quadratic = std::max(
          quadratic, std::abs(squares.begin()[row] -
                              cell.volume * (10. * cell.centre[0] * cell.centre[0] - 4. * 2.)));
  }
  check::absolute(name + "uniform motion", largest(constant), 0., 1e-11);
  check::absolute(name + "row sums", largest(sums), 0., 1e-13);
  check::absolute(name + "a quadratic function", largest(quadratic), 0., 1e-11);

  auto x = body.equations.vector(), y = x, z = x;
  std::mt19937 generator(1 + dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD));
  std::uniform_real_distribution<double> distribution(-1., 1.);
  for (unsigned int row = 0; row < n_rows; ++row)
  {
    x.begin()[row] = distribution(generator);
    y.begin()[row] = distribution(generator);
  }
  x.update_ghost_values();
  y.update_ghost_values();
  const auto of_x = body.product(x), of_y = body.product(y);
  double asymmetry = 0., error = 0.;
  for (unsigned int row = 0; row < n_rows; ++row)
    asymmetry += y.begin()[row] * of_x.begin()[row] - x.begin()[row] * of_y.begin()[row];
  body.predictor.solve(of_x, z);
  for (unsigned int row = 0; row < n_rows; ++row)
    error = std::max(error, std::abs(z.begin()[row] - x.begin()[row]));
  check::absolute(name + "symmetric", sum(asymmetry), 0., 1e-11);
  check::absolute(name + "the factor is the inverse", largest(error), 0., 1e-12);
  // Along the wall and across it a cell is held by different springs; two components share one.
  check::is_true(name + "a factor",
                 body.predictor.factor_entries() >= 2. * body.space.mesh.cell_dofs.n_dofs() &&
                     states_memory(body.predictor.factor_memory()) &&
                     !body.predictor.name().empty());
}

/// Two squares of width 1/2, moduli of 4 and 2: the face between them is half-way, 1/4 from either
/// centre, so that the links are 4 (1/2)/(1/4) = 8 and 4, in series 8/3.
void check_two_materials()
{
  Predictor<2> body(make_two_squares, Model::plane_strain,
                    [](Problem &problem)
                    {
                      for (BoundaryCondition &condition : problem.conditions)
                        set_free(condition);
                    });
  const auto product = body.product(
      body.cell_values([](const dealii::Point<2> &p) { return p[0] < 0.5 ? 0. : 1.; }));
  double left = 0., right = 0.;
  for (unsigned int cell = 0; cell < body.space.mesh.n_owned_cells(); ++cell)
    (body.space.mesh.cells()[cell].material_id == 0 ? left : right) = product.begin()[2 * cell];
  check::absolute("in series: first", sum(left), -8. / 3., 1e-13);
  check::absolute("in series: second", sum(right), 20. / 4. + 8. / 3., 1e-13);
}
} // namespace

UNIT_TEST(momentum_predictor)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  quiet_other_ranks();
  check_one_material<2>(Model::plane_strain);
  check_one_material<2>(Model::axisymmetric);
  check_one_material<3>(Model::three_dimensional);
  check_two_materials();
}
} // namespace test_of_momentum_predictor
