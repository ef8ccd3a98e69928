#include <continua/mesh/cylinder_channel_geometry.h>
#include <continua/mesh/distortion.h>

#include "../unit_test.h"
#include "curved_measures.h"
#include "geometry_text.h"
#include "mesh_measures.h"

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>

#include <cmath>
#include <limits>
#include <set>

namespace test_of_cylinder_channel_geometry
{
using namespace Continua;
using dealii::Point;
using dealii::numbers::PI;
using geometry_text::joined;

namespace
{
template <int dim>
using Parameters = typename CylinderChannelGeometry<dim>::Parameters;

/// Area (volume) of a region as a discretisation with curved cells sees it; 0 if there is none.
template <int dim>
double curved_region(const measures::Measures<dim> &channel,
                     const std::string &region,
                     const unsigned int mapping_degree)
{
  return measures::CurvedMeasures<dim>(channel.region_names, channel.boundary_names, channel.mesh,
                                       mapping_degree)
      .volumes[region];
}

/// Length (area) of a boundary, alike; `distance_from_circle` becomes the largest one of the
/// points of the faces that the mapping takes from the manifold.
template <int dim>
double curved_boundary(const measures::Measures<dim> &channel,
                       const std::string &boundary,
                       const unsigned int mapping_degree,
                       const Parameters<dim> &parameters,
                       double &distance_from_circle)
{
  const dealii::MappingQ<dim> mapping(mapping_degree);
  const dealii::FE_Nothing<dim> element;
  dealii::FEFaceValues<dim> values(mapping, element, dealii::QGauss<dim - 1>(mapping_degree + 2),
                                   dealii::update_JxW_values);
  dealii::FEFaceValues<dim> nodes(mapping, element,
                                  dealii::QGaussLobatto<dim - 1>(mapping_degree + 1),
                                  dealii::update_quadrature_points);
  double sum = 0.;
  distance_from_circle = 0.;
  for (const auto &cell : channel.mesh.active_cell_iterators())
    for (const unsigned int f : cell->face_indices())
      if (cell->at_boundary(f) && channel.boundary_names[cell->face(f)->boundary_id()] == boundary)
      {
        values.reinit(cell, f);
        for (const double weight : values.get_JxW_values())
          sum += weight;
        nodes.reinit(cell, f);
        for (const Point<dim> &point : nodes.get_quadrature_points())
          distance_from_circle =
              std::max(distance_from_circle, std::abs(std::hypot(point[0] - parameters.cylinder_x,
                                                                 point[1] - parameters.cylinder_y) -
                                                      parameters.cylinder_radius));
      }
  return sum;
}

/// The least Jacobian of the mapping over the cell's measure, at points up to the corners.
template <int dim>
double least_jacobian(const dealii::Triangulation<dim> &mesh, const unsigned int mapping_degree)
{
  const dealii::MappingQ<dim> mapping(mapping_degree);
  const dealii::FE_Nothing<dim> element;
  dealii::FEValues<dim> values(mapping, element, dealii::QGaussLobatto<dim>(mapping_degree + 2),
                               dealii::update_jacobians);
  double least = std::numeric_limits<double>::max();
  for (const auto &cell : mesh.active_cell_iterators())
  {
    values.reinit(cell);
    for (unsigned int q = 0; q < values.n_quadrature_points; ++q)
      least = std::min(least, values.jacobian(q).determinant() / cell->measure());
  }
  return least;
}

/// The areas and lengths by formula.
template <int dim>
struct Exact
{
  explicit Exact(const Parameters<dim> &channel)
  {
    const double r = channel.cylinder_radius;
    const double half = channel.has_beam() ? 0.5 * channel.beam_thickness : 0.;
    const double angle = std::asin(half / r);
    // From the centre to the tip, without the part of the disc.
    beam = 2. * half * (r + channel.beam_length) -
           (r * r * angle + half * std::sqrt(r * r - half * half));
    if (!channel.has_beam())
      beam = 0.;
    fluid = channel.length * channel.height - PI * r * r - beam;
    beam_root = 2. * r * angle;
    cylinder = 2. * PI * r - beam_root;
  }

