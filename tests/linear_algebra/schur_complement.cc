// The approximate inverse of the Schur complement of small systems against elimination: exact where
// the velocities have inertia alone, or pressures a diagonal mass form alone, and the sum of both.

#include <continua/linear_algebra/schur_complement.h>

#include "dense_systems.h"

#include "../unit_test.h"

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
  SchurComplement inertia(divergence, compression, nullptr, &mobility);
  check::absolute("inertia alone", distance(apply(inertia), of_inertia), 0., 1e-11);
  SchurComplement stiffness(divergence, compression, &mass, nullptr);
  check::absolute("mass form alone", distance(apply(stiffness), of_stiffness), 0., 1e-13);
  SchurComplement both(divergence, compression, &mass, &mobility);
  check::absolute("both", distance(apply(both), of_both), 0., 1e-11);

  // The first row of C + B D B^T by hand: 0.3 + 0.5 + 0.6; the first of the mass is 2.
  check::absolute("diagonal of inertia", gathered(inertia.diagonal())[0], 1.4, 1e-14);
  check::absolute("diagonal of the mass form", gathered(stiffness.diagonal())[0], 2., 1e-14);
  check::absolute("diagonal of both", gathered(both.diagonal())[0], 1. / (1. / 1.4 + 0.5), 1e-14);
}
