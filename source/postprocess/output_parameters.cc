#include <continua/postprocess/output_parameters.h>

#include <continua/base/name_choice.h>
#include <continua/base/parameter_text.h>
#include <continua/postprocess/report_entry.h>

#include <utility>

namespace Continua
{
namespace
{
/// The fields that can be asked for.
const std::vector<std::pair<std::string, bool FurtherFields::*>> further_field_words = {
    {"vorticity", &FurtherFields::vorticity},
    {"Q criterion", &FurtherFields::q_criterion},
    {"wall shear stress", &FurtherFields::wall_shear_stress},
    {"averages of wall shear stress", &FurtherFields::wall_shear_averages}};

FurtherFields read_further_fields(ParameterSection section)
{
  std::vector<std::string> words, known;
  section.add(
      "Further fields", words,
      "Fields in fields.pvd beside those that are always there: vorticity; Q criterion; wall "
      "shear stress - what liquids exert on their walls, at the nodes there; averages of "
      "wall shear stress - its mean magnitude over time and the oscillatory shear index");
  for (const auto &row : further_field_words)
    known.push_back(row.first);
  FurtherFields fields;
  for (const std::string &word : words)
    fields.*further_field_words[find_name(section, "Further fields", collapse_blanks(word), known,
                                          "there is no field '")]
                .second = true;
  return fields;
}
} // namespace

void OutputParameters::read(ParameterSection section)
{
  const Dimension &time = Dimensions::time;
  const Range range = Range::not_negative();
  section.add("Probe interval", probe_interval, time,
              "Time between two rows of probes.csv [s]; 0: a row after every step", range);
  section.add(
      "Power interval", power_interval, time,
      "Time between two rows of power.csv, with a mesh that moves also of mass.csv [s]; 0: a row "
      "after every step; the balance of powers is kept over every step in any case",
      range);
  section.add("Field interval", field_interval, time,
              "Time between two states in fields.pvd [s]; 0: none but the final one", range);
  section.add("Final fields", final_fields,
              "Whether the state at the end of the run is written to fields.pvd");
  section.add("Checkpoint interval", checkpoint_interval, time,
              "Simulated time between two checkpoints [s]; 0: none", range);
  section.add("Checkpoint steps", checkpoint_steps, "Steps between two checkpoints; 0: none", 0);
  section.add(
      "Checkpoint wall time", checkpoint_wall_time, time,
      "Time on the clock between two checkpoints [s]; 0: none. With any of the three one is "
      "written when any of them is due; on SIGTERM, SIGINT and SIGUSR1 in any case",
      range);
  section.add("Checkpoint at end", checkpoint_at_end,
              "Whether the state at the end is saved, so that a later run can go on from there");
  section.add("Subdivisions", subdivisions,
              "Parts into which a cell is cut in each direction in the fields; 0: as many as the "
              "degree of the elements");
  section.add(
      "Higher order cells", higher_order_cells,
      "Whether the parts of a cell are written as one curved cell (ParaView 5.5 and later)");
  section.add("Files per state", files_per_state,
              "Files into which the ranks write a state of the fields together; 0: one a rank", 0);
  read_report_entry(section);
  further_fields = read_further_fields(section);
  section.add(
      "Averages from", wall_shear_window.begin, time,
      "Start of the time over which the wall shear stress is averaged, for fields and probes "
      "[s]. A periodic response has the average over its period, whatever is given",
      range);
  section.add("Averages to", wall_shear_window.end, time,
              "End of this time [s]; infinite: the end of the run", Range::positive());
  if (wall_shear_window.end <= wall_shear_window.begin)
    section.refuse("Averages to", "the averages end before they begin",
                   "Give a time after Averages from");
}

unsigned int OutputParameters::subdivisions_for(const unsigned int element_degree) const
{
  return subdivisions > 0 ? subdivisions : element_degree;
}

Schedule OutputParameters::probe_schedule(const double end_time) const
{
  return {probe_interval, Schedule::ZeroInterval::every_step, end_time, true, true};
}

Schedule OutputParameters::power_schedule(const double end_time) const
{
  return {power_interval, Schedule::ZeroInterval::every_step, end_time, true, true};
}

Schedule OutputParameters::step_schedule(const double end_time) const
{
  return {0., Schedule::ZeroInterval::every_step, end_time, false, true};
}

Schedule OutputParameters::field_schedule(const double end_time) const
{
  return {field_interval, Schedule::ZeroInterval::never, end_time, field_interval > 0.,
          final_fields};
}

Schedule OutputParameters::checkpoint_schedule(const double end_time) const
{
  return {checkpoint_interval, Schedule::ZeroInterval::never, end_time, false, checkpoint_at_end};
}
} // namespace Continua
