// A mapping that keeps the support points of cells: the points of MappingQ to the last bit, without
// a visit of the geometry; not those of a mesh that has changed; copies.

#include <continua/finite_element/space/kept_mapping.h>

#include <deal.II/base/mpi.h>
#include <deal.II/grid/manifold_lib.h>

#include <memory>

#include "../unit_test.h"
#include "small_problem.h"

namespace test_of_kept_mapping
{
using namespace Continua;
using namespace dealii;

namespace
{
/// Counts how often it is asked for points.
template <int dim>
class CountedManifold : public SphericalManifold<dim>
{
public:
  explicit CountedManifold(unsigned int &n_visits)
      : SphericalManifold<dim>(Point<dim>()), n_visits(n_visits)
  {
  }
  std::unique_ptr<Manifold<dim>> clone() const override
  {
    return std::make_unique<CountedManifold>(n_visits);
  }
  Point<dim> get_new_point(const ArrayView<const Point<dim>> &points,
                           const ArrayView<const double> &weights) const override
  {
    ++n_visits;
    return SphericalManifold<dim>::get_new_point(points, weights);
  }
  void get_new_points(const ArrayView<const Point<dim>> &points,
                      const Table<2, double> &weights,
                      ArrayView<Point<dim>> new_points) const override
  {
    ++n_visits;
    SphericalManifold<dim>::get_new_points(points, weights, new_points);
  }

private:
  unsigned int &n_visits;
};

/// Whether the cells of this rank, and others as far as they are known, have the points of
/// MappingQ.
template <int dim>
bool same_points(const Mapping<dim> &mapping, const Triangulation<dim> &mesh)
{
  const MappingQ<dim> plain(2);
  bool same = true;
  for (const auto &cell : mesh.active_cell_iterators())
    for (const Point<dim> &unit : {Point<dim>(Point<dim>::unit_vector(0) * 0.3),
                                   Point<dim>(Point<dim>::unit_vector(1) * 0.7)})
      same = same && mapping.transform_unit_to_real_cell(cell, unit) ==
                         plain.transform_unit_to_real_cell(cell, unit);
  return same;
}

template <int dim>
void check_mapping(const std::string &name)
{
  unsigned int n_visits = 0;
  small_problem::Mesh<dim> mesh(MPI_COMM_WORLD);
  GridGenerator::quarter_hyper_shell(mesh, Point<dim>(), 1., 1.5, 0, true);
  for (const auto id : mesh.get_manifold_ids())
    if (id != numbers::flat_manifold_id)
      mesh.set_manifold(id, CountedManifold<dim>(n_visits));
  mesh.refine_global(1);
  auto mapping = std::make_unique<KeptMapping<dim>>(2, mesh);
  check::is_true(name + ": before points are kept", same_points<dim>(*mapping, mesh));
  const std::unique_ptr<Mapping<dim>> copy = mapping->clone();
  mapping->keep_points();
  n_visits = 0;
  for (const auto &cell : mesh.active_cell_iterators())
    if (!cell->is_artificial())
    {
      mapping->transform_unit_to_real_cell(cell, Point<dim>());
      copy->transform_unit_to_real_cell(cell, Point<dim>());
    }
  check::is_true(name + ": without a visit of the geometry", n_visits == 0);
  check::is_true(name + ": kept", same_points<dim>(*mapping, mesh));
  check::is_true(name + ": of a copy", same_points<dim>(*copy, mesh));
  check::is_true(name + ": the geometry is asked where it must be", n_visits > 0);

  small_problem::refine<dim>(mesh, [](const Point<dim> &x) { return x[0] > 0.5; });
  check::is_true(name + ": of a finer mesh", same_points<dim>(*mapping, mesh));
  mapping->keep_points();
  check::is_true(name + ": kept anew", same_points<dim>(*mapping, mesh));
  // The small cells go, and others come that take over their numbers.
  for (const auto &cell : mesh.active_cell_iterators())
    if (cell->is_locally_owned())
    {
      if (cell->level() == 2)
        cell->set_coarsen_flag();
      else
        cell->set_refine_flag();
    }
  mesh.execute_coarsening_and_refinement();
  check::is_true(name + ": of a mesh with other small cells", same_points<dim>(*mapping, mesh));
  mapping->keep_points();
  for (const auto &cell : mesh.active_cell_iterators())
    if (cell->is_locally_owned())
      cell->set_coarsen_flag();
  mesh.execute_coarsening_and_refinement();
  check::is_true(name + ": of a coarser mesh", same_points<dim>(*mapping, mesh));
  mapping->keep_points();
  mapping = nullptr;
  check::is_true(name + ": of a copy that is left", same_points<dim>(*copy, mesh));
}
} // namespace

UNIT_TEST(kept_mapping)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  small_problem::quiet_other_ranks();
  check_mapping<2>("plane");
  check_mapping<3>("in space");
}
} // namespace test_of_kept_mapping
