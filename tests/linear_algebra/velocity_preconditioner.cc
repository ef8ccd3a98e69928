// The preconditioner of the velocities on a chain of springs against elimination in full matrices:
// exact where all is stiff, symmetric Gauss-Seidel where all is fluid, and the three steps where a
// stiff part meets a soft one; multigrid on a small block is exact.

#include <continua/linear_algebra/matrix_relaxation.h>
#include <continua/linear_algebra/velocity_preconditioner.h>

#include "dense_systems.h"

#include "../unit_test.h"

#include <numeric>

namespace test_of_velocity_preconditioner
{
namespace
{
using namespace Continua;
using namespace dense_systems;

constexpr unsigned int n = 8;

List apply(VelocityPreconditioner &preconditioner, const List &source)
{
  DistributedVector target = distributed(numbers(n, 4));
  preconditioner.vmult(target, distributed(source));
  return gathered(target);
}

/// Gauss-Seidel forwards and backwards from zero.
List relaxed(const Full &a, const List &source)
{
  List x(n);
  const auto update = [&](const unsigned int i)
  {
    double sum = source[i];
    for (unsigned int j = 0; j < n; ++j)
      if (j != i)
        sum -= a(i, j) * x[j];
    x[i] = sum / a(i, i);
  };
  for (unsigned int i = 0; i < n; ++i)
    update(i);
  for (unsigned int i = n; i-- > 0;)
    update(i);
  return x;
}

List residual(const Full &a, const List &x, const List &source)
{
  List result(n);
  a.residual(result, x, source);
  return result;
}

/// Adds the solution of the first half's block.
void add_stiff(const Full &a, const List &source, List &x)
{
  Full block(n / 2, n / 2);
  List part(n / 2);
  for (unsigned int i = 0; i < n / 2; ++i)
  {
    part[i] = source[i];
    for (unsigned int j = 0; j < n / 2; ++j)
      block(i, j) = a(i, j);
  }
  part = solve(block, part);
  for (unsigned int i = 0; i < n / 2; ++i)
    x[i] += part[i];
}
} // namespace

UNIT_TEST(velocity_preconditioner)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  quiet_other_ranks();
  const Full a = chain(n, 1e6, 0.5);
  Sparse matrix;
  distribute(a, matrix);
  const List source = numbers(n);
  const dealii::IndexSet rows = owned(n);
  std::vector<unsigned int> all(rows.n_elements());
  std::iota(all.begin(), all.end(), 0u);

  VelocityBlocks stiff;
  stiff.stiff = all;
  VelocityPreconditioner of_stiff(matrix, stiff, nullptr);
  check::absolute("all stiff: the inverse", distance(apply(of_stiff, source), solve(a, source)), 0.,
                  1e-11);
  check::is_true("all stiff: a factor", of_stiff.factor() != nullptr);

  // Multigrid does not coarsen what is so small. The mode: all masses move alike.
  VelocityBlocks viscous;
  viscous.fluid = all;
  viscous.fluid_is_viscous = true;
  viscous.modes = {std::vector<double>(all.size(), 1.)};
  VelocityPreconditioner of_viscous(matrix, viscous,
                                    std::make_unique<MatrixRelaxation>(matrix, viscous));
  check::absolute("all viscous: the inverse", distance(apply(of_viscous, source), solve(a, source)),
                  0., 1e-9);
  check::is_true("all viscous: no factor", of_viscous.factor() == nullptr);

  VelocityBlocks mixed;
  for (const unsigned int i : all)
    (rows.nth_index_in_set(i) < n / 2 ? mixed.stiff : mixed.fluid).push_back(i);
  VelocityPreconditioner of_mixed(matrix, mixed, std::make_unique<MatrixRelaxation>(matrix, mixed));
  // Symmetric, on any number of ranks.
  const List other = numbers(n, 1);
  const double one_way = apply(of_mixed, source) * other, back = apply(of_mixed, other) * source;
  check::relative("stiff and fluid: symmetric", one_way, back, 1e-10);
  VelocityBlocks fluid;
  fluid.fluid = all;
  VelocityPreconditioner of_fluid(matrix, fluid, std::make_unique<MatrixRelaxation>(matrix, fluid));
  check::relative("all fluid: symmetric", apply(of_fluid, source) * other,
                  apply(of_fluid, other) * source, 1e-10);
  // Every rank relaxes its own unknowns.
  if (rows.n_elements() < n)
    return;
  check::absolute("all fluid: Gauss-Seidel", distance(apply(of_fluid, source), relaxed(a, source)),
                  0., 1e-12);
  List expected = relaxed(a, source);
  add_stiff(a, residual(a, expected, source), expected);
  expected += relaxed(a, residual(a, expected, source));
  check::absolute("stiff and fluid: three steps", distance(apply(of_mixed, source), expected), 0.,
                  1e-11);
}
} // namespace test_of_velocity_preconditioner
