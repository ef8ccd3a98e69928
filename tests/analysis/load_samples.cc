// Loads over time as few shapes: a force that turns, a velocity, a constant.

#include "../unit_test.h"
#include "small_harmonic_system.h"

#include <continua/analysis/load_samples.h>

#include <deal.II/base/mpi.h>

#include <cmath>

namespace test_of_load_samples
{
using namespace Continua;
using Complex = std::complex<double>;

UNIT_TEST(load_samples)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const small_system::SmallHarmonicSystem system;
  std::vector<double> times;
  for (unsigned int j = 0; j < 50; ++j)
    times.push_back(0.1 * j);
  const LoadSamples<2> samples(system, times, MPI_COMM_WORLD);
  // Two of the force that turns, one of its velocity, one of the constant.
  check::is_true("shapes", samples.n_shapes() == 4);
  double largest = 0.;
  for (std::size_t j = 0; j < times.size(); ++j)
  {
    std::vector<Complex> factors;
    for (std::size_t k = 0; k < samples.n_shapes(); ++k)
      factors.emplace_back(samples.factors(k)[j]);
    const HarmonicLoad sum = samples.sum(factors);
    const std::vector<double> forces = {std::cos(times[j]), std::sin(times[j]), 0., 7.};
    for (std::size_t i = 0; i < forces.size(); ++i)
      largest = std::max(largest, std::abs(sum.forces[i] - forces[i]));
    largest = std::max(largest, std::abs(sum.velocities[2] - 2. * std::cos(times[j])));
  }
  check::absolute("the loads come back", largest, 0., 1e-13);
}
} // namespace test_of_load_samples
