#include <continua/mesh/structured_extent.h>

#include <algorithm>

namespace Continua
{
MeshExtent structured_extent(const std::vector<unsigned int> &cells)
{
  MeshExtent extent;
  for (const unsigned int n : cells)
    extent.n_cells *= n;
  extent.n_layers = *std::max_element(cells.begin(), cells.end());
  return extent;
}

std::vector<unsigned int> coarsened_cells(std::vector<unsigned int> cells, const double most_cells)
{
  while (structured_extent(cells).n_cells > most_cells)
  {
    unsigned int &largest = *std::max_element(cells.begin(), cells.end());
    if (largest == 1)
      break;
    largest = (largest + 1) / 2;
  }
  return cells;
}
} // namespace Continua
