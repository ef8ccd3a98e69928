#include <continua/mesh/connected_cells.h>

#include <deal.II/base/types.h>

namespace Continua
{
using namespace dealii;

template <int dim>
std::vector<unsigned int> connected_cells(const Triangulation<dim> &triangulation,
                                          const std::vector<unsigned int> &kind_of_region)
{
  constexpr unsigned int none = numbers::invalid_unsigned_int;
  std::vector<unsigned int> numbers(triangulation.n_cells(0), none);
  unsigned int n_sets = 0;
  std::vector<typename Triangulation<dim>::cell_iterator> cells;
  for (const auto &first : triangulation.cell_iterators_on_level(0))
  {
    if (numbers[first->index()] != none)
      continue;
    numbers[first->index()] = n_sets;
    cells.assign(1, first);
    while (!cells.empty())
    {
      const auto cell = cells.back();
      cells.pop_back();
      for (const unsigned int f : cell->face_indices())
        if (!cell->at_boundary(f))
        {
          const auto neighbour = cell->neighbor(f);
          if (numbers[neighbour->index()] != none ||
              kind_of_region[neighbour->material_id()] != kind_of_region[cell->material_id()])
            continue;
          numbers[neighbour->index()] = n_sets;
          cells.push_back(neighbour);
        }
    }
    ++n_sets;
  }
  return numbers;
}

template std::vector<unsigned int> connected_cells(const Triangulation<2> &,
                                                   const std::vector<unsigned int> &);
template std::vector<unsigned int> connected_cells(const Triangulation<3> &,
                                                   const std::vector<unsigned int> &);
} // namespace Continua
