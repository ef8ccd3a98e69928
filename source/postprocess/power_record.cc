#include <continua/base/input_error.h>
#include <continua/base/output_files.h>
#include <continua/continuum/equation_term.h>
#include <continua/postprocess/power_record.h>

#include <algorithm>
#include <cmath>

namespace Continua
{
namespace
{
bool has_stores(const Outlet &outlet)
{
  return outlet.network || (outlet.impedance.terms_store_energy && !outlet.impedance.terms.empty());
}
} // namespace

template <int dim>
PowerRecord<dim>::PowerRecord(const MPI_Comm communicator,
                              const std::vector<std::string> &regions,
                              const std::vector<bool> &relaxes,
                              const std::vector<Outlet> &outlets,
                              const bool mesh_changes,
                              const std::vector<EquationTermType> &terms,
                              const bool relaxation_is_known)
    : run_table(communicator),
      regions(regions),
      relaxes(relaxes),
      any_relaxes(std::find(relaxes.begin(), relaxes.end(), true) != relaxes.end()),
      knows_loss(!any_relaxes || relaxation_is_known),
      mesh_changes(mesh_changes),
      term_types(terms),
      transferred(term_types.size(), std::vector<double>(regions.size(), 0.)),
      taken(regions.size(), std::vector<double>(term_types.size(), 0.)),
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
  row.insert(row.end(), power.terms.begin(), power.terms.end());
  if (with_relaxation)
    row.push_back(power.relaxation);
}

template <int dim>
std::vector<std::string> PowerRecord<dim>::header() const
{
  std::vector<std::string> names = {"time [s]", "balance time [s]", "external [W]"};
  const auto add_terms = [&](const std::string &prefix, const bool with_relaxation)
  {
    for (const EquationTermType &term : term_types)
      names.push_back(prefix + term.name + " [W]");
    if (with_relaxation)
      names.push_back(prefix + "relaxation [W]");
  };
  add_terms("", any_relaxes);
  if (regions.size() > 1)
    for (unsigned int region = 0; region < regions.size(); ++region)
      add_terms(regions[region] + ": ", region_relaxes(region));
  for (unsigned int outlet = 0; outlet < given.size(); ++outlet)
  {
    names.push_back("outlet " + outlet_names[outlet] + ": leaving [W]");
    if (outlet_stores[outlet])
      names.push_back("outlet " + outlet_names[outlet] + ": stored [W]");
  }
  names.insert(names.end(), {"residual [W]", "share [1]"});
  for (const EquationTermType &term : term_types)
    if (term.stores)
      names.push_back(term.name + " energy [J]");
  names.emplace_back("work of loads [J]");
  if (knows_loss)
    names.emplace_back("loss of the scheme [J]");
  if (mesh_changes)
    names.emplace_back("energy change by transfer [J]");
  return names;
}

template <int dim>
void PowerRecord<dim>::open(ContinuumSolver<dim> &solver,
                            const std::string &folder,
                            const bool /*is_due*/)
{
  open(output_file(folder, "power.csv"));
  start(solver);
}

template <int dim>
void PowerRecord<dim>::resume(ContinuumSolver<dim> & /*solver*/,
                              const std::string &folder,
                              const double time)
{
  open(output_file(folder, "power.csv"), time);
}

template <int dim>
void PowerRecord<dim>::record(const RecordedStep<dim> &step)
{
  SectionTimer::Scope scope(step.log.timer(), "power ledger");
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
  run_table.open(file, header());
}

template <int dim>
void PowerRecord<dim>::open(const std::string &file, const double restart_time)
{
  run_table.resume(file, header(), restart_time);
}

template <int dim>
void PowerRecord<dim>::start(ContinuumSolver<dim> &solver)
{
  const Energy energy = solver.energy();
  totals.initial_energy = energy.sum();
  initial = energy.terms;
  compare(totals.initial_energy);
}

template <int dim>
void PowerRecord<dim>::record(ContinuumSolver<dim> &solver, const Step &step, const bool write)
{
  const PowerBalance balance = solver.power_balance((write || knows_loss) && any_relaxes);
  totals.largest_residual = std::max(totals.largest_residual, std::abs(balance.residual));
  totals.largest_exchanged = std::max(totals.largest_exchanged, balance.exchanged);
  totals.residual_energy += step.size() * balance.residual;
  totals.work += step.size() * balance.external;
  for (unsigned int region = 0; region < taken.size(); ++region)
    for (unsigned int term = 0; term < taken[region].size(); ++term)
      taken[region][term] += step.size() * balance.materials[region].terms[term];
  for (const Power &power : balance.materials)
    totals.relaxed += step.size() * power.relaxation;
  for (unsigned int outlet = 0; outlet < given.size(); ++outlet)
  {
    given[outlet].leaving += step.size() * balance.outlets[outlet].leaving;
    given[outlet].stored += step.size() * balance.outlets[outlet].stored;
  }
  if (!write)
    return;

  const Energy energy = solver.energy();
  compare(energy.sum());
  if (!run_table.is_writing())
    return;

  Power total;
  total.terms.assign(term_types.size(), 0.);
  for (const Power &power : balance.materials)
  {
    for (unsigned int term = 0; term < power.terms.size(); ++term)
      total.terms[term] += power.terms[term];
    total.relaxation += power.relaxation;
  }
  row.assign({step.time, balance.time, balance.external});
  append(total, any_relaxes);
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
  row.insert(row.end(), {balance.residual, share});
  for (unsigned int term = 0; term < term_types.size(); ++term)
    if (term_types[term].stores)
      row.push_back(energy.of_term(term));
  row.push_back(totals.work);
  if (knows_loss)
    row.push_back(loss_of_scheme(energy));
  if (mesh_changes)
    row.push_back(totals.transfer);
  run_table.row(row);
}

