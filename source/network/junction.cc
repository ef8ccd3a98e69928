#include <continua/network/junction.h>

#include <cmath>
#include <stdexcept>

namespace Continua
{
Junction::Junction(const std::vector<std::pair<Vessel *, Vessel::End>> &ends)
    : areas(ends.size()), values(ends.size())
{
  for (const auto &[vessel, end] : ends)
    waves.emplace_back(*vessel, end);
}

void Junction::solve()
{
  constexpr unsigned int most_iterations = 50;
  constexpr double tolerance =
      1e-9; // of the areas; the error after the last correction is its square
  for (std::size_t k = 0; k < waves.size(); ++k)
  {
    waves[k].begin();
    areas[k] = waves[k].inside().area;
  }
  for (unsigned int i = 0; i < most_iterations; ++i)
  {
    // The head for which the linear equations of all ends lose no liquid.
    double inflow = 0., of_head = 0.;
    for (std::size_t k = 0; k < waves.size(); ++k)
    {
      values[k] = waves[k].at_area(areas[k]);
      const double slope = values[k].inflow_slope / values[k].head_slope;
      inflow += values[k].inflow - slope * values[k].head;
      of_head += slope;
    }
    const double head = -inflow / of_head;
    double largest = 0.;
    for (std::size_t k = 0; k < waves.size(); ++k)
    {
      double change = (head - values[k].head) / values[k].head_slope;
      if (std::abs(change) > 0.5 * areas[k])
        change = std::copysign(0.5 * areas[k], change);
      areas[k] += change;
      largest = std::fmax(largest, std::abs(change) / areas[k]);
      if (!std::isfinite(change))
        fail();
    }
    if (largest < tolerance)
    {
      for (std::size_t k = 0; k < waves.size(); ++k)
        waves[k].take(areas[k]);
      return;
    }
  }
  fail();
}

void Junction::fail() const
{
  throw std::domain_error("junction of the vessel '" + waves.front().of().name() +
                          "': no state was found that all its ends have in common");
}
} // namespace Continua
