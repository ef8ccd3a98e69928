// The divergence by the values on faces: linear fields, what is conserved, the hoop term, and
// observed orders.

#include "cell_wise_meshes.h"

#include "../unit_test.h"

#include <algorithm>

namespace test_of_divergence
{
using namespace cell_wise_meshes;

namespace
{
/// Sum over a vector field's components, each with values of its own.
template <int dim>
double evaluate_vector(const Stencil<dealii::Tensor<1, dim>> &stencil,
                       const std::vector<std::vector<double>> &values)
{
  double result = 0.;
  for (const auto &entry : stencil)
    for (unsigned int c = 0; c < dim; ++c)
      result += entry.second[c] * values[c][entry.first];
  return result;
}

template <int dim>
void check_plane()
{
  on_each<dim>(
      flat_faced<dim>(), false,
      [](const std::string &name, const Operators<dim> &operators)
      {
        const auto &mesh = operators.mesh;
        // u_c = (c + 1) x_c + x_0: divergence 1 + 1 + 2 (+ 3).
        std::vector<std::vector<double>> values, rough;
        for (unsigned int k = 0; k < dim; ++k)
        {
          values.push_back(operators.field([k](const dealii::Point<dim> &point)
                                           { return (k + 1.) * point[k] + point[0]; }));
          rough.push_back(operators.field([k](const dealii::Point<dim> &point)
                                          { return std::sin(1e3 * point.norm() + 1e2 * k); }));
        }
        const double exact = dim == 2 ? 4. : 7.;
        double error = 0., total = 0., through = 0.;
        for (unsigned int c = 0; c < mesh.n_owned_cells(); ++c)
        {
          const auto divergence = operators.divergence(c);
          error = std::max(
              error,
              std::abs(evaluate_vector(divergence, values) / mesh.cells()[c].volume - exact));
          total += evaluate_vector(divergence, rough);
        }
        for (unsigned int f = 0; f < mesh.faces().size(); ++f)
          if (mesh.faces()[f].at_boundary())
            for (unsigned int k = 0; k < dim; ++k)
              through += mesh.faces()[f].area * mesh.faces()[f].normal[k] *
                         rough[k][operators.space.of_face(f, 0)];
        check::absolute(name + ": linear fields", largest(error), 0., 1e-12);
        check::absolute(name + ": what leaves leaves through the boundary", sum(total - through),
                        0., 1e-13);
      });
}

/// The root mean square error for the smooth field (r^2 + x, r (1 + cos x + r^2)) of a body of
/// revolution.
double axisymmetric_error(const Sequence &sequence, const unsigned int n)
{
  Triangulation<2> triangulation(MPI_COMM_WORLD);
  sequence.make(triangulation, n);
  CellWiseMesh<2> mesh(triangulation, true);
  mesh.build();
  const Operators<2> operators(mesh, InterfaceValue::common);
  const std::vector<std::vector<double>> values = {
      operators.field([](const dealii::Point<2> &p) { return p[1] * p[1] + p[0]; }),
      operators.field([](const dealii::Point<2> &p)
                      { return p[1] * (1. + std::cos(p[0]) + p[1] * p[1]); })};
  double squares = 0., volume = 0.;
  for (unsigned int c = 0; c < mesh.n_owned_cells(); ++c)
  {
    const auto &cell = mesh.cells()[c];
    const double exact =
        1. + 2. * (1. + std::cos(cell.centre[0])) + 4. * cell.centre[1] * cell.centre[1];
    squares += cell.volume *
               std::pow(evaluate_vector(operators.divergence(c), values) / cell.volume - exact, 2);
    volume += cell.volume;
  }
  return std::sqrt(sum(squares) / sum(volume));
}

/// The same for a plane field of waves.
double plane_error(const Sequence &sequence, const unsigned int n)
{
  Triangulation<2> triangulation(MPI_COMM_WORLD);
  sequence.make(triangulation, n);
  CellWiseMesh<2> mesh(triangulation, false);
  mesh.build();
  const Operators<2> operators(mesh, InterfaceValue::common);
  const auto wave = operators.field(Waves<2>::value);
  double squares = 0., volume = 0.;
  for (unsigned int c = 0; c < mesh.n_owned_cells(); ++c)
  {
    const auto &cell = mesh.cells()[c];
    const auto gradient = Waves<2>::gradient(cell.centre);
    const double error = evaluate_vector(operators.divergence(c), {wave, wave}) / cell.volume -
                         gradient[0] - gradient[1];
    squares += cell.volume * error * error;
    volume += cell.volume;
  }
  return std::sqrt(sum(squares) / sum(volume));
}
} // namespace

UNIT_TEST(divergence)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  quiet_other_ranks();

  check_plane<2>();
  check_plane<3>();

  {
    // (x, r) of a body of revolution: 1 + 2, where the 2 is radial stretch and hoop together.
    Triangulation<2> triangulation(MPI_COMM_WORLD);
    make_box(triangulation, 4);
    grade(triangulation);
    CellWiseMesh<2> mesh(triangulation, true);
    mesh.build();
    const Operators<2> operators(mesh, InterfaceValue::common);
    const std::vector<std::vector<double>> values = {
        operators.field([](const dealii::Point<2> &point) { return point[0]; }),
        operators.field([](const dealii::Point<2> &point) { return point[1]; })};
    double error = 0.;
    for (unsigned int c = 0; c < mesh.n_owned_cells(); ++c)
      error = std::max(
          error,
          std::abs(evaluate_vector(operators.divergence(c), values) / mesh.cells()[c].volume - 3.));
    check::absolute("axisymmetric, graded: (x, r)", largest(error), 0., 1e-12);
  }
  on_each<2>(flat_faced<2>(), true,
             [](const std::string &name, const Operators<2> &operators)
             {
               // A rigid motion along the axis changes no volume.
               const std::vector<std::vector<double>> values = {
                   operators.field([](const dealii::Point<2> &) { return 1.; }),
                   operators.field([](const dealii::Point<2> &) { return 0.; })};
               double error = 0.;
               for (unsigned int c = 0; c < operators.mesh.n_owned_cells(); ++c)
                 error =
                     std::max(error, std::abs(evaluate_vector(operators.divergence(c), values)) /
                                         operators.mesh.cells()[c].volume);
               check::absolute(name + ": along the axis", largest(error), 0., 1e-12);
             });

  // As the gradient, of which it is the trace. In axisymmetry the flux through a face that is not
  // parallel to the axis is that of its middle, off by a twelfth of the product of what r and u
  // change by on it: on irregular cells an error beside the axis that does not become smaller, in a
  // layer whose volume is of order 2, so of order 1 in the mean.
  for (const auto &sequence : sequences())
  {
    const double coarse = plane_error(sequence, 16), fine = plane_error(sequence, 32);
    if (sequence.name == "random")
      check::is_true("2-D, random: at least of order 1", coarse / fine > 2.);
    else
      check_order("2-D, " + sequence.name, coarse, fine, 1.5);
    const double turned = axisymmetric_error(sequence, 16) / axisymmetric_error(sequence, 32);
    if (sequence.name == "random")
      check::is_true("axisymmetric, random: at least of order 1", turned > 2.);
    else
      check_order("axisymmetric, " + sequence.name, turned, 1., 1.5);
  }
}
} // namespace test_of_divergence
