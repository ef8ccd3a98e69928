#ifndef continua_analysis_record_table_h
#define continua_analysis_record_table_h

#include <continua/case/case.h>
#include <continua/postprocess/record.h>
#include <continua/postprocess/schedule.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace Continua
{
/// A record of a transient run, and the states that it takes.
template <int dim>
struct ScheduledRecord
{
  std::unique_ptr<Record<dim>> record;
  Schedule schedule;
};

/// The records of a transient run, in the order of their table in record_table.cc. `folder`: of the
/// output. (A steady run has a writer of fields alone.)
template <int dim>
std::vector<ScheduledRecord<dim>> make_records(const Case<dim> &input, const std::string &folder);

/// Whether a run of the case that goes on from an archive keeps the row of the archive's time with
/// which a table ends: a row that stands there only because the part of the run before ended there
/// is not one of the whole run. `table`: its file in the output folder.
template <int dim>
std::function<bool(const std::string &table)> keeps_last_row(const Case<dim> &input,
                                                             const ArchiveReader &archive);

/// The names of the quantities that these records add.
template <int dim>
void name_quantities_of_records(const Case<dim> &input, QuantityNames &names);
} // namespace Continua

#endif
