#include <continua/mesh/refinement_tree.h>

#include <continua/base/collective.h>
#include <continua/base/input_error.h>

#include <deal.II/base/mpi.h>
#include <deal.II/grid/cell_id.h>

#include <algorithm>
#include <cstring>
#include <utility>
#include <vector>

namespace Continua
{
using namespace dealii;

namespace
{
const std::string name_of_list = "refined cells", name_of_number = "active cells";

constexpr std::size_t number_size = sizeof(unsigned long);

/// The number of the coarse cell, and the way from there: a 1, and `dim` bits for each child.
using Place = std::pair<unsigned long, unsigned long>;

template <int dim>
Place place_of(const typename Triangulation<dim>::cell_iterator &cell)
{
  const CellId id = cell->id();
  unsigned long path = 1;
  for (const std::uint8_t child : id.get_child_indices())
    path = (path << dim) | child;
  return {id.get_coarse_cell_id(), path};
}

/// Those cells with children whose first active descendant is this rank's: each such cell on one
/// rank.
template <int dim>
std::vector<Place> own_refined_cells(const Triangulation<dim> &triangulation)
{
  std::vector<Place> places;
  for (const auto &active : triangulation.active_cell_iterators())
    if (active->is_locally_owned())
      for (typename Triangulation<dim>::cell_iterator cell = active;
           cell->level() > 0 && cell->parent()->child(0) == cell;)
      {
        cell = cell->parent();
        places.push_back(place_of<dim>(cell));
      }
  return places;
}
} // namespace

template <int dim>
void save_refinement(const parallel::TriangulationBase<dim> &triangulation, ArchiveWriter &archive)
{
  std::vector<unsigned long> own;
  for (const auto &[coarse_cell, path] : own_refined_cells<dim>(triangulation))
    own.insert(own.end(), {coarse_cell, path});
  std::vector<Place> all;
  for (const std::string &part : all_gather(
           triangulation.get_communicator(),
           std::string(reinterpret_cast<const char *>(own.data()), own.size() * number_size)))
    for (std::size_t i = 0; i < part.size(); i += 2 * number_size)
    {
      unsigned long place[2];
      std::memcpy(place, part.data() + i, sizeof(place));
      all.emplace_back(place[0], place[1]);
    }
  std::sort(all.begin(), all.end());
  std::vector<unsigned long> numbers;
  for (const auto &[coarse_cell, path] : all)
    numbers.insert(numbers.end(), {coarse_cell, path});
  archive.add(name_of_list, numbers);
  archive.add(name_of_number, static_cast<unsigned long>(triangulation.n_global_active_cells()));
}

bool has_refinement(const ArchiveReader &archive)
{
  return archive.has(name_of_list);
}

template <int dim>
void load_refinement(const ArchiveReader &archive, parallel::TriangulationBase<dim> &triangulation)
{
  const std::vector<unsigned long> numbers = archive.integers(name_of_list);
  std::vector<Place> refined;
  for (std::size_t i = 0; i + 1 < numbers.size(); i += 2)
    refined.emplace_back(numbers[i], numbers[i + 1]);
  if (!std::is_sorted(refined.begin(), refined.end()))
    throw RunError("the list of its refined cells is not in order");
  for (bool changes = true; changes;)
  {
    unsigned int n_flags = 0;
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned() &&
          std::binary_search(refined.begin(), refined.end(), place_of<dim>(cell)))
      {
        cell->set_refine_flag();
        ++n_flags;
      }
    changes = Utilities::MPI::max(n_flags, triangulation.get_communicator()) > 0;
    if (changes)
      triangulation.execute_coarsening_and_refinement();
  }
  const unsigned long n_cells = triangulation.n_global_active_cells();
  if (n_cells != archive.integer(name_of_number))
    throw RunError("its refined cells give " + std::to_string(n_cells) + " cells instead of " +
                   std::to_string(archive.integer(name_of_number)));
}

template void save_refinement(const parallel::TriangulationBase<2> &, ArchiveWriter &);
template void save_refinement(const parallel::TriangulationBase<3> &, ArchiveWriter &);
template void load_refinement(const ArchiveReader &, parallel::TriangulationBase<2> &);
template void load_refinement(const ArchiveReader &, parallel::TriangulationBase<3> &);
} // namespace Continua
