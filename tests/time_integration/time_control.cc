// Counted time: no drift, changes of the step, jumps, starts anew, and what a checkpoint keeps.

#include <continua/base/archive.h>
#include <continua/time_integration/time_control.h>

#include "../parameter_text.h"
#include "../unit_test.h"

namespace test_of_time_control
{
using namespace Continua;

namespace
{
TimeParameters parameters(const Scheme scheme, const double step, const double end)
{
  TimeParameters result;
  result.scheme = scheme;
  result.time_step = step;
  result.end_time = end;
  return result;
}

/// One letter a step: e Euler, b backward differencing, c Crank-Nicolson, r Rannacher's pair.
std::string letters(TimeControl &control, const unsigned int n_steps)
{
  std::string text;
  for (unsigned int i = 0; i < n_steps; ++i)
  {
    const std::vector<Step> steps = control.next();
    text += steps.size() == 2 ? 'r' : steps[0].extrapolate ? 'c' : steps[0].a2 != 0. ? 'b' : 'e';
  }
  return text;
}

void refused(const std::string &name, const std::string &text, const std::string &pattern)
{
  check::throws<InputError>(
      name,
      [&]
      {
        ParameterFile file = parameters_of(text);
        TimeParameters().read(file.root());
      },
      "parameters_of_the_test.prm.*" + pattern);
}
} // namespace

UNIT_TEST(time_control)
{
  {
    TimeParameters changing = parameters(Scheme::euler_implicit, 2e-3, 1.);
    check::is_true("smallest step", changing.smallest_step() == 2e-3);
    changing.changes = {{0.1, 1e-3}, {0.2, 5e-3}};
    check::is_true("smallest step of several", changing.smallest_step() == 1e-3);
  }
  {
    TimeControl control(parameters(Scheme::euler_implicit, 1e-4, 30.));
    double last_time = 0.;
    bool chained = true, same_size = true;
    while (!control.at_end())
    {
      const Step step = control.next().front();
      chained = chained && step.time_old == last_time;
      same_size = same_size && step.size() == 1e-4;
      last_time = step.time;
    }
    check::is_true("3e5 steps", control.n_steps() == 300000);
    check::absolute("no drift", control.time(), 30., 1e-14 * 30.);
    check::is_true("each step starts where the last one ended", chained);
    check::is_true("each step has the same size to the last bit", same_size);
  }
  {
    TimeControl control(parameters(Scheme::euler_implicit, 0.3, 1.));
    unsigned int n = 0;
    for (; !control.at_end(); ++n)
      control.next();
    check::is_true("the first step that reaches the end is the last", n == 4);
  }
  {
    TimeControl control(parameters(Scheme::backward_differencing, 0.1, 10.));
    check::equal("backward differencing starts with euler", letters(control, 3), "ebb");
    control.restart();
    check::equal("and again after a change of the mesh", letters(control, 2), "eb");
  }
  {
    TimeControl control(parameters(Scheme::crank_nicolson, 0.1, 10.));
    const std::vector<Step> first = control.next();
    check::is_true("two halves", first.size() == 2);
    check::absolute("first half ends in the middle", first[0].time, 0.05, 1e-16);
    check::absolute("first half is balanced there", first[0].balance_time, 0.05, 1e-16);
    check::absolute("second half ends at the end", first[1].time, 0.1, 1e-16);
    check::absolute("a0 of a half and of Crank-Nicolson", first[1].a0, 20., 1e-12);
    check::equal("then one more pair", letters(control, 1), "r");
    check::absolute("half a step before the first", control.next().front().older_distance, 0.05,
                    0.);
    check::absolute("and a whole one before the next", control.next().front().older_distance, 0.1,
                    0.);
    control.restart();
    check::equal("pairs after a jump", letters(control, 3), "rrc");
    TimeParameters sharp = parameters(Scheme::crank_nicolson, 0.1, 10.);
    sharp.smooth_start = false;
    TimeControl plain(sharp);
    check::equal("without smooth start", letters(plain, 2), "cc");
  }
  {
    TimeParameters changing = parameters(Scheme::backward_differencing, 0.1, 1.);
    changing.changes = {{0.25, 0.2}, {0.7, 0.05}};
    changing.jump_times = {0.7};
    TimeControl control(changing);
    // 0.1, 0.2, 0.3 | 0.5, 0.7 | 0.75, ... 1.0
    letters(control, 2);
    check::absolute("the last step before the change", control.next_size(), 0.1, 0.);
    control.next();
    check::absolute("the step after it", control.next_size(), 0.2, 0.);
    const Step step = control.next().front();
    check::absolute("changed step: end", step.time, 0.5, 1e-15);
    check::absolute("changed step: a0 for the ratio 2", step.a0, 25. / 3., 1e-12);
    control.next();
    check::equal("jump at 0.7: euler", letters(control, 2), "eb");
    unsigned int n = 7;
    for (; !control.at_end(); ++n)
      control.next();
    check::is_true("number of steps", n == 11 && control.n_steps() == 11);
    check::absolute("end", control.time(), 1., 1e-15);
  }
  {
    TimeParameters changing = parameters(Scheme::backward_differencing, 0.1, 3.);
    changing.changes = {{0.4, 0.15}};
    changing.jump_times = {0.7};
    TimeControl whole(changing);
    letters(whole, 5);
    ArchiveWriter writer;
    whole.save(writer);
    writer.write("time_control.archive");
    TimeControl half(changing);
    half.load(ArchiveReader("time_control.archive"));
    bool same = true;
    for (unsigned int i = 0; i < 8; ++i)
    {
      const Step a = whole.next().front(), b = half.next().front();
      same = same && a.time == b.time && a.time_old == b.time_old && a.a0 == b.a0 && a.a1 == b.a1 &&
             a.a2 == b.a2;
    }
    check::is_true("load goes on bit by bit", same && whole.n_steps() == half.n_steps());
  }

  const std::string good = "set Time step = 1 ms\nset End time = 1 s\n";
  refused("no time step", "set End time = 1 s\n", "'Time step'");
  refused("time step 0", "set Time step = 0\nset End time = 1 s\n", ":1: 'Time step'");
  refused("negative time step", "set Time step = -1 ms\nset End time = 1 s\n", ":1: 'Time step'");
  refused("no end", "set Time step = 1\n", "'End time'");
  refused("update of crank nicolson", good + "set Scheme = crank nicolson\nset Update = implicit\n",
          ":4: 'Update'");
  refused("change without colon", good + "set Time step changes = 3 s\n",
          ":3: 'Time step changes'.*no colon.*TIME : STEP");
  refused("change to 0", good + "set Time step changes = 3 s : 0 s\n",
          ":3: 'Time step changes'.*not positive");
  refused("changes not sorted", good + "set Time step changes = 3 s : 1 ms, 2 s : 2 ms\n",
          ":3: 'Time step changes'.*increase");
  refused("jumps not sorted", good + "set Jump times = 3 s, 2 s\n", ":3: 'Jump times'");
}
} // namespace test_of_time_control
