#include <continua/mesh/cylinder_channel_geometry.h>
#include <continua/mesh/cylinder_sector_manifold.h>
#include <continua/mesh/grading.h>

#include <deal.II/base/numbers.h>
#include <deal.II/grid/tria_description.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <sstream>
#include <utility>

namespace Continua
{
using dealii::Point;
using dealii::numbers::PI;

namespace
{
constexpr unsigned int fluid_region = 0, beam_region = 1;
constexpr unsigned int inlet = 0, outlet = 1, bottom = 2, top = 3, cylinder = 4, beam_root = 5;
constexpr unsigned int no_boundary = dealii::numbers::invalid_unsigned_int;

/// The largest thickness of the beam over the diameter: beyond it the cells between the beam and
/// the diagonal of the square would be slivers.
constexpr double thickest_beam = 0.6;
/// The shortest beam over the radius, and the narrowest gap between cylinder and walls over it.
constexpr double shortest_beam = 0.5, narrowest_gap = 0.05;
/// Neighbours behind the tip differ by this factor at most, where the number of cells allows.
constexpr double wake_growth = 1.3;

/// Appends the ends of `n_cells` cells up to `end` that grow from `first`, or, where that would
/// make them grow too fast, from a longer one.
void append_growing_cells(std::vector<double> &points,
                          const double end,
                          const unsigned int n_cells,
                          const double first)
{
  const double ratio = ratio_for_last_cell(n_cells, first / (end - points.back()), wake_growth);
  append_graded_cells(points, end, n_cells, 1. / ratio);
}

std::vector<double>
graded_cells(const double begin, const double end, const unsigned int n_cells, const double ratio)
{
  std::vector<double> points = {begin};
  append_graded_cells(points, end, n_cells, ratio);
  return points;
}

std::string in_metres(const double length)
{
  std::ostringstream text;
  text << length << " m";
  return text.str();
}
} // namespace

/// The vertices and cells in the plane; a cell's vertices and faces are in deal.II's order.
template <int dim>
struct CylinderChannelGeometry<dim>::Section
{
  struct Cell
  {
    std::array<unsigned int, 4> vertices;
    unsigned int region = fluid_region;
    /// For its faces; those inside have none.
    std::array<unsigned int, 4> boundaries = {{no_boundary, no_boundary, no_boundary, no_boundary}};
    unsigned int manifold = 0; ///< 1 + the number of the sector; 0: flat
  };

  /// The number of the vertex at this very point, which is entered if it is new.
  unsigned int vertex(const double x, const double y)
  {
    const auto [entry, is_new] = numbers.emplace(std::make_pair(x, y), vertices.size());
    if (is_new)
      vertices.emplace_back(x, y);
    return entry->second;
  }

  /// Appends the rectangles between these coordinates.
  void add_rectangles(const std::vector<double> &x, const std::vector<double> &y)
  {
    for (std::size_t j = 0; j + 1 < y.size(); ++j)
      for (std::size_t i = 0; i + 1 < x.size(); ++i)
      {
        Cell cell;
        cell.vertices = {{vertex(x[i], y[j]), vertex(x[i + 1], y[j]), vertex(x[i], y[j + 1]),
                          vertex(x[i + 1], y[j + 1])}};
        cells.push_back(cell);
      }
  }

