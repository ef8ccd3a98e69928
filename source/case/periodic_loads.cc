#include <continua/case/periodic_loads.h>

#include <continua/base/name_choice.h>
#include <continua/base/parameter_text.h>
#include <continua/continuum/field_list.h>
#include <continua/mesh/coordinates.h>
#include <continua/network/network_parameters.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <utility>

namespace Continua
{
namespace
{
/// Of the largest value of a load, by which one that repeats may differ after a period.
constexpr double repetition_slack = 1e-6;
constexpr unsigned int n_times_of_repetition = 256;
/// Of the places of a load that depends on place.
constexpr std::size_t most_places = 8;
/// Of a step, by which a number of steps may differ from a whole one.
constexpr double count_slack = 1e-6;
/// A beat of fewer rows has no shape.
constexpr double fewest_rows_of_beat = 16.;

using Places = std::vector<std::array<double, 3>>;

/// A load over time, with where it acts.
struct PeriodicLoad
{
  Waveform *waveform;
  std::string name; ///< "the boundary 'inlet'"
  Places places;    ///< some of them
};

Places some_of(const Places &all)
{
  Places some;
  for (std::size_t i = 0; i < std::min(most_places, all.size()); ++i)
    some.push_back(all[i * all.size() / std::min(most_places, all.size())]);
  return some;
}

template <int dim>
Places places_of(const Case<dim> &input, const BoundaryCondition &condition)
{
  Places all;
  for (const auto &cell : input.triangulation->cell_iterators_on_level(0))
    for (const unsigned int f : cell->face_indices())
      if (cell->at_boundary(f) && cell->face(f)->boundary_id() == condition.boundary_id &&
          condition.region_ids.count(cell->material_id()) > 0)
        all.push_back(coordinates(cell->face(f)->center()));
  return some_of(all);
}

template <int dim>
Places places_inside(const Case<dim> &input)
{
  Places all;
  for (const auto &cell : input.triangulation->cell_iterators_on_level(0))
    all.push_back(coordinates(cell->center()));
  return some_of(all);
}

/// All loads that depend on time but the pressures behind outlets.
template <int dim>
std::vector<PeriodicLoad> loads_of(Case<dim> &input)
{
  std::vector<PeriodicLoad> loads;
  const auto add = [&](Waveform &waveform, const std::string &name, const Places &places)
  {
    if (waveform.depends_on_time())
      loads.push_back({&waveform, name, places});
  };
  for (BoundaryCondition &condition : input.problem.conditions)
  {
    const std::string name = "the boundary '" + condition.name + "'";
    const Places places = places_of(input, condition);
    add(condition.volume_ratio, name, {{{0., 0., 0.}}});
    if (condition.free_flow)
      add(condition.free_flow->rate, name, {{{0., 0., 0.}}});
    for (BoundaryPart *const part : {&condition.normal, &condition.tangential})
    {
      add(part->along_normal, name, places);
      for (Waveform &component : part->vector)
        add(component, name, places);
    }
  }
  for (auto *const components :
       {&input.problem.interior.body_force, &input.problem.interior.acceleration})
    for (Waveform &component : *components)
      add(component, "the body force", places_inside(input));
  return loads;
}

/// What depends on time in a network at the body.
struct NetworkLoad
{
  std::string name; ///< "the terminal 'heart' of the network"
  std::function<double(double)> value;
  double period; ///< of a table that is repeated [s]; 0: none
};

template <int dim>
std::vector<NetworkLoad> network_loads(const Case<dim> &input)
{
  std::vector<NetworkLoad> loads;
  if (!input.network)
    return loads;
  for (const TerminalEntries &terminal : input.network->terminals)
    if (terminal.law.value)
      loads.push_back({"the terminal '" + terminal.node + "' of the network", terminal.law.value,
                       terminal.period});
  for (const ElementEntries &element : input.network->elements)
    if (element.law.elastance)
      loads.push_back({"the element '" + element.law.name + "' of the network",
                       element.law.elastance, element.period});
  return loads;
}

/// The period of the tables that are repeated. Throws InputError unless they have one.
double period_of_tables(const std::vector<PeriodicLoad> &loads,
                        const std::vector<NetworkLoad> &of_network,
                        const ParameterSection &section)
{
  std::vector<double> of_tables;
  of_tables.reserve(loads.size() + of_network.size());
  for (const PeriodicLoad &load : loads)
    of_tables.push_back(load.waveform->table_period());
  for (const NetworkLoad &load : of_network)
    of_tables.push_back(load.period);
  double period = 0.;
  for (const double of_table : of_tables)
  {
    if (of_table == 0.)
      continue;
    if (period > 0. && std::abs(of_table - period) > 1e-9 * period)
      section.refuse("",
                     "the tables of the loads have different periods, " + shortest_number(period) +
                         " s and " + shortest_number(of_table) + " s",
                     "Set Period to the time after which all of them repeat themselves");
    period = of_table;
  }
  if (period == 0.)
    section.refuse("",
                   "no table of a load is repeated, from which the length of a beat would follow",
                   "Set 'After the table = repeat' for a table of a load, or give Period");
  return period;
}

bool is_integer(const double number)
{
  return std::abs(number - std::round(number)) <= count_slack * std::max(1., number) &&
         number > 0.5;
}

/// That two beats fit into the run and have the same times. Throws InputError.
template <int dim>
void check_times(const Case<dim> &input, ParameterSection root, const bool period_is_given)
{
  const TimeParameters &time = input.time;
  const double period = input.periodic_state.period;
  const std::string beat = shortest_number(period) + " s";
  ParameterSection section = root.subsection("Periodic state"), of_time = root.subsection("Time");
  if (2. * period > time.end_time * (1. + 1e-9))
    (period_is_given ? section : of_time)
        .refuse(period_is_given ? "Period" : "End time",
                "the run ends at " + shortest_number(time.end_time) +
                    " s, before the second beat of " + beat + " does: there is nothing to compare",
                "Set Time/End time to several periods");
  if (time.is_adaptive())
    of_time.refuse("Time step control",
                   "with an adaptive time step the beats do not have the same times, at which "
                   "Periodic state compares them",
                   "Set Time step control = fixed, or remove the section Periodic state");
  if (!time.changes.empty())
    of_time.refuse(
        "Time step changes",
        "with several time steps the beats do not have the same times, at which Periodic "
        "state compares them",
        "Remove the entry, or the section Periodic state");
  const double n_steps = period / time.time_step;
  if (!is_integer(n_steps))
    of_time.refuse("Time step",
                   "a beat of " + beat +
                       " is no whole number of time steps, so that the beats do "
                       "not have the same times",
                   "Give a step that divides the beat, such as " +
                       shortest_number(period / std::ceil(n_steps)) + " s");
  const double interval = input.output.probe_interval;
  if (interval > 0. && (!is_integer(interval / time.time_step) || !is_integer(period / interval)))
    root.subsection("Output").refuse(
        "Probe interval",
        "the rows of probes.csv are those that Periodic state compares, and the beats of " + beat +
            " would not have the same ones",
        "Give a whole number of time steps that divides the beat, or remove the entry");
  const double n_rows = interval > 0. ? period / interval : n_steps;
  if (n_rows < fewest_rows_of_beat - 0.5)
    (interval > 0. ? root.subsection("Output") : of_time)
        .refuse(interval > 0. ? "Probe interval" : "Time step",
                "a beat of " + beat + " would have " + shortest_number(std::round(n_rows)) +
                    " rows in probes.csv, too few to compare beats",
                "Give a shorter one, with " + shortest_number(fewest_rows_of_beat) +
                    " rows in a beat or more");
}

struct Repetition
{
  bool varies = false;   ///< the load, within a beat
  std::size_t first = 0; ///< the first beat, counted from 0, from which on all are the same
};

/// Throws InputError unless the load does the same in the last two beats of the run.
template <int dim>
Repetition repetition_of(const Case<dim> &input,
                         const std::string &name,
                         const std::function<double(double)> &load,
                         const ParameterSection &section,
                         const bool period_is_given)
{
  const double period = input.periodic_state.period;
  // The ends of a beat, where a table may jump, are none of these times.
  const auto value = [&](const std::size_t beat, const unsigned int i)
  { return load((static_cast<double>(beat) + (i + 0.5) / n_times_of_repetition) * period); };
  const auto last = static_cast<std::size_t>(input.time.end_time / period * (1. + 1e-9)) - 1;
  double largest = 0., low = value(last, 0), high = low;
  for (unsigned int i = 0; i < n_times_of_repetition; ++i)
  {
    largest = std::max({largest, std::abs(value(last, i)), std::abs(value(last - 1, i))});
    low = std::min(low, value(last, i));
    high = std::max(high, value(last, i));
  }
  const auto is_as_the_last = [&](const std::size_t beat)
  {
    for (unsigned int i = 0; i < n_times_of_repetition; ++i)
      if (std::abs(value(beat, i) - value(last, i)) > repetition_slack * largest)
        return false;
    return true;
  };
  Repetition result;
  result.varies = high - low > repetition_slack * largest;
  result.first = last;
  while (result.first > 0 && is_as_the_last(result.first - 1))
    --result.first;
  if (result.first == last)
    section.refuse(period_is_given ? "Period" : "",
                   "the load of " + name + " does not repeat itself after " +
                       shortest_number(period) + " s in the last two beats of the run",
                   "Give the period of the loads (with a table: After the table = repeat), and a "
                   "later Time/End time where a Ramp is longer than the run without two beats");
  return result;
}
} // namespace

template <int dim>
std::size_t intervals_of_beat(const Case<dim> &input)
{
  const double interval = input.output.probe_interval;
  return static_cast<std::size_t>(
      std::round(input.periodic_state.period / (interval > 0. ? interval : input.time.time_step)));
}

template <int dim>
void set_periodic_loads(Case<dim> &input, ParameterSection root)
{
  ParameterSection section = root.subsection("Periodic state");
  if (!input.periodic_state.is_on)
  {
    if (input.problem.interior.starts_under_mean_loads)
      root.subsection("Initial state")
          .refuse("Type", "the period over which the loads have their mean is not known",
                  "Add the section Periodic state, or set Type = steady");
    return;
  }
  std::vector<PeriodicLoad> loads = loads_of(input);
  // Outlets are shared and never change: copies take the place of those with a load behind them.
  std::vector<std::pair<BoundaryCondition *, std::shared_ptr<Outlet>>> shared;
  for (BoundaryCondition &condition : input.problem.conditions)
    if (condition.outlet && condition.outlet->pressure_behind.depends_on_time())
    {
      shared.emplace_back(&condition, std::make_shared<Outlet>(*condition.outlet));
      loads.push_back({&shared.back().second->pressure_behind,
                       "the boundary '" + condition.name + "'",
                       {{{0., 0., 0.}}}});
    }
  PeriodicStateParameters &periodic_state = input.periodic_state;
  const bool period_is_given = section.given("Period");
  const std::vector<NetworkLoad> of_network = network_loads(input);
  if (!period_is_given)
    periodic_state.period = period_of_tables(loads, of_network, section);
  check_times(input, root, period_is_given);
  bool any_varies = false;
  std::string latest;
  const auto take = [&](const std::string &name, const std::function<double(double)> &load)
  {
    const Repetition repetition = repetition_of(input, name, load, section, period_is_given);
    any_varies = any_varies || repetition.varies;
    if (repetition.first > periodic_state.first_of_loads)
    {
      periodic_state.first_of_loads = repetition.first;
      latest = name;
    }
  };
  for (const PeriodicLoad &load : loads)
    for (const std::array<double, 3> &place : load.places)
      take(load.name, [&](const double time) { return (*load.waveform)(place.data(), time); });
  for (const NetworkLoad &load : of_network)
    take(load.name, load.value);
  if (!any_varies)
    section.refuse("", "no load varies in time, so that there are no beats",
                   "Give the inlet a formula of t, or a table with After the table = repeat, or "
                   "remove the section");
  if (input.problem.interior.starts_under_mean_loads && periodic_state.first_of_loads > 0)
    root.subsection("Initial state")
        .refuse("Type",
                "the load of " + latest +
                    " does not repeat itself from t = 0 on, as a start from the mean asks for",
                "Remove its Ramp, or let its table or formula begin at t = 0, or set Type = given");
  for (const BoundaryCondition &condition : input.problem.conditions)
    if (input.problem.interior.starts_under_mean_loads && condition.outlet &&
        !condition.outlet->initial_states.empty())
      root.subsection("Boundaries")
          .subsection(condition.name)
          .refuse("Initial pressure",
                  "a start from the mean of the loads gives the windkessel the charge of the mean "
                  "flow",
                  "Remove the entry, or set Initial state/Type = steady or given");
  // Any one, since all are the same.
  const double end = 2. * periodic_state.period;
  for (const PeriodicLoad &load : loads)
    load.waveform->set_period(periodic_state.period, end);
  for (const auto &[condition, outlet] : shared)
    condition->outlet = outlet;
}

template <int dim>
void check_compared_probes(const Case<dim> &input, const ParameterSection &section)
{
  const std::vector<ProbeColumnName> columns =
      input.probes.expected_columns(field_names<dim>(input.problem));
  for (const std::string &text : input.periodic_state.probes)
    if (std::none_of(columns.begin(), columns.end(),
                     [&text](const ProbeColumnName &column) { return column.is_meant_by(text); }))
    {
      std::vector<std::string> labels;
      labels.reserve(columns.size());
      for (const ProbeColumnName &column : columns)
        labels.push_back(column.label());
      section.refuse("Probes", "there is no probe '" + text + "'", choices(text, labels));
    }
}

template std::size_t intervals_of_beat(const Case<2> &);
template std::size_t intervals_of_beat(const Case<3> &);
template void set_periodic_loads(Case<2> &, ParameterSection);
template void set_periodic_loads(Case<3> &, ParameterSection);
template void check_compared_probes(const Case<2> &, const ParameterSection &);
template void check_compared_probes(const Case<3> &, const ParameterSection &);
} // namespace Continua
