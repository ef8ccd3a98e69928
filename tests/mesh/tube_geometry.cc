#include <continua/mesh/tube_geometry.h>

#include "../unit_test.h"
#include "curved_measures.h"
#include "geometry_text.h"
#include "mesh_measures.h"

#include <deal.II/distributed/tria.h>

#include <algorithm>
#include <map>

namespace test_of_tube_geometry
{
using namespace Continua;
using dealii::Point;
using dealii::numbers::PI;
using geometry_text::joined;

namespace
{
template <int dim>
measures::CurvedMeasures<dim> curved(const measures::Measures<dim> &tube, const unsigned int degree)
{
  return {tube.region_names, tube.boundary_names, tube.mesh, degree};
}

/// Volume (in two dimensions, area) of a region as a discretisation with curved cells sees it.
template <int dim>
double volume(const measures::Measures<dim> &tube,
              const std::string &region,
              const unsigned int mapping_degree)
{
  return curved(tube, mapping_degree).volumes.at(region);
}

/// Area (length) of a boundary, alike; `normal` becomes the sum of its normals times area.
template <int dim>
double area(const measures::Measures<dim> &tube,
            const std::string &boundary,
            const unsigned int mapping_degree,
            dealii::Tensor<1, dim> &normal)
{
  const measures::CurvedMeasures<dim> measured = curved(tube, mapping_degree);
  normal = measured.normals.at(boundary);
  return measured.areas.at(boundary);
}

void test_section()
{
  TubeGeometry<2>::Parameters parameters;
  parameters.law = TubeLaw::uniform(0.8, 0.01, 0.001);
  parameters.axial_cells = 5;
  parameters.axial_grading = 0.5;
  parameters.radial_cells = 4;
  parameters.radial_grading = 0.2;
  parameters.wall_cells = {2};
  TubeGeometry<2> geometry(parameters);
  geometry.note_held_boundaries({"wall inlet end"});
  const measures::Measures<2> tube(geometry);
  check::equal("regions", joined(tube.region_names), "fluid; wall; ");
  check::absolute("cells", tube.mesh.n_cells(), 30., 0.);
  check::relative("fluid", tube.region("fluid"), 0.004, 1e-13);
  check::relative("wall", tube.region("wall"), 0.0008, 1e-13);
  check::relative("inlet", tube.boundary("inlet"), 0.005, 1e-13);
  check::relative("outlet", tube.boundary("outlet"), 0.005, 1e-13);
  check::relative("wall inlet end", tube.boundary("wall inlet end"), 0.001, 1e-13);
  check::relative("wall outlet end", tube.boundary("wall outlet end"), 0.001, 1e-13);
  check::relative("axis", tube.boundary("axis"), 0.8, 1e-13);
  check::relative("outside", tube.boundary("outside"), 0.8, 1e-13);

  double at_axis = 0.;
  double at_wall = 0.;
  double at_inlet = 0.;
  double at_outlet = 0.;
  for (const auto &cell : tube.mesh.active_cell_iterators())
  {
    if (cell->at_boundary(2))
      at_axis = cell->extent_in_direction(1);
    if (cell->material_id() == 0 && cell->neighbor(3)->material_id() == 1)
      at_wall = cell->extent_in_direction(1);
    if (cell->at_boundary(0))
      at_inlet = cell->extent_in_direction(0);
    if (cell->at_boundary(1))
      at_outlet = cell->extent_in_direction(0);
  }
  check::relative("radial grading", at_wall / at_axis, 0.2, 1e-12);
  // Half of 0.16 m, 0.12 m, 0.18 m and two equal ones.
  check::relative("axial grading", at_inlet, 0.08, 1e-12);
  check::relative("equal cells", at_outlet, 0.21, 1e-12);
}

/// The lengths of the cells along the axis, in their order.
std::vector<double> axial_cells(const TubeGeometry<2> &tube)
{
  dealii::Triangulation<2> mesh;
  tube.create(mesh);
  // Cells of one column have the same centre but for the last digits.
  std::map<long, double> lengths;
  for (const auto &cell : mesh.active_cell_iterators())
    lengths[std::lround(1e9 * cell->center()[0])] = cell->vertex(1)[0] - cell->vertex(0)[0];
  std::vector<double> result;
  for (const auto &[x, length] : lengths)
    result.push_back(length);
  return result;
}

void test_automatic_grading()
{
  // Tube A: sqrt(12.5 mm 0.1 mm) / 2 = 0.559 mm, and equal cells of 446 mm / 200 = 2.23 mm.
  const double bending = 0.5 * std::sqrt(1.25e-6), equal = 0.446 / 200.;
  TubeGeometry<2>::Parameters parameters;
  parameters.law = TubeLaw::thesis('A');
  parameters.axial_cells = 200;
  parameters.radial_cells = 1;
  parameters.wall_cells = {1};
  TubeGeometry<2> tube(parameters);
  const auto extremes = [](const std::vector<double> &lengths)
  { return std::minmax_element(lengths.begin(), lengths.end()); };
  std::vector<double> lengths = axial_cells(tube);
  check::relative("free ends: shortest", *extremes(lengths).first, equal, 1e-9);
  check::relative("free ends: longest", *extremes(lengths).second, equal, 1e-9);

  tube.note_held_boundaries({"inlet", "outlet", "wall inlet end", "wall outlet end"});
  lengths = axial_cells(tube);
  check::relative("clamped ends: first", lengths.front(), bending, 1e-9);
  check::relative("clamped ends: second", lengths[1], 1.5 * bending, 1e-9);
  check::relative("clamped ends: last", lengths.back(), bending, 1e-9);
  const double longest = *extremes(lengths).second;
  check::is_true("clamped ends: longest at most 1.05 of equal cells", longest < 1.05 * equal);
  double rest = 0.;
  for (std::size_t i = 4; i + 4 < lengths.size(); ++i)
    rest = std::max(rest, std::abs(lengths[i] / longest - 1.));
  check::absolute("clamped ends: the rest is equal", rest, 0., 1e-9);

  tube.note_held_boundaries({"wall outlet end"});
  lengths = axial_cells(tube);
  check::relative("clamped outlet: first", lengths.front(), *extremes(lengths).second, 1e-9);
  check::relative("clamped outlet: last", lengths.back(), bending, 1e-9);

  // A prescribed flow rate holds the rim of a wall whose end slides.
  tube.note_held_boundaries({"inlet"});
  lengths = axial_cells(tube);
  check::relative("held inlet: first", lengths.front(), bending, 1e-9);
  check::relative("held inlet: last", lengths.back(), *extremes(lengths).second, 1e-9);

  // Each end has its own length: R and h of tube F are halved at the outlet.
  parameters.law = TubeLaw::thesis('F');
  TubeGeometry<2> tapered(parameters);
  tapered.note_held_boundaries({"wall inlet end", "wall outlet end"});
  lengths = axial_cells(tapered);
  check::relative("taper: first", lengths.front(), bending, 1e-9);
  check::relative("taper: last", lengths.back(), 0.5 * bending, 1e-9);

  // Cells in the layer at the wall: R / 128.
  parameters.law = TubeLaw::thesis('A');
  parameters.radial_cells = 6;
  parameters.axial_cells = 1;
  dealii::Triangulation<2> mesh;
  TubeGeometry<2>(parameters).create(mesh);
  for (const auto &cell : mesh.active_cell_iterators())
    if (cell->material_id() == 0 && cell->neighbor(3)->material_id() == 1)
      check::relative("cell at the wall", cell->extent_in_direction(1), 12.5e-3 / 128., 1e-9);
}

void test_laws()
{
  // Half the section of C: the fluid's is D L / 2; the wall's h* D times the integral of 1 / D*,
  // which is L / (D* (L) - D* (0)) log(D* (L) / D* (0)).
  TubeGeometry<2>::Parameters parameters;
  parameters.law = TubeLaw::thesis('C');
  parameters.law.set_layers({"inner", "outer"}, {0.25, 0.75});
  parameters.axial_cells = 8;
  parameters.axial_grading = 1.;
  measures::Measures<2> c(TubeGeometry<2>{parameters});
  check::equal("layers", joined(c.region_names), "fluid; inner; outer; ");
  const double exact_wall = 0.05e-3 * 25. * 0.446 / 12.5 * std::log(2.);
  check::relative("C: fluid", volume(c, "fluid", 2), 0.0125 * 0.446, 1e-13);
  check::relative("C: outer layer", volume(c, "outer", 3), 0.75 * exact_wall, 1e-6);
  c.mesh.refine_global(2);
  // The trapezoidal rule on 32 cells: (1/32)^2 / 12 * (f'(1) - f'(0)) / int f = 9e-5, f = 1 / (1 -
  // x / 2).
  check::relative("C: outer layer, refined", volume(c, "outer", 1), 0.75 * exact_wall, 1e-4);
  check::relative("C: wall outlet end", c.boundary("wall outlet end"), 0.1e-3, 1e-11);

  parameters.law = TubeLaw::thesis('D');
  const measures::Measures<2> d(TubeGeometry<2>{parameters});
  check::relative("D: fluid", d.region("fluid"), 0.5 * 0.01875 * 0.446, 1e-13);
  check::relative("D: outside", d.boundary("outside"), std::hypot(0.446, 0.00625), 1e-13);
  check::is_true("law", TubeGeometry<2>(parameters).branches().front().law.name() == "D");
}

TubeGeometry<3>::Parameters coarse(const TubeLaw &law, const TubeCrossSection::Sector sector)
{
  TubeGeometry<3>::Parameters parameters;
  parameters.law = law;
  parameters.sector = sector;
  parameters.axial_cells = 2;
  parameters.axial_grading = 1.;
  parameters.radial_cells = 2;
  parameters.radial_grading = 0.5;
  parameters.circumferential_cells = 2;
  return parameters;
}

void test_space()
{
  const TubeLaw law = TubeLaw::uniform(0.5, 2., 0.4);
  measures::Measures<3> quarter(TubeGeometry<3>(coarse(law, TubeCrossSection::Sector::quarter)));
  check::equal("quarter: boundaries", joined(quarter.boundary_names),
               "inlet; outlet; wall inlet end; wall outlet end; outside; side y; side z; ");
  check::absolute("quarter: cells", quarter.mesh.n_active_cells(), 2. * (1 + 4 + 2), 0.);
  dealii::Tensor<1, 3> normal;
  check::relative("quarter: fluid", volume(quarter, "fluid", 4), PI / 4. * 0.5, 1e-6);
  check::relative("quarter: wall", volume(quarter, "wall", 4), PI / 4. * 0.96 * 0.5, 1e-6);
  check::relative("quarter: inlet", area(quarter, "inlet", 4, normal), PI / 4., 1e-6);
  check::relative("quarter: normal of the inlet", normal[0], -PI / 4., 1e-6);
  check::relative("quarter: wall outlet end", area(quarter, "wall outlet end", 4, normal),
                  PI / 4. * 0.96, 1e-6);
  check::relative("quarter: normal of the outlet", normal[0], PI / 4. * 0.96, 1e-6);
  check::relative("quarter: outside", area(quarter, "outside", 4, normal), PI / 4. * 2.8 * 0.5,
                  1e-6);
  check::relative("quarter: side y", area(quarter, "side y", 4, normal), 1.4 * 0.5, 1e-12);
  check::absolute("quarter: normal of side y", normal[1] + 0.7, 0., 1e-12);
  check::relative("quarter: side z", area(quarter, "side z", 4, normal), 1.4 * 0.5, 1e-12);
  check::absolute("quarter: normal of side z", normal[2] + 0.7, 0., 1e-12);

  quarter.mesh.refine_global(1);
  check::relative("refined: fluid", volume(quarter, "fluid", 2), PI / 4. * 0.5, 1e-4);
  double error = 0.;
  bool in_plane = true;
  for (const auto &cell : quarter.mesh.active_cell_iterators())
    for (const auto &face : cell->face_iterators())
      if (face->at_boundary())
        for (unsigned int v = 0; v < 4; ++v)
        {
          const std::string name = quarter.boundary_names[face->boundary_id()];
          const Point<3> p = face->vertex(v);
          if (name == "outside")
            error = std::max(error, std::abs(std::hypot(p[1], p[2]) - 1.4));
          in_plane &= (name != "side y" || p[1] == 0.) && (name != "side z" || p[2] == 0.);
        }
  check::absolute("refined: vertices on the outside", error, 0., 1e-14);
  check::is_true("refined: vertices on the symmetry planes", in_plane);

  const measures::Measures<3> full(TubeGeometry<3>(coarse(law, TubeCrossSection::Sector::full)));
  check::equal("full: boundaries", joined(full.boundary_names),
               "inlet; outlet; wall inlet end; wall outlet end; outside; ");
  check::relative("full: fluid", volume(full, "fluid", 4), PI * 0.5, 1e-6);
  check::relative("full: wall", volume(full, "wall", 4), PI * 0.96 * 0.5, 1e-6);
  check::relative("full: outside", area(full, "outside", 4, normal), PI * 2.8 * 0.5, 1e-6);
  check::absolute("full: normal of the outside", normal.norm(), 0., 1e-12);

  // The frustum: pi L (R0^2 + R0 R1 + R1^2) / 3, of the fluid and of all.
  measures::Measures<3> cone(TubeGeometry<3>(
      coarse(TubeLaw::taper(2., 2., 1., 0.1, 0.3), TubeCrossSection::Sector::quarter)));
  const double fluid = PI / 4. * 2. * (1. + 0.5 + 0.25) / 3.;
  const double all = PI / 4. * 2. * (1.21 + 1.1 * 0.8 + 0.64) / 3.;
  check::relative("cone: fluid", volume(cone, "fluid", 4), fluid, 1e-6);
  check::relative("cone: wall", volume(cone, "wall", 4), all - fluid, 1e-6);
  check::relative("cone: outlet", area(cone, "outlet", 4, normal), PI / 16., 1e-6);
  cone.mesh.refine_global(1);
  check::relative("cone, refined: wall", volume(cone, "wall", 2), all - fluid, 1e-4);

  // Wide in the middle, by a table: pi times the integral of R^2 = (1 + x (2 - x))^2.
  std::vector<double> x, diameter;
  for (unsigned int i = 0; i <= 400; ++i)
  {
    x.push_back(0.005 * i);
    diameter.push_back(2. * (1. + x[i] * (2. - x[i])));
  }
  const measures::Measures<3> bulge(TubeGeometry<3>(coarse(
      TubeLaw::table(x, diameter, std::vector<double>(x.size(), 0.1), Interpolant::Kind::cubic),
      TubeCrossSection::Sector::quarter)));
  check::relative("bulge", volume(bulge, "fluid", 4), PI / 4. * (2. + 8. / 3. + 16. / 15.), 1e-5);

  TubeGeometry<3>::Parameters thesis =
      coarse(TubeLaw::thesis('F'), TubeCrossSection::Sector::quarter);
  thesis.law.set_layers({"inner", "outer"}, {0.5, 0.5});
  const measures::Measures<3> f((TubeGeometry<3>(thesis)));
  // h = D / 250: the inner layer reaches from R to R (1 + 1 / 250).
  check::relative("F: inner layer", volume(f, "inner", 4),
                  0.446 / 3. * (12.5e-3 * 12.5e-3 * 1.75) * PI / 4. * (1.004 * 1.004 - 1.), 1e-6);
}

template <int dim>
void test_distributed(const std::string &name, const typename TubeGeometry<dim>::Parameters &tube)
{
  dealii::parallel::distributed::Triangulation<dim> mesh(MPI_COMM_WORLD);
  TubeGeometry<dim>(tube).create(mesh);
  dealii::Triangulation<dim> serial;
  TubeGeometry<dim>(tube).create(serial);
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
      1e-12);
}
} // namespace

UNIT_TEST(tube_geometry)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_section();
  test_automatic_grading();
  test_laws();
  test_space();
  TubeGeometry<2>::Parameters section;
  section.law = TubeLaw::thesis('C');
  test_distributed<2>("distributed section", section);
  test_distributed<3>("distributed quarter", coarse(TubeLaw::taper(1., 1., 0.5, 0.1, 0.2),
                                                    TubeCrossSection::Sector::quarter));
  test_distributed<3>("distributed tube", coarse(TubeLaw::taper(1., 1., 0.5, 0.1, 0.2),
                                                 TubeCrossSection::Sector::full));
}
} // namespace test_of_tube_geometry
