#include <continua/time_integration/time_control.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace Continua
{
void TimeParameters::read(ParameterSection section)
{
  section.add_choice("Scheme", scheme,
                     {"euler implicit", "backward differencing", "crank nicolson"},
                     "How dU/dt is discretised: euler implicit (first order, damps), backward "
                     "differencing (second "
                     "order, damps stiff modes), crank nicolson (second order, conserves energy).");
  section.add_choice(
      "Update", update, {"automatic", "trapezoidal", "implicit"},
      "How displacement and pressure follow the velocity: trapezoidal (the thesis's), implicit (by "
      "the "
      "formula of the velocity), automatic: trapezoidal for euler implicit, implicit for backward "
      "differencing. Crank-Nicolson has its own.");
  section.add("Time step", time_step, Dimensions::time, "Time step. Required.", Range::positive());
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
  section.require("Time step");
  section.require("End time");
  if (time_step > end_time * (1. + 1e-9))
    section.refuse("Time step", "the time step is larger than the end time",
                   "Give a smaller step, or a later end");
  if (scheme == "crank nicolson" && update != "automatic")
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
  double smallest = time_step;
  for (const auto &change : changes)
    smallest = std::min(smallest, change.second);
  return smallest;
}

Scheme TimeParameters::scheme_type() const
{
  if (scheme == "euler implicit")
    return Scheme::euler_implicit;
  return scheme == "crank nicolson" ? Scheme::crank_nicolson : Scheme::backward_differencing;
}

Update TimeParameters::update_type() const
{
  if (update == "automatic")
    return scheme_type() == Scheme::euler_implicit ? Update::trapezoidal : Update::implicit;
  return update == "trapezoidal" ? Update::trapezoidal : Update::implicit;
}

TimeControl::TimeControl(const TimeParameters &parameters) : parameters(parameters)
{
  apply_changes();
}

double TimeControl::time() const
{
  return segment_start + steps_in_segment * next_size();
}

double TimeControl::next_size() const
{
  return n_changes_done == 0 ? parameters.time_step : parameters.changes[n_changes_done - 1].second;
}

bool TimeControl::at_end() const
{
  // The run ends with the first step that reaches the end, up to round-off of the count.
  return time() > parameters.end_time - 1e-6 * next_size();
}

void TimeControl::apply_changes()
{
  while (n_changes_done < parameters.changes.size() &&
         parameters.changes[n_changes_done].first <= time() + 1e-6 * next_size())
  {
    segment_start = time();
    steps_in_segment = 0;
    ++n_changes_done;
  }
  while (n_jumps_done < parameters.jump_times.size() &&
         parameters.jump_times[n_jumps_done] <= time() + 1e-6 * next_size())
  {
    restart();
    ++n_jumps_done;
  }
}

std::vector<Step> TimeControl::next()
{
  const double start = time();
  const double size = next_size();
  std::vector<Step> steps;
  switch (parameters.scheme_type())
  {
  case Scheme::euler_implicit:
    steps.push_back(euler_step(start, size, parameters.update_type()));
    break;
  case Scheme::backward_differencing:
    if (smooth_steps == 0)
      steps.push_back(euler_step(start, size, parameters.update_type()));
    else
      steps.push_back(backward_differencing_step(start, size, size_old, parameters.update_type()));
    break;
  case Scheme::crank_nicolson:
    if (smooth_steps < 2 && parameters.smooth_start)
    {
      steps.push_back(euler_step(start, 0.5 * size, Update::midpoint));
      steps.push_back(euler_step(start + 0.5 * size, 0.5 * size, Update::midpoint));
    }
    else
      steps.push_back(crank_nicolson_step(start, size));
    break;
  }
  ++smooth_steps;
  ++steps_in_segment;
  ++step_number;
  size_old = size;
  // The end of the step is the counted time, not a sum, so that its loads and output agree with it
  // to the last bit.
  steps.back().time = time();
  if (!steps.back().extrapolate)
    steps.back().balance_time = steps.back().time;
  apply_changes();
  return steps;
}

void TimeControl::restart()
{
  smooth_steps = 0;
}

void TimeControl::save(ArchiveWriter &archive) const
{
  archive.add("time: step number", static_cast<unsigned long>(step_number));
  archive.add("time: segment start", segment_start);
  archive.add("time: steps in segment", static_cast<unsigned long>(steps_in_segment));
  archive.add("time: changes done", static_cast<unsigned long>(n_changes_done));
  archive.add("time: jumps done", static_cast<unsigned long>(n_jumps_done));
  archive.add("time: smooth steps", static_cast<unsigned long>(smooth_steps));
  archive.add("time: size of the last step", size_old);
}

void TimeControl::load(const ArchiveReader &archive)
{
  step_number = archive.integer("time: step number");
  segment_start = archive.value("time: segment start");
  steps_in_segment = archive.integer("time: steps in segment");
  n_changes_done = archive.integer("time: changes done");
  n_jumps_done = archive.integer("time: jumps done");
  smooth_steps = archive.integer("time: smooth steps");
  size_old = archive.value("time: size of the last step");
}
} // namespace Continua
