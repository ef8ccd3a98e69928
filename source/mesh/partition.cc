#include <continua/base/kept_signal_action.h>
#include <continua/mesh/partition.h>

#include <deal.II/base/config.h>
#include <deal.II/base/mpi.h>
#include <deal.II/distributed/shared_tria.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace Continua
{
using namespace dealii;

namespace
{
/// The lighter kind of cell has this weight, so that ratios are kept to a tenth. METIS sums the
/// weights in 32 bits: at the largest ratio they are enough for 2e7 cells.
constexpr double unit_weight = 10.;
constexpr double largest_ratio = 10.;

template <int dim>
unsigned int weight_of(const Triangulation<dim> &triangulation,
                       const typename Triangulation<dim>::cell_iterator &cell)
{
  return triangulation.signals.weight.empty()
             ? 1
             : triangulation.signals.weight(cell, Triangulation<dim>::CELL_PERSIST);
}

/// Active cells of one part, by their numbers.
using CellsOfPart = std::vector<unsigned int>;

/// The cells of a part that are reached from `start` over faces, the nearest first; behind them
/// those that are not reached.
CellsOfPart by_distance(const CellsOfPart &part,
                        const unsigned int start,
                        const DynamicSparsityPattern &neighbours,
                        std::vector<bool> &is_left)
{
  for (const unsigned int cell : part)
    is_left[cell] = true;
  CellsOfPart reached = {start};
  is_left[start] = false;
  for (std::size_t i = 0; i < reached.size(); ++i)
    for (auto entry = neighbours.begin(reached[i]); entry != neighbours.end(reached[i]); ++entry)
      if (is_left[entry->column()])
      {
        is_left[entry->column()] = false;
        reached.push_back(entry->column());
      }
  for (const unsigned int cell : part)
    if (is_left[cell])
    {
      is_left[cell] = false;
      reached.push_back(cell);
    }
  return reached;
}

/// Takes one end of the part away, with about half of its weight.
CellsOfPart cut_in_two(CellsOfPart &part,
                       const std::vector<double> &weights,
                       const DynamicSparsityPattern &neighbours,
                       std::vector<bool> &is_left)
{
  const CellsOfPart from_inside = by_distance(part, part.front(), neighbours, is_left);
  const CellsOfPart from_an_end = by_distance(part, from_inside.back(), neighbours, is_left);
  const double all = std::accumulate(part.begin(), part.end(), 0.,
                                     [&weights](const double sum, const unsigned int cell)
                                     { return sum + weights[cell]; });
  double taken = weights[from_an_end.front()];
  std::size_t n_taken = 1;
  while (n_taken + 1 < part.size() && taken + 0.5 * weights[from_an_end[n_taken]] < 0.5 * all)
    taken += weights[from_an_end[n_taken++]];
  part.assign(from_an_end.begin() + n_taken, from_an_end.end());
  return {from_an_end.begin(), from_an_end.begin() + n_taken};
}
} // namespace

template <int dim>
void divide_by_metis(Triangulation<dim> &triangulation, const unsigned int n_parts)
{
  const unsigned int n_cells = triangulation.n_active_cells();
  // METIS has no rule for more parts than cells.
  if (n_parts >= n_cells)
  {
    for (const auto &cell : triangulation.active_cell_iterators())
      cell->set_subdomain_id(cell->active_cell_index());
    return;
  }
  // By name: deal.II's own choice would be Zoltan.
  const KeptSignalAction kept;
  GridTools::partition_triangulation(n_parts, triangulation, SparsityTools::Partitioner::metis);
  if (n_parts == 1)
    return;

  std::vector<CellsOfPart> parts(n_parts);
  std::vector<double> weights(n_cells), work(n_parts, 0.);
  for (const auto &cell : triangulation.active_cell_iterators())
  {
    const unsigned int number = cell->active_cell_index();
    weights[number] = weight_of<dim>(triangulation, cell);
    parts[cell->subdomain_id()].push_back(number);
    work[cell->subdomain_id()] += weights[number];
  }
  if (std::none_of(parts.begin(), parts.end(),
                   [](const CellsOfPart &part) { return part.empty(); }))
    return;
  // METIS's method for more than eight parts leaves parts empty where there are few cells a part,
  // and reports success.
  DynamicSparsityPattern neighbours;
  GridTools::get_face_connectivity_of_cells(triangulation, neighbours);
  std::vector<bool> is_left(n_cells, false);
  for (unsigned int empty = 0; empty < n_parts; ++empty)
  {
    if (!parts[empty].empty())
      continue;
    unsigned int heaviest = n_parts;
    for (unsigned int part = 0; part < n_parts; ++part)
      if (parts[part].size() > 1 && (heaviest == n_parts || work[part] > work[heaviest]))
        heaviest = part;
    parts[empty] = cut_in_two(parts[heaviest], weights, neighbours, is_left);
    for (const unsigned int cell : parts[empty])
      work[empty] += weights[cell];
    work[heaviest] -= work[empty];
  }
  std::vector<unsigned int> part_of_cell(n_cells);
  for (unsigned int part = 0; part < n_parts; ++part)
    for (const unsigned int cell : parts[part])
      part_of_cell[cell] = part;
  for (const auto &cell : triangulation.active_cell_iterators())
    cell->set_subdomain_id(part_of_cell[cell->active_cell_index()]);
}

const Words<Partitioner> &partitioner_words()
{
  static const Words<Partitioner> words = {{"p4est", Partitioner::p4est},
                                           {"metis", Partitioner::metis}};
  return words;
}

void PartitionParameters::read(ParameterSection mesh)
{
  add_choice(
      mesh, "Partitioner", partitioner, partitioner_words(),
      "What divides the mesh among the ranks: p4est - every rank keeps its own part only, needed "
      "where the mesh adapts and from some ten million cells or hundreds of ranks on; metis - "
      "every "
      "rank keeps the whole mesh, with fewer and shorter cuts through meshes of many coarse cells, "
      "such as those of gmsh. The results are the same");
  mesh.add("Solid weight", solid_weight, Dimensions::none,
           "How much more work for its rank a cell of a solid makes than one of a fluid; the mesh "
           "is divided into parts of equal work [1]",
           Range{1. / largest_ratio, largest_ratio, false, false});
#ifndef DEAL_II_WITH_METIS
  if (is_metis())
    mesh.refuse("Partitioner", "this deal.II was built without METIS",
                "Set Partitioner = p4est, or link with a deal.II that has DEAL_II_WITH_METIS = ON");
#endif
}

template <int dim>
std::unique_ptr<parallel::TriangulationBase<dim>> make_triangulation(
    const MPI_Comm communicator, const PartitionParameters &parameters, std::vector<bool> is_solid)
{
  std::unique_ptr<parallel::TriangulationBase<dim>> triangulation;
  const auto smoothing = Triangulation<dim>::limit_level_difference_at_vertices;
  if (parameters.is_metis())
  {
    // With artificial cells ranks exchange values with their neighbours alone.
    triangulation = std::make_unique<parallel::shared::Triangulation<dim>>(
        communicator, smoothing, true,
        parallel::shared::Triangulation<dim>::partition_custom_signal);
    const auto divide =
        [mesh = triangulation.get(), n_ranks = Utilities::MPI::n_mpi_processes(communicator)]()
    { divide_by_metis<dim>(*mesh, n_ranks); };
    triangulation->signals.create.connect(divide);
    triangulation->signals.post_refinement.connect(divide);
  }
  else
    triangulation =
        std::make_unique<parallel::distributed::Triangulation<dim>>(communicator, smoothing);

  const double ratio = parameters.solid_weight;
  if (ratio != 1.)
  {
    const double lighter = std::min(ratio, 1.);
    const auto solid = static_cast<unsigned int>(std::lround(unit_weight * ratio / lighter));
    const auto fluid = static_cast<unsigned int>(std::lround(unit_weight / lighter));
    triangulation->signals.weight.connect(
        [solid, fluid,
         is_solid = std::move(is_solid)](const typename Triangulation<dim>::cell_iterator &cell,
                                         const typename Triangulation<dim>::CellStatus)
        { return is_solid.at(cell->material_id()) ? solid : fluid; });
  }
  return triangulation;
}

template <int dim>
void refine(parallel::TriangulationBase<dim> &triangulation, const unsigned int n_refinements)
{
  triangulation.refine_global(n_refinements);
  if (n_refinements > 0 || triangulation.signals.weight.empty())
    return;
  // p4est does not ask for weights when it divides the coarse mesh, and METIS before it is painted.
  if (auto *const mesh = dynamic_cast<parallel::distributed::Triangulation<dim> *>(&triangulation))
    mesh->repartition();
  else
    triangulation.execute_coarsening_and_refinement();
}

template <int dim>
PartitionQuality measure_partition(const parallel::TriangulationBase<dim> &triangulation)
{
  double work = 0.;
  unsigned int n_faces = 0, n_cells = 0;
  for (const auto &cell : triangulation.active_cell_iterators())
    if (cell->is_locally_owned())
    {
      work += weight_of<dim>(triangulation, cell);
      ++n_cells;
      for (const unsigned int f : cell->face_indices())
        // Of two ranks the one with the smaller number counts; a face with finer cells beyond is
        // one of theirs.
        if (!cell->at_boundary(f) && !cell->neighbor(f)->has_children() &&
            cell->neighbor(f)->is_ghost() &&
            (cell->neighbor_is_coarser(f) ||
             cell->subdomain_id() < cell->neighbor(f)->subdomain_id()))
          ++n_faces;
    }
  const MPI_Comm communicator = triangulation.get_communicator();
  const Utilities::MPI::MinMaxAvg works = Utilities::MPI::min_max_avg(work, communicator);
  return {works.max / works.avg, Utilities::MPI::sum(n_faces, communicator),
          Utilities::MPI::sum(n_cells == 0 ? 1U : 0U, communicator)};
}

template std::unique_ptr<parallel::TriangulationBase<2>>
make_triangulation(MPI_Comm, const PartitionParameters &, std::vector<bool>);
template std::unique_ptr<parallel::TriangulationBase<3>>
make_triangulation(MPI_Comm, const PartitionParameters &, std::vector<bool>);
template void divide_by_metis(Triangulation<2> &, unsigned int);
template void divide_by_metis(Triangulation<3> &, unsigned int);
template void refine(parallel::TriangulationBase<2> &, unsigned int);
template void refine(parallel::TriangulationBase<3> &, unsigned int);
template PartitionQuality measure_partition(const parallel::TriangulationBase<2> &);
template PartitionQuality measure_partition(const parallel::TriangulationBase<3> &);
} // namespace Continua
