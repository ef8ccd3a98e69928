// The observed order of the solution of Poisson's equation with the compact Laplacian, with values
// given on the boundary and equal fluxes on interfaces.

#include "cell_wise_meshes.h"

#include "../unit_test.h"

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparse_direct.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/vector.h>

namespace test_of_laplacian_order
{
using namespace cell_wise_meshes;

namespace
{
/// The root mean square error.
double poisson_error(const Sequence &sequence, const unsigned int n, const bool axisymmetric)
{
  Triangulation<2> triangulation(MPI_COMM_WORLD);
  sequence.make(triangulation, n);
  CellWiseMesh<2> mesh(triangulation, axisymmetric);
  mesh.build();
  const Operators<2> operators(mesh, InterfaceValue::common);
  const ValueSpace<2> &space = operators.space;

  std::vector<Stencil<double>> rows(space.n_values());
  dealii::Vector<double> solution(space.n_values());
  for (unsigned int c = 0; c < mesh.n_owned_cells(); ++c)
  {
    const auto &cell = mesh.cells()[c];
    rows[space.of_cell(c)] = operators.compact_laplacian(c);
    double density = Waves<2>::laplacian(cell.centre);
    if (axisymmetric)
      density += Waves<2>::gradient(cell.centre)[1] / cell.radius;
    solution[space.of_cell(c)] = density * cell.volume;
  }
  for (unsigned int f = 0; f < mesh.faces().size(); ++f)
  {
    const auto &face = mesh.faces()[f];
    if (face.at_boundary())
    {
      rows[space.of_face(f, 0)].add(space.of_face(f, 0), 1.);
      solution[space.of_face(f, 0)] = Waves<2>::value(face.centre);
    }
    else if (face.is_interface)
      for (const unsigned int side : {0, 1})
        rows[space.of_face(f, 0)].add(1., operators.normal_gradient(f, side));
  }

  dealii::DynamicSparsityPattern entries(rows.size());
  for (unsigned int i = 0; i < rows.size(); ++i)
    for (const auto &entry : rows[i])
      entries.add(i, entry.first);
  dealii::SparsityPattern pattern;
  pattern.copy_from(entries);
  dealii::SparseMatrix<double> matrix(pattern);
  for (unsigned int i = 0; i < rows.size(); ++i)
    for (const auto &entry : rows[i])
      matrix.add(i, entry.first, entry.second);
  dealii::SparseDirectUMFPACK().solve(matrix, solution);

  double squares = 0., volume = 0.;
  for (unsigned int c = 0; c < mesh.n_owned_cells(); ++c)
  {
    const auto &cell = mesh.cells()[c];
    squares += std::pow(solution[space.of_cell(c)] - Waves<2>::value(cell.centre), 2) * cell.volume;
    volume += cell.volume;
  }
  return std::sqrt(squares / volume);
}
} // namespace

UNIT_TEST(laplacian_order)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const auto &sequence : sequences())
    for (const bool axisymmetric : {false, true})
      check_order((axisymmetric ? "axisymmetric, " : "2-D, ") + sequence.name,
                  poisson_error(sequence, 8, axisymmetric),
                  poisson_error(sequence, 16, axisymmetric), 2.);
}
} // namespace test_of_laplacian_order
