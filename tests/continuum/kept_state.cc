// Steps that are undone and steps that change, on oscillators u' = -w^2 d, d' = u put together from
// the scheme's coefficients as a solver does it: what is given back is the same to the last bit, a
// doubled step of backward differencing has the older level that the state had there, the whole
// control meets the exact solution the better the smaller the tolerance, and a run that is saved
// and loaded goes on to the same numbers.

#include <continua/continuum/kept_state.h>
#include <continua/continuum/state_archive.h>
#include <continua/time_integration/time_control.h>

#include "../unit_test.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

namespace test_of_kept_state
{
using namespace Continua;

namespace
{
/// Two oscillators, 3 and 50 rad/s; the fast one is damped as U' = ... - 40 U, so that it is gone
/// after half a second.
struct Oscillators
{
  std::vector<double> u = {0., 0.}, u_older = u, d = {1., 1.}, d_older = d;
  double time = 0.;
  std::vector<double> predicted_error = u;
  KeptState kept{[this](StateVisitor &visitor)
                 {
                   visitor.levels("u", u.data(), u_older.data(), u.size());
                   visitor.levels("d", d.data(), d_older.data(), d.size());
                   visitor.value("now", time);
                 }};
  double angular(const unsigned int i) const { return i == 0 ? 3. : 50.; }
  double damping(const unsigned int i) const { return i == 0 ? 0. : 40.; }

  void advance(const Step &step)
  {
    kept.move_older_level(step);
    const BranchCoefficients c = step.branch(std::numeric_limits<double>::infinity());
    for (unsigned int i = 0; i < u.size(); ++i)
    {
      const double stiffness = angular(i) * angular(i);
      const double d_plus = c.old * d[i] + c.older * d_older[i] + c.velocity_old * u[i];
      double u_new = (-step.a1 * u[i] - step.a2 * u_older[i] - stiffness * d_plus) /
                     (step.a0 + damping(i) + stiffness * c.velocity);
      double d_new = c.velocity * u_new + d_plus;
      if (step.extrapolate)
      {
        u_new = 2. * u_new - u[i];
        d_new = 2. * d_new - d[i];
      }
      u_older[i] = u[i];
      d_older[i] = d[i];
      u[i] = u_new;
      d[i] = d_new;
    }
    time = step.time;
    kept.advance(step);
  }
  std::optional<double> error()
  {
    if (!kept.error_is_known())
      return {};
    kept.velocity_error(u.data(), predicted_error.data(), u.size());
    // Both masses are 1; the energy at the start is 1/2 (9 + 2500).
    return std::sqrt(
        (predicted_error[0] * predicted_error[0] + predicted_error[1] * predicted_error[1]) /
        2509.);
  }
  /// It has no vectors that ranks share.
  static StateNumbering numbering()
  {
    return {VectorNumbering(MPI_COMM_WORLD, "velocity", {}),
            VectorNumbering(MPI_COMM_WORLD, "pressure", {})};
  }
  void save(ArchiveWriter &archive) const { save_state(archive, numbering(), kept); }
  void load(const ArchiveReader &archive) { load_state(archive, numbering(), kept); }
};

TimeParameters adaptive(const Scheme scheme, const double tolerance)
{
  TimeParameters result;
  result.step_control = StepControl::adaptive;
  result.scheme = scheme;
  result.time_step = 2e-3;
  result.end_time = 2.;
  result.error_tolerance = tolerance;
  result.smooth_start = false;
  return result;
}

void make_step(Oscillators &body, TimeControl &control)
{
  body.kept.keep();
  for (;;)
  {
    for (const Step &step : control.next())
      body.advance(step);
    if (control.judge(body.error()))
      return;
    body.kept.give_back();
  }
}

struct Run
{
  double error; ///< of the slow one's displacement at the end
  unsigned int n_steps, n_rejected;
  double largest_size;
};

Run run(const Scheme scheme, const double tolerance)
{
  Oscillators body;
  TimeControl control(adaptive(scheme, tolerance));
  double largest_size = 0.;
  while (!control.at_end())
  {
    make_step(body, control);
    largest_size = std::max(largest_size, control.last_size());
  }
  return {std::abs(body.d[0] - std::cos(3. * control.time())), control.n_steps(),
          control.sizes().n_rejected(), largest_size};
}
} // namespace

UNIT_TEST(kept_state)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  {
    Oscillators body;
    TimeControl control(adaptive(Scheme::backward_differencing, 1e-3));
    for (unsigned int i = 0; i < 4; ++i)
      make_step(body, control);
    const Oscillators before = body;
    body.kept.keep();
    body.advance(control.next().front());
    body.kept.give_back();
    check::is_true("given back to the last bit",
                   body.u == before.u && body.d == before.d && body.u_older == before.u_older &&
                       body.d_older == before.d_older && body.time == before.time);
    // Levels at distances 0, h and 2h; a step of 2h starts from that at 2h.
    const std::vector<double> two_steps_old = body.d_older;
    const Step step = control.next().front();
    body.kept.keep();
    body.advance(step);
    body.kept.keep();
    body.kept.move_older_level(backward_differencing_step(body.time, 4e-3, 4e-3, Update::implicit));
    check::is_true("the older level of a doubled step", body.d_older == two_steps_old);
  }
  // Euler's errors are of another size: its order is one.
  for (const Scheme scheme :
       {Scheme::backward_differencing, Scheme::crank_nicolson, Scheme::euler_implicit})
  {
    const std::string name = word_of(scheme_words(), scheme);
    const double scale = scheme == Scheme::euler_implicit ? 10. : 1.;
    const Run coarse = run(scheme, scale * 1e-4), fine = run(scheme, scale * 1e-5);
    check::is_true(name + ": the error follows the tolerance", fine.error < 0.5 * coarse.error);
    check::is_true(name + ": and so do the steps", fine.n_steps > coarse.n_steps);
    check::is_true(name + ": they become longer when the fast motion is gone",
                   coarse.largest_size >= 4 * 2e-3);
    check::is_true(name + ": few are rejected", coarse.n_rejected + fine.n_rejected < 10);
  }
  {
    Oscillators whole;
    TimeControl control(adaptive(Scheme::backward_differencing, 1e-4));
    for (unsigned int i = 0; i < 80; ++i)
      make_step(whole, control);
    ArchiveWriter writer;
    control.save(writer);
    whole.save(writer);
    writer.write("kept_state.archive");
    const ArchiveReader reader("kept_state.archive");
    Oscillators half;
    TimeControl of_half(adaptive(Scheme::backward_differencing, 1e-4));
    of_half.load(reader);
    half.load(reader);
    bool same = true;
    double largest_size = 0.;
    while (!control.at_end())
    {
      make_step(whole, control);
      make_step(half, of_half);
      largest_size = std::max(largest_size, control.last_size());
      same = same && half.u == whole.u && half.d == whole.d && half.time == whole.time;
    }
    check::is_true("goes on after a restart to the same numbers", same && of_half.at_end());
    check::is_true("through changes of the step", largest_size > 4 * 2e-3);
  }
}
} // namespace test_of_kept_state
