// Saddle points against elimination in the full matrix: compressible, incompressible and augmented;
// three iterations where the preconditioner is exact but for 1e-12; a guess that is the solution,
// one that is worse than nothing, no right side, and too few iterations.

#include <continua/linear_algebra/matrix_operator.h>
#include <continua/linear_algebra/matrix_product.h>
#include <continua/linear_algebra/saddle_point_solver.h>

#include "dense_systems.h"

#include "../unit_test.h"

#include <numeric>

namespace test_of_saddle_point_solver
{
namespace
{
using namespace Continua;
using namespace dense_systems;

constexpr unsigned int n_pressures = 5, n_velocities = n_pressures + 1;

/// B by its matrix.
class MatrixDivergence : public DivergenceOperator
{
public:
  explicit MatrixDivergence(const Sparse &matrix) : matrix(matrix) {}
  void multiply(DistributedVector &target, const DistributedVector &source) const override
  {
    Continua::multiply(matrix, target, source);
  }
  void multiply_transposed(DistributedVector &target,
                           const DistributedVector &source) const override
  {
    Continua::multiply_transposed(matrix, target, source);
  }

private:
  const Sparse &matrix;
};

/// [A -B^T; -B -C] with B of differences and C = compression I.
struct System
{
  System(const Full &a, const double compression, const double augmentation)
      : full(n_velocities + n_pressures, n_velocities + n_pressures)
  {
    const Full b = differences(n_pressures);
    Full c(n_pressures, n_pressures), augmented(a), schur(n_pressures, n_pressures);
    List diagonal(n_velocities);
    for (unsigned int i = 0; i < n_velocities; ++i)
    {
      diagonal[i] = 1. / a(i, i);
      for (unsigned int j = 0; j < n_velocities; ++j)
      {
        full(i, j) = a(i, j);
        for (unsigned int k = 0; k < n_pressures; ++k)
          augmented(i, j) += augmentation * b(k, i) * b(k, j);
      }
    }
    for (unsigned int k = 0; k < n_pressures; ++k)
    {
      c(k, k) = compression;
      full(n_velocities + k, n_velocities + k) = -compression;
      for (unsigned int i = 0; i < n_velocities; ++i)
        full(n_velocities + k, i) = full(i, n_velocities + k) = -b(k, i);
    }
    distribute(a, velocity);
    distribute(augmented, augmented_velocity);
    distribute(b, divergence);
    distribute(c, this->compression);
    VelocityBlocks blocks;
    blocks.stiff.resize(owned(n_velocities).n_elements());
    std::iota(blocks.stiff.begin(), blocks.stiff.end(), 0u);
    velocity_inverse =
        std::make_unique<VelocityPreconditioner>(augmented_velocity, blocks, nullptr);
    const DistributedVector mobility = distributed(diagonal);
    schur_complement = std::make_unique<SchurComplement>(
        copy_of(divergence), this->compression, nullptr, &mobility, SchurComplement::Places());
    weights = distributed(List(n_pressures));
    weights.add(augmentation);
  }

  /// What elimination finds.
  List exact(const List &momentum, const List &mass) const
  {
    List right_hand_side(full.m());
    std::copy(momentum.begin(), momentum.end(), right_hand_side.begin());
    std::copy(mass.begin(), mass.end(), right_hand_side.begin() + n_velocities);
    return dense_systems::solve(full, right_hand_side);
  }

