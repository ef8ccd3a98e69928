#include <continua/analysis/transient_checkpoint.h>

#include <continua/base/atomic_file.h>
#include <continua/base/input_error.h>
#include <continua/base/interruption.h>
#include <continua/mesh/refinement_tree.h>
#include <continua/postprocess/writing_rank.h>

#include <array>
#include <filesystem>
#include <optional>
#include <sstream>

namespace Continua
{
using namespace dealii;

template <int dim>
TransientCheckpoint<dim>::TransientCheckpoint(TransientProgress<dim> &so_far)
    : so_far(so_far),
      run(so_far.run),
      checkpoint(run.input.communicator, run.directory, run.file),
      checkpoint_schedule(run.input.output.checkpoint_schedule(run.input.time.end_time))
{
}

template <int dim>
void TransientCheckpoint<dim>::read(const std::function<void()> &reader) const
{
  try
  {
    reader();
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
}

template <int dim>
void TransientCheckpoint<dim>::restart()
{
  const ArchiveReader archive = checkpoint.read();
  read(
      [&]()
      {
        run.input.power_laws.load(archive, run.input.problem, run.input.time);
        run.input.absorbing_ends.load(archive, run.input.problem);
      });
  so_far.mesh_has_changed = has_refinement(archive);
  if (so_far.mesh_has_changed)
    run.initialise([&]()
                   { read([&]() { load_refinement<dim>(archive, *run.input.triangulation); }); });
  else
    run.initialise();
  double size = 0.;
  unsigned long n_rows_written = 0;
  bool is_due_to_adapt = false;
  std::vector<std::string> warnings;
  read(
      [&]()
      {
        so_far.time_control.load(archive);
        run.solver->load(archive);
        for (const ScheduledRecord<dim> &entry : so_far.records)
          entry.record->load(archive);
        so_far.largest_energy = archive.value("largest energy");
        n_restarts = archive.integer("restarts") + 1;
        so_far.n_halved = archive.integer("steps halved");
        so_far.flow.load(archive);
        so_far.range.load(archive);
        earlier_wall_time = archive.value("wall time");
        std::istringstream lines(archive.text("warnings"));
        for (std::string line; std::getline(lines, line);)
          warnings.push_back(line);
        size = archive.value("size of the last step");
        n_rows_written = archive.integer("rows of probes.csv");
        is_due_to_adapt = archive.integer("adaptation is due") == 1;
      });
  const double time = so_far.time_control.time();
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
  run.input.probes.open(run.directory.file("probes.csv"), kept(so_far.probe_schedule));
  const unsigned long n_rows = n_rows_written - (so_far.probe_schedule.due(time, size) ? 0 : 1);
  if (run.input.probes.n_columns() > 0 && run.input.probes.times().size() != n_rows)
    run.log.warning("probes.csv has " + std::to_string(run.input.probes.times().size()) +
                    " rows up to the restart, the run that is continued had written " +
                    std::to_string(n_rows));
  so_far.beats.resume(time);
  for (const ScheduledRecord<dim> &entry : so_far.records)
    entry.record->resume(*run.solver, run.directory.path(), kept(entry.schedule));
  // The mesh does not change at the end of a run; if the run goes on it does.
  if (is_due_to_adapt && !so_far.at_end())
    so_far.adapt();
  std::ostringstream text;
  text << "Restart at t = " << time << " s, step " << so_far.time_control.n_steps();
  run.log.line(text.str());
}

template <int dim>
void TransientCheckpoint<dim>::save_or_stop()
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
  const bool stop = all[0] != 0 && !so_far.at_end();
  const bool steps_are_over =
      output.checkpoint_steps > 0 && so_far.time_control.n_steps() % output.checkpoint_steps == 0;
  if (stop || all[1] != 0 || steps_are_over ||
      checkpoint_schedule.due(so_far.time_control.time(), so_far.last_size))
    write();
  if (!stop)
    return;
  run.summary.set("steps", static_cast<double>(so_far.time_control.n_steps()));
  std::ostringstream text;
  text << "interrupted by " << SignalWatch::name(all[0]) << " at t = " << so_far.time_control.time()
       << " s, step " << so_far.time_control.n_steps()
       << "; the state is saved, go on with --restart";
  throw Interrupted(text.str());
}

template <int dim>
void TransientCheckpoint<dim>::write()
{
  SectionTimer::Scope scope(run.log.timer(), "checkpoint");
  // A run that is killed goes on from here: what stands before must be on the disk.
  run.input.probes.flush_to_disk();
  so_far.beats.flush_to_disk();
  for (const ScheduledRecord<dim> &entry : so_far.records)
    entry.record->flush_to_disk();
  on_writing_rank(run.input.communicator, [this]() { flush_log_to_disk(); });
  const std::string warning = checkpoint.write(
      so_far.time_control.n_steps(),
      [this](ArchiveWriter &archive)
      {
        so_far.time_control.save(archive);
        run.input.power_laws.save(archive);
        run.input.absorbing_ends.save(archive, run.input.problem);
        archive.add("size of the last step", so_far.last_size);
        archive.add(
            "adaptation is due",
            static_cast<unsigned long>(so_far.adaptation_is_due() && so_far.at_end() ? 1 : 0));
        run.solver->save(archive);
        for (const ScheduledRecord<dim> &entry : so_far.records)
          entry.record->save(archive);
        archive.add("largest energy", so_far.largest_energy);
        archive.add("rows of probes.csv",
                    static_cast<unsigned long>(run.input.probes.times().size()));
        archive.add("restarts", n_restarts);
        archive.add("steps halved", so_far.n_halved);
        so_far.flow.save(archive);
        so_far.range.save(archive);
        so_far.beats.save(archive, so_far.time_control.time());
        archive.add("wall time", earlier_wall_time + run.log.wall_times().at("total"));
        std::string warnings;
        for (const std::string &warning : run.log.warnings())
          warnings += warning + "\n";
        archive.add("warnings", warnings);
        if (so_far.mesh_has_changed)
          save_refinement<dim>(*run.input.triangulation, archive);
      },
      written_tables());
  if (!warning.empty())
    run.log.warning(warning);
  last_checkpoint = std::chrono::steady_clock::now();
}

template <int dim>
void TransientCheckpoint<dim>::flush_log_to_disk()
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
std::vector<WrittenTable> TransientCheckpoint<dim>::written_tables() const
{
  std::vector<std::optional<WrittenTable>> all = {run.input.probes.table(), so_far.beats.table()};
  if (of_log.length() > 0)
  {
    all.emplace_back(WrittenTable());
    all.back()->name = "log.txt";
    all.back()->all = of_log;
  }
  for (const ScheduledRecord<dim> &entry : so_far.records)
    all.push_back(entry.record->table());
  std::vector<WrittenTable> tables;
  for (const std::optional<WrittenTable> &table : all)
    if (table)
    {
      tables.push_back(*table);
      // A restart leaves out no other row than that of the present time.
      if (table->last_time <= so_far.time_control.time() - 0.5 * so_far.last_size)
        tables.back().without_last_row = table->all;
    }
  return tables;
}

template class TransientCheckpoint<2>;
template class TransientCheckpoint<3>;
} // namespace Continua