template <int dim>
double PowerRecord<dim>::loss_of_scheme(const Energy &energy) const
{
  double stored = -totals.relaxed;
  for (const std::vector<double> &of_region : taken)
    for (unsigned int term = 0; term < term_types.size(); ++term)
      if (term_types[term].stores)
        stored += of_region[term];
  return stored - (energy.sum() - totals.initial_energy - totals.transfer);
}

template <int dim>
void PowerRecord<dim>::record_transfer(const Energy &before, const Energy &after)
{
  totals.transfer += after.sum() - before.sum();
  for (unsigned int term = 0; term < transferred.size(); ++term)
    for (unsigned int region = 0; region < regions.size(); ++region)
      transferred[term][region] += after.terms[term][region] - before.terms[term][region];
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
  run_table.flush_to_disk();
}

template <int dim>
std::optional<WrittenTable> PowerRecord<dim>::table() const
{
  return run_table.written();
}

template <int dim>
void PowerRecord<dim>::flush()
{
  run_table.flush();
}

template <int dim>
void PowerRecord<dim>::finish(ContinuumSolver<dim> &solver, Summary &summary)
{
  const Energy energy = solver.energy();
  if (totals.largest_exchanged > 0.)
    summary.add({"power residual", totals.largest_residual / totals.largest_exchanged, "1", ""});
  if (totals.largest_energy > 0.)
    summary.add(
        {"energy residual", std::abs(totals.residual_energy) / totals.largest_energy, "1", ""});
  if (totals.initial_energy > 0.)
    summary.add(
        {"total energy change", totals.largest_energy_change / totals.initial_energy, "1", ""});
  if (totals.largest_exchanged > 0.)
  {
    summary.add({"work of the loads", totals.work, "J", ""});
    if (knows_loss)
      summary.add({"loss of the scheme", loss_of_scheme(energy), "J", ""});
  }
  if (mesh_changes)
    summary.add({"energy change by transfer", totals.transfer, "J", ""});
  for (unsigned int region = 0; region < taken.size() && totals.largest_exchanged > 0.; ++region)
  {
    std::vector<double> held = taken[region];
    double relaxed = 0.;
    for (unsigned int term = 0; term < held.size() && region_relaxes(region); ++term)
      if (term_types[term].may_relax)
      {
        // What the springs hold; the rest of what they were given has relaxed.
        held[term] = energy.terms[term][region] - initial[term][region] - transferred[term][region];
        relaxed += taken[region][term] - held[term];
      }
    if (region_relaxes(region))
      summary.add({"energy relaxed", relaxed, "J", regions[region]});
    for (const bool stores : {true, false})
      for (unsigned int term = 0; term < held.size(); ++term)
        if (term_types[term].stores == stores)
          summary.add({term_types[term].total, held[term], "J", regions[region]});
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
                                       const std::vector<EquationTermType> &terms,
                                       const bool relaxation_is_known,
                                       QuantityNames &names)
{
  for (const char *const name :
       {"power residual", "energy residual", "total energy change", "work of the loads"})
    names.add(name);
  if (relaxation_is_known || std::find(relaxes.begin(), relaxes.end(), true) == relaxes.end())
    names.add("loss of the scheme");
  if (mesh_changes)
    names.add("energy change by transfer");
  for (unsigned int region = 0; region < regions.size(); ++region)
  {
    for (const EquationTermType &term : terms)
      names.add(term.total, regions[region]);
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
  std::vector<double> values = {totals.largest_residual,
                                totals.largest_exchanged,
                                totals.residual_energy,
                                totals.work,
                                totals.initial_energy,
                                totals.largest_energy,
                                totals.largest_energy_change,
                                totals.transfer,
                                totals.relaxed};
  for (const std::vector<double> &of_region : taken)
    values.insert(values.end(), of_region.begin(), of_region.end());
  for (const OutletPower &power : given)
    values.insert(values.end(), {power.leaving, power.stored});
  archive.add("power record", values);
  for (unsigned int term = 0; term < term_types.size(); ++term)
  {
    const std::string &name = term_types[term].name;
    archive.add("initial energies: " + name,
                initial.empty() ? std::vector<double>() : initial[term]);
    archive.add("energies by transfer: " + name, transferred[term]);
  }
}

template <int dim>
void PowerRecord<dim>::load(const ArchiveReader &archive)
{
  const std::vector<double> values = archive.values("power record");
  const std::size_t n_terms = term_types.size(), n_totals = 9;
  if (values.size() != n_totals + n_terms * taken.size() + 2 * given.size())
    throw RunError("the checkpoint's power record is that of another version of the program");
  totals = {values[0], values[1], values[2], values[3], values[4],
            values[5], values[6], values[7], values[8]};
  auto value = values.begin() + n_totals;
  for (std::vector<double> &of_region : taken)
  {
    of_region.assign(value, value + n_terms);
    value += n_terms;
  }
  for (OutletPower &of_outlet : given)
  {
    of_outlet = {value[0], value[1]};
    value += 2;
  }
  initial.clear();
  for (unsigned int term = 0; term < n_terms; ++term)
  {
    const std::string &name = term_types[term].name;
    initial.push_back(archive.values("initial energies: " + name));
    transferred[term] = archive.values("energies by transfer: " + name);
  }
}

template class PowerRecord<2>;
template class PowerRecord<3>;
} // namespace Continua
