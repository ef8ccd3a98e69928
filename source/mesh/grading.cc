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

std::vector<double> symmetrically_graded_points(const double begin,
                                                const double end,
                                                const unsigned int n_cells,
                                                const double ratio)
{
  Assert(n_cells > 0 && ratio > 0., dealii::ExcInternalError());
  const unsigned int n_to_middle = (n_cells - 1) / 2;
  std::vector<double> sizes(n_cells, 1.);
  if (n_to_middle > 0)
    for (unsigned int i = 0; i < n_cells; ++i)
      sizes[i] =
          std::pow(ratio, 1. - static_cast<double>(std::min(i, n_cells - 1 - i)) / n_to_middle);
  std::vector<double> points = {begin};
  append_cells(points, end, sizes);
  return points;
}
} // namespace Continua
