#include <continua/analysis/record_table.h>

#include <continua/analysis/periodic_state.h>
#include <continua/postprocess/field_writer.h>
#include <continua/postprocess/loop_record.h>
#include <continua/postprocess/mass_record.h>
#include <continua/postprocess/mesh_record.h>
#include <continua/postprocess/network_record.h>
#include <continua/postprocess/power_record.h>
#include <continua/postprocess/residual_record.h>
#include <continua/postprocess/step_record.h>
#include <continua/time_integration/time_control.h>

#include <map>

namespace Continua
{
namespace
{
/// A power law relaxes, also when its branches are still in the checkpoint.
std::vector<bool> relaxing_regions(const std::vector<Material> &materials)
{
  std::vector<bool> relaxing;
  relaxing.reserve(materials.size());
  for (const Material &material : materials)
    relaxing.push_back(material.relaxes());
  return relaxing;
}

template <int dim>
std::unique_ptr<Record<dim>> make_power_record(const Case<dim> &input, const std::string &)
{
  return std::make_unique<PowerRecord<dim>>(
      input.communicator, input.problem.regions, relaxing_regions(input.problem.materials),
      input.problem.outlets, input.adaptation.changes_mesh(), equation_terms(input.problem),
      input.problem.deformation == Deformation::finite);
}

template <int dim>
void name_power(const Case<dim> &input, QuantityNames &names)
{
  PowerRecord<dim>::name_quantities(
      input.problem.regions, relaxing_regions(input.problem.materials), input.problem.outlets,
      input.adaptation.changes_mesh(), equation_terms(input.problem),
      input.problem.deformation == Deformation::finite, names);
}

template <int dim>
std::unique_ptr<Record<dim>> make_field_writer(const Case<dim> &input, const std::string &folder)
{
  return std::make_unique<FieldWriter<dim>>(
      input.communicator, folder,
      input.output.subdivisions_for(input.discretisation.velocities_per_cell()),
      input.output.higher_order_cells, input.output.files_per_state);
}

template <int dim>
std::unique_ptr<Record<dim>> make_residual_record(const Case<dim> &input, const std::string &)
{
  return std::make_unique<ResidualRecord<dim>>(input.communicator);
}

template <int dim>
std::unique_ptr<Record<dim>> make_mass_record(const Case<dim> &input, const std::string &)
{
  return std::make_unique<MassRecord<dim>>(input.communicator);
}

template <int dim>
std::unique_ptr<Record<dim>> make_network_record(const Case<dim> &input, const std::string &)
{
  return std::make_unique<NetworkRecord<dim>>(input.communicator, input.network);
}

template <int dim>
void name_network(const Case<dim> &input, QuantityNames &names)
{
  NetworkRecord<dim>::name_quantities(*input.network, names);
}

/// The record of a run that has one.
template <int dim, typename Type>
std::unique_ptr<Record<dim>> make_record(const Case<dim> &, const std::string &)
{
  return std::make_unique<Type>();
}

template <int dim, typename Type>
void name_quantities_of(const Case<dim> &, QuantityNames &names)
{
  Type::name_quantities(names);
}

template <int dim>
struct RecordRow
{
  /// Whether a run of the case has it; null: each has.
  bool (*applies)(const Case<dim> &);
  std::unique_ptr<Record<dim>> (*make)(const Case<dim> &, const std::string &folder);
  /// Null: it adds no quantities.
  void (*name_quantities)(const Case<dim> &, QuantityNames &);
  /// Which states it takes; null: none.
  Schedule (OutputParameters::*schedule)(double end_time) const;
  /// The table in which each state that it takes has a row; empty: none.
  std::string table{};
};

/// To add a record, add a row. The records are called in this order.
template <int dim>
const std::vector<RecordRow<dim>> &record_table()
{
  static const std::vector<RecordRow<dim>> rows = {
      {nullptr, make_power_record<dim>, name_power<dim>, &OutputParameters::power_schedule,
       "power.csv"},
      {[](const Case<dim> &input)
       { return input.problem.mesh_moves && !input.discretisation.is_cell_wise(); },
       make_mass_record<dim>, name_quantities_of<dim, MassRecord<dim>>,
       &OutputParameters::power_schedule, "mass.csv"},
      {[](const Case<dim> &input) { return input.network != nullptr; }, make_network_record<dim>,
       name_network<dim>, &OutputParameters::probe_schedule, "network.csv"},
      {nullptr, make_record<dim, LoopRecord<dim>>, name_quantities_of<dim, LoopRecord<dim>>,
       nullptr},
      {[](const Case<dim> &input)
       {
         return input.discretisation.cell_wise.is_segregated() &&
                input.discretisation.cell_wise.residual_history;
       },
       make_residual_record<dim>, nullptr, &OutputParameters::step_schedule, "residuals.csv"},
      {nullptr, make_record<dim, StepRecord<dim>>,
       [](const Case<dim> &input, QuantityNames &names)
       {
         if (input.time.is_adaptive())
           StepRecord<dim>::name_quantities(names);
       },
       nullptr},
      {[](const Case<dim> &input) { return input.adaptation.changes_mesh(); },
       make_record<dim, MeshRecord<dim>>, name_quantities_of<dim, MeshRecord<dim>>, nullptr},
      {nullptr, make_field_writer<dim>, nullptr, &OutputParameters::field_schedule, "fields.pvd"}};
  return rows;
}
} // namespace

template <int dim>
std::vector<ScheduledRecord<dim>> make_records(const Case<dim> &input, const std::string &folder)
{
  std::vector<ScheduledRecord<dim>> records;
  for (const RecordRow<dim> &row : record_table<dim>())
    if (row.applies == nullptr || row.applies(input))
      records.push_back(
          {row.make(input, folder),
           row.schedule == nullptr
               ? Schedule(0., Schedule::ZeroInterval::never, input.time.end_time, false, false)
               : (input.output.*row.schedule)(input.time.end_time)});
  return records;
}

template <int dim>
std::function<bool(const std::string &)> keeps_last_row(const Case<dim> &input,
                                                        const ArchiveReader &archive)
{
  TimeControl time_control(input.time);
  time_control.load(archive);
  const double time = time_control.time(), size = archive.value("size of the last step");
  const bool had_ended = PeriodicState<dim>::ended_run(input, archive);
  std::map<std::string, bool> is_due = {
      {"probes.csv", input.output.probe_schedule(input.time.end_time).due(time, size)}};
  for (const RecordRow<dim> &row : record_table<dim>())
    if (!row.table.empty())
    {
      const Schedule schedule = (input.output.*row.schedule)(input.time.end_time);
      is_due[row.table] = schedule.due(time, size) || (had_ended && schedule.takes_end());
    }
  return [is_due](const std::string &table)
  {
    const auto found = is_due.find(table);
    return found == is_due.end() || found->second;
  };
}

template <int dim>
void name_quantities_of_records(const Case<dim> &input, QuantityNames &names)
{
  for (const RecordRow<dim> &row : record_table<dim>())
    if (row.name_quantities != nullptr && (row.applies == nullptr || row.applies(input)))
      row.name_quantities(input, names);
}

template std::vector<ScheduledRecord<2>> make_records(const Case<2> &, const std::string &);
template std::vector<ScheduledRecord<3>> make_records(const Case<3> &, const std::string &);
template std::function<bool(const std::string &)> keeps_last_row(const Case<2> &,
                                                                 const ArchiveReader &);
template std::function<bool(const std::string &)> keeps_last_row(const Case<3> &,
                                                                 const ArchiveReader &);
template void name_quantities_of_records(const Case<2> &, QuantityNames &);
template void name_quantities_of_records(const Case<3> &, QuantityNames &);
} // namespace Continua
