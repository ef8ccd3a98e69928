#include <continua/analysis/beat_columns.h>

namespace Continua
{
const std::array<BeatColumn, 5> &beat_columns()
{
  static const std::array<BeatColumn, 5> columns = {
      {{"largest", "systolic ", "largest ", &BeatValues::largest},
       {"smallest", "diastolic ", "smallest ", &BeatValues::smallest},
       {"mean", "mean ", "mean ", &BeatValues::mean},
       {"range", "pulse ", "range of ", &BeatValues::range},
       {"difference", "difference of ", "difference of ", &BeatValues::difference}}};
  return columns;
}

std::string beat_quantity_name(const BeatColumn &column, const std::string &field)
{
  const bool is_pressure = field == "pressure" || field == "axis pressure";
  return (is_pressure ? column.of_pressure : column.of_others) + field + " of the last beat";
}
} // namespace Continua
