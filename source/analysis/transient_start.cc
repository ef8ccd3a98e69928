#include <continua/analysis/transient_start.h>

#include <continua/analysis/steady_search.h>
#include <continua/base/interruption.h>
#include <continua/case/before_the_run/preflight_report.h>
#include <continua/case/network_ends.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <string>
#include <unistd.h>

namespace Continua
{
using namespace dealii;

template <int dim>
TransientStart<dim>::TransientStart(TransientProgress<dim> &so_far)
    : so_far(so_far), run(so_far.run)
{
}

template <int dim>
void TransientStart<dim>::report_input()
{
  const double steps_to_end = run.input.time.end_time / run.input.time.time_step;
  if (run.input.time.changes.empty() && std::abs(steps_to_end - std::round(steps_to_end)) > 1e-6)
    run.log.warning("the end time is not a whole number of time steps: the run ends with the first "
                    "step beyond it");
  // Backward differencing knows its error from the sixth step of a start on.
  const unsigned int every_n_steps = run.input.adaptation.every_n_steps;
  if (so_far.time_control.is_adaptive() && every_n_steps > 0)
    run.log.warning(every_n_steps <= 5
                        ? "the mesh changes so often that the error of a step is hardly ever "
                          "known, and the time step does not adapt"
                        : "each change of the mesh excites fast motions, which an adaptive time "
                          "step follows: a fixed one may need fewer steps");
  report_tables();
  for (const std::string &warning : network_warnings(run.input))
    run.log.warning(warning);
}

template <int dim>
void TransientStart<dim>::start()
{
  run.initialise();
  report_how_to_stop();
  adapt_before_start();
  if (run.input.problem.finds_unloaded_shape())
    SteadySearch<dim>(
        run, [](const StepReport &, double, double) {}, "begin anew with --overwrite")
        .find_unloaded_shape(true);
  else if (run.input.problem.interior.starts_steady_under_loads)
    start_steady_under_loads();
  else
    report_initial_jumps();
  if (const std::string text = network_at_start(run.input); !text.empty())
    run.log.detail(text);
  run.input.probes.open(run.directory.file("probes.csv"));
  so_far.beats.open();
  if (so_far.probe_schedule.due(0., 0.))
    run.input.probes.record(0.);
  if (so_far.time_control.is_adaptive())
    so_far.largest_energy = run.solver->energy().sum();
  for (const ScheduledRecord<dim> &entry : so_far.records)
    entry.record->open(*run.solver, run.directory.path(), entry.schedule.due(0., 0.));
}

template <int dim>
void TransientStart<dim>::start_steady_under_loads()
{
  const bool is_mean = run.input.problem.interior.starts_under_mean_loads;
  run.log.line(is_mean
                   ? "Before the start: the steady state under the mean of the loads over a beat"
                   : "Before the start: the steady state under the loads at t = 0");
  SteadySearch<dim>(
      run, [](const StepReport &, double, double) {}, "begin anew with --overwrite")
      .perform(SteadySearch<dim>::Loads::in_parts, is_mean ? mean_over_period : 0.);
  run.solver->start_from_present_state();
}

template <int dim>
void TransientStart<dim>::adapt_before_start()
{
  const AdaptationParameters &adaptation = run.input.adaptation;
  for (unsigned int cycle = 1; cycle <= adaptation.initial_cycles; ++cycle)
  {
    if (!adaptation.is_geometric())
    {
      TimeControl trial(run.input.time);
      for (unsigned int step = 0; step < std::max(1u, adaptation.every_n_steps); ++step)
        for (const Step &part : trial.next())
          run.solver->advance(part);
    }
    if (!run.adapt_before_start())
    {
      // The trial steps are taken back.
      run.solver->initialise();
      break;
    }
    so_far.mesh_has_changed = true;
    std::ostringstream text;
    text << "Initial cycle " << cycle << ": mesh of " << run.solver->sizes().n_cells << " cells";
    run.log.line(text.str());
    SignalWatch::stop_if_asked(run.input.communicator, "before the start, after initial cycle " +
                                                           std::to_string(cycle) +
                                                           "; begin anew with --overwrite");
  }
}

template <int dim>
void TransientStart<dim>::report_how_to_stop()
{
  if (dealii::Utilities::MPI::n_mpi_processes(run.input.communicator) > 1 && run.is_writer)
    run.log.note("To stop this run without loss: kill -USR1 " + std::to_string(::getpid()) +
                 " on the machine of the first rank, or to mpirun itself; it ends after its step, "
                 "with a checkpoint. After Ctrl-C mpirun kills the ranks within seconds, in the "
                 "middle of a long step");
}

template <int dim>
void TransientStart<dim>::report_initial_jumps()
{
  const InteriorData &interior = run.input.problem.interior;
  if (!interior.initial_velocity.empty() || !interior.initial_displacement.empty() ||
      !interior.initial_pressure.empty())
    return;
  for (const BoundaryCondition &condition : run.input.problem.conditions)
  {
    // A value that depends on place is asked for in the middle of one of the coarse faces.
    double point[3] = {0., 0., 0.};
    for (const auto &cell : run.input.triangulation->cell_iterators_on_level(0))
      for (const unsigned int f : cell->face_indices())
        if (cell->face(f)->at_boundary() && cell->face(f)->boundary_id() == condition.boundary_id &&
            condition.region_ids.count(cell->material_id()) > 0)
          for (unsigned int c = 0; c < dim; ++c)
            point[c] = cell->face(f)->center()[c];
    const std::string text = condition.initial_jump(point);
    // A constant load is meant to begin at once; a table of absolute pressures seldom is.
    if (!text.empty() && condition.table_begins_with_jump())
      run.log.warning(text + ", and 'Offset' counts a table from its value at rest");
    else if (!text.empty())
      run.log.detail(text);
  }
}

template <int dim>
void TransientStart<dim>::report_tables()
{
  const double end_time = run.input.time.end_time;
  const auto report = [this](const std::vector<Waveform::Remark> &remarks)
  {
    for (const Waveform::Remark &remark : remarks)
      if (remark.is_warning)
        run.log.warning(remark.text);
      else
        run.log.note("Pre-flight: " + remark.text);
  };
  for (const BoundaryCondition &condition : run.input.problem.conditions)
    report(condition.table_remarks(end_time));
  report(run.input.problem.interior.table_remarks(end_time));
}

template <int dim>
void TransientStart<dim>::report_preflight()
{
  const bool has_waves = has_fluid_and_solid(run.input);
  if (!has_waves && !run.input.problem.convection.is_on)
    return;
  const PreflightInput input = preflight_input(run.input);
  double tube_speed = 0.;
  if (has_waves)
  {
    const PreflightReport report(input);
    run.log.line(report.headline());
    for (const std::string &line :
         preflight_text("Pre-flight report (doc/preflight.md)", report.entries()))
      run.log.detail(line);
    for (const std::string &warning : report.warnings())
      run.log.warning(warning);
    std::map<std::string, double> values;
    for (const PreflightReport::Entry &entry : report.entries())
      values[entry.name + " [" + entry.unit + "]"] = entry.value;
    run.summary.set("pre-flight report", values);
    if (input.is_tube)
      tube_speed = input.length / report.value("transit time");
  }
  so_far.flow.start(input.frequency, tube_speed);
  so_far.range.set_tube_speed(tube_speed);
}

template class TransientStart<2>;
template class TransientStart<3>;
} // namespace Continua
