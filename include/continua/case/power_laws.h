#ifndef continua_case_power_laws_h
#define continua_case_power_laws_h

#include <continua/base/archive.h>
#include <continua/base/log.h>
#include <continua/base/parameter_section.h>
#include <continua/base/summary.h>
#include <continua/continuum/problem.h>
#include <continua/materials/prony_series.h>
#include <continua/materials/relaxation_test.h>
#include <continua/time_integration/time_control.h>

#include <map>
#include <string>

namespace Continua
{
/**
 * The relaxation tests behind the power laws of the regions, and the Prony series that a run in
 * time takes for these laws. Its band is that of the material, or else that of the run: from the
 * frequency whose period is 2 pi times the end time to that whose period is ten of the smallest
 * time steps.
 */
class PowerLaws
{
public:
  /// Remembers what a region's relaxation table, which the material has read, came to.
  void note_table(const std::string &region, const ParameterSection &section);
  /// A line and the quantities "c", "n" and "misfit of the relaxation table" for each table.
  void report_tables(Log &log, Summary &summary) const;
  /// The names of what report_tables() adds.
  void name_quantities(QuantityNames &names) const;

  /// Gives the regions with a power law their branches; not in a run that goes on, whose band may
  /// be another one by its end time: it loads them. `materials`: the section of that name.
  /// Throws InputError.
  void fit(Problem &problem, const TimeParameters &time, ParameterSection materials);
  /// Gives one power law its branches over a band [Hz]; `section` is that of the material. Throws
  /// InputError if the band is empty or the law cannot be met there.
  static PronySeries fit(Material &material,
                         double lowest_frequency,
                         double highest_frequency,
                         const ParameterSection &section);
  /// A line and a quantity "Prony fit error" for each of these regions, and the series.
  void report_series(Log &log, Summary &summary) const;

  void save(ArchiveWriter &archive) const;
  /// Instead of a fit: the series of the run that goes on.
  void load(const ArchiveReader &archive, Problem &problem, const TimeParameters &time);

private:
  std::map<std::string, RelaxationFit> tables; ///< by region
  std::map<std::string, RelaxationTest> tests; ///< the tables' rows, by region
  std::map<std::string, PronySeries> series;   ///< of the shear modulus, by region
  double smallest_step = 0.;                   ///< [s]
};

/// What to warn of where a region's power law misses its relaxation table, or its Prony series the
/// law, by more than `largest_misfit`; else empty.
std::string warning_of_relaxation_table(const std::string &region, double misfit);
std::string warning_of_prony_series(const std::string &region, double error);
/// What to warn of where a Prony series follows a region's relaxation table very clearly better
/// than the power law, by Schwarz's criterion (fit_prony_series_to_bar()); else empty, also where
/// the comparison fails, which must not end a run.
std::string warning_of_better_series(const std::string &region, const RelaxationTest &test);
} // namespace Continua

#endif
