#include <continua/analysis/transient.h>

#include <continua/analysis/linear_wave_theory.h>
#include <continua/analysis/steady_search.h>
#include <continua/analysis/stream_report.h>
#include <continua/base/atomic_file.h>
#include <continua/base/collective.h>
#include <continua/base/input_error.h>
#include <continua/base/interruption.h>
#include <continua/case/before_the_run/preflight_report.h>
#include <continua/case/network_ends.h>
#include <continua/mesh/refinement_tree.h>
#include <continua/postprocess/writing_rank.h>

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <functional>
#include <limits>
#include <optional>
#include <sstream>

namespace Continua
{
using namespace dealii;

template <int dim>
Transient<dim>::Transient(Run<dim> &run)
    : run(run),
      time_control(run.input.time),
      records(make_records(run.input, run.directory.path())),
      flow(run),
      range(run),
      beats(run),
      checkpoint(run.input.communicator, run.directory, run.file),
      probe_schedule(run.input.output.probe_schedule(run.input.time.end_time)),
      checkpoint_schedule(run.input.output.checkpoint_schedule(run.input.time.end_time))
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
  const double steps_to_end = run.input.time.end_time / run.input.time.time_step;
  if (run.input.time.changes.empty() && std::abs(steps_to_end - std::round(steps_to_end)) > 1e-6)
    run.log.warning("the end time is not a whole number of time steps: the run ends with the first "
                    "step beyond it");
  // Backward differencing knows its error from the sixth step of a start on.
  const unsigned int every_n_steps = run.input.adaptation.every_n_steps;
  if (time_control.is_adaptive() && every_n_steps > 0)
    run.log.warning(every_n_steps <= 5
                        ? "the mesh changes so often that the error of a step is hardly ever "
                          "known, and the time step does not adapt"
                        : "each change of the mesh excites fast motions, which an adaptive time "
                          "step follows: a fixed one may need fewer steps");
  report_tables();
  for (const std::string &warning : network_warnings(run.input))
    run.log.warning(warning);
  if (run.command_line.restart)
    restart();
  else
    start();
  report_preflight();
  if (!run.command_line.restart)
    range.take(0.);
  while (!at_end())
    step();
  run.log.end_progress();
  if (run.input.output.checkpoint_at_end)
    write_checkpoint();
  // After the checkpoint: a run that goes on from it need not have looked at this state.
  range.take(time_control.time());
  for (const ScheduledRecord<dim> &entry : records)
    entry.record->finish({*run.solver, time_control, run.summary, run.log});
  LinearWaveTheory<dim>(run).compare();
  StreamReport<dim>::add(run);
  StreamReport<dim>::add_difference(run);
  // In finite deformation that of the body at rest says nothing.
  if (run.input.problem.deformation == Deformation::small)
    run.summary.add({"weak divergence at the end", run.solver->divergence(), "1/s", ""});
  flow.finish();
  range.finish();
  beats.finish();
  if (run.input.problem.is_nonlinear())
    run.summary.add({"steps halved", static_cast<double>(n_halved), "1", ""});
  if (run.input.time.scheme == Scheme::crank_nicolson && run.input.time.smooth_start)
    run.citations.add("rannacher1984");
  run.finish(time_control.n_steps(), time_control.time());
}

template <int dim>
void Transient<dim>::start()
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
  beats.open();
  if (probe_schedule.due(0., 0.))
    run.input.probes.record(0.);
  if (time_control.is_adaptive())
    largest_energy = run.solver->energy().sum();
  for (const ScheduledRecord<dim> &entry : records)
    entry.record->open(*run.solver, run.directory.path(), entry.schedule.due(0., 0.));
}

template <int dim>
void Transient<dim>::start_steady_under_loads()
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
void Transient<dim>::adapt_before_start()
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
    mesh_has_changed = true;
    std::ostringstream text;
    text << "Initial cycle " << cycle << ": mesh of " << run.solver->sizes().n_cells << " cells";
    run.log.line(text.str());
    SignalWatch::stop_if_asked(run.input.communicator, "before the start, after initial cycle " +
                                                           std::to_string(cycle) +
                                                           "; begin anew with --overwrite");
  }
}

