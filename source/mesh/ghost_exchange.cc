#include <continua/mesh/ghost_exchange.h>

#include <deal.II/grid/grid_tools.h>

#include <optional>

namespace Continua
{
using namespace dealii;

template <int dim>
void exchange_with_ghosts(
    const parallel::TriangulationBase<dim> &triangulation,
    const std::function<std::vector<double>(
        const typename Triangulation<dim>::active_cell_iterator &cell)> &numbers_of,
    const std::function<void(const typename Triangulation<dim>::active_cell_iterator &cell,
                             const std::vector<double> &numbers)> &take)
{
  using Numbers = std::vector<double>;
  GridTools::exchange_cell_data_to_ghosts<Numbers, Triangulation<dim>>(
      triangulation, [&](const auto &cell) { return std::optional<Numbers>(numbers_of(cell)); },
      [&](const auto &cell, const Numbers &numbers) { take(cell, numbers); });
}

template void exchange_with_ghosts(
    const parallel::TriangulationBase<2> &,
    const std::function<std::vector<double>(const Triangulation<2>::active_cell_iterator &)> &,
    const std::function<void(const Triangulation<2>::active_cell_iterator &,
                             const std::vector<double> &)> &);
template void exchange_with_ghosts(
    const parallel::TriangulationBase<3> &,
    const std::function<std::vector<double>(const Triangulation<3>::active_cell_iterator &)> &,
    const std::function<void(const Triangulation<3>::active_cell_iterator &,
                             const std::vector<double> &)> &);
} // namespace Continua
