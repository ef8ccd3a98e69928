// The approximate inverse of the Schur complement of small systems against elimination: exact where
// the velocities have inertia alone, or pressures a diagonal mass form alone, and the sum of both.
// On a grid whose couplings are weak in one direction the multigrid converges as fast as in one
// dimension.

#include <continua/linear_algebra/matrix_product.h>
#include <continua/linear_algebra/schur_complement.h>

#include "dense_systems.h"

#include "../unit_test.h"

#include <array>
#include <cmath>

namespace test_of_schur_complement
{
namespace
{
using namespace Continua;
using namespace dense_systems;

constexpr unsigned int n_pressures = 6;

double mobility_of(const unsigned int i)
{
  return 0.5 + 0.1 * i;
}
double compression_of(const unsigned int i)
{
  return 0.3 + 0.2 * i;
}
double mass_of(const unsigned int i)
{
  return 2. + i;
}

/// C + B D B^T.
Full laplacian(const Full &b)
{
  Full result(n_pressures, n_pressures);
  for (unsigned int i = 0; i < n_pressures; ++i)
  {
    for (unsigned int j = 0; j < n_pressures; ++j)
      for (unsigned int k = 0; k < b.n(); ++k)
        result(i, j) += b(i, k) * mobility_of(k) * b(j, k);
    result(i, i) += compression_of(i);
  }
  return result;
}
/// By what the multigrid reduces a residual, as a mean of five steps, on a grid of pressures whose
/// neighbours exchange 1 in one direction and 1e-3 in the other.
double reduction_of_weak_couplings()
{
  const unsigned int n = 40;
  Sparse divergence, compression;
  {
    const dealii::IndexSet rows = owned(n * n), columns = owned(2 * n * (n + 1));
    dealii::TrilinosWrappers::SparsityPattern pattern(rows, columns, MPI_COMM_WORLD, 4),
        diagonal(rows, rows, MPI_COMM_WORLD, 1);
    const auto sides = [](const unsigned int row)
    {
      const unsigned int i = row % n, j = row / n, second = n * (n + 1);
      return std::array<unsigned int, 4>{
          {j * (n + 1) + i, j * (n + 1) + i + 1, second + j * n + i, second + (j + 1) * n + i}};
    };
    for (const auto row : rows)
    {
      diagonal.add(row, row);
      for (const unsigned int side : sides(row))
        pattern.add(row, side);
    }
    pattern.compress();
    diagonal.compress();
    divergence.reinit(pattern);
    compression.reinit(diagonal);
    for (const auto row : rows)
    {
      compression.set(row, row, 1e-6);
      for (unsigned int k = 0; k < 4; ++k)
        divergence.set(row, sides(row)[k], k % 2 == 0 ? -1. : 1.);
    }
    divergence.compress(dealii::VectorOperation::insert);
    compression.compress(dealii::VectorOperation::insert);
  }
  List weights(2 * n * (n + 1));
  for (unsigned int k = 0; k < weights.size(); ++k)
    weights[k] = k < weights.size() / 2 ? 1. : 1e-3;
  const DistributedVector mobility = distributed(weights);
  SchurComplement inverse(copy_of(divergence), compression, nullptr, &mobility, {});

  DistributedVector residual = distributed(numbers(n * n)), solution = residual, step = residual,
                    pressures = residual, flux = mobility;
  const DistributedVector source = residual;
  solution = 0.;
  for (unsigned int k = 0; k < 5; ++k)
  {
    inverse.vmult(step, residual);
    solution.add(1., step);
    multiply_transposed(divergence, flux, solution);
    flux.scale(mobility);
    multiply(divergence, pressures, flux);
    multiply(compression, step, solution);
    residual.equ(1., source);
    residual.add(-1., pressures, -1., step);
  }
  return std::pow(residual.l2_norm() / source.l2_norm(), 0.2);
}
} // namespace

UNIT_TEST(schur_complement)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  quiet_other_ranks();
  const Full b = differences(n_pressures);
  Full c(n_pressures, n_pressures), m(n_pressures, n_pressures);
  List d(b.n());
  for (unsigned int i = 0; i < n_pressures; ++i)
  {
    c(i, i) = compression_of(i);
    m(i, i) = mass_of(i);
  }
  for (unsigned int k = 0; k < d.size(); ++k)
    d[k] = mobility_of(k);
  Sparse divergence, compression, mass;
  distribute(b, divergence);
  distribute(c, compression);
  distribute(m, mass);
  const DistributedVector mobility = distributed(d);

