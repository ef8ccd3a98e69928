#ifndef continua_laboratory_inflation_test_h
#define continua_laboratory_inflation_test_h

#include <continua/inference/data_record.h>

#include <string>
#include <vector>

namespace Continua
{
/// A row of an inflation-extension test.
struct InflationRow
{
  double axial_stretch = 1.; ///< length over that of the ring without load [1]
  double pressure = 0.;      ///< inside [Pa]
  double diameter = 0.;      ///< measured [m]
  double axial_force = 0.;   ///< measured by a transducer at the closed end: N - pi a^2 p [N]
};

/// A tube that is held at axial stretches and inflated.
struct InflationTest
{
  std::vector<InflationRow> rows;
  bool is_outer = true;   ///< whether the diameter is that of the outer surface
  bool has_force = false; ///< whether the axial force was measured
  std::string file;

  /// Diameters, then the forces if there are any, rows independent of each other. Standard
  /// deviations [m] and [N] of their noise; NaN: unknown.
  std::vector<DataRecord> data_records(double diameter_noise, double force_noise) const;
};

/**
 * Reads a csv file (CsvTable) with the columns axial stretch, pressure, outer diameter or inner
 * diameter, and axial force, which may be missing. Throws InputError, also for stretches and
 * diameters that are not positive and for pressures below 0.
 */
InflationTest read_inflation_test(const std::string &file);
} // namespace Continua

#endif
