#include <continua/finite_element/space/kept_mapping.h>

#include <deal.II/base/exceptions.h>

#include <utility>

namespace Continua
{
using namespace dealii;

template <int dim>
KeptMapping<dim>::KeptMapping(const unsigned int degree, const Triangulation<dim> &triangulation)
    : Base(degree), triangulation(&triangulation), kept(std::make_shared<Kept>())
{
  kept->change_of_mesh =
      triangulation.signals.any_change.connect([points = &kept->points]() { points->clear(); });
}

template <int dim>
void KeptMapping<dim>::keep_points()
{
  std::vector<std::vector<std::vector<Point<dim>>>> points(triangulation->n_levels());
  for (unsigned int level = 0; level < points.size(); ++level)
    points[level].resize(triangulation->n_raw_cells(level));
  for (const auto &cell : triangulation->active_cell_iterators())
    if (!cell->is_artificial())
    {
#if DEAL_II_VERSION_GTE(9, 8, 0)
      Points of_cell;
      Base::compute_mapping_support_points(cell, of_cell);
      points[cell->level()][cell->index()].assign(of_cell.begin(), of_cell.end());
#else
      points[cell->level()][cell->index()] = Base::compute_mapping_support_points(cell);
#endif
    }
  kept->points = std::move(points);
}

template <int dim>
std::unique_ptr<Mapping<dim>> KeptMapping<dim>::clone() const
{
  return std::make_unique<KeptMapping>(*this);
}

template <int dim>
const std::vector<Point<dim>> *
KeptMapping<dim>::kept_points(const typename Triangulation<dim>::cell_iterator &cell) const
{
  Assert(&cell->get_triangulation() == triangulation, ExcInternalError());
  const unsigned int level = cell->level(), index = cell->index();
  return level < kept->points.size() && !kept->points[level][index].empty()
             ? &kept->points[level][index]
             : nullptr;
}

#if DEAL_II_VERSION_GTE(9, 8, 0)
template <int dim>
void KeptMapping<dim>::compute_mapping_support_points(
    const typename Triangulation<dim>::cell_iterator &cell, Points &points) const
{
  if (const std::vector<Point<dim>> *of_cell = kept_points(cell))
    points.assign(of_cell->begin(), of_cell->end());
  else
    Base::compute_mapping_support_points(cell, points);
}
#else
template <int dim>
std::vector<Point<dim>> KeptMapping<dim>::compute_mapping_support_points(
    const typename Triangulation<dim>::cell_iterator &cell) const
{
  if (const std::vector<Point<dim>> *of_cell = kept_points(cell))
    return *of_cell;
  return Base::compute_mapping_support_points(cell);
}
#endif

template class KeptMapping<2>;
template class KeptMapping<3>;
} // namespace Continua