  const List right_hand_side = numbers(n_pressures);
  const List of_inertia = solve(laplacian(b), right_hand_side),
             of_stiffness = solve(m, right_hand_side);
  List of_both(of_inertia);
  of_both += of_stiffness;
  const auto apply = [&](SchurComplement &inverse)
  {
    DistributedVector target = distributed(numbers(n_pressures, 4));
    inverse.vmult(target, distributed(right_hand_side));
    return gathered(target);
  };

  // Multigrid adds 1e-12 to the diagonal of its coarsest matrix, here the only one.
  SchurComplement inertia(copy_of(divergence), compression, nullptr, &mobility, {});
  check::absolute("inertia alone", distance(apply(inertia), of_inertia), 0., 1e-11);
  SchurComplement stiffness(copy_of(divergence), compression, &mass, nullptr, {});
  check::absolute("mass form alone", distance(apply(stiffness), of_stiffness), 0., 1e-13);
  SchurComplement both(copy_of(divergence), compression, &mass, &mobility, {});
  check::absolute("both", distance(apply(both), of_both), 0., 1e-11);

  // Of the first pressures only: on two ranks the second one has none of them.
  const unsigned int n_first = 3;
  Full laplacian_of_first(n_first, n_first);
  List of_first(n_first);
  for (unsigned int i = 0; i < n_first; ++i)
  {
    of_first[i] = right_hand_side[i];
    for (unsigned int j = 0; j < n_first; ++j)
      laplacian_of_first(i, j) = laplacian(b)(i, j);
  }
  of_first = solve(laplacian_of_first, of_first);
  List expected(n_pressures);
  std::vector<unsigned int> first;
  for (unsigned int i = 0; i < n_first; ++i)
    expected[i] = of_first[i];
  for (unsigned int i = 0; i < owned(n_pressures).n_elements(); ++i)
    if (owned(n_pressures).nth_index_in_set(i) < n_first)
      first.push_back(i);
  SchurComplement part(copy_of(divergence), compression, nullptr, &mobility, {}, first);
  check::absolute("some pressures only", distance(apply(part), expected), 0., 1e-11);

  List roots(n_pressures), scaled(right_hand_side);
  for (unsigned int i = 0; i < n_pressures; ++i)
  {
    roots[i] = 1. + 0.5 * i;
    scaled[i] *= roots[i];
  }
  scaled = solve(m, scaled);
  for (unsigned int i = 0; i < n_pressures; ++i)
    scaled[i] = scaled[i] * roots[i] + of_inertia[i];
  both.scale_mass_inverse(distributed(roots));
  check::absolute("both, the mass form scaled", distance(apply(both), scaled), 0., 1e-11);

  // The first row of C + B D B^T by hand: 0.3 + 0.5 + 0.6; the first of the mass is 2.
  check::absolute("diagonal of inertia", gathered(inertia.diagonal())[0], 1.4, 1e-14);
  check::absolute("diagonal of the mass form", gathered(stiffness.diagonal())[0], 2., 1e-14);
  check::absolute("diagonal of both", gathered(both.diagonal())[0], 1. / (1. / 1.4 + 0.5), 1e-14);

  const double reduction = reduction_of_weak_couplings();
  if (reduction > 0.2)
    std::cout << reduction << std::endl;
  check::is_true("weak couplings: multigrid reduces the residual", reduction < 0.2);
}
} // namespace test_of_schur_complement
