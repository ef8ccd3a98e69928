// The corners of a circle and of a cylinder of straight cells, whose angle is 2 pi/n; those that
// are meant, that a manifold rounds, and that lie between names count not.

#include "../unit_test.h"

#include <continua/mesh/kept_corners.h>
#include <continua/mesh/quadratic_cell_manifold.h>

#include <deal.II/base/numbers.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/grid_generator.h>

#include <cmath>

namespace test_of_kept_corners
{
using namespace Continua;

namespace
{
/// A ring of n cells, divided at radius 2 into two regions, without its manifolds.
template <int dim>
void make_ring(dealii::Triangulation<dim> &mesh, const unsigned int n)
{
  if constexpr (dim == 2)
    dealii::GridGenerator::concentric_hyper_shells(mesh, dealii::Point<dim>(), 1., 3., 2, 0., n);
  else
    dealii::GridGenerator::cylinder_shell(mesh, 1., 1., 3., n, 1);
  mesh.reset_all_manifolds();
  for (const auto &cell : mesh.active_cell_iterators())
  {
    cell->set_all_manifold_ids(dealii::numbers::flat_manifold_id);
    cell->set_material_id(dim == 3 || cell->center().norm() < 2. ? 0 : 1);
    for (const auto &face : cell->face_iterators())
      if (face->at_boundary())
        face->set_boundary_id(0);
  }
}

double degrees(const double angle)
{
  return angle * 180. / dealii::numbers::PI;
}
} // namespace

UNIT_TEST(kept_corners)
{
  const std::vector<std::string> regions = {"inside", "outside"}, boundaries = {"rim", "ends"};
  dealii::Triangulation<2> ring;
  make_ring(ring, 24);
  const auto of_ring = kept_corners<2>(ring, regions, boundaries);
  check::equal("ring: a boundary and an interface", std::to_string(of_ring.size()), "2");
  for (const auto &corner : of_ring)
    check::relative("ring: " + corner.surface, degrees(corner.angle), 15., 1e-9);
  check::is_true("ring: warning",
                 warning_of(of_ring).find("'rim' up to 15 degrees") != std::string::npos);

  dealii::Triangulation<2> square;
  make_ring(square, 8);
  check::equal("eight corners of 45 degrees are meant",
               std::to_string(kept_corners<2>(square, regions, boundaries).size()), "0");
  check::equal("no warning", warning_of(kept_corners<2>(square, regions, boundaries)), "");

  dealii::Triangulation<2> round;
  dealii::GridGenerator::hyper_shell(round, dealii::Point<2>(), 1., 3., 24);
  check::equal("a manifold rounds them",
               std::to_string(kept_corners<2>(round, regions, boundaries).size()), "0");

  // Curved cells of second order through points of a circle with the half angle a: the parabola
  // leaves its end at the angle atan(2 h/l) to the chord, where h = 1 - cos a is its height and l =
  // sin a half of the chord; the corner is twice of what is missing to a.
  const auto curve = [](dealii::Triangulation<2> &mesh)
  {
    for (const auto &cell : mesh.active_cell_iterators())
    {
      const dealii::MappingQ<2> mapping(2);
      QuadraticCellManifold<2>::Nodes nodes;
      for (unsigned int node = 0; node < nodes.size(); ++node)
        nodes[node] =
            mapping.transform_unit_to_real_cell(cell, {0.5 * (node % 3), 0.5 * (node / 3)});
      const unsigned int id = 1 + cell->index();
      cell->set_all_manifold_ids(id);
      mesh.set_manifold(id, QuadraticCellManifold<2>(nodes));
    }
  };
  for (const unsigned int n : {6u, 24u})
  {
    dealii::Triangulation<2> curved;
    dealii::GridGenerator::hyper_shell(curved, dealii::Point<2>(), 1., 3., n);
    curve(curved);
    const double a = dealii::numbers::PI / n;
    const double angle = 2. * (std::atan(2. * (1. - std::cos(a)) / std::sin(a)) - a);
    const auto corners = kept_corners<2>(curved, regions, boundaries);
    check::is_true("curved cells, " + std::to_string(n), corners.size() == (n == 6 ? 1 : 0));
    for (const auto &corner : corners)
      check::relative("their angle", corner.angle, std::abs(angle), 1e-9);
  }

  dealii::Triangulation<2> box;
  dealii::GridGenerator::subdivided_hyper_rectangle(box, {4, 4}, dealii::Point<2>(),
                                                    dealii::Point<2>(1., 1.));
  check::equal("a box", std::to_string(kept_corners<2>(box, regions, boundaries).size()), "0");

  dealii::Triangulation<3> cylinder;
  make_ring(cylinder, 36);
  const auto of_cylinder = kept_corners<3>(cylinder, regions, boundaries);
  check::equal("cylinder: its surface", std::to_string(of_cylinder.size()), "1");
  if (!of_cylinder.empty())
    check::relative("cylinder: angle", degrees(of_cylinder.front().angle), 10., 1e-9);
}
} // namespace test_of_kept_corners
