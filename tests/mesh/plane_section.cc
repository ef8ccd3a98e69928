// Sections of boxes and round bars by planes: areas, integrals of polynomials, rims; through faces
// of cells, at the ends of the body, on distorted cells, with hanging nodes and over the ranks.

#include <continua/mesh/plane_section.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include "../unit_test.h"

#include <iostream>

namespace test_of_plane_section
{
using namespace Continua;
using namespace dealii;

namespace
{
template <int dim>
using Mesh = parallel::distributed::Triangulation<dim>;

template <int dim>
PlaneSection<dim> section(const Mesh<dim> &mesh,
                          const Point<dim> &point,
                          const Tensor<1, dim> &normal,
                          const std::set<unsigned int> &regions = {})
{
  static const MappingQ<dim> mapping(2);
  return PlaneSection<dim>(mapping, mesh, PlaneSection<dim>::Cells::active, regions, point, normal,
                           4);
}

template <int dim>
PlaneSection<dim>
section(const Mesh<dim> &mesh, const double x, const std::set<unsigned int> &regions = {})
{
  return section<dim>(mesh, Point<dim>(x * Point<dim>::unit_vector(0)), Point<dim>::unit_vector(0),
                      regions);
}

/// Integral of a function over parts on all ranks.
template <int dim>
double
integral(const std::vector<typename PlaneSection<dim>::Part> &parts,
         const std::function<double(const Point<dim> &, const Tensor<1, dim> &normal)> &function)
{
  double sum = 0.;
  for (const auto &part : parts)
    for (unsigned int q = 0; q < part.points.size(); ++q)
      sum += part.quadrature.weight(q) *
             function(part.points[q], part.normals.empty() ? Tensor<1, dim>() : part.normals[q]);
  return Utilities::MPI::sum(sum, MPI_COMM_WORLD);
}

template <int dim>
void refine_some(Mesh<dim> &mesh)
{
  for (const auto &cell : mesh.active_cell_iterators())
    if (cell->is_locally_owned() && cell->center()[1] > 0.3 && cell->center()[0] > 0.)
      cell->set_refine_flag();
  mesh.execute_coarsening_and_refinement();
}

/// The angle that a rim subtends at the x axis, by Gauss's law in the plane.
double angle(const PlaneSection<3> &present)
{
  return integral<3>(present.outer_rim(),
                     [](const Point<3> &x, const Tensor<1, 3> &normal)
                     {
                       const Point<3> radial(0., x[1], x[2]);
                       return radial * normal / radial.norm_square();
                     });
}

void test_rectangle()
{
  Mesh<2> mesh(MPI_COMM_WORLD);
  GridGenerator::subdivided_hyper_rectangle(mesh, {8, 4}, Point<2>(0., 0.), Point<2>(2., 1.));
  for (const auto &cell : mesh.active_cell_iterators())
    cell->set_material_id(cell->center()[1] > 0.5 ? 1 : 0);
  const auto cubic = [](const Point<2> &x, const Tensor<1, 2> &)
  { return x[0] + x[1] * x[1] * x[1]; };
  for (const double x : {0., 0.25, 0.6, 2.})
  {
    const PlaneSection<2> present = section<2>(mesh, x);
    check::relative("height of a rectangle", present.area(), 1., 1e-12);
    check::relative("integral of a cubic", integral<2>(present.parts(), cubic), x + 0.25, 1e-8);
  }
  const PlaneSection<2> lower = section<2>(mesh, 0.75, {0});
  check::relative("one region", lower.area(), 0.5, 1e-12);
  check::absolute("its rim is a point",
                  integral<2>(lower.outer_rim(), [](const Point<2> &x, const Tensor<1, 2> &normal)
                              { return std::abs(x[1] - 0.5) < 1e-12 ? normal[1] : 100.; }),
                  1., 1e-12);
  check::absolute("no area outside", section<2>(mesh, 2.001).area(), 0., 0.);
  check::absolute("no region of that number", section<2>(mesh, 1., {7}).area(), 0., 0.);
  check::relative("oblique, the normal of any length",
                  section<2>(mesh, Point<2>(1., 0.5), Point<2>(3., 3.)).area(), std::sqrt(2.),
                  1e-12);

  GridTools::distort_random(0.25, mesh, true, 1);
  check::relative("height on distorted cells", section<2>(mesh, 0.73).area(), 1., 1e-5);
  check::relative("integral on distorted cells", integral<2>(section<2>(mesh, 0.73).parts(), cubic),
                  0.98, 1e-5);
  refine_some(mesh);
  check::relative("height with hanging nodes", section<2>(mesh, 0.73).area(), 1., 1e-5);
  check::relative("the same, of the coarse mesh",
                  PlaneSection<2>(MappingQ<2>(1), mesh, PlaneSection<2>::Cells::coarse, {},
                                  Point<2>(0.73, 0.), Point<2>(1., 0.), 4)
                      .area(),
                  1., 1e-5);
}

void test_bar()
{
  // A round bar of radius 1 about the x axis from -2 to 2.
  Mesh<3> mesh(MPI_COMM_WORLD);
  GridGenerator::cylinder(mesh, 1., 2.);
  mesh.refine_global(1);
  const auto round = [&mesh](const std::string &name, const double tolerance)
  {
    const PlaneSection<3> present = section<3>(mesh, 0.4);
    check::relative("area " + name, present.area(), numbers::PI, tolerance);
    // int y^2 = pi/4, int (1 + y) = pi
    check::relative("integral " + name,
                    integral<3>(present.parts(), [](const Point<3> &x, const Tensor<1, 3> &)
                                { return x[1] * x[1] + 1. + x[1]; }),
                    1.25 * numbers::PI, 2. * tolerance);
    check::relative(
        "circumference " + name,
        integral<3>(present.outer_rim(), [](const Point<3> &, const Tensor<1, 3> &) { return 1.; }),
        2. * numbers::PI, tolerance);
    check::relative("angle " + name, angle(present), 2. * numbers::PI, 1e-6);
  };
  round("of a round bar", 2e-3);
  check::relative("through faces", section<3>(mesh, 0.).area(), section<3>(mesh, 0.4).area(),
                  1e-10);
  check::relative("at the end", section<3>(mesh, 2.).area(), section<3>(mesh, 0.4).area(), 1e-10);
  check::relative("at the beginning", section<3>(mesh, -2.).area(), section<3>(mesh, 0.4).area(),
                  1e-10);
  refine_some(mesh);
  round("with hanging nodes", 2e-3);
  // Cells that taper and whose faces are curved.
  Mesh<3> tapered(MPI_COMM_WORLD);
  GridGenerator::cylinder(tapered, 1., 2.);
  GridTools::transform(
      [](const Point<3> &x)
      { return Point<3>(x[0], (1. - 0.1 * x[0]) * x[1], (1. - 0.1 * x[0]) * x[2]); },
      tapered);
  check::relative("rim of a cone",
                  integral<3>(section<3>(tapered, 0.4).outer_rim(),
                              [](const Point<3> &x, const Tensor<1, 3> &)
                              { return std::hypot(x[1], x[2]) > 0.5 ? 1. : 0.; }) /
                      integral<3>(section<3>(tapered, -0.4).outer_rim(),
                                  [](const Point<3> &, const Tensor<1, 3> &) { return 1.; }),
                  0.96 / 1.04, 1e-2);

  Mesh<3> quarter(MPI_COMM_WORLD);
  Triangulation<2> disk;
  GridGenerator::quarter_hyper_ball(disk);
  Triangulation<3> straight;
  GridGenerator::extrude_triangulation(disk, 3, 1., straight);
  GridTools::rotate(0.5 * numbers::PI, 1, straight); // z becomes x
  quarter.copy_triangulation(straight);
  quarter.set_all_manifold_ids_on_boundary(numbers::flat_manifold_id);
  check::relative("a quarter's angle, straight-sided", angle(section<3>(quarter, 0.5)),
                  0.5 * numbers::PI, 1e-4);
}
} // namespace

UNIT_TEST(plane_section)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    std::cout.setstate(std::ios::failbit);
  test_rectangle();
  test_bar();
}
} // namespace test_of_plane_section
