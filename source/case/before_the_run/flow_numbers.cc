#include <continua/case/before_the_run/flow_numbers.h>

#include <deal.II/base/numbers.h>

#include <cmath>
#include <limits>

namespace Continua
{
namespace
{
using Duct = FlowNumbersInput::Duct;

std::string short_text(const double value)
{
  return quantity_text(value, "1");
}

/// Not by round-off alone.
bool is_above(const double value, const double limit)
{
  return value > limit * (1. + 1e-9);
}
} // namespace

FlowNumbers::FlowNumbers(const FlowNumbersInput &input) : input(input)
{
  if (input.boundary.empty())
    return;
  add("mean speed of the flow", input.mean_speed, "m/s",
      "'" + input.boundary + "', largest of the run");
  add("largest speed of the flow", input.largest_speed, "m/s", "there");
  report_reynolds_numbers();
  report_time();
  report_waves();
}

void FlowNumbers::add(const std::string &name,
                      const double value,
                      const std::string &unit,
                      const std::string &remark)
{
  list.push_back({name, value, unit, remark});
}

double FlowNumbers::value(const std::string &name) const
{
  for (const PreflightEntry &entry : list)
    if (entry.name == name)
      return entry.value;
  return std::numeric_limits<double>::quiet_NaN();
}

double FlowNumbers::reynolds_number(const double speed) const
{
  return input.viscosity > 0. ? input.density * speed * input.width / input.viscosity : 0.;
}

double FlowNumbers::cell_reynolds_number(const double speed) const
{
  return input.viscosity > 0. ? input.density * speed * input.largest_cell / input.viscosity : 0.;
}

double FlowNumbers::courant_number(const double speed, const double time_step) const
{
  return speed * time_step / input.shortest_cell;
}

void FlowNumbers::report_reynolds_numbers()
{
  if (input.viscosity == 0.)
    return;
  const double reynolds = reynolds_number(input.mean_speed);
  const std::string width = quantity_text(input.width, "m");
  const std::string rest = input.has_flow_curve ? ", with the viscosity at rest" : "";
  switch (input.duct)
  {
  case Duct::pipe:
    add("Reynolds number", reynolds, "1", "mean speed and diameter, " + width + rest);
    break;
  case Duct::channel:
    add("Reynolds number", reynolds, "1", "mean speed and gap, " + width + rest);
    break;
  default:
    add("Reynolds number", reynolds, "1", "mean speed and extent, " + width + rest);
  }
  const double cell = cell_reynolds_number(input.largest_speed);
  add("cell Reynolds number", cell, "1",
      (input.is_developed ? "largest speed and longest cell across the developed flow, "
                          : "largest speed and longest cell, ") +
          quantity_text(input.largest_cell, "m") + rest);
  if (is_above(cell, largest_cell_reynolds_number))
    warning_list.push_back("pre-flight: the cell Reynolds number is " + short_text(cell) +
                           ", above " + short_text(largest_cell_reynolds_number) +
                           ": where the flow has layers or jets its cells may be too long for "
                           "them; compare with a finer mesh");
  if (!input.flows_in || input.duct == Duct::none)
    return;
  const bool is_channel = input.duct == Duct::channel;
  const double limit = is_channel ? turbulence_in_a_channel : turbulence_in_a_pipe;
  if (is_above(reynolds, limit))
    warning_list.push_back(
        "pre-flight: the Reynolds number of " + short_text(reynolds) + " (" +
        (is_channel ? "mean speed and gap) is above " : "mean speed and diameter) is above ") +
        short_text(limit) +
        ", where the flow becomes turbulent: there is no turbulence model, and "
        "a laminar solution may not be the real flow");
  report_entrance(reynolds);
}

void FlowNumbers::report_entrance(const double reynolds)
{
  const bool is_channel = input.duct == Duct::channel;
  const double at_rest = is_channel ? 0.631 : 0.619, slope = is_channel ? 0.0442 : 0.0567;
  const double widths =
      std::pow(std::pow(at_rest, 1.6) + std::pow(slope * reynolds, 1.6), 1. / 1.6);
  add("entrance length", widths * input.width, "m",
      "from a uniform to a developed flow: " + short_text(widths) +
          (is_channel ? " gaps" : " diameters"));
}

void FlowNumbers::report_time()
{
  if (input.frequency > 0. && input.viscosity > 0. && input.duct != Duct::none)
    add("Womersley number of the flow",
        0.5 * input.width *
            std::sqrt(2. * dealii::numbers::PI * input.frequency * input.density / input.viscosity),
        "1",
        std::string(input.duct == Duct::channel ? "half the gap" : "radius") +
            " and frequency of the load, " + quantity_text(input.frequency, "Hz"));
  if (input.time_step == 0.)
    return;
  const double courant = courant_number(input.largest_speed, input.time_step);
  add("Courant number of the flow", courant, "1",
      "largest speed and time step in the shortest cell along its longest side, " +
          quantity_text(input.shortest_cell, "m"));
  if (input.convects_explicitly && is_above(courant, largest_explicit_courant_number))
    warning_list.push_back("pre-flight: the Courant number of the flow is " + short_text(courant) +
                           ", above " + short_text(largest_explicit_courant_number) +
                           ": explicit convection may be unstable, and inside the body the flow "
                           "may be faster; take a smaller time step, or Flow/Time treatment = "
                           "newton");
  else if (is_above(courant, largest_courant_number))
    warning_list.push_back("pre-flight: the Courant number of the flow is " + short_text(courant) +
                           ", above " + short_text(largest_courant_number) +
                           ": what the flow carries passes that many cells in a step, and is "
                           "smeared; a steady flow does not mind; take a smaller time step");
}

void FlowNumbers::report_waves()
{
  if (input.wave_speed == 0.)
    return;
  const double mach = input.mean_speed / input.wave_speed;
  add("mean flow over wave speed", mach, "1",
      input.wave + " of " + quantity_text(input.wave_speed, "m/s"));
  if (input.has_absorbing_end && is_above(mach, largest_mach_number))
    warning_list.push_back("pre-flight: the mean flow has " + short_text(100. * mach) +
                           " % of the wave speed, and absorbing ends are those of a liquid at "
                           "rest: they reflect part of the waves");
}

std::string FlowNumbers::headline() const
{
  if (input.boundary.empty())
    return "Pre-flight: no velocity is prescribed that would tell the Reynolds number of the flow; "
           "summary.json has it after the run";
  std::string text = "Pre-flight: flow of " + quantity_text(input.mean_speed, "m/s") + " at '" +
                     input.boundary + "'";
  const auto add_number = [&](const std::string &name)
  {
    if (const double number = value(name); std::isfinite(number))
      text += ", " + name + " " + short_text(number);
  };
  add_number("Reynolds number");
  add_number("cell Reynolds number");
  add_number("Courant number of the flow");
  return text + "; more in log.txt";
}
} // namespace Continua
