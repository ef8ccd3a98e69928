// The factor of a part of a small saddle point against elimination in full matrices: all of it, and
// the first velocities with the first pressures; what is outside stays as it was. The
// velocities come as a matrix, and as single entries that add up.

#include <continua/linear_algebra/saddle_point_block.h>

#include "dense_systems.h"

#include "../unit_test.h"

#include <numeric>

namespace test_of_saddle_point_block
{
namespace
{
using namespace Continua;
using namespace dense_systems;

constexpr unsigned int n_pressures = 5, n_velocities = n_pressures + 1;
constexpr double outside = 7.;

/// What a block of the first unknowns of each kind adds to vectors of 7, velocities first.
void check_block(const std::string &name,
                 const unsigned int n_u,
                 const unsigned int n_p,
                 const bool in_parts)
{
  const Full a = chain(n_velocities, 1e3, 0.5), b = differences(n_pressures);
  Full c(n_pressures, n_pressures);
  for (unsigned int k = 0; k < n_pressures; ++k)
    c(k, k) = 0.1 + k;
  Sparse velocity, divergence, compression;
  distribute(a, velocity);
  distribute(b, divergence);
  distribute(c, compression);

  Full block(n_u + n_p, n_u + n_p);
  List source(n_u + n_p);
  const List momentum = numbers(n_velocities), mass = numbers(n_pressures, 2);
  for (unsigned int i = 0; i < n_u; ++i)
  {
    source[i] = momentum[i];
    for (unsigned int j = 0; j < n_u; ++j)
      block(i, j) = a(i, j);
  }
  for (unsigned int k = 0; k < n_p; ++k)
  {
    source[n_u + k] = mass[k];
    for (unsigned int j = 0; j < n_u; ++j)
      block(n_u + k, j) = block(j, n_u + k) = -b(k, j);
    block(n_u + k, n_u + k) = -c(k, k);
  }
  const List solution = solve(block, source);
  List wanted_velocity(n_velocities), wanted_pressure(n_pressures);
  for (unsigned int i = 0; i < n_velocities; ++i)
    wanted_velocity[i] = outside + (i < n_u ? solution[i] : 0.);
  for (unsigned int k = 0; k < n_pressures; ++k)
    wanted_pressure[k] = outside + (k < n_p ? solution[n_u + k] : 0.);

  const auto of_this_rank = [](const unsigned int n_all, const unsigned int n_first)
  {
    std::vector<unsigned int> rows;
    for (unsigned int i = 0; i < owned(n_all).n_elements(); ++i)
      if (owned(n_all).nth_index_in_set(i) < n_first)
        rows.push_back(i);
    return rows;
  };
  SaddlePointBlock inverse(divergence.trilinos_matrix(), compression.trilinos_matrix(),
                           of_this_rank(n_velocities, n_u), of_this_rank(n_pressures, n_p));
  if (!in_parts)
    inverse.add_velocity_entries(velocity.trilinos_matrix());
  else
  {
    // Each rank gives a part of each entry, also of the rows of other ranks.
    std::vector<int> all(n_velocities);
    std::iota(all.begin(), all.end(), 0);
    inverse.learn_numbers(all);
    inverse.reserve(n_velocities * n_velocities);
    const unsigned int n_ranks = dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
    for (const int i : all)
      for (const int j : all)
      {
        const int row = inverse.number(i), column = inverse.number(j);
        for (unsigned int part = 0; part < 2 && column >= 0 && column <= row; ++part)
          inverse.add_velocity_entry(row, column, a(i, j) / (2. * n_ranks));
      }
  }
  inverse.factorize();
  DistributedVector u = distributed(List(n_velocities)), p = distributed(List(n_pressures));
  u.add(outside);
  p.add(outside);
  inverse.add_solution(distributed(momentum).begin(), distributed(mass).begin(), u.begin(),
                       p.begin());
  check::absolute(name + ": velocity", distance(gathered(u), wanted_velocity), 0., 1e-11);
  check::absolute(name + ": pressure", distance(gathered(p), wanted_pressure), 0., 1e-9);
}
} // namespace

UNIT_TEST(saddle_point_block)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  quiet_other_ranks();
  for (const bool in_parts : {false, true})
  {
    const std::string how = in_parts ? ", in parts" : "";
    check_block("all" + how, n_velocities, n_pressures, in_parts);
    check_block("a part" + how, 3, 2, in_parts);
    check_block("velocities alone" + how, 4, 0, in_parts);
  }
}
} // namespace test_of_saddle_point_block
