#include <continua/boundary/boundary_condition.h>

#include <continua/base/joined.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Continua
{
std::vector<const Waveform *> BoundaryCondition::waveforms() const
{
  std::vector<const Waveform *> result;
  for (const BoundaryPart *part : {&normal, &tangential})
  {
    result.push_back(&part->along_normal);
    for (const Waveform &component : part->vector)
      result.push_back(&component);
  }
  if (is_cavity())
    result.push_back(&volume_ratio);
  if (free_flow)
    result.push_back(&free_flow->rate);
  if (outlet)
    result.push_back(&outlet->pressure_behind);
  return result;
}

std::vector<Waveform::Remark> BoundaryCondition::table_remarks(const double end_time) const
{
  return Waveform::table_remarks(waveforms(), "the boundary '" + name + "': ", end_time);
}

bool BoundaryCondition::table_begins_with_jump() const
{
  const std::vector<const Waveform *> all = waveforms();
  return std::any_of(all.begin(), all.end(),
                     [](const Waveform *one) { return one->table_begins_with_jump(); });
}

std::string BoundaryCondition::initial_jump(const double *point) const
{
  const std::string traction = "Pa", velocity = "m/s";
  std::vector<std::string> values;
  const auto add = [&](const std::string &what, const double value, const std::string &unit)
  {
    std::ostringstream text;
    text << what << " of " << value << ' ' << unit;
    if (value != 0. && std::find(values.begin(), values.end(), text.str()) == values.end())
      values.push_back(text.str());
  };
  for (const BoundaryPart *part : {&normal, &tangential})
  {
    const bool is_velocity = part->kind == BoundaryPart::Kind::velocity;
    double square = 0.;
    for (const Waveform &component : part->vector)
      square += std::pow(component.initial_value(point), 2);
    add(is_velocity ? "a velocity" : "a traction", std::sqrt(square),
        is_velocity ? velocity : traction);
    const double along = part->along_normal.initial_value(point);
    if (profile)
      add("a flow rate", along, is_in_plane ? "m^2/s" : "m^3/s");
    else if (part->negative)
      add("a pressure", along, traction);
    else
      add(is_velocity ? "a normal velocity" : "a normal traction", along,
          is_velocity ? velocity : traction);
  }
  if (const double ratio = volume_ratio.initial_value(point); is_cavity() && ratio != 1.)
    add("a volume ratio", ratio, "times the undeformed volume");
  if (free_flow)
    add("a flow rate", free_flow->rate.initial_value(point), is_in_plane ? "m^2/s" : "m^3/s");
  if (outlet)
  {
    double pressure = outlet->pressure_behind.initial_value(point);
    for (unsigned int k = 0; k < outlet->initial_states.size(); ++k)
      pressure += outlet->impedance.terms[k].residue(0, 0) * outlet->initial_states[k];
    add("a pressure", pressure, traction);
  }
  if (values.empty())
    return "";
  return "The boundary '" + name + "' starts at t = 0 with " + joined(values) +
         ": a body at rest meets it as a jump, which the scheme starts with; 'Ramp' makes a "
         "waveform rise smoothly from zero";
}
} // namespace Continua
