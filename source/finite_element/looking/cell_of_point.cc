#include <continua/finite_element/looking/cell_of_point.h>

#include <continua/base/collective.h>
#include <continua/finite_element/motion/present_cell_point.h>
#include <continua/mesh/cell_point.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/mpi.templates.h>
#include <deal.II/grid/cell_id.h>

#include <string>

namespace Continua
{
using namespace dealii;

template <int dim>
CellOfPoint<dim> find_cell_of_point(const Space<dim> &space,
                                    const ProbeRequest<dim> &request,
                                    const DistributedVector &displacement,
                                    const std::function<bool(unsigned int region)> &counts)
{
  CellOfPoint<dim> result;
  CellId chosen_id;
  bool found = false;
  for (const auto &cell : space.velocity_dofs.active_cell_iterators())
    if (cell->is_locally_owned() && counts(cell->material_id()))
    {
      Point<dim> candidate;
      if ((request.is_fixed_in_space
               ? cell_holds_present_point(space, cell, displacement, request.point, candidate)
               : cell_holds_point<dim>(space.mapping, cell, request.point, candidate)) &&
          (!found || cell->id() < chosen_id))
      {
        found = true;
        result.cell = cell;
        chosen_id = cell->id();
        result.unit_point = candidate;
      }
    }
  std::string first;
  for (const std::string &of_rank :
       all_gather(space.communicator, found ? chosen_id.to_string() : std::string()))
    if (!of_rank.empty() && (first.empty() || CellId(of_rank) < CellId(first)))
      first = of_rank;
  result.is_here = found && CellId(first) == chosen_id;
  result.is_anywhere = !first.empty();
  return result;
}

template CellOfPoint<2> find_cell_of_point(const Space<2> &,
                                           const ProbeRequest<2> &,
                                           const DistributedVector &,
                                           const std::function<bool(unsigned int)> &);
template CellOfPoint<3> find_cell_of_point(const Space<3> &,
                                           const ProbeRequest<3> &,
                                           const DistributedVector &,
                                           const std::function<bool(unsigned int)> &);
} // namespace Continua
