// Dilatations that relax over a step against the update worked out by hand.

#include <continua/continuum/bulk_history.h>
#include <continua/continuum/state_vectors.h>

#include "../unit_test.h"

#include <deal.II/base/index_set.h>
#include <deal.II/base/mpi.h>

#include <limits>

namespace test_of_bulk_history
{
using namespace Continua;
using namespace dealii;

UNIT_TEST(bulk_history)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  // Two regions with four nodes each.
  const DistributedVector prototype(complete_index_set(8), MPI_COMM_WORLD);

  // An elastic neighbour, and a spring of 4 Pa beside one of 6 Pa that relaxes within 0.5 s.
  std::vector<Material> materials(2);
  materials[0].compression = Compression::elastic(0.5);
  materials[1].compression = Compression::relaxing(
      {BulkBranch{4., std::numeric_limits<double>::infinity()}, BulkBranch{6., 0.5}});
  BulkHistory history(materials);
  history.reinit(prototype, {{0, 1, 2, 3}, {4, 5, 6, 7}});
  check::is_true("an elastic region has none", !history.has(0) && history.has(1));
  StateVectors vectors;
  history.visit(vectors);
  check::is_true("two branches now and before, and the rate",
                 vectors.pressures.size() == 5 && vectors.velocities.empty());
  check::absolute("long-term compressibility", materials[1].long_term_inverse_bulk_modulus(), 0.25,
                  1e-15);

  // Brought to 10 Pa at once: e = -1 in both springs.
  DistributedVector pressure = prototype, work = pressure;
  pressure = 10.;
  history.start(pressure);
  const Step euler = euler_step(0., 0.25, Update::implicit);
  const double relaxing = 0.25 / (1. + 0.25 / 0.5), modulus = 4. * 0.25 + 6. * relaxing;
  check::absolute("modulus of the step", BulkHistory::step_modulus(materials[1], euler), modulus,
                  1e-15);
  check::absolute("compressibility, elastic",
                  BulkHistory::step_compressibility(materials[0], euler), 0.5 / 0.25, 1e-15);
  check::absolute("compressibility, relaxing",
                  BulkHistory::step_compressibility(materials[1], euler), 1. / modulus, 1e-15);
  // Without a further change of volume the pressure falls to 4 + 6/(1 + dt/tau).
  history.predict(1, euler, work);
  const double held = 4. + 6. / 1.5;
  check::absolute("held volume", work.linfty_norm(), held, 1e-14);
  // The four nodes of the region, and no other.
  check::absolute("nodes", work.l1_norm(), 4. * held, 1e-13);

  // A pressure 3 Pa above that: d = -3/modulus.
  pressure = held + 3.;
  history.advance(euler, pressure);
  const double rate = -3. / modulus;
  const double elastic = -1. + 0.25 * rate, relaxed = (-1. + 0.25 * rate) / 1.5;
  check::absolute("spring", history.internal_dilatation(1, 0).linfty_norm(), -elastic, 1e-14);
  check::absolute("branch", history.internal_dilatation(1, 1).linfty_norm(), -relaxed, 1e-14);
  check::absolute("they make the pressure", -4. * elastic - 6. * relaxed, held + 3., 1e-14);
  history.forgotten_rate(1, 1, euler, work);
  check::absolute("forgotten: e / tau", work.linfty_norm(), -relaxed / 0.5, 1e-14);

  // Crank-Nicolson from there at constant volume: d = 0 in the middle, whatever it was before.
  const Step half = crank_nicolson_step(0.25, 0.25);
  history.predict(1, half, work);
  const double middle = relaxed / (1. + 0.125 / 0.5);
  check::absolute("held again", work.linfty_norm(), -4. * elastic - 6. * middle, 1e-14);
  pressure = work.linfty_norm();
  history.advance(half, pressure);
  check::absolute("branch after it", history.internal_dilatation(1, 1).linfty_norm(),
                  relaxed - 2. * middle, 1e-14);
}
} // namespace test_of_bulk_history
