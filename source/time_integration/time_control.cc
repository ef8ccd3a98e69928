#include <continua/time_integration/time_control.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace Continua
{
const Words<Scheme> &scheme_words()
{
  static const Words<Scheme> words = {{"euler implicit", Scheme::euler_implicit},
                                      {"backward differencing", Scheme::backward_differencing},
                                      {"crank nicolson", Scheme::crank_nicolson}};
  return words;
}

const Words<std::optional<Update>> &update_words()
{
  static const Words<std::optional<Update>> words = {{"automatic", std::nullopt},
                                                     {"trapezoidal", Update::trapezoidal},
                                                     {"implicit", Update::implicit}};
  return words;
}

void TimeParameters::read(ParameterSection section)
{
  add_choice(section, "Scheme", scheme, scheme_words(),
             "How dU/dt is discretised: euler implicit (first order, damps), backward "
             "differencing (second "
             "order, damps stiff modes), crank nicolson (second order, conserves energy).");
  add_choice(
      section, "Update", update, update_words(),
      "How displacement and pressure follow the velocity: trapezoidal (the thesis's), implicit (by "
      "the "
      "formula of the velocity), automatic: trapezoidal for euler implicit with small deformation, "
      "else "
      "implicit. Crank-Nicolson has its own.");
  section.add("Time step", time_step, Dimensions::time,
              "Time step; of an adaptive one the first. Required.", Range::positive());
  section.add("End time", end_time, Dimensions::time, "Time at which the run ends. Required.",
              Range::positive());
  std::vector<std::string> change_texts;
  section.add("Time step changes", change_texts,
              "Later time steps as a list of TIME : STEP, such as 0.5 s : 2 ms, 1 s : 5 ms; each "
              "holds from its time on [s].");
  section.add("Jump times", jump_times, Dimensions::time,
              "Times at which a load or a prescribed velocity jumps: the scheme starts anew there.",
              Range::not_negative());
  section.add("Smooth start", smooth_start,
              "Whether Crank-Nicolson starts, and starts anew, with damped half steps (Rannacher). "
              "Without them a jump "
              "of the load leaves stiff modes ringing for ever.");
  section.add("Velocity limit", velocity_limit, Dimensions::velocity,
              "A run whose largest velocity exceeds this has diverged and is stopped.",
              Range::positive());
  add_choice(section, "Time step control", step_control,
             {{"fixed", StepControl::fixed}, {"adaptive", StepControl::adaptive}},
             "fixed: every step has the size given; adaptive: its size follows an estimate "
             "of its local error, in powers of two of the first step.");
  section.add("Error tolerance", error_tolerance, Dimensions::none,
              "Of an adaptive step: the local error that the velocity may have after one step, as "
              "the square root of the kinetic energy that it would have as a motion over the "
              "largest energy of the body so far.",
              Range::positive());
  section.add("Smallest time step", least_step, Dimensions::time,
              "Of an adaptive step; a step of that size stands, whatever its error. 0: a 64th of "
              "the first.",
              Range::not_negative());
  section.add("Largest time step", largest_step, Dimensions::time,
              "Of an adaptive step. No load may come and go within it: what happens between the "
              "steps is not seen. 0: 64 times the first.",
              Range::not_negative());
  section.add("Steps between increases", steps_between_increases,
              "Of an adaptive step: how many in a row must have allowed one twice as long before "
              "it becomes that [1].",
              3, 10000);
  section.require("Time step");
  section.require("End time");
  if (time_step > end_time * (1. + 1e-9))
    section.refuse("Time step", "the time step is larger than the end time",
                   "Give a smaller step, or a later end");
  if (is_adaptive())
  {
    if (section.given("Time step changes"))
      section.refuse("Time step changes", "an adaptive time step changes by itself",
                     "Remove the entry, or set Time step control = fixed");
    if (least_step > time_step)
      section.refuse("Smallest time step", "it is larger than the first one, Time step",
                     "Give a smaller one, or a larger Time step");
    if (least_step > 0. && least_step < 1e-9 * end_time)
      section.refuse("Smallest time step",
                     "so many steps do not fit between 0 and End time that rounding tells apart",
                     "Give at least 1e-9 of End time");
    if (largest_step > 0. && largest_step < time_step)
      section.refuse("Largest time step", "it is smaller than the first one, Time step",
                     "Give a larger one, or a smaller Time step");
  }
  else
    for (const char *const key :
         {"Error tolerance", "Smallest time step", "Largest time step", "Steps between increases"})
      if (section.given(key))
        section.refuse(key, "a fixed time step has none", "Set Time step control = adaptive");
  if (scheme == Scheme::crank_nicolson && update)
    section.refuse("Update", "crank nicolson has its own update of displacement and pressure",
                   "Remove the entry, or choose another scheme");
  for (const std::string &text : change_texts)
  {
    const auto colon = text.find(':');
    try
    {
      if (colon == std::string::npos)
        throw std::invalid_argument("'" + text + "' has no colon");
      changes.emplace_back(parse_quantity(text.substr(0, colon), Dimensions::time),
                           parse_quantity(text.substr(colon + 1), Dimensions::time));
    }
    catch (const std::invalid_argument &error)
    {
      section.refuse("Time step changes", error.what(),
                     "Write a list of TIME : STEP, such as 0.5 s : 2 ms");
    }
    if (changes.back().first < 0.)
      section.refuse("Time step changes", "the time in '" + text + "' is negative",
                     "Give a time >= 0 s");
    if (changes.back().second <= 0.)
      section.refuse("Time step changes", "the time step in '" + text + "' is not positive",
                     "Give a step > 0 s");
    if (changes.size() > 1 && changes.back().first <= changes[changes.size() - 2].first)
      section.refuse("Time step changes", "the times do not increase at '" + text + "'",
                     "Sort the list by time");
  }
  if (!std::is_sorted(jump_times.begin(), jump_times.end()))
    section.refuse("Jump times", "the times do not increase", "Sort the list");
}

double TimeParameters::smallest_step() const
{
  if (is_adaptive())
    return step_sizes().smallest;
  double smallest = time_step;
  for (const auto &change : changes)
    smallest = std::min(smallest, change.second);
  return smallest;
}

void TimeParameters::take_implicit_update()
{
  if (!update && scheme == Scheme::euler_implicit)
    update = Update::implicit;
}

Update TimeParameters::update_type() const
{
  if (update)
    return *update;
  return scheme == Scheme::euler_implicit ? Update::trapezoidal : Update::implicit;
}

StepSizeParameters TimeParameters::step_sizes() const
{
  StepSizeParameters sizes;
  sizes.first = time_step;
  sizes.tolerance = error_tolerance;
  sizes.smallest = least_step > 0. ? least_step : time_step / 64.;
  sizes.largest = largest_step > 0. ? largest_step : 64. * time_step;
  sizes.steps_between_increases = steps_between_increases;
  sizes.order = scheme == Scheme::euler_implicit ? 1 : 2;
  return sizes;
}

TimeControl::TimeControl(const TimeParameters &parameters)
    : parameters(parameters), size_control(parameters.step_sizes())
{
  now.segment_size = parameters.time_step;
  apply_changes();
}

double TimeControl::time() const
{
  return now.segment_start + now.steps_in_segment * now.segment_size;
}

double TimeControl::tolerance() const
{
  return 1e-6 * (is_adaptive() ? size_control.size_of(size_control.smallest_exponent_used())
                               : now.segment_size);
}

int TimeControl::next_exponent() const
{
  const double event = now.n_jumps_done < parameters.jump_times.size()
                           ? std::min(parameters.jump_times[now.n_jumps_done], parameters.end_time)
                           : parameters.end_time;
  const double left = event - time() + tolerance();
  int exponent = size_control.present_exponent();
  // All times so far are multiples of the smallest size: if the first one divides the time of the
  // event, some multiple of that size leads there.
  while (size_control.size_of(exponent) > left && exponent > size_control.smallest_exponent_used())
    --exponent;
  return exponent;
}

double TimeControl::next_size() const
{
  return is_adaptive() ? size_control.size_of(next_exponent()) : now.segment_size;
}

bool TimeControl::at_end() const
{
  // The run ends with the first step that reaches the end, up to round-off of the count.
  return time() > parameters.end_time - tolerance();
}

void TimeControl::begin_segment(const double size)
{
  now.segment_start = time();
  now.steps_in_segment = 0;
  now.segment_size = size;
}

void TimeControl::apply_changes()
{
  while (now.n_changes_done < parameters.changes.size() &&
         parameters.changes[now.n_changes_done].first <= time() + tolerance())
    begin_segment(parameters.changes[now.n_changes_done++].second);
  while (now.n_jumps_done < parameters.jump_times.size() &&
         parameters.jump_times[now.n_jumps_done] <= time() + tolerance())
  {
    restart();
    size_control.return_to_first();
    ++now.n_jumps_done;
  }
}

std::vector<Step> TimeControl::next()
{
  before = now;
  const double size = next_size();
  if (is_adaptive())
  {
    last_exponent = next_exponent();
    if (size != now.segment_size)
      begin_segment(size);
  }
  const double start = time();
  const bool begins_smoothly =
      parameters.scheme == Scheme::crank_nicolson && parameters.smooth_start;
  const bool is_start = now.smooth_steps < (begins_smoothly ? 2 : 1);
  std::vector<Step> steps;
  switch (parameters.scheme)
  {
  case Scheme::euler_implicit:
    steps.push_back(euler_step(start, size, parameters.update_type()));
    break;
  case Scheme::backward_differencing:
    if (is_start)
      steps.push_back(euler_step(start, size, parameters.update_type()));
    else
    {
      // As soon as there are three earlier states, the older one can be moved.
      const bool can_move = is_adaptive() && now.smooth_steps >= 3;
      steps.push_back(backward_differencing_step(start, size, can_move ? size : now.size_old,
                                                 parameters.update_type()));
    }
    break;
  case Scheme::crank_nicolson:
    if (is_start && begins_smoothly)
    {
      steps.push_back(euler_step(start, 0.5 * size, Update::midpoint));
      steps.push_back(euler_step(start + 0.5 * size, 0.5 * size, Update::midpoint));
    }
    else
    {
      // A smooth start ends with half a step.
      const bool follows_halves = begins_smoothly && now.smooth_steps == 2;
      steps.push_back(
          crank_nicolson_step(start, size, follows_halves ? 0.5 * now.size_old : now.size_old));
    }
    break;
  }
  for (Step &step : steps)
    step.is_start = is_start;
  ++now.smooth_steps;
  ++now.steps_in_segment;
  ++now.step_number;
  now.size_old = size;
  // The end of the step is the counted time, not a sum, so that its loads and output agree with it
  // to the last bit.
  steps.back().time = time();
  if (!steps.back().extrapolate)
    steps.back().balance_time = steps.back().time;
  apply_changes();
  return steps;
}

bool TimeControl::judge(const std::optional<double> &error)
{
  if (!error || size_control.judge(*error, last_exponent))
    return true;
  now = before;
  return false;
}

void TimeControl::restart()
{
  now.smooth_steps = 0;
}

bool TimeControl::jump()
{
  if (is_adaptive() && next_exponent() > 0)
  {
    size_control.return_to_first();
    return false;
  }
  restart();
  return true;
}

void TimeControl::save(ArchiveWriter &archive) const
{
  archive.add("time: step number", static_cast<unsigned long>(now.step_number));
  archive.add("time: segment start", now.segment_start);
  archive.add("time: segment size", now.segment_size);
  archive.add("time: steps in segment", static_cast<unsigned long>(now.steps_in_segment));
  archive.add("time: changes done", static_cast<unsigned long>(now.n_changes_done));
  archive.add("time: jumps done", static_cast<unsigned long>(now.n_jumps_done));
  archive.add("time: smooth steps", static_cast<unsigned long>(now.smooth_steps));
  archive.add("time: size of the last step", now.size_old);
  size_control.save(archive);
}

void TimeControl::load(const ArchiveReader &archive)
{
  now.step_number = archive.integer("time: step number");
  now.segment_start = archive.value("time: segment start");
  now.segment_size = archive.value("time: segment size");
  now.steps_in_segment = archive.integer("time: steps in segment");
  now.n_changes_done = archive.integer("time: changes done");
  now.n_jumps_done = archive.integer("time: jumps done");
  now.smooth_steps = archive.integer("time: smooth steps");
  now.size_old = archive.value("time: size of the last step");
  size_control.load(archive);
}
} // namespace Continua
