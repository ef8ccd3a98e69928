#include <continua/analysis/flow_report.h>

#include <continua/case/before_the_run/flow_numbers_input.h>

#include <algorithm>
#include <map>
#include <sstream>

namespace Continua
{
namespace
{
const char *const attained_speed = "largest speed";
const char *const attained_reynolds = "attained Reynolds number";
const char *const attained_cell_reynolds = "attained cell Reynolds number";
const char *const attained_courant = "attained Courant number";
} // namespace

template <int dim>
void FlowReport<dim>::start(const double frequency, const double tube_speed)
{
  if (!run.input.problem.convection.is_on)
    return;
  FlowNumbersInput input = flow_numbers_input(run.input);
  input.frequency = frequency;
  if (tube_speed > 0.)
  {
    input.wave_speed = tube_speed;
    input.wave = "the tube wave";
  }
  is_in_time = input.time_step > 0.;
  numbers.emplace(input);
  run.log.line(numbers->headline());
  if (!numbers->entries().empty())
    for (const std::string &line :
         preflight_text("Numbers of the flow (doc/preflight.md)", numbers->entries()))
      run.log.detail(line);
  for (const std::string &warning : numbers->warnings())
    run.log.warning(warning);
  std::map<std::string, double> values;
  for (const PreflightEntry &entry : numbers->entries())
    values[entry.name + " [" + entry.unit + "]"] = entry.value;
  run.summary.set("numbers of the flow", values);
}

template <int dim>
void FlowReport<dim>::take(const StepReport &report, const double size)
{
  if (!numbers)
    return;
  largest_speed = std::max(largest_speed, report.largest_velocity);
  if (size == 0.)
    return;
  const double before = largest_courant, limit = FlowNumbers::largest_explicit_courant_number;
  largest_courant =
      std::max(largest_courant, numbers->courant_number(report.largest_velocity, size));
  if (!run.input.problem.convection.is_explicit() || before > limit || largest_courant <= limit)
    return;
  std::ostringstream text;
  text.precision(3);
  text << "the Courant number of the flow has come to " << largest_courant << ", above " << limit
       << ": explicit convection may be unstable; take a smaller time step, or Flow/Time treatment "
          "= "
          "newton";
  run.log.warning(text.str());
}

template <int dim>
void FlowReport<dim>::finish()
{
  if (!numbers)
    return;
  run.summary.add({attained_speed, largest_speed, "m/s", ""});
  run.summary.add({attained_reynolds, numbers->reynolds_number(largest_speed), "1", ""});
  run.summary.add({attained_cell_reynolds, numbers->cell_reynolds_number(largest_speed), "1", ""});
  if (is_in_time)
    run.summary.add({attained_courant, largest_courant, "1", ""});
}

template <int dim>
void FlowReport<dim>::name_quantities(const Case<dim> &input, QuantityNames &names)
{
  if (!input.problem.convection.is_on)
    return;
  for (const char *const name : {attained_speed, attained_reynolds, attained_cell_reynolds})
    names.add(name);
  if (input.analysis.is_transient())
    names.add(attained_courant);
}

template <int dim>
void FlowReport<dim>::save(ArchiveWriter &archive) const
{
  archive.add("largest speed of the flow", largest_speed);
  archive.add("largest Courant number of the flow", largest_courant);
}

template <int dim>
void FlowReport<dim>::load(const ArchiveReader &archive)
{
  largest_speed = archive.value("largest speed of the flow");
  largest_courant = archive.value("largest Courant number of the flow");
}

template class FlowReport<2>;
template class FlowReport<3>;
} // namespace Continua
