#include <continua/mesh/grading.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace Continua
{
namespace
{
void append_cells(std::vector<double> &points, const double end, const std::vector<double> &sizes)
{
  const double begin = points.back();
  const double sum = std::accumulate(sizes.begin(), sizes.end(), 0.);
  double partial_sum = 0.;
  for (std::size_t i = 0; i + 1 < sizes.size(); ++i)
  {
    partial_sum += sizes[i];
    points.push_back(begin + (end - begin) * (partial_sum / sum));
  }
  points.push_back(end);
}
} // namespace

void append_graded_cells(std::vector<double> &points,
                         const double end,
                         const unsigned int n_cells,
                         const double ratio)
{
  Assert(!points.empty() && n_cells > 0 && ratio > 0., dealii::ExcInternalError());
  std::vector<double> sizes(n_cells, 1.);
  for (unsigned int i = 1; i < n_cells; ++i)
    sizes[i] = std::pow(ratio, static_cast<double>(i) / (n_cells - 1));
  append_cells(points, end, sizes);
}

std::vector<double> points_with_end_zones(const double begin,
                                          const double end,
                                          const unsigned int n_cells,
                                          const std::array<double, 2> &end_cells,
                                          const double growth)
{
  Assert(n_cells > 0 && end_cells[0] > 0. && end_cells[1] > 0. && growth > 1.,
         dealii::ExcInternalError());
  std::vector<double> grown(n_cells), sizes(n_cells);
  for (unsigned int i = 0; i < n_cells; ++i)
    grown[i] = std::min(end_cells[0] * std::pow(growth, static_cast<double>(i)),
                        end_cells[1] * std::pow(growth, static_cast<double>(n_cells - 1 - i)));
  // The length of the equal cells with which all cells fill the interval.
  const auto fill = [&](const double equal)
  {
    for (unsigned int i = 0; i < n_cells; ++i)
      sizes[i] = std::min(equal, grown[i]);
    return std::accumulate(sizes.begin(), sizes.end(), 0.);
  };
  double shortest = (end - begin) / n_cells, longest = end - begin;
  while (longest > shortest * (1. + 1e-14))
  {
    const double middle = 0.5 * (shortest + longest);
    if (middle == shortest || middle == longest)
      break;
    (fill(middle) < end - begin ? shortest : longest) = middle;
  }
  fill(longest);
  std::vector<double> points = {begin};
  append_cells(points, end, sizes);
  return points;
}

double
ratio_for_last_cell(const unsigned int n_cells, const double last, const double largest_growth)
{
  Assert(n_cells > 0 && last > 0. && largest_growth > 1., dealii::ExcInternalError());
  if (last * n_cells >= 1.)
    return 1.;
  const auto last_cell = [n_cells](const double ratio)
  {
    std::vector<double> points = {0.};
    append_graded_cells(points, 1., n_cells, ratio);
    return 1. - points[n_cells - 1];
  };
  double smallest = std::max(grading_range.lower, std::pow(largest_growth, 1. - n_cells));
  double largest = 1.;
  if (last_cell(smallest) >= last)
    return smallest;
  while (largest > smallest * (1. + 1e-14))
  {
    const double middle = std::sqrt(smallest * largest);
    if (middle <= smallest || middle >= largest)
      break;
    (last_cell(middle) < last ? smallest : largest) = middle;
  }
  return largest;
}
} // namespace Continua
