// The numbers by which vectors are saved are those of a mesh on one rank: of elements of degree 2
// with a pressure that is broken between regions, and of values in cells and on faces; with hanging
// nodes, cut by p4est and by METIS. What several ranks save one rank reads, and the other way
// round.

#include <continua/continuum/vector_numbering.h>
#include <continua/finite_element/space/space.h>
#include <continua/finite_volume/cell_wise_space.h>

#include <deal.II/distributed/shared_tria.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/grid/grid_generator.h>

#include "../unit_test.h"

#include <array>
#include <functional>
#include <map>

namespace test_of_vector_numbering
{
using namespace Continua;
using namespace dealii;

namespace
{
/// Where an entry belongs: coordinates in units of half the finest cell, and which of those there.
using Place = std::array<long, 4>;
using Places = std::map<unsigned long, Place>;

template <int dim>
Place place(const Point<dim> &point, const long which)
{
  Place result = {{0, 0, 0, which}};
  for (unsigned int c = 0; c < dim; ++c)
    result[c] = std::lround(16. * point[c]);
  return result;
}

/// Two regions; cells along a line across their interface are divided once more.
template <int dim>
void make_mesh(parallel::TriangulationBase<dim> &mesh)
{
  std::vector<unsigned int> cells(dim, 2);
  cells[0] = 3;
  Point<dim> end;
  for (unsigned int c = 0; c < dim; ++c)
    end[c] = cells[c];
  GridGenerator::subdivided_hyper_rectangle(mesh, cells, Point<dim>(), end);
  for (const auto &cell : mesh.active_cell_iterators())
    cell->set_material_id(cell->center()[0] > 1. ? 1 : 0);
  mesh.refine_global(1);
  for (const auto &cell : mesh.active_cell_iterators())
    if (std::abs(cell->center()[0] - 1.) + std::abs(cell->center()[1] - 0.4) < 0.7)
      cell->set_refine_flag();
  mesh.execute_coarsening_and_refinement();
}

template <int dim>
Places places_of_dofs(const DoFHandler<dim> &dofs, const hp::MappingCollection<dim> &mappings)
{
  std::vector<Place> of_index(dofs.n_dofs());
  for (const auto &cell : dofs.active_cell_iterators())
    if (cell->is_locally_owned())
    {
      std::vector<types::global_dof_index> indices(cell->get_fe().n_dofs_per_cell());
      cell->get_dof_indices(indices);
      for (unsigned int i = 0; i < indices.size(); ++i)
      {
        const auto component = cell->get_fe().system_to_component_index(i);
        const Point<dim> unit =
            cell->get_fe()
                .base_element(cell->get_fe().component_to_base_index(component.first).first)
                .unit_support_point(component.second);
        of_index[indices[i]] =
            place(mappings[0].transform_unit_to_real_cell(cell, unit), component.first);
      }
    }
  const std::vector<unsigned long> numbers = numbers_of_dofs(dofs);
  Places result;
  unsigned int i = 0;
  for (const auto index : dofs.locally_owned_dofs())
    result[numbers[i++]] = of_index[index];
  return result;
}

template <int dim>
Places places_of_values(const CellWiseMesh<dim> &mesh,
                        const ValueSpace<dim> &space,
                        const unsigned int n_components,
                        const bool common)
{
  std::vector<Place> of_value(space.n_owned());
  for (unsigned int c = 0; c < mesh.n_owned_cells(); ++c)
    of_value[space.of_cell(c) - space.first_owned()] = place(mesh.cells()[c].centre, 0);
  for (unsigned int f = 0; f < mesh.faces().size(); ++f)
    for (unsigned int side = 0; mesh.faces()[f].has_value() && side < mesh.faces()[f].n_sides();
         ++side)
      if (space.owns_face(f, side))
        of_value[space.of_face(f, side) - space.first_owned()] =
            place(mesh.faces()[f].centre,
                  common ? 1 : 1 + mesh.cells()[mesh.faces()[f].cell(side)].material_id);
  const std::vector<unsigned long> numbers = space.numbers(n_components);
  Places result;
  for (unsigned int i = 0; i < numbers.size(); ++i)
  {
    result[numbers[i]] = of_value[i / n_components];
    result[numbers[i]][3] += 10 * (i % n_components);
  }
  return result;
}

/// A mesh with both discretisations on it.
template <int dim>
struct Discretised
{
  explicit Discretised(std::unique_ptr<parallel::TriangulationBase<dim>> empty)
      : mesh(std::move(empty)),
        space(
            *mesh, SpaceParameters(), dim == 2 ? Model::plane_strain : Model::three_dimensional, 2),
        cells(*mesh, dim == 2 ? Model::plane_strain : Model::three_dimensional)
  {
    make_mesh(*mesh);
    space.distribute();
    cells.distribute();
  }
  std::array<Places, 4> places() const
  {
    return {{places_of_dofs(space.velocity_dofs, space.mappings),
             places_of_dofs(space.pressure_dofs, space.mappings),
             places_of_values(cells.mesh, cells.velocities, dim, true),
             places_of_values(cells.mesh, cells.pressures, 1, false)}};
  }
  std::vector<std::pair<std::vector<unsigned long>, DistributedVector>> vectors() const
  {
    return {{numbers_of_dofs(space.velocity_dofs), space.velocity_vector()},
            {numbers_of_dofs(space.pressure_dofs), space.pressure_vector()},
            {cells.velocities.numbers(dim), cells.velocity_vector()},
            {cells.pressures.numbers(1), cells.pressure_vector()}};
  }