  /// Starts from `guess` and leaves the solution there.
  KrylovReport solve(const List &momentum,
                     const List &mass,
                     List &guess,
                     const unsigned int maximum = 50,
                     const double tolerance = 1e-13)
  {
    List of_velocity(n_velocities), of_pressure(n_pressures);
    std::copy_n(guess.begin(), n_velocities, of_velocity.begin());
    std::copy_n(guess.begin() + n_velocities, n_pressures, of_pressure.begin());
    DistributedVector u = distributed(of_velocity), p = distributed(of_pressure);
    const MatrixOperator velocity_operator(velocity);
    const MatrixDivergence divergence_operator(divergence);
    const SaddlePointSolver::Blocks blocks{velocity_operator, divergence_operator, compression, {}};
    SaddlePointSolver solver(30);
    solver.reinit(blocks);
    const KrylovReport report =
        solver.solve(blocks, *velocity_inverse, *schur_complement, weights, distributed(momentum),
                     distributed(mass), u, p, tolerance, maximum);
    of_velocity = gathered(u);
    of_pressure = gathered(p);
    std::copy(of_velocity.begin(), of_velocity.end(), guess.begin());
    std::copy(of_pressure.begin(), of_pressure.end(), guess.begin() + n_velocities);
    return report;
  }

  Full full;
  Sparse velocity, augmented_velocity, divergence, compression;
  std::unique_ptr<VelocityPreconditioner> velocity_inverse;
  std::unique_ptr<SchurComplement> schur_complement;
  DistributedVector weights;
};

void check_system(const std::string &name,
                  const Full &a,
                  const double compression,
                  const double augmentation,
                  const unsigned int n_iterations)
{
  System system(a, compression, augmentation);
  const List momentum = numbers(n_velocities), mass = numbers(n_pressures, 2);
  const List exact = system.exact(momentum, mass);
  List found(exact.size());
  const KrylovReport report = system.solve(momentum, mass, found);
  check::is_true(name + ": converged", report.converged && report.residual <= 1e-13);
  check::absolute(name + ": solution", distance(found, exact) / exact.linfty_norm(), 0., 1e-11);
  check::is_true(name + ": iterations", report.iterations > 0 && report.iterations <= n_iterations);

  List guess = exact;
  check::is_true(name + ": a guess that is right",
                 system.solve(momentum, mass, guess).iterations == 0);
  guess *= -1e6;
  check::is_true(name + ": one that is worse than nothing",
                 system.solve(momentum, mass, guess).iterations == report.iterations);
  check::absolute(name + ": does no harm", distance(guess, exact) / exact.linfty_norm(), 0., 1e-11);
  guess = found;
  const KrylovReport nothing = system.solve(List(n_velocities), List(n_pressures), guess);
  check::is_true(name + ": no right side", nothing.converged && nothing.iterations == 0);
  check::absolute(name + ": no solution", guess.linfty_norm(), 0., 0.);
}
} // namespace

UNIT_TEST(saddle_point_solver)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  quiet_other_ranks();
  // Inertia alone: both inverses are exact, and the triangular preconditioner needs two iterations;
  // a third one since multigrid adds 1e-12 to the diagonal of its coarsest matrix, here the only
  // one. (With Debian 13's libraries the third one is needed from 1e-8 on.)
  Full inertia(n_velocities, n_velocities);
  for (unsigned int i = 0; i < n_velocities; ++i)
    inertia(i, i) = 1. + 0.5 * i;
  check_system("inertia", inertia, 0.3, 0., 3);
  {
    System exact_inverses(inertia, 0.3, 0.);
    List found(n_velocities + n_pressures);
    check::absolute(
        "inertia: iterations to 1e-6",
        exact_inverses.solve(numbers(n_velocities), numbers(n_pressures, 2), found, 50, 1e-6)
            .iterations,
        2., 0.);
  }
  const Full springs = chain(n_velocities, 100., 1.);
  const unsigned int n_unknowns = n_velocities + n_pressures;
  check_system("springs", springs, 0.3, 0., n_unknowns);
  check_system("incompressible", springs, 0., 0., n_unknowns);
  check_system("augmented", springs, 0.3, 0.7, n_unknowns);

  System system(springs, 0.3, 0.);
  List found(n_unknowns);
  const KrylovReport report =
      system.solve(numbers(n_velocities), numbers(n_pressures, 2), found, 2);
  check::is_true("too few iterations",
                 !report.converged && report.iterations == 2 && report.residual > 1e-13);
}
} // namespace test_of_saddle_point_solver
