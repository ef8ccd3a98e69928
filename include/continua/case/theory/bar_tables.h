#ifndef continua_case_theory_bar_tables_h
#define continua_case_theory_bar_tables_h

#include <continua/base/csv_table.h>
#include <continua/base/parameter_section.h>
#include <continua/theory/bar_record.h>

#include <optional>
#include <string>
#include <vector>

namespace Continua
{
/// A relaxation test of a bar as a file has it; noise_units are the values.
struct BarRelaxation
{
  BarRecord record;
  std::size_t n_left_out = 0; ///< rows up to the end of the loading

  /**
   * Declares `Relaxation table`, `Cross-section`, `Strain` and `Loading time` in the section and
   * reads the table; nothing if there is none. `remedy`: of a stress that is not positive, whose
   * logarithm does not exist; empty: it is accepted. Throws InputError.
   */
  static std::optional<BarRelaxation> read(ParameterSection &section, const std::string &remedy);
};

/// The column `time` [s]: times since the start of the load; refuses those before it.
std::vector<double> times_of_bar_table(const CsvTable &table);

/// Refuses a value of a row that is not positive, with this remedy; accepts all if it is empty.
void require_positive_value(const CsvTable &table,
                            std::size_t row,
                            std::size_t column,
                            double value,
                            const std::string &remedy);

/// Refuses a record with too few rows for a fit, without load, or of a modulus that no material
/// has. `key`: the entry of the section by which the values of the table were divided.
void check_bar_record(const CsvTable &table,
                      const BarRecord &record,
                      std::size_t n_rows,
                      const ParameterSection &section,
                      const std::string &key);
} // namespace Continua

#endif
