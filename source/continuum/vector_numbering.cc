#include <continua/base/input_error.h>
#include <continua/continuum/vector_numbering.h>
#include <continua/mesh/tree_places.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <limits>
#include <numeric>

namespace Continua
{
using namespace dealii;

VectorNumbering::VectorNumbering(const MPI_Comm communicator,
                                 const std::string &name,
                                 const std::vector<unsigned long> &numbers)
    : name(name),
      n_entries(numbers.size()),
      extents(2 * Utilities::MPI::n_mpi_processes(communicator))
{
  if (!std::is_sorted(numbers.begin(), numbers.end()))
  {
    order.resize(numbers.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(),
              [&numbers](const unsigned int a, const unsigned int b)
              { return numbers[a] < numbers[b]; });
  }
  for (std::size_t i = 0; i < n_entries; ++i)
  {
    const unsigned long number = numbers[order.empty() ? i : order[i]];
    Assert(intervals.empty() || number >= intervals.back().second,
           ExcMessage("Two entries have the same number."));
    if (intervals.empty() || number != intervals.back().second)
      intervals.emplace_back(number, number);
    ++intervals.back().second;
  }
  unsigned long own[2] = {0, 0};
  if (!intervals.empty())
  {
    own[0] = intervals.front().first;
    own[1] = intervals.back().second;
  }
  const int error =
      MPI_Allgather(own, 2, MPI_UNSIGNED_LONG, extents.data(), 2, MPI_UNSIGNED_LONG, communicator);
  AssertThrowMPI(error);
}

void VectorNumbering::save(ArchiveWriter &archive) const
{
  archive.add("numbers of each piece: " + name, extents);
  std::vector<unsigned long> ends;
  for (const Interval &interval : intervals)
    ends.insert(ends.end(), {interval.first, interval.second});
  archive.piece().add("numbers: " + name, ends);
}

void VectorNumbering::save(ArchiveWriter &archive,
                           const std::string &name_of_vector,
                           const DistributedVector &vector) const
{
  AssertDimension(static_cast<std::size_t>(vector.end() - vector.begin()), n_entries);
  std::vector<double> values(vector.begin(), vector.end());
  for (std::size_t i = 0; i < order.size(); ++i)
    values[i] = vector.begin()[order[i]];
  archive.piece().add(name_of_vector, values);
}

void VectorNumbering::load(const ArchiveReader &archive,
                           const std::string &name_of_vector,
                           DistributedVector &vector) const
{
  AssertDimension(static_cast<std::size_t>(vector.end() - vector.begin()), n_entries);
  std::size_t n_found = 0;
  const std::vector<unsigned long> of_pieces = archive.integers("numbers of each piece: " + name);
  for (std::size_t p = 0; p < archive.n_pieces() && !intervals.empty(); ++p)
  {
    if (of_pieces.at(2 * p) >= intervals.back().second ||
        of_pieces.at(2 * p + 1) <= intervals.front().first)
      continue;
    const ArchiveReader &piece = archive.piece(p);
    const std::vector<unsigned long> ends = piece.integers("numbers: " + name);
    const std::vector<double> values = piece.values(name_of_vector);
    // Both lists of intervals are sorted; the first entry of the present one in each:
    std::size_t own = 0, own_first = 0, other = 0, other_first = 0;
    while (own < intervals.size() && 2 * other < ends.size())
    {
      const Interval &mine = intervals[own];
      const Interval theirs = {ends[2 * other], ends[2 * other + 1]};
      const unsigned long begin = std::max(mine.first, theirs.first);
      const unsigned long end = std::min(mine.second, theirs.second);
      for (unsigned long number = begin; number < end; ++number)
      {
        const std::size_t i = own_first + (number - mine.first);
        vector.begin()[order.empty() ? i : order[i]] =
            values.at(other_first + (number - theirs.first));
        ++n_found;
      }
      if (mine.second <= theirs.second)
      {
        own_first += mine.second - mine.first;
        ++own;
      }
      else
      {
        other_first += theirs.second - theirs.first;
        ++other;
      }
    }
  }
  if (n_found != n_entries)
    throw RunError("the checkpoint's field '" + name_of_vector + "' has " +
                   std::to_string(n_found) + " of the " + std::to_string(n_entries) +
                   " values of this rank: it belongs to another mesh");
}

template <int dim>
std::vector<unsigned long> numbers_of_dofs(const DoFHandler<dim> &dof_handler)
{
  const IndexSet &owned = dof_handler.locally_owned_dofs();
  std::vector<unsigned long> numbers;
  numbers.reserve(owned.n_elements());
  const auto &triangulation =
      dynamic_cast<const parallel::TriangulationBase<dim> &>(dof_handler.get_triangulation());
  const std::vector<unsigned long> places = tree_places(triangulation);
  if (places.empty())
  {
    for (const auto index : owned)
      numbers.push_back(index);
    return numbers;
  }

  // All cells that have one of this rank's dofs are its own or their neighbours.
  numbers.assign(owned.n_elements(), std::numeric_limits<unsigned long>::max());
  const unsigned long n_per_cell = dof_handler.get_fe_collection().max_dofs_per_cell();
  std::vector<types::global_dof_index> indices;
  for (const auto &cell : dof_handler.active_cell_iterators())
    if (!cell->is_artificial())
    {
      indices.resize(cell->get_fe().n_dofs_per_cell());
      cell->get_dof_indices(indices);
      for (std::size_t i = 0; i < indices.size(); ++i)
        if (owned.is_element(indices[i]))
        {
          unsigned long &number = numbers[owned.index_within_set(indices[i])];
          number = std::min(number, places[cell->active_cell_index()] * n_per_cell + i);
        }
    }
  return numbers;
}

template std::vector<unsigned long> numbers_of_dofs(const DoFHandler<2> &);
template std::vector<unsigned long> numbers_of_dofs(const DoFHandler<3> &);
} // namespace Continua
