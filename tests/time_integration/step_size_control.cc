// Decisions on made-up errors: sizes are powers of two, when they grow and shrink, how far, and
// what is remembered. A scheme of order p has errors that change by 2^(p+1) with the size.

#include <continua/base/archive.h>
#include <continua/time_integration/time_control.h>

#include "../unit_test.h"

#include <functional>

namespace test_of_step_size_control
{
using namespace Continua;

namespace
{
StepSizeParameters sizes(const unsigned int order)
{
  StepSizeParameters result;
  result.first = 1e-3;
  result.tolerance = 1e-2;
  result.smallest = 1.2e-4; // so 1.25e-4
  result.largest = 9e-3;    // so 8e-3
  result.steps_between_increases = 4;
  result.order = order;
  return result;
}

/// The exponents that were tried, a bar before those that were made again.
std::string exponents(StepSizeControl &control,
                      const unsigned int n_steps,
                      const std::function<double(unsigned int, double)> &error)
{
  std::string text;
  for (unsigned int i = 0; i < n_steps; ++i)
    for (bool stands = false; !stands;)
    {
      const int exponent = control.present_exponent();
      stands = control.judge(error(i, control.size()), exponent);
      text += (stands ? "" : "|") + std::to_string(exponent);
    }
  return text;
}

TimeParameters adaptive(const Scheme scheme, const double step, const double end)
{
  TimeParameters result;
  result.step_control = StepControl::adaptive;
  result.scheme = scheme;
  result.time_step = step;
  result.end_time = end;
  result.error_tolerance = 1e-2;
  return result;
}
} // namespace

UNIT_TEST(step_size_control)
{
  const auto cubic = [](const double scale)
  { return [scale](unsigned int, const double size) { return scale * std::pow(size / 1e-3, 3); }; };
  {
    // Half the tolerance or less is expected of 2 ms (scale < 0.005/8), of 4 ms with 7e-5 ...
    StepSizeControl control(sizes(2));
    check::equal("grows after four steps, as far as the tolerance lets it",
                 exponents(control, 12, cubic(7e-5)), "000011112222");
    check::is_true("none rejected", control.n_rejected() == 0);
  }
  {
    StepSizeControl control(sizes(2));
    check::equal("not larger than the largest", exponents(control, 20, cubic(1e-9)),
                 "00001111222233333333");
  }
  {
    StepSizeControl control(sizes(2));
    check::equal("half the tolerance is the aim", exponents(control, 6, cubic(0.006 / 8.)),
                 "000000");
  }
  {
    StepSizeControl control(sizes(2));
    check::equal("a step above the tolerance is made again", exponents(control, 3, cubic(0.02)),
                 "|0-1-1-1");
    check::is_true("and counted", control.n_rejected() == 1);
  }
  {
    StepSizeControl control(sizes(2));
    check::equal("reduced as far as needed at once", exponents(control, 3, cubic(0.2)), "|0-2-2-2");
  }
  {
    StepSizeControl control(sizes(1));
    check::equal("backward Euler's errors fall by four only",
                 exponents(control, 3,
                           [](unsigned int, const double size)
                           { return 0.1 * size * size / 1e-6; }),
                 "|0-3-3-3");
  }
  {
    StepSizeControl control(sizes(2));
    check::equal("the smallest step stands", exponents(control, 3, cubic(1e3)), "|0-3-3-3");
    check::is_true("and is counted", control.n_above_tolerance() == 3);
    check::equal("an infinite error, too",
                 exponents(control, 1, [](unsigned int, double) { return std::nan(""); }), "-3");
  }
  {
    // An error that is next to nothing for five steps, as twice in each period of a vibration: the
    // increase is taken back, and the next one waits for eight.
    StepSizeControl control(sizes(2));
    const auto vibration = [](const unsigned int i, const double size)
    { return (i % 10 < 5 ? 1e-5 : 4e-3) * std::pow(size / 1e-3, 3); };
    check::equal("an increase that comes too early", exponents(control, 30, vibration),
                 "00001|1" + std::string(25, '0'));
  }
  {
    StepSizeControl control(sizes(2));
    exponents(control, 5, cubic(1e-9));
    check::is_true("before a jump", control.present_exponent() == 1);
    control.return_to_first();
    check::is_true("after it: the first", control.present_exponent() == 0);
    exponents(control, 1, cubic(0.02));
    control.return_to_first();
    check::is_true("or a smaller one that it was", control.present_exponent() == -1);
  }
  {
    // The digits that other ranks add decide nothing.
    StepSizeControl control(sizes(2));
    check::is_true("round-off above the tolerance", control.judge(1e-2 * (1. + 1e-9), 0));
    check::is_true("round-off below it", control.judge(1e-2 * (1. - 1e-9), 0));
  }

  {
    // Steps of up to 6.4 meet the end at 10 exactly.
    TimeControl control(adaptive(Scheme::crank_nicolson, 0.1, 10.));
    bool exact = true;
    double last = 0.;
    while (!control.at_end())
    {
      const Step step = control.next().front();
      exact = exact && step.time_old == last && control.judge(1e-9);
      last = control.time();
    }
    check::is_true("steps follow each other", exact);
    check::absolute("the end is met", control.time(), 10., 1e-13);
    check::is_true("by few steps", control.n_steps() < 45);
  }
  {
    // A rejection goes back; halves of the first step still lead to jumps and end.
    TimeParameters parameters = adaptive(Scheme::backward_differencing, 0.1, 3.);
    parameters.jump_times = {1.7};
    parameters.steps_between_increases = 3;
    TimeControl control(parameters);
    bool back = true, met = false;
    std::string starts;
    for (unsigned int i = 0; !control.at_end(); ++i)
    {
      const double time = control.time();
      const unsigned int n = control.n_steps();
      const Step step = control.next().front();
      if (i == 5)
      {
        back = !control.judge(0.02) && control.time() == time && control.n_steps() == n &&
               control.next_size() == 0.1;
        continue;
      }
      control.judge(1e-6);
      met = met || std::abs(control.time() - 1.7) < 1e-13;
      if (step.is_start)
        starts += std::to_string(static_cast<int>(std::round(10. * step.time_old))) + " " +
                  (step.a2 == 0. && step.size() <= 0.1 ? "e" : "?") + " ";
      // No matrix of its own for a changed step.
      if (!step.is_start && control.n_steps() > 3 && std::abs(step.a0 * step.size() - 1.5) > 1e-12)
        starts += "own matrix";
    }
    check::is_true("goes back to the step's start", back);
    check::is_true("meets the jump", met);
    check::equal("starts, at most with the first step", starts, "0 e 17 e ");
    check::absolute("meets the end", control.time(), 3., 1e-13);
  }
  {
    TimeControl whole(adaptive(Scheme::backward_differencing, 0.1, 30.));
    const auto error = [](const unsigned int i, const double size)
    { return (i % 37 < 20 ? 1e-5 : 1e-3) * std::pow(size / 0.1, 3); };
    unsigned int i = 0;
    for (; i < 60; ++i)
    {
      const double size = whole.next().front().size();
      whole.judge(error(i, size));
    }
    ArchiveWriter writer;
    whole.save(writer);
    writer.write("step_size_control.archive");
    TimeControl half(adaptive(Scheme::backward_differencing, 0.1, 30.));
    half.load(ArchiveReader("step_size_control.archive"));
    bool same = true;
    while (!whole.at_end())
    {
      const Step a = whole.next().front(), b = half.next().front();
      same = same && a.time == b.time && a.a0 == b.a0 && a.a2 == b.a2 &&
             whole.judge(error(i, a.size())) == half.judge(error(i, b.size()));
      ++i;
    }
    check::is_true("load goes on bit by bit", same && half.at_end());
  }
}
} // namespace test_of_step_size_control
