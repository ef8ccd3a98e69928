#include <continua/mesh/tree_places.h>

#include <deal.II/distributed/shared_tria.h>

namespace Continua
{
using namespace dealii;

namespace
{
template <int dim>
void number_active_cells(const typename Triangulation<dim>::cell_iterator &cell,
                         unsigned long &next,
                         std::vector<unsigned long> &places)
{
  if (cell->is_active())
    places[cell->active_cell_index()] = next++;
  else
    for (unsigned int child = 0; child < cell->n_children(); ++child)
      number_active_cells<dim>(cell->child(child), next, places);
}
} // namespace

template <int dim>
std::vector<unsigned long> tree_places(const parallel::TriangulationBase<dim> &triangulation)
{
  if (dynamic_cast<const parallel::shared::Triangulation<dim> *>(&triangulation) == nullptr)
    return {};
  std::vector<unsigned long> places(triangulation.n_active_cells());
  unsigned long next = 0;
  for (const auto &cell : triangulation.cell_iterators_on_level(0))
    number_active_cells<dim>(cell, next, places);
  return places;
}

template std::vector<unsigned long> tree_places(const parallel::TriangulationBase<2> &);
template std::vector<unsigned long> tree_places(const parallel::TriangulationBase<3> &);
} // namespace Continua
