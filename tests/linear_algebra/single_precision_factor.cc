// The factor in single precision on saddle-point matrices whose entries differ by many orders, some
// beyond the range of single precision: alone it has single precision's digits, and with FGMRES
// the solution of a factor in double precision.

#include "../unit_test.h"
#include "symmetric_problems.h"

#include <continua/base/input_error.h>
#include <continua/linear_algebra/block_krylov.h>
#include <continua/linear_algebra/mumps_factor.h>
#include <continua/linear_algebra/single_precision_factor.h>

#include <deal.II/base/index_set.h>
#include <deal.II/base/mpi.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <algorithm>

namespace test_of_single_precision_factor
{
using namespace Continua;
namespace problems = symmetric_problems;

namespace
{
/// Rows and columns times 10^(+-30), in turn: products of them would leave single precision.
SymmetricTriplets badly_scaled(SymmetricTriplets matrix)
{
  const auto factor = [](const int i) { return i % 3 == 0 ? 1e30 : i % 3 == 1 ? 1. : 1e-30; };
  for (std::size_t k = 0; k < matrix.rows.size(); ++k)
    matrix.values[k] *= factor(matrix.rows[k]) * factor(matrix.columns[k]);
  return matrix;
}

/// A matrix [A -B^T; -B -C] with its first `n_velocities` rows as those of the velocities, spread
/// over the ranks, for products.
class Blocks
{
public:
  Blocks(const SymmetricTriplets &matrix, const unsigned int n_velocities)
      : n_velocities(n_velocities),
        velocities(share(n_velocities)),
        pressures(share(matrix.n - n_velocities)),
        whole(matrix)
  {
  }

  DistributedVector velocity() const { return DistributedVector(velocities, MPI_COMM_WORLD); }
  DistributedVector pressure() const { return DistributedVector(pressures, MPI_COMM_WORLD); }
  std::vector<int> owned() const
  {
    std::vector<int> indices;
    for (const auto index : velocities)
      indices.push_back(index);
    for (const auto index : pressures)
      indices.push_back(n_velocities + index);
    return indices;
  }
  /// Every rank multiplies with the whole.
  void multiply(const DistributedVector &velocity,
                const DistributedVector &pressure,
                DistributedVector &momentum,
                DistributedVector &mass) const
  {
    std::vector<double> x(whole.n, 0.);
    for (const auto index : velocities)
      x[index] = velocity[index];
    for (const auto index : pressures)
      x[n_velocities + index] = pressure[index];
    MPI_Allreduce(MPI_IN_PLACE, x.data(), whole.n, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
    scatter(problems::multiply(whole, x), momentum, mass);
  }
  void scatter(const std::vector<double> &x,
               DistributedVector &velocity,
               DistributedVector &pressure) const
  {
    for (unsigned int k = 0; k < velocities.n_elements(); ++k)
      velocity.begin()[k] = x[velocities.nth_index_in_set(k)];
    for (unsigned int k = 0; k < pressures.n_elements(); ++k)
      pressure.begin()[k] = x[n_velocities + pressures.nth_index_in_set(k)];
  }

private:
  const unsigned int n_velocities;
  const dealii::IndexSet velocities, pressures;
  const SymmetricTriplets whole;

  static dealii::IndexSet share(const unsigned int n)
  {
    dealii::IndexSet set(n);
    const unsigned int n_ranks = problems::n_ranks(), rank = problems::rank();
    set.add_range(rank * n / n_ranks, (rank + 1) * n / n_ranks);
    return set;
  }
};

/// Solves for a known solution of the staggered grid of m x m cells; returns the iterations.
KrylovReport solve(const std::string &name, const int m, const SymmetricTriplets &matrix)
{
  const Blocks blocks(matrix, 2 * m * m - m);
  SinglePrecisionFactor factor(true, MPI_COMM_WORLD);
  factor.factorize(problems::strewn(matrix), blocks.owned());
  const std::vector<double> &scale = factor.scale();
  BlockKrylov solver(BlockKrylov::Method::fgmres, 21);
  DistributedVector velocity = blocks.velocity(), pressure = blocks.pressure(), momentum = velocity,
                    mass = pressure, solved = velocity, solved_pressure = pressure;
  blocks.scatter(problems::manufactured(matrix.n), velocity, pressure);
  blocks.multiply(velocity, pressure, momentum, mass);
  solver.reinit(velocity, pressure);
  const auto middle = scale.begin() + velocity.locally_owned_size();
  std::copy(scale.begin(), middle, solver.scale.block(0).begin());
  std::copy(middle, scale.end(), solver.scale.block(1).begin());
  solver.set_right_hand_side(momentum, mass);
  const auto product = [&blocks](const DistributedVector &u, const DistributedVector &p,
                                 DistributedVector &f, DistributedVector &g)
  { blocks.multiply(u, p, f, g); };
  const auto inverse =
      [&](DistributedVector &f, DistributedVector &g, DistributedVector &u, DistributedVector &p)
  {
    std::vector<double> x(f.begin(), f.end());
    x.insert(x.end(), g.begin(), g.end());
    for (std::size_t k = 0; k < x.size(); ++k)
      x[k] /= scale[k];
    factor.solve(x);
    std::copy_n(x.begin(), u.locally_owned_size(), u.begin());
    std::copy_n(x.begin() + u.locally_owned_size(), p.locally_owned_size(), p.begin());
  };
  const KrylovReport report =
      solver.solve(product, inverse, solver.scaled_right_hand_side().l2_norm(), 1e-12, 20, solved,
                   solved_pressure);
  check::is_true(name + ": converged", report.converged && report.residual < 1e-12);
  check::is_true(name + ": iterations", report.iterations > 1 && report.iterations <= 6);
  if (report.iterations > 6)
    std::cout << report.iterations << " iterations\n";

  // The residual anew, and against a factor in double precision.
  blocks.multiply(solved, solved_pressure, velocity, pressure);
  double squares[2] = {0., 0.};
  unsigned int k = 0;
  for (const auto &[product_rows, rows] :
       {std::pair(&velocity, &momentum), std::pair(&pressure, &mass)})
    for (unsigned int i = 0; i < rows->locally_owned_size(); ++i, ++k)
    {
      squares[0] += std::pow(scale[k] * (product_rows->begin()[i] - rows->begin()[i]), 2);
      squares[1] += std::pow(scale[k] * rows->begin()[i], 2);
    }
  MPI_Allreduce(MPI_IN_PLACE, squares, 2, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  check::absolute(name + ": residual", std::sqrt(squares[0] / squares[1]), 0., 2e-12);
  return report;
}
} // namespace

UNIT_TEST(single_precision_factor)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  if (problems::rank() > 0)
    std::cout.setstate(std::ios::failbit); // rank 0 alone prints

