#include <continua/finite_element/space/place_of_entry.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <limits>
#include <sstream>

namespace Continua
{
using namespace dealii;

template <int dim>
std::string place_of_largest_entry(const Space<dim> &space,
                                   const DoFHandler<dim> &dofs,
                                   const DistributedVector &entries,
                                   const std::vector<std::string> &regions)
{
  double largest = -1.;
  unsigned int place = 0;
  for (unsigned int i = 0; i < entries.locally_owned_size(); ++i)
  {
    const double size = std::isfinite(entries.begin()[i]) ? std::abs(entries.begin()[i])
                                                          : std::numeric_limits<double>::infinity();
    if (size > largest)
    {
      largest = size;
      place = i;
    }
  }
  const auto over_ranks = Utilities::MPI::min_max_avg(largest, space.communicator);
  std::string text;
  if (over_ranks.max_index == Utilities::MPI::this_mpi_process(space.communicator))
  {
    const types::global_dof_index wanted = entries.locally_owned_elements().nth_index_in_set(place);
    std::vector<types::global_dof_index> indices;
    for (const auto &cell : dofs.active_cell_iterators())
    {
      if (!cell->is_locally_owned() || !text.empty())
        continue;
      indices.resize(cell->get_fe().n_dofs_per_cell());
      cell->get_dof_indices(indices);
      for (unsigned int i = 0; i < indices.size() && text.empty(); ++i)
        if (indices[i] == wanted)
        {
          const Point<dim> point =
              space.mapping.transform_unit_to_real_cell(cell, cell->get_fe().unit_support_point(i));
          std::ostringstream words;
          words.precision(4);
          words << "in the region '" << regions[cell->material_id()] << "' near (";
          for (unsigned int c = 0; c < dim; ++c)
            words << (c == 0 ? "" : ", ") << point[c];
          words << ") m";
          text = words.str();
        }
    }
  }
  return Utilities::MPI::broadcast(space.communicator, text, over_ranks.max_index);
}

template std::string place_of_largest_entry(const Space<2> &,
                                            const DoFHandler<2> &,
                                            const DistributedVector &,
                                            const std::vector<std::string> &);
template std::string place_of_largest_entry(const Space<3> &,
                                            const DoFHandler<3> &,
                                            const DistributedVector &,
                                            const std::vector<std::string> &);
} // namespace Continua