template <int dim>
void Transient<dim>::report_how_to_stop()
{
  if (dealii::Utilities::MPI::n_mpi_processes(run.input.communicator) > 1 && run.is_writer)
    run.log.note("To stop this run without loss: kill -USR1 " + std::to_string(::getpid()) +
                 " on the machine of the first rank, or to mpirun itself; it ends after its step, "
                 "with a checkpoint. After Ctrl-C mpirun kills the ranks within seconds, in the "
                 "middle of a long step");
}

template <int dim>
void Transient<dim>::report_initial_jumps()
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
void Transient<dim>::report_tables()
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
void Transient<dim>::report_preflight()
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
  flow.start(input.frequency, tube_speed);
  range.set_tube_speed(tube_speed);
}

template <int dim>
void Transient<dim>::restart()
{
  const ArchiveReader archive = checkpoint.read();
  // What is read of it, with a word of where it comes from.
  const auto reading = [this](const std::function<void()> &read)
  {
    try
    {
      read();
    }
    catch (const Interrupted &)
    {
      throw;
    }
    catch (const std::exception &error)
    {
      throw RunError("the checkpoint in '" + run.directory.file("checkpoint") +
                     "' has right checksums but cannot be used: " + error.what());
    }
  };
  reading(
      [&]()
      {
        run.input.power_laws.load(archive, run.input.problem, run.input.time);
        run.input.absorbing_ends.load(archive, run.input.problem);
      });
  mesh_has_changed = has_refinement(archive);
  if (mesh_has_changed)
    run.initialise(
        [&]() { reading([&]() { load_refinement<dim>(archive, *run.input.triangulation); }); });
  else
    run.initialise();
  double size = 0.;
  unsigned long n_rows_written = 0;
  bool is_due_to_adapt = false;
  std::vector<std::string> warnings;
  reading(
      [&]()
      {
        time_control.load(archive);
        run.solver->load(archive);
        for (const ScheduledRecord<dim> &entry : records)
          entry.record->load(archive);
        largest_energy = archive.value("largest energy");
        n_restarts = archive.integer("restarts") + 1;
        n_halved = archive.integer("steps halved");
        flow.load(archive);
        range.load(archive);
        earlier_wall_time = archive.value("wall time");
        std::istringstream lines(archive.text("warnings"));
        for (std::string line; std::getline(lines, line);)
          warnings.push_back(line);
        size = archive.value("size of the last step");
        n_rows_written = archive.integer("rows of probes.csv");
        is_due_to_adapt = archive.integer("adaptation is due") == 1;
      });
  const double time = time_control.time();
  run.summary.set("restarts", static_cast<double>(n_restarts));
  run.summary.set("wall time before the restart [s]", earlier_wall_time);
  run.log.resume_warnings(warnings);
  // A row that stands there only because the first part of the run ended there is not one of the
  // whole run.
  const bool had_ended = PeriodicState<dim>::ended_run(run.input, archive);
  const auto kept = [&](const Schedule &schedule)
  {
    return schedule.due(time, size) || (had_ended && schedule.takes_end()) ? time
                                                                           : time - 0.5 * size;
  };
  checkpoint.cut_tables(archive, run.directory.path(), keeps_last_row(run.input, archive));
  run.input.probes.open(run.directory.file("probes.csv"), kept(probe_schedule));
  const unsigned long n_rows = n_rows_written - (probe_schedule.due(time, size) ? 0 : 1);
  if (run.input.probes.n_columns() > 0 && run.input.probes.times().size() != n_rows)
    run.log.warning("probes.csv has " + std::to_string(run.input.probes.times().size()) +
                    " rows up to the restart, the run that is continued had written " +
                    std::to_string(n_rows));
  beats.resume(time);
  for (const ScheduledRecord<dim> &entry : records)
    entry.record->resume(*run.solver, run.directory.path(), kept(entry.schedule));
  // The mesh does not change at the end of a run; if the run goes on it does.
  if (is_due_to_adapt && !at_end())
    adapt();
  std::ostringstream text;
  text << "Restart at t = " << time << " s, step " << time_control.n_steps();
  run.log.line(text.str());
  tenths_reported = static_cast<unsigned int>(10. * time / run.input.time.end_time + 1e-6);
}

