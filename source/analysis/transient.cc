#include <continua/analysis/transient.h>

#include <continua/analysis/linear_wave_theory.h>
#include <continua/analysis/steady_search.h>
#include <continua/analysis/stream_report.h>
#include <continua/analysis/transient_start.h>
#include <continua/base/input_error.h>

#include <sstream>
#include <string>

namespace Continua
{
using namespace dealii;

template <int dim>
Transient<dim>::Transient(Run<dim> &run)
    : run(run), so_far(run), attempts(so_far), checkpoint(so_far)
{
}

template <int dim>
void Transient<dim>::check(const Case<dim> &input, ParameterSection root)
{
  LinearWaveTheory<dim>::check_overlay(input, root);
  StreamReport<dim>::check(input, root);
  const bool finds_unloaded_shape = input.problem.finds_unloaded_shape();
  if (!input.problem.interior.starts_steady_under_loads && !finds_unloaded_shape)
    return;
  const std::string remedy =
      finds_unloaded_shape ? "set Unloaded shape = mesh" : "set Initial state/Type = given";
  SteadySearch<dim>::check(input, root, remedy);
}

template <int dim>
void Transient<dim>::name_quantities(const Case<dim> &input, QuantityNames &names)
{
  Run<dim>::name_quantities(input, names);
  name_quantities_of_records(input, names);
  LinearWaveTheory<dim>::name_quantities_of_comparison(input, names);
  StreamReport<dim>::name_quantities(input, names);
  if (input.problem.deformation == Deformation::small)
    names.add("weak divergence at the end");
  FlowReport<dim>::name_quantities(input, names);
  RangeReport<dim>::name_quantities(input, names);
  PeriodicState<dim>::name_quantities(input, names);
  if (input.problem.is_nonlinear())
    names.add("steps halved");
}

template <int dim>
void Transient<dim>::perform()
{
  TransientStart<dim> start(so_far);
  start.report_input();
  if (run.command_line.restart)
  {
    checkpoint.restart();
    tenths_reported = tenths_of_end();
  }
  else
    start.start();
  start.report_preflight();
  if (!run.command_line.restart)
    so_far.range.take(0.);
  while (!so_far.at_end())
    step();
  run.log.end_progress();
  if (run.input.output.checkpoint_at_end)
    checkpoint.write();
  // After the checkpoint: a run that goes on from it need not have looked at this state.
  so_far.range.take(so_far.time_control.time());
  for (const ScheduledRecord<dim> &entry : so_far.records)
    entry.record->finish({*run.solver, so_far.time_control, run.summary, run.log});
  LinearWaveTheory<dim>(run).compare();
  StreamReport<dim>::add(run);
  StreamReport<dim>::add_difference(run);
  // In finite deformation that of the body at rest says nothing.
  if (run.input.problem.deformation == Deformation::small)
    run.summary.add({"weak divergence at the end", run.solver->divergence(), "1/s", ""});
  so_far.flow.finish();
  so_far.range.finish();
  so_far.beats.finish();
  if (run.input.problem.is_nonlinear())
    run.summary.add({"steps halved", static_cast<double>(so_far.n_halved), "1", ""});
  if (run.input.time.scheme == Scheme::crank_nicolson && run.input.time.smooth_start)
    run.citations.add("rannacher1984");
  run.finish(so_far.time_control.n_steps(), so_far.time_control.time());
}

template <int dim>
void Transient<dim>::step()
{
  StepReport report = attempts.begin();
  const double time = so_far.time_control.time(), size = so_far.time_control.last_size();
  for (bool is_first = true; is_first || attempts.has_next_part(); is_first = false)
  {
    if (!is_first)
      report = attempts.make_next_part();
    const Step part = attempts.last_part();
    so_far.flow.take(report, part.size());
    for (const ScheduledRecord<dim> &entry : so_far.records)
      entry.record->take(report, part.time, run.log);
    check_velocity(report, part);
    const bool ends_step = !attempts.has_next_part();
    // What a beat was decides whether this state is the last one, which the records then take.
    const bool ends_beat = ends_step && so_far.beats.ends_beat(time);
    if (ends_beat)
    {
      so_far.record_probes();
      so_far.beats.add_beat(time);
    }
    for (const ScheduledRecord<dim> &entry : so_far.records)
      entry.record->record(
          {*run.solver, part, time, size, ends_step,
           ends_step && (entry.schedule.due(time, size) ||
                         (ends_beat && so_far.beats.ends_run() && entry.schedule.takes_end())),
           run.log});
    // After the ledger, which has made the forces that a probe may ask for.
    if (ends_step && !ends_beat && so_far.probe_schedule.due(time, size))
      so_far.record_probes();
  }
  if (attempts.is_divided())
    so_far.time_control.set_last_size(attempts.last_part().size());
  so_far.last_size = size;
  if (so_far.time_control.n_steps() % RangeReport<dim>::every_n_steps == 0)
    so_far.range.take(time);
  if (so_far.adaptation_is_due() && !so_far.at_end())
    so_far.adapt();
  checkpoint.save_or_stop();
  report_progress();
}

template <int dim>
void Transient<dim>::check_velocity(const StepReport &report, const Step &part) const
{
  if (!(report.largest_velocity > run.input.time.velocity_limit))
    return;
  std::ostringstream text;
  text << "the run diverges: the largest velocity in the step to t = " << part.time << " s is "
       << report.largest_velocity
       << " m/s, above Time/Velocity limit = " << run.input.time.velocity_limit << " m/s";
  if (run.input.problem.convection.is_explicit())
    text << "; explicit convection is stable with shorter steps only: see the Courant number "
            "of the flow, or set Flow/Time treatment = newton";
  throw RunError(text.str());
}

template <int dim>
unsigned int Transient<dim>::tenths_of_end() const
{
  return static_cast<unsigned int>(10. * so_far.time_control.time() / run.input.time.end_time +
                                   1e-6);
}

template <int dim>
void Transient<dim>::report_progress()
{
  const double time = so_far.time_control.time(), end = run.input.time.end_time;
  run.log.progress(time, end, so_far.time_control.n_steps());
  const unsigned int tenths = tenths_of_end();
  if (tenths > tenths_reported)
  {
    tenths_reported = tenths;
    std::ostringstream text;
    text << "t = " << time << " s of " << end << " s (step " << so_far.time_control.n_steps()
         << ")";
    run.log.line(text.str());
  }
}

template class Transient<2>;
template class Transient<3>;
} // namespace Continua