  SinglePrecisionFactor factor(true, MPI_COMM_WORLD);
  problems::factorize(factor, problems::small_indefinite());
  const std::vector<double> x = problems::solve(factor, {-1, 8, -6});
  for (int i = 0; i < 3; ++i)
    check::absolute("small indefinite " + std::to_string(i), x[i], i + 1, 1e-5);
  check::equal("zero", std::to_string(problems::norm(problems::solve(factor, {0, 0, 0}))),
               "0.000000");
  check::is_true("a right-hand side beyond single precision",
                 std::abs(problems::solve(factor, {-1e200, 8e200, -6e200})[1] / 2e200 - 1.) < 1e-5);

  // Half the memory of a factor in double precision, with and without pivoting.
  const int m = 40;
  const SymmetricTriplets compressible = problems::saddle_point(m, 1e3, 1., false);
  const SymmetricTriplets incompressible = problems::saddle_point(m, 1e3, 0., false);
  MumpsFactor twice(false, MPI_COMM_WORLD);
  problems::factorize(twice, incompressible);
  const double residual = problems::relative_residual(factor, incompressible);
  check::is_true("digits of single precision", residual > 1e-9 && residual < 1e-2);
  check::equal("it pivots", factor.name(), "MUMPS, L D L^T with pivoting, in single precision");
  check::relative("entries", factor.n_entries(), twice.n_entries(), 0.2);
  problems::factorize(factor, compressible);
  check::equal("it does not", factor.name(),
               "MUMPS, L D L^T without pivoting, in single precision");

  solve("compressible", m, compressible);
  solve("incompressible", m, incompressible);
  solve("nearly incompressible", m, problems::saddle_point(m, 1e3, 1e-9, false));
  solve("badly scaled", m, badly_scaled(compressible));
}
} // namespace test_of_single_precision_factor