template <int dim>
void Transient<dim>::find_jumps()
{
  if (time_control.n_steps() == 0 ||
      (run.input.time.scheme == Scheme::euler_implicit && !time_control.is_adaptive()))
    return;
  SectionTimer::Scope scope(run.log.timer(), "search for jumps");
  const double start = time_control.time();
  // A jump anywhere in the step: at its end it is the next step's.
  const auto jumps = [&]()
  {
    const double size = time_control.next_size();
    return run.solver->data_jump(start - 1e-6 * size, start + (1. - 1e-6) * size);
  };
  while (jumps())
    if (time_control.jump())
    {
      std::ostringstream text;
      text << "A load or prescribed velocity jumps in the step from t = " << start
           << " s: the scheme starts anew";
      run.log.line(text.str());
      return;
    }
}

template <int dim>
StepReport Transient<dim>::advance(const Step &part)
{
  const StepReport report = run.solver->advance(part);
  for (const ScheduledRecord<dim> &entry : records)
    entry.record->attempt(report);
  return report;
}

template <int dim>
void Transient<dim>::record_probes()
{
  SectionTimer::Scope scope(run.log.timer(), "probes");
  run.input.probes.record(time_control.time());
}

template <int dim>
std::vector<Step> Transient<dim>::next_parts()
{
  std::vector<Step> parts = time_control.next();
  std::reverse(parts.begin(), parts.end());
  return parts;
}

template <int dim>
StepReport Transient<dim>::make_next_part(std::vector<Step> &parts, const bool is_first)
{
  const double shortest = std::ldexp(time_control.last_size(), -most_halvings);
  for (;;)
  {
    last_part = parts.back();
    parts.pop_back();
    try
    {
      return advance(last_part);
    }
    catch (const StepFailure &failure)
    {
      if (is_first && time_control.is_adaptive())
      {
        // A step without a solution has an error without bound.
        if (time_control.judge(std::numeric_limits<double>::infinity()))
          throw RunError(std::string(failure.what()) +
                         "; the step has the smallest size (Time/Smallest time step)");
        run.log.detail(std::string(failure.what()) + "; a shorter step takes its place");
        run.solver->return_to_kept_state();
        parts = next_parts();
        continue;
      }
      if (last_part.size() < 1.5 * shortest)
      {
        std::ostringstream text;
        text << failure.what() << "; the step was halved " << most_halvings << " times";
        throw RunError(text.str());
      }
      step_is_divided = true;
      const std::array<Step, 2> halves = halves_of(last_part);
      ++n_halved;
      std::ostringstream text;
      text << failure.what() << "; it is made in halves of " << halves.front().size() << " s";
      run.log.line(text.str());
      // The formulas of the part after these two know the size of the one before it.
      if (!parts.empty() && parts.back().older_distance != 0.)
      {
        const Step after = parts.back();
        parts.back() = step_like(after, after.time_old, after.size(), halves.back().size());
        parts.back().time = after.time;
        parts.back().balance_time = after.balance_time;
      }
      parts.push_back(halves.back());
      parts.push_back(halves.front());
    }
  }
}

template <int dim>
bool Transient<dim>::stands()
{
  if (!time_control.is_adaptive())
    return true;
  const StepError error = run.solver->step_error();
  double scale = largest_energy;
  const auto relative = [&]()
  { return error.kinetic_energy > 0. ? std::sqrt(error.kinetic_energy / scale) : 0.; };
  // The energy may cost products with all matrices: it is asked for now and then, and where it may
  // save a step.
  if (time_control.n_steps() % 4 == 0 || relative() > run.input.time.error_tolerance)
  {
    SectionTimer::Scope scope(run.log.timer(), "step error");
    scale = std::max(scale, run.solver->energy().sum());
  }
  const bool accepted =
      time_control.judge(error.is_known ? std::optional<double>(relative()) : std::nullopt);
  // A step that is undone was never there.
  if (accepted)
    largest_energy = scale;
  return accepted;
}

