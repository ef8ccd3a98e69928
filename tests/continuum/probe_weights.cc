// Sums of weights times entries of a state, entries of other ranks included.

#include <continua/continuum/probe_weights.h>

#include "../unit_test.h"

#include <deal.II/base/index_set.h>
#include <deal.II/base/mpi.h>

#include <limits>

namespace test_of_probe_weights
{
using namespace Continua;
using namespace dealii;

UNIT_TEST(probe_weights)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
  const unsigned int rank = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
  if (rank != 0)
    std::cout.setstate(std::ios::failbit);
  IndexSet velocities(8), pressures(4);
  velocities.add_range(rank * 8 / n_ranks, (rank + 1) * 8 / n_ranks);
  pressures.add_range(rank * 4 / n_ranks, (rank + 1) * 4 / n_ranks);
  DistributedVector velocity(velocities, MPI_COMM_WORLD), pressure(pressures, MPI_COMM_WORLD);
  for (const auto i : velocities)
    velocity[i] = i;
  for (const auto i : pressures)
    pressure[i] = 100. + i;
  velocity.compress(VectorOperation::insert);
  pressure.compress(VectorOperation::insert);

  // A solid with mu = 3 Pa beside a fluid with eta = 2 Pa s.
  std::vector<Material> materials(2);
  materials[0].shear.branches = {Branch{3., std::numeric_limits<double>::infinity()}};
  materials[1].shear.viscosity = 2.;
  BranchHistory history(materials);
  std::vector<unsigned int> mine(velocities.n_elements());
  for (unsigned int i = 0; i < mine.size(); ++i)
    mine[i] = i;
  history.reinit(velocity, {mine, mine});
  history.displacement() = velocity;
  history.displacement() *= 0.1;
  const State state{velocity, pressure, history};

  DistributedVector forces(velocity);
  forces *= 5.;
  const auto value =
      [&](const ProbeWeights::Source source, const unsigned int region, const double factor)
  {
    ProbeWeights::Collector collector(velocity, pressure, 2);
    // Half from the last rank and half from the first, for entries at both ends.
    DistributedVector &weights = collector.weights(source, region);
    const unsigned int last = weights.size() - 1;
    if (rank == 0)
    {
      weights(0) += 1.;
      weights(last) += 1.;
    }
    if (rank == n_ranks - 1)
      weights(last) += 1.;
    const ProbeWeights probe(collector, factor);
    return Utilities::MPI::sum(probe.share(state, &forces, materials), MPI_COMM_WORLD);
  };
  using Source = ProbeWeights::Source;
  check::absolute("velocity", value(Source::velocity, 0, 1.), 14., 1e-13);
  check::absolute("displacement, times two", value(Source::displacement, 0, 2.), 2.8, 1e-13);
  check::absolute("pressure", value(Source::pressure, 0, 1.), 100. + 2. * 103., 1e-12);
  check::absolute("mixture of the solid", value(Source::mixture, 0, 1.), 3. * 1.4, 1e-13);
  check::absolute("mixture of the fluid", value(Source::mixture, 1, 1.), 2. * 14., 1e-13);
  check::absolute("force", value(Source::force, 0, -1.), -5. * 14., 1e-12);
  DistributedVector mixture(velocity);
  set_mixture(state, 0, materials[0], mixture);
  check::absolute("the mixture as a vector", mixture.linfty_norm(), 3. * 0.7, 1e-14);
}
} // namespace test_of_probe_weights
