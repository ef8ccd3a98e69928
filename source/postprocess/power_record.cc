#include <continua/base/input_error.h>
#include <continua/postprocess/power_record.h>
#include <continua/postprocess/writing_rank.h>

#include <algorithm>
#include <cmath>

namespace Continua
{
namespace
{
bool has_stores(const Outlet &outlet)
{
  return outlet.impedance.terms_store_energy && !outlet.impedance.terms.empty();
}
} // namespace

template <int dim>
PowerRecord<dim>::PowerRecord(const MPI_Comm communicator,
                              const std::vector<std::string> &regions,
                              const std::vector<bool> &relaxes,
                              const std::vector<Outlet> &outlets,
                              const bool mesh_changes)
    : communicator(communicator),
      regions(regions),
      relaxes(relaxes),
      any_relaxes(std::find(relaxes.begin(), relaxes.end(), true) != relaxes.end()),
      mesh_changes(mesh_changes),
      transfer_strain(regions.size(), 0.),
      transfer_compressive(regions.size(), 0.),
      taken(regions.size()),
      given(outlets.size())
{
  for (const Outlet &outlet : outlets)
  {
    outlet_names.push_back(outlet.name);
    outlet_stores.push_back(has_stores(outlet));
  }
}

template <int dim>
void PowerRecord<dim>::append(const Power &power, const bool with_relaxation)
{
  row.insert(row.end(), {power.kinetic, power.strain, power.viscous, power.compressive});
  if (with_relaxation)
    row.push_back(power.relaxation);
}

template <int dim>
std::vector<std::string> PowerRecord<dim>::header() const
{
  std::vector<std::string> names = {"time [s]",       "balance time [s]", "external [W]",
                                    "kinetic [W]",    "strain [W]",       "viscous [W]",
                                    "compressive [W]"};
  if (any_relaxes)
    names.emplace_back("relaxation [W]");
  if (regions.size() > 1)
    for (unsigned int region = 0; region < regions.size(); ++region)
    {
      for (const char *const part : {"kinetic", "strain", "viscous", "compressive"})
        names.push_back(regions[region] + ": " + part + " [W]");
      if (region_relaxes(region))
        names.push_back(regions[region] + ": relaxation [W]");
    }
  for (unsigned int outlet = 0; outlet < given.size(); ++outlet)
  {
    names.push_back("outlet " + outlet_names[outlet] + ": leaving [W]");
    if (outlet_stores[outlet])
      names.push_back("outlet " + outlet_names[outlet] + ": stored [W]");
  }
  for (const char *const name :
       {"residual [W]", "share [1]", "kinetic energy [J]", "strain energy [J]",
        "compressive energy [J]", "work of loads [J]"})
    names.emplace_back(name);
  if (mesh_changes)
    names.emplace_back("energy change by transfer [J]");
  return names;
}

template <int dim>
void PowerRecord<dim>::open(ContinuumSolver<dim> &solver,
                            const std::string &folder,
                            const bool /*is_due*/)
{
  open(folder + "/power.csv");
  start(solver);
}

template <int dim>
void PowerRecord<dim>::resume(const std::string &folder, const double time)
{
  open(folder + "/power.csv", time);
}

template <int dim>
void PowerRecord<dim>::record(const RecordedStep<dim> &step)
{
  dealii::TimerOutput::Scope scope(step.log.timer(), "power ledger");
  record(step.solver, step.part, step.is_due);
}

template <int dim>
void PowerRecord<dim>::change_mesh(const MeshChange<dim> &change)
{
  record_transfer(change.before, change.after);
}

template <int dim>
void PowerRecord<dim>::finish(const RecordedEnd<dim> &end)
{
  finish(end.solver, end.summary);
}

template <int dim>
void PowerRecord<dim>::open(const std::string &file)
{
  on_writing_rank(communicator, [&]() { table = std::make_unique<TableWriter>(file, header()); });
}

template <int dim>
void PowerRecord<dim>::open(const std::string &file, const double restart_time)
{
  on_writing_rank(communicator,
                  [&]() { table = std::make_unique<TableWriter>(file, header(), restart_time); });
}

template <int dim>
void PowerRecord<dim>::start(ContinuumSolver<dim> &solver)
{
  const Energy energy = solver.energy();
  totals.initial_energy = energy.sum();
  initial_strain = energy.strain_of_materials;
  initial_compressive = energy.compressive_of_materials;
  compare(totals.initial_energy);
}

template <int dim>
void PowerRecord<dim>::record(ContinuumSolver<dim> &solver, const Step &step, const bool write)
{
  const PowerBalance balance = solver.power_balance(write && any_relaxes);
  totals.largest_residual = std::max(totals.largest_residual, std::abs(balance.residual));
  totals.largest_exchanged = std::max(totals.largest_exchanged, balance.exchanged);
  totals.residual_energy += step.size() * balance.residual;
  totals.work += step.size() * balance.external;
  for (unsigned int region = 0; region < taken.size(); ++region)
  {
    const Power &power = balance.materials[region];
    taken[region].kinetic += step.size() * power.kinetic;
    taken[region].strain += step.size() * power.strain;
    taken[region].viscous += step.size() * power.viscous;
    taken[region].compressive += step.size() * power.compressive;
  }
  for (unsigned int outlet = 0; outlet < given.size(); ++outlet)
  {
    given[outlet].leaving += step.size() * balance.outlets[outlet].leaving;
    given[outlet].stored += step.size() * balance.outlets[outlet].stored;
  }
  if (!write)
    return;

  const Energy energy = solver.energy();
  compare(energy.sum());
  if (!table)
    return;

  Power whole;
  for (const Power &power : balance.materials)
  {
    whole.kinetic += power.kinetic;
    whole.strain += power.strain;
    whole.viscous += power.viscous;
    whole.compressive += power.compressive;
    whole.relaxation += power.relaxation;
  }
  row.assign({step.time, balance.time, balance.external});
  append(whole, any_relaxes);
  if (regions.size() > 1)
    for (unsigned int region = 0; region < regions.size(); ++region)
      append(balance.materials[region], region_relaxes(region));
  for (unsigned int outlet = 0; outlet < given.size(); ++outlet)
  {
    row.push_back(balance.outlets[outlet].leaving);
    if (outlet_stores[outlet])
      row.push_back(balance.outlets[outlet].stored);
  }
  const double share = balance.exchanged > 0. ? balance.residual / balance.exchanged : 0.;
  row.insert(row.end(), {balance.residual, share, energy.kinetic, energy.strain, energy.compressive,
                         totals.work});
  if (mesh_changes)
    row.push_back(totals.transfer);
  table->row(row);
}

template <int dim>
void PowerRecord<dim>::record_transfer(const Energy &before, const Energy &after)
{
  totals.transfer += after.sum() - before.sum();
  for (unsigned int region = 0; region < regions.size(); ++region)
  {
    transfer_strain[region] +=
        after.strain_of_materials[region] - before.strain_of_materials[region];
    transfer_compressive[region] +=
        after.compressive_of_materials[region] - before.compressive_of_materials[region];
  }
}

template <int dim>
void PowerRecord<dim>::compare(const double energy)
{
  totals.largest_energy = std::max(totals.largest_energy, energy);
  totals.largest_energy_change =
      std::max(totals.largest_energy_change, std::abs(energy - totals.initial_energy));
}

template <int dim>
void PowerRecord<dim>::flush_to_disk()
{
  on_writing_rank(communicator,
                  [&]()
                  {
                    if (table)
                      table->flush_to_disk();
                  });
}

template <int dim>
void PowerRecord<dim>::flush()
{
  on_writing_rank(communicator,
                  [&]()
                  {
                    if (table)
                      table->flush();
                  });
}

template <int dim>
void PowerRecord<dim>::finish(ContinuumSolver<dim> &solver, Summary &summary)
{
  const Energy energy = any_relaxes ? solver.energy() : Energy();
  if (totals.largest_exchanged > 0.)
    summary.add({"power residual", totals.largest_residual / totals.largest_exchanged, "1", ""});
  if (totals.largest_energy > 0.)
    summary.add(
        {"energy residual", std::abs(totals.residual_energy) / totals.largest_energy, "1", ""});
  if (totals.initial_energy > 0.)
    summary.add(
        {"total energy change", totals.largest_energy_change / totals.initial_energy, "1", ""});
  if (totals.largest_exchanged > 0.)
    summary.add({"work of the loads", totals.work, "J", ""});
  if (mesh_changes)
    summary.add({"energy change by transfer", totals.transfer, "J", ""});
  for (unsigned int region = 0; region < taken.size() && totals.largest_exchanged > 0.; ++region)
  {
    double strain = taken[region].strain, compressive = taken[region].compressive;
    if (region_relaxes(region))
    {
      strain =
          energy.strain_of_materials[region] - initial_strain[region] - transfer_strain[region];
      compressive = energy.compressive_of_materials[region] - initial_compressive[region] -
                    transfer_compressive[region];
      summary.add({"energy relaxed",
                   taken[region].strain - strain + taken[region].compressive - compressive, "J",
                   regions[region]});
    }
    summary.add({"kinetic energy taken", taken[region].kinetic, "J", regions[region]});
    summary.add({"strain energy taken", strain, "J", regions[region]});
    summary.add({"compressive energy taken", compressive, "J", regions[region]});
    summary.add({"energy dissipated", taken[region].viscous, "J", regions[region]});
  }
  for (unsigned int outlet = 0; outlet < given.size() && totals.largest_exchanged > 0.; ++outlet)
  {
    const OutletPower &energy_given = given[outlet];
    summary.add({"energy left", energy_given.leaving, "J", outlet_names[outlet]});
    if (outlet_stores[outlet])
      summary.add({"energy dissipated", energy_given.leaving - energy_given.stored, "J",
                   outlet_names[outlet]});
  }
  flush();
}

template <int dim>
void PowerRecord<dim>::name_quantities(const std::vector<std::string> &regions,
                                       const std::vector<bool> &relaxes,
                                       const std::vector<Outlet> &outlets,
                                       const bool mesh_changes,
                                       QuantityNames &names)
{
  for (const char *const name :
       {"power residual", "energy residual", "total energy change", "work of the loads"})
    names.add(name);
  if (mesh_changes)
    names.add("energy change by transfer");
  for (unsigned int region = 0; region < regions.size(); ++region)
  {
    for (const char *const name : {"kinetic energy taken", "strain energy taken",
                                   "compressive energy taken", "energy dissipated"})
      names.add(name, regions[region]);
    if (region < relaxes.size() && relaxes[region])
      names.add("energy relaxed", regions[region]);
  }
  for (const Outlet &outlet : outlets)
  {
    names.add("energy left", outlet.name);
    if (has_stores(outlet))
      names.add("energy dissipated", outlet.name);
  }
}

template <int dim>
void PowerRecord<dim>::save(ArchiveWriter &archive) const
{
  std::vector<double> values = {totals.largest_residual,      totals.largest_exchanged,
                                totals.residual_energy,       totals.work,
                                totals.initial_energy,        totals.largest_energy,
                                totals.largest_energy_change, totals.transfer};
  for (const Power &power : taken)
    values.insert(values.end(), {power.kinetic, power.strain, power.viscous, power.compressive});
  for (const OutletPower &power : given)
    values.insert(values.end(), {power.leaving, power.stored});
  archive.add("power record", values);
  archive.add("initial strain energies", initial_strain);
  archive.add("initial compressive energies", initial_compressive);
  archive.add("strain energies by transfer", transfer_strain);
  archive.add("compressive energies by transfer", transfer_compressive);
}

template <int dim>
void PowerRecord<dim>::load(const ArchiveReader &archive)
{
  const std::vector<double> values = archive.values("power record");
  if (values.size() != 8 + 4 * taken.size() + 2 * given.size())
    throw RunError("the checkpoint's power record is that of another version of the program");
  totals = {values[0], values[1], values[2], values[3], values[4], values[5], values[6], values[7]};
  for (unsigned int region = 0; region < taken.size(); ++region)
  {
    const double *const value = &values[8 + 4 * region];
    taken[region].kinetic = value[0];
    taken[region].strain = value[1];
    taken[region].viscous = value[2];
    taken[region].compressive = value[3];
  }
  for (unsigned int outlet = 0; outlet < given.size(); ++outlet)
  {
    const double *const value =
        &values[8 + 4 * taken.size() + 2 * static_cast<std::size_t>(outlet)];
    given[outlet] = {value[0], value[1]};
  }
  initial_strain = archive.values("initial strain energies");
  initial_compressive = archive.values("initial compressive energies");
  transfer_strain = archive.values("strain energies by transfer");
  transfer_compressive = archive.values("compressive energies by transfer");
}

template class PowerRecord<2>;
template class PowerRecord<3>;
} // namespace Continua