template <int dim>
void Transient<dim>::step()
{
  find_jumps();
  step_is_divided = false;
  if (time_control.is_adaptive())
    run.solver->keep_state();
  // The parts of the step that are left, the next one last.
  std::vector<Step> parts = next_parts();
  StepReport report = make_next_part(parts, true);
  // A step in two halves stands: it starts the scheme, and its error is not known.
  while (!stands())
  {
    run.solver->return_to_kept_state();
    parts = next_parts();
    report = make_next_part(parts, true);
  }
  const double time = time_control.time(), size = time_control.last_size();
  for (bool is_first = true; is_first || !parts.empty(); is_first = false)
  {
    if (!is_first)
      report = make_next_part(parts, false);
    const Step part = last_part;
    flow.take(report, part.size());
    for (const ScheduledRecord<dim> &entry : records)
      entry.record->take(report, part.time, run.log);
    if (report.largest_velocity > run.input.time.velocity_limit)
    {
      std::ostringstream text;
      text << "the run diverges: the largest velocity in the step to t = " << part.time << " s is "
           << report.largest_velocity
           << " m/s, above Time/Velocity limit = " << run.input.time.velocity_limit << " m/s";
      if (run.input.problem.convection.is_explicit())
        text << "; explicit convection is stable with shorter steps only: see the Courant number "
                "of the flow, or set Flow/Time treatment = newton";
      throw RunError(text.str());
    }
    const bool ends_step = parts.empty();
    // What a beat was decides whether this state is the last one, which the records then take.
    const bool ends_beat = ends_step && beats.ends_beat(time);
    if (ends_beat)
    {
      record_probes();
      beats.add_beat(time);
    }
    for (const ScheduledRecord<dim> &entry : records)
      entry.record->record(
          {*run.solver, part, time, size, ends_step,
           ends_step && (entry.schedule.due(time, size) ||
                         (ends_beat && beats.ends_run() && entry.schedule.takes_end())),
           run.log});
    // After the ledger, which has made the forces that a probe may ask for.
    if (ends_step && !ends_beat && probe_schedule.due(time, size))
      record_probes();
  }
  if (step_is_divided)
    time_control.set_last_size(last_part.size());
  last_size = size;
  if (time_control.n_steps() % RangeReport<dim>::every_n_steps == 0)
    range.take(time);
  if (adaptation_is_due() && !at_end())
    adapt();
  save_or_stop();
  report_progress();
}

template <int dim>
void Transient<dim>::save_or_stop()
{
  // A signal may have come on one rank alone, and no two clocks are the same.
  const OutputParameters &output = run.input.output;
  const double wall_time =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - last_checkpoint).count();
  const bool time_is_over =
      output.checkpoint_wall_time > 0. && run.is_writer && wall_time >= output.checkpoint_wall_time;
  const std::array<int, 2> mine = {{SignalWatch::pending(), time_is_over ? 1 : 0}};
  std::array<int, 2> all;
  const int error =
      MPI_Allreduce(mine.data(), all.data(), 2, MPI_INT, MPI_MAX, run.input.communicator);
  AssertThrowMPI(error);
  const bool stop = all[0] != 0 && !at_end();
  const bool steps_are_over =
      output.checkpoint_steps > 0 && time_control.n_steps() % output.checkpoint_steps == 0;
  if (stop || all[1] != 0 || steps_are_over ||
      checkpoint_schedule.due(time_control.time(), last_size))
    write_checkpoint();
  if (!stop)
    return;
  run.summary.set("steps", static_cast<double>(time_control.n_steps()));
  std::ostringstream text;
  text << "interrupted by " << SignalWatch::name(all[0]) << " at t = " << time_control.time()
       << " s, step " << time_control.n_steps() << "; the state is saved, go on with --restart";
  throw Interrupted(text.str());
}

template <int dim>
bool Transient<dim>::adaptation_is_due() const
{
  const AdaptationParameters &adaptation = run.input.adaptation;
  return adaptation.every_n_steps > 0 && time_control.n_steps() % adaptation.every_n_steps == 0 &&
         time_control.time() < adaptation.end_time;
}

