#ifndef continua_mesh_ghost_exchange_h
#define continua_mesh_ghost_exchange_h

#include <deal.II/distributed/tria_base.h>

#include <functional>
#include <vector>

namespace Continua
{
/**
 * Hands numbers of each owned cell to the ranks on which the cell is a ghost: `numbers_of` is
 * called for owned cells that are ghosts elsewhere, `take` for this rank's ghosts. Collective.
 * Whole numbers up to 2^53 pass unchanged. (deal.II's exchange of any type compiles Boost's
 * serialisation into each file that calls it.)
 */
template <int dim>
void exchange_with_ghosts(
    const dealii::parallel::TriangulationBase<dim> &triangulation,
    const std::function<std::vector<double>(
        const typename dealii::Triangulation<dim>::active_cell_iterator &cell)> &numbers_of,
    const std::function<void(const typename dealii::Triangulation<dim>::active_cell_iterator &cell,
                             const std::vector<double> &numbers)> &take);
} // namespace Continua

#endif
