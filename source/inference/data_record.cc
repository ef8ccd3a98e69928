#include <continua/inference/data_record.h>

#include <continua/inference/whitening.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace Continua
{
void check_data_records(const std::vector<DataRecord> &records, const bool with_values)
{
  if (records.empty())
    throw std::invalid_argument("there is no record of data");
  for (const DataRecord &record : records)
  {
    const auto refuse = [&](const std::string &problem)
    { throw std::invalid_argument("the record '" + record.name + "' " + problem); };
    if (record.times.empty())
      refuse("has no values");
    if (!(record.interval >= 0.) || !std::isfinite(record.interval))
      refuse("has an interval that is negative or no number");
    if (with_values && record.values.size() != record.times.size())
      refuse("has " + std::to_string(record.values.size()) + " values at " +
             std::to_string(record.times.size()) + " times");
    if (with_values && !std::all_of(record.values.begin(), record.values.end(),
                                    [](const double value) { return std::isfinite(value); }))
      refuse("has a value that is not finite");
    NoiseModel noise = record.noise;
    if (with_values && !noise.standard_deviation_is_known())
      noise.standard_deviation = 1.;
    try
    {
      const Whitening whitening(noise, record.interval);
    }
    catch (const std::invalid_argument &error)
    {
      refuse(std::string("cannot be weighted: ") + error.what());
    }
  }
}

std::vector<std::vector<double>> by_record(const std::vector<DataRecord> &records,
                                           const std::vector<double> &values)
{
  std::vector<std::vector<double>> pieces;
  auto begin = values.begin();
  for (const DataRecord &record : records)
  {
    const auto end = begin + static_cast<std::ptrdiff_t>(record.size());
    pieces.emplace_back(begin, end);
    begin = end;
  }
  return pieces;
}
} // namespace Continua
