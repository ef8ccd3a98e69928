#ifndef continua_analysis_beat_columns_h
#define continua_analysis_beat_columns_h

#include <continua/signal/beat_values.h>

#include <array>
#include <string>

namespace Continua
{
/// A value of a beat, with its name in the table and in the summary: of a pressure, of another
/// field.
struct BeatColumn
{
  const char *column;
  const char *of_pressure;
  const char *of_others;
  double BeatValues::*member;
};

/// The columns of beats.csv for each field of a probe.
const std::array<BeatColumn, 5> &beat_columns();

/// "systolic pressure of the last beat".
std::string beat_quantity_name(const BeatColumn &column, const std::string &field);
} // namespace Continua

#endif
