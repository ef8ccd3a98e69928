#ifndef continua_finite_element_space_solution_transfer_h
#define continua_finite_element_space_solution_transfer_h

#include <deal.II/base/config.h>

#if DEAL_II_VERSION_GTE(9, 7, 0)
#include <deal.II/numerics/solution_transfer.h>
#else
#include <deal.II/distributed/solution_transfer.h>
#endif

namespace Continua
{
/**
 * deal.II's class that carries distributed vectors over a change of the mesh. Its name has been
 * dealii::SolutionTransfer since deal.II 9.7. In older versions this name belongs to a class for
 * meshes that are not distributed.
 */
template <int dim, typename Vector>
#if DEAL_II_VERSION_GTE(9, 7, 0)
using SolutionTransfer = dealii::SolutionTransfer<dim, Vector>;
#else
using SolutionTransfer = dealii::parallel::distributed::SolutionTransfer<dim, Vector>;
#endif
} // namespace Continua

#endif
