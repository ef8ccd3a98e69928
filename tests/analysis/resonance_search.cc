// Resonances of four masses on springs with a power law, each beside the root of its own equation.

#include "../unit_test.h"
#include "small_harmonic_system.h"

#include <continua/analysis/resonance_search.h>
#include <continua/base/lack_of_memory.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <sstream>

namespace test_of_resonance_search
{
using namespace Continua;
using Complex = std::complex<double>;

namespace
{
/// s^2 + stiffness modulus(s) = 0 by Newton's method with differences.
Complex root(const double stiffness)
{
  Complex s(0., std::sqrt(stiffness));
  const auto equation = [stiffness](const Complex at)
  { return at * at + stiffness * small_system::modulus(at); };
  for (unsigned int i = 0; i < 60; ++i)
  {
    const Complex step = 1e-5 * s;
    s -= equation(s) * 2. * step / (equation(s + step) - equation(s - step));
  }
  return s;
}
} // namespace

UNIT_TEST(resonance_search)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  small_system::SmallHarmonicSystem system;
  ResonanceParameters parameters;
  parameters.lowest = 0.1;
  parameters.highest = 2.;
  Log log(MPI_COMM_WORLD, false);
  ResonanceSearch<2> search(system, parameters, {0}, MPI_COMM_WORLD, log);
  const std::vector<Resonance> found = search.find();
  check::is_true("three are in the band", found.size() == 3);
  for (unsigned int k = 0; k < found.size(); ++k)
  {
    const Complex exact = root(system.stiffness[k]);
    check::absolute("s", std::abs(found[k].s - exact) / std::abs(exact), 0., 1e-9);
    check::relative("damping ratio", found[k].damping_ratio(), -exact.real() / std::abs(exact),
                    1e-8);
    check::relative("frequency", found[k].frequency(), exact.imag() / (2. * M_PI), 1e-8);
    check::relative("natural frequency", found[k].natural_frequency(),
                    std::abs(exact) / (2. * M_PI), 1e-8);
    check::relative("quality factor", found[k].quality_factor(),
                    -0.5 * std::abs(exact) / exact.real(), 1e-8);
    check::is_true("residual", found[k].residual < 1e-8 && found[k].corrections < 8);
  }
  check::is_true("responses are known",
                 search.responses_are_known() && search.n_frequencies() < 60);
  // The power law has a branch cut: there are candidates that are none.
  check::is_true("candidates", search.n_candidates() >= 3);

  // What decays faster than it may is none.
  parameters.largest_damping_ratio = 0.5 * (found[0].damping_ratio() + found[1].damping_ratio());
  ResonanceSearch<2> narrow(system, parameters, {}, MPI_COMM_WORLD, log);
  check::is_true("damping ratios",
                 found[0].damping_ratio() < found[1].damping_ratio() && narrow.find().size() == 1);

  // Where an absorbing end has no wave there is no resonance. Any other failure is told, and
  // without memory there is no answer.
  const auto n_found_with = [&](const std::string &failure)
  {
    system.failure = failure;
    return ResonanceSearch<2>(system, parameters, {}, MPI_COMM_WORLD, log).find().size();
  };
  check::is_true("no wave",
                 n_found_with("a wave of the tube behind the absorbing end was lost") == 0 &&
                     log.warnings().empty());
  check::is_true("left out with a warning",
                 n_found_with("an internal error") == 0 && log.warnings().size() == 1);
  check::throws<RunError>(
      "lack of memory", [&]() { n_found_with("MUMPS, factorisation: " + lack_of_memory); },
      "memory");
}
} // namespace test_of_resonance_search