  double fluid, beam, cylinder, beam_root;
};

/// A thing whose error falls with h^4, as quadratic cells have it, from each mesh to the next.
void check_order(const std::string &name, const std::vector<double> &errors)
{
  for (std::size_t i = 1; i < errors.size(); ++i)
    check::absolute(name + ": order", std::log2(std::abs(errors[i - 1] / errors[i])), 4., 0.3);
}

void test_benchmark(const std::string &title, const Parameters<2> &parameters)
{
  const CylinderChannelGeometry<2> geometry(parameters);
  measures::Measures<2> channel(geometry);
  const Exact<2> exact(parameters);
  check::equal(title + ": regions", joined(channel.region_names),
               parameters.has_beam() ? "fluid; beam; " : "fluid; ");
  check::equal(title + ": boundaries", joined(channel.boundary_names),
               parameters.has_beam() ? "inlet; outlet; bottom; top; cylinder; beam root; "
                                     : "inlet; outlet; bottom; top; cylinder; ");
  check::absolute(title + ": cells", channel.mesh.n_active_cells(), geometry.extent().n_cells, 0.);
  check::relative(title + ": inlet", channel.boundary("inlet"), parameters.height, 1e-13);
  check::relative(title + ": outlet", channel.boundary("outlet"), parameters.height, 1e-13);
  check::relative(title + ": bottom", channel.boundary("bottom"), parameters.length, 1e-13);
  check::relative(title + ": top", channel.boundary("top"), parameters.length, 1e-13);

  std::vector<std::string> on_circle = {"cylinder"};
  std::vector<double> lengths = {exact.cylinder};
  if (parameters.has_beam())
  {
    on_circle.push_back("beam root");
    lengths.push_back(exact.beam_root);
  }
  std::vector<std::vector<double>> region_errors(2), boundary_errors(2);
  double off_circle = 0.;
  for (unsigned int refinement = 0; refinement < 3; ++refinement)
  {
    region_errors[0].push_back(curved_region(channel, "fluid", 2) - exact.fluid);
    region_errors[1].push_back(curved_region(channel, "beam", 2) - exact.beam);
    for (std::size_t i = 0; i < on_circle.size(); ++i)
    {
      double distance = 0.;
      boundary_errors[i].push_back(
          curved_boundary<2>(channel, on_circle[i], 2, parameters, distance) - lengths[i]);
      off_circle = std::max(off_circle, distance);
    }
    check::is_true(title + ": Jacobians", least_jacobian(channel.mesh, 2) > 0.);
    if (refinement < 2)
      channel.mesh.refine_global(1);
  }
  check::relative(title + ": fluid", curved_region(channel, "fluid", 2), exact.fluid, 1e-9);
  check_order(title + ": fluid", region_errors[0]);
  check_order(title + ": cylinder", boundary_errors[0]);
  if (parameters.has_beam())
  {
    check::relative(title + ": beam", curved_region(channel, "beam", 2), exact.beam, 1e-8);
    check_order(title + ": beam", region_errors[1]);
    check_order(title + ": beam root", boundary_errors[1]);
  }
  check::absolute(title + ": points on the circle", off_circle, 0., 1e-14);
}

/// The mesh in the square, after one refinement, is its own mirror image.
void test_symmetry(const Parameters<2> &parameters)
{
  measures::Measures<2> channel(CylinderChannelGeometry<2>{parameters});
  channel.mesh.refine_global(1);
  // The centres in the square and behind it, by region.
  std::vector<Point<2>> centres[2];
  for (const auto &cell : channel.mesh.active_cell_iterators())
  {
    const Point<2> centre = cell->center();
    if (std::abs(centre[1] - parameters.cylinder_y) < 0.1 + 1e-9 && centre[0] > 0.1 - 1e-9)
      centres[cell->material_id()].push_back(centre);
  }
  double largest = 0.;
  for (const auto &region : centres)
    for (const Point<2> &point : region)
    {
      double nearest = std::numeric_limits<double>::max();
      for (const Point<2> &other : region)
        nearest = std::min(nearest, std::hypot(point[0] - other[0],
                                               2. * parameters.cylinder_y - point[1] - other[1]));
      largest = std::max(largest, nearest);
    }
  const std::size_t n_points = centres[0].size() + centres[1].size();
  check::is_true("mirror: points", n_points > 1000);
  check::absolute("mirror", largest, 0., 1e-14);
}

/// The lengths of the cells that the horizontal (0) or vertical (1) line through `point` cuts, in
/// their order.
std::vector<double>
cells_along(const dealii::Triangulation<2> &mesh, const Point<2> &point, const unsigned int d)
{
  std::map<double, double> lengths;
  for (const auto &cell : mesh.active_cell_iterators())
  {
    double low = std::numeric_limits<double>::max(), high = -low, begin = low, end = high;
    for (const unsigned int v : cell->vertex_indices())
    {
      low = std::min(low, cell->vertex(v)[1 - d]);
      high = std::max(high, cell->vertex(v)[1 - d]);
      begin = std::min(begin, cell->vertex(v)[d]);
      end = std::max(end, cell->vertex(v)[d]);
    }
    if (low < point[1 - d] && point[1 - d] < high)
      lengths[begin] = end - begin;
  }
  std::vector<double> result;
  for (const auto &[begin, length] : lengths)
    result.push_back(length);
  return result;
}

void test_sizes()
{
  Parameters<2> parameters;
  parameters.beam_cells = 4;
  parameters.wall_grading = 0.5;
  const measures::Measures<2> channel(CylinderChannelGeometry<2>{parameters});

  // Across the beam halfway: bottom, square, beam, square, top.
  const std::vector<double> across = cells_along(channel.mesh, {0.41, 0.2}, 1);
  check::absolute("sizes: cells across", across.size(), 3. + 4. + 4. + 4. + 3., 0.);
  check::relative("sizes: bottom", across[0] / across[2], 0.5, 1e-9);
  check::relative("sizes: top", across[17] / across[15], 0.5, 1e-9);
  check::relative("sizes: below the beam", across[6] / across[3], 0.4, 1e-9);
  check::relative("sizes: above the beam", across[11] / across[14], 0.4, 1e-9);
  for (unsigned int i = 7; i < 11; ++i)
    check::relative("sizes: in the beam", across[i], 0.005, 1e-9);

  // Along the beam just above it, from the square on.
  const std::vector<double> along = cells_along(channel.mesh, {0., 0.2 + 0.0101}, 0);
  const std::size_t tip = along.size() - 20;
  check::relative("sizes: tip over first", along[tip - 1] / along[tip - 15], 0.5, 1e-9);
  check::relative("sizes: behind the tip", along[tip] / along[tip - 1], 1., 1e-9);
  bool grows = true;
  for (std::size_t i = tip + 1; i < along.size(); ++i)
    grows &= along[i] > 1.01 * along[i - 1] && along[i] < 1.3 * along[i - 1];
  check::is_true("sizes: growth in the wake", grows);

  // Before the cylinder, on its level: the square's cells become longer upstream.
  std::vector<double> before;
  for (const auto &cell : channel.mesh.active_cell_iterators())
    for (const unsigned int f : cell->face_indices())
    {
      const auto face = cell->face(f);
      const Point<2> a = face->vertex(0), b = face->vertex(1);
      if (std::abs(a[1] - 0.2) < 1e-9 && std::abs(b[1] - 0.2) < 1e-9 && a[0] < 0.16 &&
          a[0] > 0.099 && b[0] < 0.16 && b[0] > 0.099)
        before.push_back(a.distance(b));
    }
  std::sort(before.begin(), before.end());
  check::absolute("sizes: radial cells", before.size(), 2. * 6., 0.);
  check::relative("sizes: at the cylinder", before.front() / before.back(), 0.25, 1e-9);

  // Without a beam the wake goes on from the outermost cell of the square.
  parameters.beam_length = 0.;
  const measures::Measures<2> bare(CylinderChannelGeometry<2>{parameters});
  const std::vector<double> wake = cells_along(bare.mesh, {0., 0.26}, 0);
  check::relative("sizes: behind the square", wake[wake.size() - 20], before.back(), 1e-9);
}

/// Positive Jacobians and right areas for a shape far from the benchmark's.
void test_shape(const std::string &name, const Parameters<2> &parameters)
{
  measures::Measures<2> channel(CylinderChannelGeometry<2>{parameters});
  const Exact<2> exact(parameters);
  double least = std::numeric_limits<double>::max();
  for (unsigned int refinement = 0; refinement < 2; ++refinement)
  {
    for (const unsigned int degree : {1, 2})
      least = std::min(least, least_jacobian(channel.mesh, degree));
    channel.mesh.refine_global(1);
  }
  check::is_true(name + ": Jacobians", least > 0.01);
  check::relative(name + ": fluid", curved_region(channel, "fluid", 4), exact.fluid, 1e-6);
  check::absolute(name + ": beam", curved_region(channel, "beam", 4), exact.beam,
                  1e-6 * exact.beam);
}

void test_shapes()
{
  Parameters<2> parameters;
  parameters.circumferential_cells = 2;
  parameters.radial_cells = 1;
  parameters.beam_cells = 1;
  test_shape("fewest cells", parameters);
  parameters = Parameters<2>();
  parameters.beam_thickness = 0.06;
  test_shape("thickest beam", parameters);
  parameters.beam_length = 0.025;
  test_shape("shortest beam", parameters);
  parameters = Parameters<2>();
  parameters.beam_thickness = 1e-4;
  test_shape("thin beam", parameters);
  parameters = Parameters<2>();
  parameters.cylinder_y = 0.0525;
  parameters.beam_thickness = 0.06;
  test_shape("narrow gap at the bottom", parameters);
  parameters = Parameters<2>();
  parameters.cylinder_radius = 0.195;
  parameters.cylinder_x = 0.3;
  parameters.cylinder_y = 0.205;
  test_shape("thick cylinder", parameters);
  parameters = Parameters<2>();
  parameters.length = 0.3;
  parameters.beam_length = 0.;
  test_shape("short channel", parameters);
}

void test_space()
{
  Parameters<3> parameters;
  parameters.width = 0.3;
  parameters.width_cells = 2;
  parameters.circumferential_cells = 4;
  parameters.radial_cells = 2;
  parameters.axial_cells = 5;
  parameters.beam_axial_cells = 4;
  const CylinderChannelGeometry<3> geometry(parameters);
  measures::Measures<3> channel(geometry);
  const Exact<3> exact(parameters);
  check::equal("space: boundaries", joined(channel.boundary_names),
               "inlet; outlet; bottom; top; cylinder; beam root; back; front; ");
  check::absolute("space: cells", channel.mesh.n_active_cells(), geometry.extent().n_cells, 0.);
  channel.mesh.refine_global(1);
  check::relative("space: fluid", curved_region(channel, "fluid", 4), 0.3 * exact.fluid, 1e-8);
  check::relative("space: beam", curved_region(channel, "beam", 4), 0.3 * exact.beam, 1e-8);
  check::relative("space: inlet", channel.boundary("inlet"), 0.41 * 0.3, 1e-13);
  check::relative("space: outlet", channel.boundary("outlet"), 0.41 * 0.3, 1e-13);
  check::relative("space: bottom", channel.boundary("bottom"), 2.5 * 0.3, 1e-13);
  check::relative("space: top", channel.boundary("top"), 2.5 * 0.3, 1e-13);
  double distance = 0.;
  check::relative("space: back", curved_boundary<3>(channel, "back", 4, parameters, distance),
                  exact.fluid + exact.beam, 1e-8);
  check::relative("space: front", curved_boundary<3>(channel, "front", 4, parameters, distance),
                  exact.fluid + exact.beam, 1e-8);
  check::relative("space: beam root",
                  curved_boundary<3>(channel, "beam root", 4, parameters, distance),
                  0.3 * exact.beam_root, 1e-8);
  check::absolute("space: beam root on the circle", distance, 0., 1e-14);
  check::relative("space: cylinder",
                  curved_boundary<3>(channel, "cylinder", 4, parameters, distance),
                  0.3 * exact.cylinder, 1e-8);
  check::absolute("space: cylinder on the circle", distance, 0., 1e-14);
  for (const unsigned int degree : {1, 2})
    check::is_true("space: Jacobians", least_jacobian(channel.mesh, degree) > 0.01);
  for (const auto &cell : channel.mesh.active_cell_iterators())
    for (const unsigned int f : {4u, 5u})
      if (cell->at_boundary(f) &&
          (channel.boundary_names[cell->face(f)->boundary_id()] != (f == 4 ? "back" : "front") ||
           cell->face(f)->center()[2] != (f == 4 ? 0. : 0.3)))
        check::is_true("space: back and front", false);

  parameters.beam_length = 0.;
  const measures::Measures<3> bare(CylinderChannelGeometry<3>{parameters});
  check::equal("bare space: boundaries", joined(bare.boundary_names),
               "inlet; outlet; bottom; top; cylinder; back; front; ");
  check::relative("bare space: fluid", curved_region(bare, "fluid", 4),
                  0.3 * Exact<3>(parameters).fluid, 1e-6);
}

template <int dim>
void test_distributed(const std::string &name, const Parameters<dim> &parameters)
{
  dealii::parallel::distributed::Triangulation<dim> mesh(MPI_COMM_WORLD);
  CylinderChannelGeometry<dim>{parameters}.create(mesh);
  dealii::Triangulation<dim> serial;
  CylinderChannelGeometry<dim>{parameters}.create(serial);
  mesh.refine_global(1);
  serial.refine_global(1);
  dealii::Tensor<1, dim> distributed_sum, serial_sum;
  for (const auto &cell : mesh.active_cell_iterators())
    if (cell->is_locally_owned())
      distributed_sum += cell->center() * (1. + cell->material_id());
  for (const auto &cell : serial.active_cell_iterators())
    serial_sum += cell->center() * (1. + cell->material_id());
  check::absolute(
      name, (dealii::Utilities::MPI::sum(distributed_sum, MPI_COMM_WORLD) - serial_sum).norm(), 0.,
      1e-9);
}

/// Vertices that stand a little beyond their sector do no harm.
void test_distorted()
{
  const Parameters<2> parameters;
  measures::Measures<2> channel(CylinderChannelGeometry<2>{parameters});
  distort_coarse_mesh(channel.mesh, 0.2);
  channel.mesh.refine_global(2);
  const Exact<2> exact(parameters);
  check::is_true("distorted: Jacobians", least_jacobian(channel.mesh, 2) > 0.);
  check::relative("distorted: fluid", curved_region(channel, "fluid", 2), exact.fluid, 1e-8);
  check::relative("distorted: beam", curved_region(channel, "beam", 2), exact.beam, 1e-8);
}

const std::string type = "set Type = channel with cylinder\n";

void refused(const std::string &name,
             const std::string &geometry,
             const std::string &mesh,
             const std::string &pattern)
{
  geometry_text::refused<2>(name, type + geometry, mesh, pattern);
}

void test_input()
{
  const measures::Measures<2> plain(*geometry_text::make<2>(type));
  check::relative("input: defaults", curved_region(plain, "beam", 4),
                  Exact<2>(Parameters<2>()).beam, 1e-9);
  const measures::Measures<2> other(*geometry_text::make<2>(
      type + "set Length = 5 m\nset Height = 1 m\nset Cylinder x = 1 m\nset Cylinder y = 0.4 m\n"
             "set Cylinder radius = 10 cm\nset Beam length = 1 m\nset Beam thickness = 5 cm\n",
      "set Circumferential cells = 4\nset Radial cells = 3\nset Upstream cells = 2\n"
      "set Transverse cells = 1\nset Axial cells = 6\nset Beam cells = 3\n"
      "set Beam axial cells = 5\nset Cylinder grading = 0.5\nset Wall grading = 0.7\n"
      "set Beam grading = 0.6\nset Tip grading = 0.3\n"));
  // (3 4 + 7) 3 in the square, 2 4 before it, (5 + 6) 7 behind it, 2 (2 + 4 + 11) above and below.
  check::absolute("input: cells", other.mesh.n_active_cells(), 57. + 8. + 77. + 34., 0.);
  check::relative("input: bottom", other.boundary("bottom"), 5., 1e-13);

  refused("at the inlet", "set Cylinder x = 5 cm\n", "",
          "3.*/Cylinder x'.*touches the inlet.*smaller");
  refused("near the inlet", "set Cylinder x = 51 mm\n", "", "3.*/Cylinder x'.*0.001 m, too narrow");
  refused("behind the outlet", "set Cylinder x = 3 m\n", "", "3.*/Cylinder x'.*beyond.*larger");
  refused("at the bottom", "set Cylinder y = 4 cm\n", "", "3.*/Cylinder y'.*the bottom");
  refused("at the top", "set Cylinder y = 0.4\n", "", "3.*/Cylinder y'.*the top");
  refused("thick beam", "set Beam thickness = 7 cm\n", "",
          "3.*/Beam thickness'.*60 %.*0.06 m.*thinner");
  refused("short beam", "set Beam length = 2 cm\n", "", "3.*/Beam length'.*half.*or 0");
  refused("beam beyond the outlet", "set Beam length = 2.3 m\n", "",
          "3.*/Beam length'.*x = 2.55 m, not before the outlet.*shorter");
  refused("tip near the outlet", "set Beam length = 2.24 m\n", "",
          "3.*/Beam length'.*nearer to the outlet.*longer channel");
  refused("negative beam", "set Beam length = -1 m\n", "", "3.*/Beam length'");
  refused("no radius", "set Cylinder radius = 0 m\n", "", "3.*/Cylinder radius'");
  refused("thickness of no beam", "set Beam length = 0 m\nset Beam thickness = 1 cm\n", "",
          "4.*/Beam thickness'");
  refused("cells of no beam", "set Beam length = 0 m\n", "set Beam cells = 2\n", "6.*/Beam cells'");
  refused("odd quarter", "", "set Circumferential cells = 7\n", "5.*/Circumferential.*odd.*even");
  refused("no width in the plane", "set Width = 1 m\n", "", "3.*/Width'");
  refused("too many cells", "", "set Radial cells = 4000000\n", "5.*/Radial cells'.*coarse mesh");
  refused("grading", "", "set Tip grading = 0\n", "5.*/Tip grading'");
}
} // namespace

UNIT_TEST(cylinder_channel_geometry)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_benchmark("Turek and Hron", Parameters<2>());
  Parameters<2> bare;
  bare.length = 2.2;
  bare.beam_length = 0.;
  test_benchmark("Schaefer and Turek", bare);
  test_symmetry(Parameters<2>());
  test_sizes();
  test_shapes();
  test_space();
  test_distributed<2>("distributed", Parameters<2>());
  Parameters<3> space;
  space.width_cells = 1;
  space.circumferential_cells = 4;
  space.radial_cells = 2;
  space.axial_cells = 5;
  test_distributed<3>("distributed in space", space);
  test_distorted();
  test_input();
}
} // namespace test_of_cylinder_channel_geometry
