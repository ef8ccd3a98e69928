#include <continua/mesh/regions_of_boundary.h>

#include <set>

namespace Continua
{
template <int dim>
std::vector<unsigned int> regions_of_boundary(const dealii::Triangulation<dim> &triangulation,
                                              const dealii::types::boundary_id boundary)
{
  std::set<unsigned int> regions;
  for (const auto &cell : triangulation.cell_iterators_on_level(0))
    for (const unsigned int f : cell->face_indices())
      if (cell->at_boundary(f) && cell->face(f)->boundary_id() == boundary)
        regions.insert(cell->material_id());
  return {regions.begin(), regions.end()};
}

template std::vector<unsigned int> regions_of_boundary(const dealii::Triangulation<2> &,
                                                       dealii::types::boundary_id);
template std::vector<unsigned int> regions_of_boundary(const dealii::Triangulation<3> &,
                                                       dealii::types::boundary_id);
} // namespace Continua
