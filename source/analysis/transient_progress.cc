#include <continua/analysis/transient_progress.h>

#include <continua/base/collective.h>

#include <sstream>

namespace Continua
{
using namespace dealii;

template <int dim>
TransientProgress<dim>::TransientProgress(Run<dim> &run)
    : run(run),
      time_control(run.input.time),
      records(make_records(run.input, run.directory.path())),
      flow(run),
      range(run),
      beats(run),
      probe_schedule(run.input.output.probe_schedule(run.input.time.end_time))
{
}

template <int dim>
void TransientProgress<dim>::record_probes()
{
  SectionTimer::Scope scope(run.log.timer(), "probes");
  run.input.probes.record(time_control.time());
}

template <int dim>
bool TransientProgress<dim>::adaptation_is_due() const
{
  const AdaptationParameters &adaptation = run.input.adaptation;
  return adaptation.every_n_steps > 0 && time_control.n_steps() % adaptation.every_n_steps == 0 &&
         time_control.time() < adaptation.end_time;
}

template <int dim>
void TransientProgress<dim>::adapt()
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

template struct TransientProgress<2>;
template struct TransientProgress<3>;
} // namespace Continua