template <int dim>
void Transient<dim>::adapt()
{
  const Energy energy_before = run.solver->energy();
  if (!run.adapt(time_control.time()))
    return;
  mesh_has_changed = true;
  time_control.restart();
  const Energy energy_after = run.solver->energy();
  for (const ScheduledRecord<dim> &entry : records)
    entry.record->change_mesh({*run.solver, time_control.time(), energy_before, energy_after});
  const double before = energy_before.sum(), after = energy_after.sum();
  std::ostringstream text;
  text << "t = " << time_control.time() << " s: mesh of " << run.solver->sizes().n_cells
       << " cells";
  run.log.line(text.str());
  std::ostringstream detail;
  detail << "the transfer changed the energy by " << (before > 0. ? (after - before) / before : 0.)
         << " of itself";
  run.log.detail(detail.str());
  double n_unknowns = 0.;
  for (const auto &field : run.solver->sizes().n_dofs)
    n_unknowns += field.second;
  std::ostringstream partition;
  partition << n_unknowns << " unknowns; cells of each rank:";
  for (const unsigned int n_cells : all_gather(
           run.input.problem.communicator, run.input.triangulation->n_locally_owned_active_cells()))
    partition << ' ' << n_cells;
  run.log.detail(partition.str());
}

template <int dim>
void Transient<dim>::write_checkpoint()
{
  SectionTimer::Scope scope(run.log.timer(), "checkpoint");
  // A run that is killed goes on from here: what stands before must be on the disk.
  run.input.probes.flush_to_disk();
  beats.flush_to_disk();
  for (const ScheduledRecord<dim> &entry : records)
    entry.record->flush_to_disk();
  on_writing_rank(run.input.communicator, [this]() { flush_log_to_disk(); });
  const std::string warning = checkpoint.write(
      time_control.n_steps(),
      [this](ArchiveWriter &archive)
      {
        time_control.save(archive);
        run.input.power_laws.save(archive);
        run.input.absorbing_ends.save(archive, run.input.problem);
        archive.add("size of the last step", last_size);
        archive.add("adaptation is due",
                    static_cast<unsigned long>(adaptation_is_due() && at_end() ? 1 : 0));
        run.solver->save(archive);
        for (const ScheduledRecord<dim> &entry : records)
          entry.record->save(archive);
        archive.add("largest energy", largest_energy);
        archive.add("rows of probes.csv",
                    static_cast<unsigned long>(run.input.probes.times().size()));
        archive.add("restarts", n_restarts);
        archive.add("steps halved", n_halved);
        flow.save(archive);
        range.save(archive);
        beats.save(archive, time_control.time());
        archive.add("wall time", earlier_wall_time + run.log.wall_times().at("total"));
        std::string warnings;
        for (const std::string &warning : run.log.warnings())
          warnings += warning + "\n";
        archive.add("warnings", warnings);
        if (mesh_has_changed)
          save_refinement<dim>(*run.input.triangulation, archive);
      },
      written_tables());
  if (!warning.empty())
    run.log.warning(warning);
  last_checkpoint = std::chrono::steady_clock::now();
}

template <int dim>
void Transient<dim>::flush_log_to_disk()
{
  // A log that the disk has refused, or that the user has removed, does not end the run.
  const std::string file = run.directory.file("log.txt");
  std::error_code error;
  if (!std::filesystem::exists(file, error))
    return;
  flush_to_disk(file);
  of_log.add_rest_of(file);
}

template <int dim>
std::vector<WrittenTable> Transient<dim>::written_tables() const
{
  std::vector<std::optional<WrittenTable>> all = {run.input.probes.table(), beats.table()};
  if (of_log.length() > 0)
  {
    all.emplace_back(WrittenTable());
    all.back()->name = "log.txt";
    all.back()->all = of_log;
  }
  for (const ScheduledRecord<dim> &entry : records)
    all.push_back(entry.record->table());
  std::vector<WrittenTable> tables;
  for (const std::optional<WrittenTable> &table : all)
    if (table)
    {
      tables.push_back(*table);
      // A restart leaves out no other row than that of the present time.
      if (table->last_time <= time_control.time() - 0.5 * last_size)
        tables.back().without_last_row = table->all;
    }
  return tables;
}

template <int dim>
void Transient<dim>::report_progress()
{
  const double time = time_control.time(), end = run.input.time.end_time;
  run.log.progress(time, end, time_control.n_steps());
  const unsigned int tenths = static_cast<unsigned int>(10. * time / end + 1e-6);
  if (tenths > tenths_reported)
  {
    tenths_reported = tenths;
    std::ostringstream text;
    text << "t = " << time << " s of " << end << " s (step " << time_control.n_steps() << ")";
    run.log.line(text.str());
  }
}

template class Transient<2>;
template class Transient<3>;
} // namespace Continua
