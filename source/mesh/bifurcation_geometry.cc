#include <continua/base/angle_entry.h>
#include <continua/base/words.h>
#include <continua/mesh/bifurcation_geometry.h>
#include <continua/mesh/bifurcation_manifold.h>
#include <continua/mesh/branch_axis.h>
#include <continua/mesh/clamped_end.h>
#include <continua/mesh/grading.h>
#include <continua/mesh/tube_geometry.h>

#include <deal.II/base/numbers.h>
#include <deal.II/grid/tria_description.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace Continua
{
using dealii::Point;
using dealii::numbers::PI;
using Sector = TubeCrossSection::Sector;

namespace
{
constexpr unsigned int n_branches = BifurcationGeometry::n_branches;
/// The shape counts counter-clockwise: which of its tubes a branch is, and which branch a tube.
constexpr std::array<unsigned int, n_branches> counter_clockwise = {{0, 2, 1}};
/// How the entries of the branches begin, and what their ends are called.
constexpr std::array<const char *, n_branches> prefixes = {
    {"Parent", "First daughter", "Second daughter"}};
constexpr std::array<const char *, n_branches> names = {
    {"parent", "first daughter", "second daughter"}};
constexpr std::array<const char *, n_branches> ends = {{"inlet", "first outlet", "second outlet"}};
/// The boundary ids after those of the ends, of the fluid and of the wall.
constexpr unsigned int outside_id = 2 * n_branches, side_z_id = outside_id + 1;

std::string wall_end(const unsigned int branch)
{
  return std::string("wall ") + ends[branch] + " end";
}

/// For each vertex of a section the one on the other side of y = 0.
std::vector<unsigned int> mirrored_vertices(const TubeCrossSection &section)
{
  std::map<std::array<double, 2>, unsigned int> numbers;
  const auto key = [](const double y, const double z) {
    return std::array<double, 2>{{y + 0., z + 0.}};
  }; // no negative zero
  for (unsigned int v = 0; v < section.vertices().size(); ++v)
    numbers[key(section.vertices()[v][0], section.vertices()[v][1])] = v;
  std::vector<unsigned int> mirrored;
  for (const Point<2> &vertex : section.vertices())
    mirrored.push_back(numbers.at(key(-vertex[0], vertex[1])));
  return mirrored;
}

/// The numbers of the vertices on the half-surfaces at a tube's begin, for each tube and vertex of
/// the section: neighbours have the same ones.
std::array<std::vector<unsigned int>, n_branches> number_junction(const TubeCrossSection &section,
                                                                  const BifurcationShape &shape,
                                                                  std::vector<Point<3>> &vertices)
{
  const std::vector<unsigned int> mirrored = mirrored_vertices(section);
  const unsigned int n = section.vertices().size();
  std::array<std::vector<unsigned int>, n_branches> numbers;
  // The tube clockwise of a half-surface makes its vertices, the first one those of the line that
  // is common to all.
  for (unsigned int tube = 0; tube < n_branches; ++tube)
  {
    numbers[tube].assign(n, dealii::numbers::invalid_unsigned_int);
    for (unsigned int v = 0; v < n; ++v)
    {
      const Point<2> &place = section.vertices()[v];
      if (place[0] > 0. || (place[0] == 0. && tube == 0))
      {
        numbers[tube][v] = vertices.size();
        vertices.push_back(shape.point(tube, {0., place[0], place[1]}));
      }
    }
  }
  for (unsigned int tube = 0; tube < n_branches; ++tube)
    for (unsigned int v = 0; v < n; ++v)
    {
      const double y = section.vertices()[v][0];
      if (y == 0.)
        numbers[tube][v] = numbers[0][v];
      else if (y < 0.)
        numbers[tube][v] = numbers[(tube + n_branches - 1) % n_branches][mirrored[v]];
    }
  return numbers;
}

void refuse_folded_mesh(const ParameterSection &geometry, const BifurcationShape &shape)
{
  const double determinant = shape.least_scaled_determinant();
  if (determinant < BifurcationGeometry::least_determinant)
    geometry.refuse(geometry.given("First daughter angle") ? "First daughter angle" : "",
                    "where the branches meet, cells would be folded or flat: the least scaled "
                    "determinant is " +
                        shortest_number(std::round(1e3 * determinant) / 1e3) +
                        ", and the mesh needs " +
                        shortest_number(BifurcationGeometry::least_determinant),
                    "Give the daughters a larger angle to each other, or diameters that are closer "
                    "to each other and to the parent's");
}
} // namespace

BifurcationShape BifurcationGeometry::Parameters::shape() const
{
  // In counter-clockwise order, from the parent, which leaves the centre in the direction -x.
  const auto tube = [](const Branch &branch, const double direction) {
    return BifurcationShape::Tube{direction, 0.5 * branch.inner_diameter, branch.wall_thickness};
  };
  return BifurcationShape(centre(), {{tube(branches[0], PI), tube(branches[2], -branches[2].angle),
                                      tube(branches[1], branches[1].angle)}});
}

BifurcationGeometry::Parameters BifurcationGeometry::Parameters::read(ParameterSection geometry,
                                                                      ParameterSection mesh)
{
  Parameters parameters;
  for (unsigned int i = 0; i < n_branches; ++i)
  {
    Branch &branch = parameters.branches[i];
    const std::string prefix = prefixes[i];
    const bool is_parent = i == 0;
    geometry.add(prefix + " length", branch.length, Dimensions::length,
                 is_parent ? "Length of the parent's axis, from the inlet to the point where the "
                             "three axes meet [m]"
                           : "Length of the daughter's axis, from the point where the three axes "
                             "meet to the outlet [m]",
                 Range::positive());
    geometry.add(prefix + " inner diameter", branch.inner_diameter, Dimensions::length,
                 "Diameter of the fluid column [m]", Range::positive());
    geometry.add(prefix + " wall thickness", branch.wall_thickness, Dimensions::length,
                 "Thickness of the wall, all its layers together [m]", Range::positive());
    if (is_parent)
      continue;
    const std::string angle = prefix + " angle";
    add_angle(geometry, angle, branch.angle,
              std::string("Angle between the continuation of the parent's axis and the "
                          "daughter's, towards ") +
                  (i == 1 ? "+y" : "-y") + "; positive");
    if (branch.angle <= 0.)
      geometry.refuse(angle, "the angle is not positive",
                      "Give a positive one: the first daughter turns towards +y, the second one "
                      "towards -y");
    if (branch.angle >= 0.5 * PI)
      geometry.refuse(angle, "the daughter would turn by a right angle or more",
                      "Give an angle below 90 deg");
  }
  parameters.layers = WallLayers::read(geometry);
  if (parameters.layers.names.empty())
    geometry.refuse("Wall layers", "a bifurcation has a wall", "Give its layers a name");
  add_choice(
      geometry, "Sector", parameters.sector, {{"half", Sector::half}, {"full", Sector::full}},
      "Which part of the vessel there is: the half z >= 0, whose plane of symmetry is the "
      "boundary 'side z' (z = 0), on which a symmetric flow has Type = roller; or all of it");

  for (unsigned int i = 0; i < n_branches; ++i)
    mesh.add(std::string(prefixes[i]) + " cells", parameters.branches[i].axial_cells,
             "Coarse cells along the axis of this branch", 2);
  add_axial_grading(mesh, parameters.axial_grading,
                    "wall inlet end, wall first outlet end and wall second outlet end");
  parameters.section.read(mesh, parameters.layers.names.size(), 3);

  const BifurcationShape shape = parameters.shape();
  refuse_folded_mesh(geometry, shape);
  for (unsigned int i = 0; i < n_branches; ++i)
  {
    const double reach = shape.reach(counter_clockwise[i]);
    if (parameters.branches[i].length <= reach)
      geometry.refuse(std::string(prefixes[i]) + " length",
                      "the branch would end where it is not yet a round tube: the junction "
                      "reaches " +
                          shortest_number(1e-7 * std::ceil(1e7 * reach)) +
                          " m from the point where the axes meet",
                      "Give a longer one, or the daughters a larger angle to each other");
  }
  return parameters;
}

BifurcationGeometry::BifurcationGeometry(const Parameters &parameters)
    : parameters(parameters),
      stack(parameters.section.stack(parameters.layers.fractions, 3)),
      shape(std::make_shared<BifurcationShape>(parameters.shape()))
{
  for (unsigned int i = 0; i < n_branches; ++i)
    Assert(parameters.branches[i].length > shape->reach(counter_clockwise[i]),
           dealii::ExcInternalError());
}

std::vector<std::string> BifurcationGeometry::regions() const
{
  std::vector<std::string> result = {"fluid"};
  result.insert(result.end(), parameters.layers.names.begin(), parameters.layers.names.end());
  return result;
}

std::vector<std::string> BifurcationGeometry::boundaries() const
{
  std::vector<std::string> result(ends.begin(), ends.end());
  for (unsigned int i = 0; i < n_branches; ++i)
    result.push_back(wall_end(i));
  result.push_back("outside");
  if (parameters.sector == Sector::half)
    result.push_back("side z");
  return result;
}

void BifurcationGeometry::note_held_boundaries(const std::set<std::string> &names)
{
  for (unsigned int i = 0; i < n_branches; ++i)
    parameters.branches[i].held = names.count(ends[i]) > 0 || names.count(wall_end(i)) > 0;
}

std::vector<double> BifurcationGeometry::axial_points(const unsigned int i) const
{
  const Parameters::Branch &branch = parameters.branches[i];
  const double reach = shape->reach(counter_clockwise[i]);
  const double equal = branch.length / branch.axial_cells;
  const unsigned int n_in_junction =
      std::clamp(static_cast<unsigned int>(std::lround(reach / equal)), 1u, branch.axial_cells - 1);
  std::array<double, 2> end_cells;
  end_cells.fill(std::numeric_limits<double>::infinity());
  if (branch.held)
    end_cells[1] = clamped_end_cell(parameters.axial_grading, equal, 0.5 * branch.inner_diameter,
                                    branch.wall_thickness);
  std::vector<double> points = {0.};
  append_graded_cells(points, reach, n_in_junction, 1.);
  const std::vector<double> on_tube =
      points_with_end_zones(reach, branch.length, branch.axial_cells - n_in_junction, end_cells,
                            TubeGeometry<3>::axial_growth);
  points.insert(points.end(), on_tube.begin() + 1, on_tube.end());
  return points;
}

void BifurcationGeometry::create(dealii::Triangulation<3> &triangulation) const
{
  const TubeCrossSection section(stack.points(), parameters.section.circumferential_cells / 2,
                                 parameters.sector);
  const unsigned int n_section_vertices = section.vertices().size();
  const unsigned int n_section_cells = section.cells().size();
  std::vector<Point<3>> vertices;
  const auto junction = number_junction(section, *shape, vertices);

  std::vector<dealii::CellData<3>> cells;
  std::vector<unsigned int> branch_of_cell;
  for (unsigned int i = 0; i < n_branches; ++i)
  {
    const unsigned int tube = counter_clockwise[i];
    const std::vector<double> axial = axial_points(i);
    const unsigned int first_vertex = vertices.size();
    for (std::size_t k = 1; k < axial.size(); ++k)
      for (const Point<2> &vertex : section.vertices())
        vertices.push_back(shape->point(tube, {axial[k], vertex[0], vertex[1]}));
    const auto number = [&](const std::size_t k, const unsigned int v)
    { return k == 0 ? junction[tube][v] : first_vertex + (k - 1) * n_section_vertices + v; };
    for (std::size_t k = 0; k + 1 < axial.size(); ++k)
      for (const TubeCrossSection::Cell &section_cell : section.cells())
      {
        dealii::CellData<3> cell;
        for (unsigned int v = 0; v < 8; ++v)
          cell.vertices[v] = number(k + v % 2, section_cell.vertices[v / 2]);
        cell.material_id = section_cell.is_core ? 0 : stack.region(section_cell.ring);
        cells.push_back(cell);
        branch_of_cell.push_back(i);
      }
  }
  triangulation.create_triangulation(vertices, cells, dealii::SubCellData());

  for (const auto &cell : triangulation.cell_iterators_on_level(0))
    for (const unsigned int f : cell->face_indices())
      if (cell->face(f)->at_boundary())
      {
        const unsigned int branch = branch_of_cell[cell->index()];
        const auto face = cell->face(f);
        const bool is_end = f == 1;
        const bool is_in_plane = face->vertex(0)[2] == 0. && face->vertex(3)[2] == 0.;
        face->set_all_boundary_ids(is_end
                                       ? (cell->material_id() == 0 ? branch : n_branches + branch)
                                   : is_in_plane ? side_z_id
                                                 : outside_id);
      }
  // Rings last, and one branch after the other: all charts agree on the surfaces between them.
  using Part = BifurcationManifold::Part;
  for (const Part part : {Part::core, Part::rings})
  {
    const unsigned int first_id = part == Part::core ? 0 : n_branches;
    for (const auto &cell : triangulation.cell_iterators_on_level(0))
      if (section.cells()[cell->index() % n_section_cells].is_core == (part == Part::core))
        cell->set_all_manifold_ids(first_id + branch_of_cell[cell->index()]);
    for (unsigned int i = 0; i < n_branches; ++i)
      triangulation.set_manifold(first_id + i,
                                 BifurcationManifold(shape, counter_clockwise[i], part));
  }
}

MeshExtent BifurcationGeometry::extent() const
{
  double n_layers = 0.;
  for (const Parameters::Branch &branch : parameters.branches)
    n_layers += branch.axial_cells;
  const double n_quarters = static_cast<unsigned int>(parameters.sector);
  return {n_layers * n_quarters *
              parameters.section.n_cells_of_quarter(parameters.layers.names.size()),
          n_layers};
}

std::unique_ptr<Geometry<3>> BifurcationGeometry::coarsened(const double most_cells) const
{
  // The cross-section stays.
  Parameters coarse = parameters;
  const double part = std::min(1., most_cells / extent().n_cells);
  for (Parameters::Branch &branch : coarse.branches)
    branch.axial_cells = std::max(2u, static_cast<unsigned int>(part * branch.axial_cells));
  return std::make_unique<BifurcationGeometry>(coarse);
}

std::vector<VesselBranch<3>> BifurcationGeometry::branches() const
{
  std::vector<VesselBranch<3>> result;
  for (unsigned int i = 0; i < n_branches; ++i)
  {
    const Parameters::Branch &branch = parameters.branches[i];
    const bool is_parent = i == 0;
    const unsigned int number = counter_clockwise[i];
    const Point<3> centre = parameters.centre();
    const Point<3> end = shape->point(number, {branch.length, 0., 0.});
    TubeLaw law = TubeLaw::uniform(branch.length, branch.inner_diameter, branch.wall_thickness);
    law.set_layers(parameters.layers.names, parameters.layers.fractions);
    const double reach = shape->reach(number);
    const std::array<double, 2> tube = {
        {is_parent ? 0. : reach, is_parent ? branch.length - reach : branch.length}};
    result.push_back(
        {names[i],
         law,
         std::make_shared<BranchAxis>(is_parent ? end : centre, is_parent ? centre : end, tube,
                                      0.5 * branch.inner_diameter + branch.wall_thickness),
         {{ends[i], wall_end(i), is_parent ? 0. : branch.length}}});
  }
  return result;
}
} // namespace Continua