  std::unique_ptr<parallel::TriangulationBase<dim>> mesh;
  Space<dim> space;
  CellWiseSpace<dim> cells;
};

/// One that tells where it comes from.
double value(const unsigned long number)
{
  return 1. / (1. + static_cast<double>(number));
}

/// Saves on the ranks of one mesh, loads on those of the other; whether all values come back.
template <int dim>
bool passes(const Discretised<dim> &from, const Discretised<dim> &to, const std::string &file)
{
  const MPI_Comm saving = from.mesh->get_communicator(), loading = to.mesh->get_communicator();
  const bool saves = Utilities::MPI::n_mpi_processes(saving) > 1 ||
                     Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  const unsigned int rank = Utilities::MPI::this_mpi_process(saving);
  std::vector<std::string> pieces;
  for (unsigned int r = 0; r < Utilities::MPI::n_mpi_processes(saving); ++r)
    pieces.push_back(file + "-" + std::to_string(r));
  if (saves)
  {
    ArchiveWriter archive;
    unsigned int k = 0;
    for (auto &[numbers, vector] : from.vectors())
    {
      const std::string name = std::to_string(k++);
      const VectorNumbering numbering(saving, name, numbers);
      DistributedVector values(vector);
      for (unsigned int i = 0; i < numbers.size(); ++i)
        values.begin()[i] = value(numbers[i]);
      numbering.save(archive);
      numbering.save(archive, "vector " + name, values);
    }
    if (rank == 0)
      archive.write(file);
    archive.piece().write(pieces[rank]);
  }
  MPI_Barrier(MPI_COMM_WORLD);
  ArchiveReader archive(file);
  archive.set_pieces(pieces);
  bool same = true;
  unsigned int k = 0;
  for (auto &[numbers, vector] : to.vectors())
  {
    const std::string name = std::to_string(k++);
    DistributedVector values(vector);
    VectorNumbering(loading, name, numbers).load(archive, "vector " + name, values);
    for (unsigned int i = 0; i < numbers.size(); ++i)
      same = same && values.begin()[i] == value(numbers[i]);
  }
  MPI_Barrier(MPI_COMM_WORLD);
  return Utilities::MPI::min(same ? 1 : 0, MPI_COMM_WORLD) == 1;
}

template <int dim>
void test(const std::string &name,
          const std::function<std::unique_ptr<parallel::TriangulationBase<dim>>(MPI_Comm)> &make)
{
  const Discretised<dim> together(make(MPI_COMM_WORLD)), alone(make(MPI_COMM_SELF));
  const std::array<Places, 4> of_ranks = together.places(), of_one = alone.places();
  const char *const names[4] = {"velocities of elements", "pressures of elements",
                                "velocities of cells", "pressures of cells"};
  for (unsigned int k = 0; k < 4; ++k)
  {
    bool same = true;
    for (const auto &[number, where] : of_ranks[k])
      same = same && of_one[k].count(number) > 0 && of_one[k].at(number) == where;
    same = Utilities::MPI::min(same ? 1 : 0, MPI_COMM_WORLD) == 1;
    const auto n = Utilities::MPI::sum(of_ranks[k].size(), MPI_COMM_WORLD);
    check::is_true(name + ": numbers of " + names[k], same && n == of_one[k].size());
  }
  check::is_true(name + ": from all ranks to one", passes(together, alone, "to-one.archive"));
  check::is_true(name + ": from one rank to all", passes(alone, together, "to-all.archive"));
}

template <int dim>
void test(const std::string &dimension)
{
  const auto smoothing = Triangulation<dim>::limit_level_difference_at_vertices;
  test<dim>(dimension + " p4est",
            [&](const MPI_Comm communicator) -> std::unique_ptr<parallel::TriangulationBase<dim>> {
              return std::make_unique<parallel::distributed::Triangulation<dim>>(communicator,
                                                                                 smoothing);
            });
  test<dim>(dimension + " metis",
            [&](const MPI_Comm communicator) -> std::unique_ptr<parallel::TriangulationBase<dim>>
            {
              return std::make_unique<parallel::shared::Triangulation<dim>>(
                  communicator, smoothing, true,
                  parallel::shared::Triangulation<dim>::partition_metis);
            });
}
} // namespace

UNIT_TEST(vector_numbering)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    std::cout.setstate(std::ios::failbit);
  test<2>("2-D");
  test<3>("3-D");
}
} // namespace test_of_vector_numbering
