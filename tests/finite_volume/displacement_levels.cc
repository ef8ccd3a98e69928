// Derivatives over the levels of the displacement: Euler's is exact for a parabola, the four levels
// for a cubic, and a step of another size falls back to Euler until four levels are there again.

#include <continua/continuum/state_vectors.h>
#include <continua/finite_volume/displacement_levels.h>

#include "../unit_test.h"

#include <deal.II/base/mpi.h>

namespace test_of_displacement_levels
{
using namespace Continua;

namespace
{
double cubic(const double t)
{
  return 2. + 3. * t - t * t + 0.5 * t * t * t;
}
} // namespace

UNIT_TEST(displacement_levels)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  DistributedVector value(dealii::complete_index_set(1), MPI_COMM_WORLD), speed = value,
                                                                          sum = value;
  const auto set = [](DistributedVector &vector, const double number) { vector = number; };

  DisplacementLevels levels;
  StateSizes sizes(value, value, value, value);
  levels.visit(sizes);
  check::is_true("no levels at first", !levels.is_started());
  set(value, 1.);
  set(speed, 4.);
  levels.start(value, speed, 0.1);
  // A uniform motion before: D(0.1) = 1.4 needs no force.
  auto d = levels.derivatives(euler_step(0., 0.1, Update::implicit), false);
  levels.combine(d.second_known, sum);
  check::absolute("uniform motion has no acceleration", d.second_own * 1.4 + sum[0], 0., 1e-10);
  levels.combine(d.first_known, sum);
  check::absolute("and keeps its speed", d.first_own * 1.4 + sum[0], 4., 1e-12);

  // Known levels of the cubic at 0, 0.1, 0.2, 0.3 s.
  double t = 0.;
  set(value, cubic(t));
  levels.visit(sizes);
  set(speed, 0.);
  levels.start(value, speed, 0.1);
  for (unsigned int i = 0; i < 3; ++i)
  {
    t += 0.1;
    set(value, cubic(t));
    levels.advance(euler_step(t - 0.1, 0.1, Update::implicit), value);
  }
  const auto second = [&](const double size, const bool second_order)
  {
    const Step step = euler_step(t, size, Update::implicit);
    const auto derivatives = levels.derivatives(step, second_order);
    levels.combine(derivatives.second_known, sum);
    return derivatives.second_own * cubic(t + size) + sum[0];
  };
  check::absolute("four levels: exact for a cubic", second(0.1, true), -2. + 3. * 0.4, 1e-10);
  check::absolute("three levels: that of the middle one", second(0.1, false), -2. + 3. * 0.3,
                  1e-10);

  // A longer step: with the velocity of the last one, (v(0.4) - v(0.25)) over 0.2 s.
  const double v_last = (cubic(0.3) - cubic(0.2)) / 0.1, v_next = (cubic(0.5) - cubic(0.3)) / 0.2;
  check::absolute("a step of another size", second(0.2, true), (v_next - v_last) / 0.2, 1e-10);
  // Of the new displacement: 1/size^2 with three levels, 2/size^2 with four.
  const auto own = [&]
  { return levels.derivatives(euler_step(t, 0.2, Update::implicit), true).second_own; };
  check::relative("is Euler's", own(), 25., 1e-12);
  for (unsigned int i = 0; i < 3; ++i)
  {
    if (i < 2)
      check::relative("no four levels yet", own(), 25., 1e-12);
    t += 0.2;
    set(value, cubic(t));
    levels.advance(euler_step(t - 0.2, 0.2, Update::implicit), value);
  }
  check::relative("four levels again", own(), 50., 1e-12);
  check::absolute("and exact for the cubic", second(0.2, true), -2. + 3. * (t + 0.2), 1e-9);
}
} // namespace test_of_displacement_levels