  std::vector<Point<2>> vertices;
  std::vector<Cell> cells;

private:
  std::map<std::pair<double, double>, unsigned int> numbers;
};

template <int dim>
typename CylinderChannelGeometry<dim>::Parameters
CylinderChannelGeometry<dim>::Parameters::read(ParameterSection geometry, ParameterSection mesh)
{
  Parameters parameters;
  geometry.add("Length", parameters.length, Dimensions::length,
               "Extent of the channel along x, from the inlet at x = 0 [m]", Range::positive());
  geometry.add("Height", parameters.height, Dimensions::length,
               "Extent of the channel along y, from the bottom at y = 0 [m]", Range::positive());
  geometry.add("Cylinder x", parameters.cylinder_x, Dimensions::length,
               "Distance of the cylinder's axis from the inlet [m]", Range::positive());
  geometry.add("Cylinder y", parameters.cylinder_y, Dimensions::length,
               "Distance of the cylinder's axis from the bottom [m]", Range::positive());
  geometry.add("Cylinder radius", parameters.cylinder_radius, Dimensions::length,
               "Radius of the cylinder, which is a hole in the channel [m]", Range::positive());
  geometry.add("Beam length", parameters.beam_length, Dimensions::length,
               "Distance of the beam's tip from the cylinder's rearmost point, x = 'Cylinder x' + "
               "'Cylinder radius', where the beam's centre line is attached; 0: no beam [m]",
               Range::not_negative());

  const double radius = parameters.cylinder_radius;
  const double rear = parameters.cylinder_x + radius;
  // Half a radius behind the cylinder, the least that a beam needs, is a gap wide enough, too.
  const auto check_gap = [&](const std::string &entry, const double gap, const std::string &wall)
  {
    if (gap < narrowest_gap * radius)
      geometry.refuse(entry,
                      gap <= 0. ? "the cylinder touches the " + wall + " or is beyond it"
                                : "the gap between the cylinder and the " + wall + " is " +
                                      in_metres(gap) + ", too narrow for cells of use",
                      "Leave at least 5 % of 'Cylinder radius' between them, by a smaller radius, "
                      "another place or a larger channel");
  };
  check_gap("Cylinder x", parameters.cylinder_x - radius, "inlet");
  check_gap("Cylinder x", parameters.length - rear, "outlet");
  check_gap("Cylinder y", parameters.cylinder_y - radius, "bottom");
  check_gap("Cylinder y", parameters.height - parameters.cylinder_y - radius, "top");

  mesh.add("Circumferential cells", parameters.circumferential_cells,
           "Coarse cells along a quarter of the cylinder's circumference; an even number. A square "
           "around the cylinder has as many along each side. Behind a cylinder with a beam half of "
           "them are above the beam and half below it",
           2);
  if (parameters.circumferential_cells % 2 != 0)
    mesh.refuse("Circumferential cells", "the number is odd",
                "Give an even one: half of them are on each side of the beam's centre line");
  mesh.add("Radial cells", parameters.radial_cells,
           "Coarse cells from the cylinder to the square around it, whose half side is twice the "
           "radius, or less where a wall or the tip is near",
           1);
  mesh.add("Cylinder grading", parameters.cylinder_grading, Dimensions::none,
           "Size of the cell at the cylinder over that at the square, along the radius; below one "
           "the cells are small at the cylinder",
           grading_range);
  mesh.add("Upstream cells", parameters.upstream_cells,
           "Coarse cells along x from the inlet to the square around the cylinder", 1);
  mesh.add("Transverse cells", parameters.transverse_cells,
           "Coarse cells along y from the bottom to the square around the cylinder, and as many "
           "from the square to the top",
           1);
  mesh.add("Wall grading", parameters.wall_grading, Dimensions::none,
           "Of 'Transverse cells', size of that at the wall over that at the square; below one the "
           "cells are small at the bottom and the top",
           grading_range);
  mesh.add("Axial cells", parameters.axial_cells,
           "Coarse cells along x from the beam's tip (without a beam, from the square around the "
           "cylinder) to the outlet. They grow from the length of the cell before them, by a "
           "factor of 1.3 at most from one to the next: with too few cells, the first one is "
           "longer",
           1);
  if (parameters.has_beam())
  {
    geometry.add("Beam thickness", parameters.beam_thickness, Dimensions::length,
                 "Extent of the beam along y; half of it is above 'Cylinder y' [m]",
                 Range::positive());
    if (parameters.beam_length < shortest_beam * radius)
      geometry.refuse("Beam length", "it is less than half the cylinder's radius",
                      "Give a longer beam, or 0 for none");
    if (parameters.beam_thickness > 2. * thickest_beam * radius)
      geometry.refuse("Beam thickness",
                      "it is more than 60 % of the cylinder's diameter, " +
                          in_metres(2. * thickest_beam * radius),
                      "Give a thinner beam or a larger 'Cylinder radius'");
    const double tip = rear + parameters.beam_length;
    if (parameters.length - tip < parameters.beam_thickness)
      geometry.refuse("Beam length",
                      "the tip would be at x = " + in_metres(tip) +
                          (tip < parameters.length ? ", nearer to the outlet than 'Beam thickness'"
                                                   : ", not before the outlet"),
                      "Give a shorter beam or a longer channel");
    mesh.add("Beam cells", parameters.beam_cells, "Coarse cells across the beam, along y", 1);
    mesh.add("Beam axial cells", parameters.beam_axial_cells,
             "Coarse cells along the beam, from the square around the cylinder to the tip; between "
             "the cylinder and the square it has 'Radial cells'",
             1);
    mesh.add("Beam grading", parameters.beam_grading, Dimensions::none,
             "Size across of the fluid's cell at the beam over that farthest from it in the height "
             "of the square around the cylinder; below one the cells are small at the beam",
             grading_range);
    mesh.add("Tip grading", parameters.tip_grading, Dimensions::none,
             "Of 'Beam axial cells', length of that at the tip over that at the square around the "
             "cylinder; below one the cells are small at the tip, those behind it as well",
             grading_range);
  }
  if (dim == 3)
  {
    geometry.add("Width", parameters.width, Dimensions::length, "Extent along z [m]",
                 Range::positive());
    mesh.add("Width cells", parameters.width_cells, "Coarse cells along z", 1);
  }
  return parameters;
}

template <int dim>
CylinderChannelGeometry<dim>::CylinderChannelGeometry(const Parameters &parameters)
    : parameters(parameters)
{
}

template <int dim>
std::vector<std::string> CylinderChannelGeometry<dim>::regions() const
{
  if (parameters.has_beam())
    return {"fluid", "beam"};
  return {"fluid"};
}

template <int dim>
std::vector<std::string> CylinderChannelGeometry<dim>::boundaries() const
{
  std::vector<std::string> names = {"inlet", "outlet", "bottom", "top", "cylinder"};
  if (parameters.has_beam())
    names.push_back("beam root");
  if (dim == 3)
    names.insert(names.end(), {"back", "front"});
  return names;
}

template <int dim>
double CylinderChannelGeometry<dim>::half_side() const
{
  const double radius = parameters.cylinder_radius;
  double gap = std::min({parameters.cylinder_x, parameters.cylinder_y,
                         parameters.height - parameters.cylinder_y,
                         parameters.length - parameters.cylinder_x}) -
               radius;
  if (parameters.has_beam())
    gap = std::min(gap, parameters.beam_length);
  return radius + std::min(radius, 0.5 * gap);
}

template <int dim>
auto CylinderChannelGeometry<dim>::lines() const -> std::vector<Lines>
{
  CylinderSector sector;
  sector.centre = Point<2>(parameters.cylinder_x, parameters.cylinder_y);
  sector.radius = parameters.cylinder_radius;
  sector.half_side = half_side();
  sector.angles = {{-0.25 * PI, 0.25 * PI}};
  sector.sides = {{-sector.half_side, sector.half_side}};
  const std::vector<double> equal = graded_cells(0., 1., parameters.circumferential_cells, 1.);

  std::vector<Lines> result;
  if (parameters.has_beam())
  {
    const double half_thickness = 0.5 * parameters.beam_thickness;
    const double beam_angle = std::asin(half_thickness / sector.radius);
    CylinderSector below = sector, beam = sector, above = sector;
    below.angles[1] = -beam_angle;
    below.sides[1] = -half_thickness;
    beam.angles = {{-beam_angle, beam_angle}};
    beam.sides = {{-half_thickness, half_thickness}};
    beam.is_beam = true;
    above.angles[0] = beam_angle;
    above.sides[0] = half_thickness;
    result.push_back({below, graded_cells(0., 1., cells_beside_beam(), parameters.beam_grading)});
    result.push_back({beam, graded_cells(0., 1., parameters.beam_cells, 1.)});
    result.push_back(
        {above, graded_cells(0., 1., cells_beside_beam(), 1. / parameters.beam_grading)});
  }
  else
    result.push_back({sector, equal});
  for (sector.quarter = 1; sector.quarter < 4; ++sector.quarter)
    result.push_back({sector, equal});
  return result;
}

template <int dim>
auto CylinderChannelGeometry<dim>::section() const -> Section
{
  const std::vector<Lines> all_lines = lines();
  const double half = half_side();
  const double left = parameters.cylinder_x - half, right = parameters.cylinder_x + half;
  const double low = parameters.cylinder_y - half, high = parameters.cylinder_y + half;
  const std::vector<double> layers =
      graded_cells(0., 1., parameters.radial_cells, 1. / parameters.cylinder_grading);

  // Around the square: the coordinates of the rows and columns.
  const std::vector<double> x_upstream = graded_cells(0., left, parameters.upstream_cells, 1.);
  const std::vector<double> x_square =
      graded_cells(left, right, parameters.circumferential_cells, 1.);
  const std::vector<double> y_left = graded_cells(low, high, parameters.circumferential_cells, 1.);
  const std::vector<double> y_below =
      graded_cells(0., low, parameters.transverse_cells, 1. / parameters.wall_grading);
  const std::vector<double> y_above =
      graded_cells(high, parameters.height, parameters.transverse_cells, parameters.wall_grading);
  std::vector<double> y_right = {low};
  for (const Lines &part : all_lines)
    if (part.sector.quarter == 0)
      for (std::size_t k = 1; k < part.places.size(); ++k)
        y_right.push_back(part.sector.point(1., part.places[k])[1]);
  y_right.back() = high;

  std::vector<double> x_right = {right};
  double last_cell = (1. - layers[layers.size() - 2]) * (half - parameters.cylinder_radius);
  if (parameters.has_beam())
  {
    const double tip = parameters.cylinder_x + parameters.cylinder_radius + parameters.beam_length;
    append_graded_cells(x_right, tip, parameters.beam_axial_cells, parameters.tip_grading);
    last_cell = tip - x_right[x_right.size() - 2];
  }
  append_growing_cells(x_right, parameters.length, parameters.axial_cells, last_cell);

  Section section;
  section.add_rectangles(x_upstream, y_below);
  section.add_rectangles(x_square, y_below);
  section.add_rectangles(x_right, y_below);
  section.add_rectangles(x_upstream, y_left);
  const std::size_t first_behind = section.cells.size();
  section.add_rectangles(x_right, y_right);
  const std::size_t n_columns = x_right.size() - 1;
  section.add_rectangles(x_upstream, y_above);
  section.add_rectangles(x_square, y_above);
  section.add_rectangles(x_right, y_above);
  if (parameters.has_beam())
    for (unsigned int row = 0; row < parameters.beam_cells; ++row)
      for (unsigned int column = 0; column < parameters.beam_axial_cells; ++column)
        section.cells[first_behind + (cells_beside_beam() + row) * n_columns + column].region =
            beam_region;
  for (auto &cell : section.cells)
  {
    const Point<2> &lowest = section.vertices[cell.vertices[0]];
    const Point<2> &highest = section.vertices[cell.vertices[3]];
    if (lowest[0] == 0.)
      cell.boundaries[0] = inlet;
    if (highest[0] == parameters.length)
      cell.boundaries[1] = outlet;
    if (lowest[1] == 0.)
      cell.boundaries[2] = bottom;
    if (highest[1] == parameters.height)
      cell.boundaries[3] = top;
  }

  // Inside the square: for each line, counter-clockwise, its vertices from the circle outwards. The
  // last one is a vertex of the rectangles, which is why its coordinates are taken from them.
  const auto vertex_on_side = [&](const unsigned int quarter, const std::size_t place)
  {
    switch (quarter)
    {
    case 0:
      return Point<2>(right, y_right[place]);
    case 1:
      return Point<2>(x_square[x_square.size() - 1 - place], high);
    case 2:
      return Point<2>(left, y_left[y_left.size() - 1 - place]);
    default:
      return Point<2>(x_square[place], low);
    }
  };
  std::vector<std::vector<unsigned int>> numbers;
  std::array<std::size_t, 4> n_on_side = {{0, 0, 0, 0}};
  for (const Lines &part : all_lines)
    for (std::size_t k = 0; k + 1 < part.places.size(); ++k)
    {
      numbers.emplace_back();
      for (unsigned int layer = 0; layer < parameters.radial_cells; ++layer)
      {
        const Point<2> point = part.sector.point(layers[layer], part.places[k]);
        numbers.back().push_back(section.vertex(point[0], point[1]));
      }
      const std::size_t place = n_on_side[part.sector.quarter]++;
      const Point<2> on_side = vertex_on_side(part.sector.quarter, place);
      numbers.back().push_back(section.vertex(on_side[0], on_side[1]));
    }
  std::size_t number = 0;
  for (std::size_t i = 0; i < all_lines.size(); ++i)
    for (std::size_t k = 0; k + 1 < all_lines[i].places.size(); ++k, ++number)
    {
      const std::vector<unsigned int> &line = numbers[number];
      const std::vector<unsigned int> &next = numbers[(number + 1) % numbers.size()];
      const CylinderSector &sector = all_lines[i].sector;
      for (unsigned int layer = 0; layer < parameters.radial_cells; ++layer)
      {
        typename Section::Cell cell;
        // The lines along the circumference have the direction of x or y, as the rectangles' have.
        const bool is_against = sector.quarter == 1 || sector.quarter == 2;
        if (is_against)
          cell.vertices = {{next[layer], line[layer], next[layer + 1], line[layer + 1]}};
        else
          cell.vertices = {{line[layer], line[layer + 1], next[layer], next[layer + 1]}};
        if (layer == 0)
          cell.boundaries[is_against ? 2 : 0] = sector.is_beam ? beam_root : cylinder;
        cell.region = sector.is_beam ? beam_region : fluid_region;
        cell.manifold = i + 1;
        section.cells.push_back(cell);
      }
    }
  return section;
}

template <int dim>
void CylinderChannelGeometry<dim>::create(dealii::Triangulation<dim> &triangulation) const
{
  const Section plane = section();
  std::vector<double> z = {0.};
  if (dim == 3)
    append_graded_cells(z, parameters.width, parameters.width_cells, 1.);

  std::vector<Point<dim>> vertices;
  vertices.reserve(z.size() * plane.vertices.size());
  for (const double height : z)
    for (const Point<2> &vertex : plane.vertices)
    {
      Point<dim> point;
      point[0] = vertex[0];
      point[1] = vertex[1];
      if constexpr (dim == 3)
        point[2] = height;
      vertices.push_back(point);
    }
  std::vector<dealii::CellData<dim>> cells;
  const std::size_t n_slices = dim == 3 ? parameters.width_cells : 1;
  cells.reserve(n_slices * plane.cells.size());
  for (std::size_t slice = 0; slice < n_slices; ++slice)
    for (const auto &plane_cell : plane.cells)
    {
      dealii::CellData<dim> cell;
      for (unsigned int v = 0; v < cell.vertices.size(); ++v)
        cell.vertices[v] = (slice + v / 4) * plane.vertices.size() + plane_cell.vertices[v % 4];
      cell.material_id = plane_cell.region;
      cells.push_back(cell);
    }
  triangulation.create_triangulation(vertices, cells, dealii::SubCellData());

  // The coarse cells are in the order in which they were given, on every rank.
  const unsigned int back = parameters.has_beam() ? beam_root + 1 : beam_root;
  for (const auto &cell : triangulation.cell_iterators_on_level(0))
  {
    const auto &plane_cell = plane.cells[cell->index() % plane.cells.size()];
    for (const unsigned int f : cell->face_indices())
      if (cell->face(f)->at_boundary())
        cell->face(f)->set_all_boundary_ids(f < 4 ? plane_cell.boundaries[f] : back + (f - 4));
    if (plane_cell.manifold > 0)
      cell->set_all_manifold_ids(plane_cell.manifold);
  }
  const std::vector<Lines> all_lines = lines();
  for (std::size_t i = 0; i < all_lines.size(); ++i)
    triangulation.set_manifold(i + 1, CylinderSectorManifold<dim>(all_lines[i].sector));
}

template <int dim>
MeshExtent CylinderChannelGeometry<dim>::extent() const
{
  // Numbers that are too large for whole ones are refused by whoever asks.
  const double quarter = parameters.circumferential_cells, radial = parameters.radial_cells;
  double columns = parameters.axial_cells, right = quarter;
  if (parameters.has_beam())
  {
    columns += parameters.beam_axial_cells;
    right = 2. * cells_beside_beam() + parameters.beam_cells;
  }
  const double upstream = parameters.upstream_cells, transverse = parameters.transverse_cells;
  MeshExtent extent;
  extent.n_cells = (3. * quarter + right) * radial + upstream * quarter + columns * right +
                   2. * transverse * (upstream + quarter + columns);
  extent.n_layers = upstream + quarter + columns;
  if (dim == 3)
  {
    extent.n_cells *= parameters.width_cells;
    extent.n_layers = std::max<double>(extent.n_layers, parameters.width_cells);
  }
  return extent;
}

template <int dim>
std::unique_ptr<Geometry<dim>>
CylinderChannelGeometry<dim>::coarsened(const double most_cells) const
{
  Parameters coarse = parameters;
  std::vector<unsigned int *> numbers = {
      &coarse.radial_cells, &coarse.upstream_cells,   &coarse.transverse_cells, &coarse.axial_cells,
      &coarse.beam_cells,   &coarse.beam_axial_cells, &coarse.width_cells};
  for (bool is_coarser = true;
       is_coarser && CylinderChannelGeometry<dim>(coarse).extent().n_cells > most_cells;)
  {
    is_coarser = coarse.circumferential_cells > 2;
    coarse.circumferential_cells = 2 * ((coarse.circumferential_cells / 2 + 1) / 2);
    for (unsigned int *number : numbers)
    {
      is_coarser |= *number > 1;
      *number = (*number + 1) / 2;
    }
  }
  return std::make_unique<CylinderChannelGeometry<dim>>(coarse);
}

template class CylinderChannelGeometry<2>;
template class CylinderChannelGeometry<3>;
} // namespace Continua
