#include <continua/theory/kept_waves.h>

#include <algorithm>

namespace Continua
{
namespace
{
/// A tube with a taper has as many sections as it computes, for each of some sets of parameters.
constexpr std::size_t most_rows = 120;
} // namespace

std::shared_ptr<const DispersionCurves>
KeptWaves::waves(const TubeSection &section, const double shift, const double highest_frequency)
{
  {
    const std::lock_guard<std::mutex> lock(mutex);
    const auto found = std::find_if(rows.begin(), rows.end(),
                                    [&](const Row &row)
                                    {
                                      return row.shift == shift &&
                                             row.highest_frequency >= highest_frequency &&
                                             row.section == section;
                                    });
    if (found != rows.end())
    {
      rows.splice(rows.begin(), rows, found);
      return rows.front().curves;
    }
  }
  // Others may look for theirs meanwhile.
  auto curves = std::make_shared<const DispersionCurves>(section, shift, highest_frequency);
  const std::lock_guard<std::mutex> lock(mutex);
  ++computed;
  rows.push_front({section, shift, highest_frequency, curves});
  if (rows.size() > most_rows)
    rows.pop_back();
  return curves;
}

unsigned int KeptWaves::n_computed() const
{
  const std::lock_guard<std::mutex> lock(mutex);
  return computed;
}
} // namespace Continua
