#include <continua/base/input_file.h>
#include <continua/base/quoted_name.h>
#include <continua/mesh/gmsh_element_type.h>
#include <continua/mesh/gmsh_file.h>
#include <continua/mesh/gmsh_geometry.h>
#include <continua/mesh/gmsh_mesher.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>

namespace Continua
{
namespace
{
using Shape = GmshElementType::Shape;

std::string plural(const Shape shape)
{
  switch (shape)
  {
  case Shape::triangle:
    return "triangles";
  case Shape::tetrahedron:
    return "tetrahedra";
  case Shape::prism:
    return "prisms";
  case Shape::pyramid:
    return "pyramids";
  default:
    return "";
  }
}

/// "Surface", with which a physical group is declared in a .geo file.
std::string entity_name(const unsigned int dimension)
{
  return dimension == 1 ? "Curve" : dimension == 2 ? "Surface" : "Volume";
}

std::string in_dimensions(const unsigned int dim)
{
  return dim == 2 ? "two-dimensional" : "three-dimensional";
}

GmshFile read_file(const std::string &path, const unsigned int dim, const double meshing_time_limit)
{
  if (std::filesystem::path(path).extension() == ".geo")
    return GmshFile::read(mesh_with_gmsh(path, dim, meshing_time_limit), path);
  try
  {
    return GmshFile::read(read_input_file(path, "mesh"), path);
  }
  catch (const std::invalid_argument &problem)
  {
    throw InputError({path, 0}, "Geometry/File", problem.what(),
                     "Check its name and the permissions");
  }
}

/// The vertices of a cell in deal.II's order, from gmsh's: both go round the lower face, gmsh in a
/// circle, deal.II in rows.
template <int dim>
std::vector<unsigned int> in_rows(std::vector<unsigned int> circle)
{
  std::swap(circle[2], circle[3]);
  if (dim == 3)
    std::swap(circle[6], circle[7]);
  return circle;
}

/// Of a straight cell, as SecondOrderNodes::orientation().
template <int dim>
int straight_orientation(const std::vector<dealii::Point<dim>> &points,
                         const std::vector<unsigned int> &cell)
{
  constexpr unsigned int n = dealii::GeometryInfo<dim>::vertices_per_cell;
  dealii::Point<dim> vertices[n];
  dealii::Tensor<0, dim> determinants[n];
  for (unsigned int v = 0; v < n; ++v)
    vertices[v] = points[cell[v]];
  dealii::GeometryInfo<dim>::alternating_form_at_vertices(vertices, determinants);
  const auto is_positive = [](const double determinant) { return determinant > 0.; };
  const auto is_negative = [](const double determinant) { return determinant < 0.; };
  return std::all_of(determinants, determinants + n, is_positive)   ? 1
         : std::all_of(determinants, determinants + n, is_negative) ? -1
                                                                    : 0;
}

/// Makes the cell positively oriented; false if it is twisted, not convex or has no volume.
template <int dim>
bool orient(const std::vector<dealii::Point<dim>> &points,
            const SecondOrderNodes<dim> &curved_cells,
            std::vector<unsigned int> &cell)
{
  int orientation = curved_cells.empty() ? straight_orientation<dim>(points, cell)
                                         : curved_cells.orientation(cell, points);
  // deal.II takes no cell whose corners alone have a negative volume.
  if (!curved_cells.empty() &&
      orientation * dealii::GridTools::cell_measure<dim>(points, cell) < 0.)
    orientation = 0;
  // A surface whose loop runs clockwise: exchange the two directions.
  if (orientation < 0)
    for (unsigned int v = 0; v < cell.size(); v += 4)
      std::swap(cell[v + 1], cell[v + 2]);
  return orientation != 0;
}

/// The names of the groups of a dimension: those of the file, then the numbers of those without
/// one. `place_of_tag[tag]` becomes the place of the name.
std::vector<std::string> group_names(const GmshFile &file,
                                     const unsigned int dimension,
                                     std::map<int, unsigned int> &place_of_tag)
{
  std::vector<std::string> names;
  for (const GmshFile::Group &group : file.groups)
    if (group.dimension == dimension && !group.name.empty())
    {
      place_of_tag[group.tag] = names.size();
      names.push_back(group.name);
    }
  std::set<int> tags;
  for (const GmshFile::Block &block : file.blocks)
    if (block.dimension == dimension && !block.elements.empty())
      tags.insert(block.groups.begin(), block.groups.end());
  for (const int tag : tags)
    if (place_of_tag.count(tag) == 0)
    {
      place_of_tag[tag] = names.size();
      names.push_back(std::to_string(tag));
    }
  return names;
}

std::vector<unsigned int> sorted(std::vector<unsigned int> indices)
{
  std::sort(indices.begin(), indices.end());
  return indices;
}
} // namespace

template <int dim>
typename GmshGeometry<dim>::Parameters
GmshGeometry<dim>::Parameters::read(ParameterSection geometry, ParameterSection, const bool)
{
  Parameters parameters;
  geometry.add_input_file(
      "File", parameters.file,
      "Mesh of quadrilaterals or hexahedra: a .msh file of gmsh in ASCII, or a .geo file, which is "
      "meshed for the run. Its physical groups are the regions (surfaces; in three dimensions "
      "volumes) and the boundaries (curves; surfaces); a group without a name is called by its "
      "number");
  geometry.require("File");
  const std::string extension = std::filesystem::path(parameters.file).extension().string();
  if (!parameters.file.empty() && extension != ".msh" && extension != ".geo")
    geometry.refuse(
        "File", "'" + parameters.file + "' is called neither .msh nor .geo, the files of gmsh",
        "Give a file of gmsh. It makes one of .unv, .bdf, .vtk and .mesh "
        "(gmsh FILE -save -save_all -format msh41 -o FILE.msh), and of .med and .cgns where "
        "'gmsh -info' names Med and Cgns, as Debian's does not; the Python package "
        "meshio makes one of Abaqus' .inp, .e, .vtu and .vtk of the version 5 (meshio "
        "convert -o gmsh22 --ascii FILE FILE.msh, of UCD's .inp and .ucd with -i avsucd)");
  geometry.add("Unit length", parameters.unit_length, Dimensions::length,
               "What a coordinate of 1 in the file means: 1 mm if it is drawn in millimetres [m]",
               Range::positive());
  geometry.add("Meshing time limit", parameters.meshing_time_limit, Dimensions::time,
               "The wall time after which gmsh is stopped that meshes a .geo file [s]",
               Range::positive());
  geometry.add("Ignored groups", parameters.ignored_groups,
               "Physical groups of the file that are to be no region and no boundary, such as one "
               "that lies on other ones; empty: none");
  geometry.add("Ungrouped cells", parameters.ungrouped_cells,
               "The region of the cells that belong to no physical group; empty: each cell must "
               "belong to one");
  geometry.add("Ungrouped faces", parameters.ungrouped_faces,
               "The boundary of the faces on the outside that belong to no physical group; empty: "
               "each must belong to one");
  geometry.add("Straighten curved elements", parameters.straightens,
               "Whether of elements of second or higher order the corners alone are taken, between "
               "which the cells are straight; the nodes between the corners are left out. Without "
               "it cells of second order keep their shape, and those of higher order are refused");
  return parameters;
}

template <int dim>
GmshGeometry<dim>::GmshGeometry(const Parameters &parameters, const bool axisymmetric)
    : parameters(parameters)
{
  if (parameters.file.empty())
  {
    region_names = {"the named physical groups of " +
                    std::string(dim == 2 ? "surfaces" : "volumes")};
    boundary_names = {"those of " + std::string(dim == 2 ? "curves" : "surfaces")};
    return;
  }
  GmshFile file = read_file(parameters.file, dim, parameters.meshing_time_limit);
  if (std::filesystem::path(parameters.file).extension() == ".geo")
    leave_ungrouped_out(file);
  ignore_groups(file);
  check_elements(file);
  set_vertices(file, axisymmetric);
  leave_corners(file);
  take_once(file, dim);
  take_once(file, dim - 1);
  set_cells(file);
  set_faces(file);
  delete_unused_vertices();
  dealii::GridTools::consistently_order_cells(cells);
}

template <int dim>
std::vector<std::string> GmshGeometry<dim>::regions() const
{
  return region_names;
}

template <int dim>
std::vector<std::string> GmshGeometry<dim>::boundaries() const
{
  return boundary_names;
}

template <int dim>
std::vector<NamedInterface> GmshGeometry<dim>::interfaces() const
{
  return named_interfaces;
}

template <int dim>
void GmshGeometry<dim>::create(dealii::Triangulation<dim> &triangulation) const
{
  if (cells.empty())
  {
    dealii::GridGenerator::hyper_cube(triangulation);
    return;
  }
  triangulation.create_triangulation(vertices, cells, faces);
  // The edges, too.
  for (const auto &cell : triangulation.cell_iterators_on_level(0))
    for (const auto &face : cell->face_iterators())
      if (face->at_boundary())
        face->set_all_boundary_ids(face->boundary_id());
  curved_cells.attach(triangulation);
}

template <int dim>
void GmshGeometry<dim>::refuse(const unsigned int line,
                               const std::string &problem,
                               const std::string &remedy) const
{
  // A .geo file has other lines than the mesh that is made from it.
  const bool is_mesh = std::filesystem::path(parameters.file).extension() == ".msh";
  throw InputError({parameters.file, is_mesh ? line : 0}, "Geometry/File", problem, remedy);
}

template <int dim>
void GmshGeometry<dim>::leave_ungrouped_out(GmshFile &file)
{
  if (file.groups.empty() && std::all_of(file.blocks.begin(), file.blocks.end(),
                                         [](const auto &block) { return block.groups.empty(); }))
    return;
  const bool keeps_cells = !parameters.ungrouped_cells.empty();
  const auto stays = [keeps_cells](const GmshFile::Block &block)
  { return !block.groups.empty() || (block.dimension == dim && keeps_cells); };
  const auto rest = std::stable_partition(file.blocks.begin(), file.blocks.end(), stays);
  for (auto block = rest; block != file.blocks.end(); ++block)
    if (block->dimension == dim)
      for (const GmshFile::Element &element : block->elements)
        for (const unsigned int vertex : element.nodes)
          left_out[vertex].push_back(sorted(element.nodes));
  file.blocks.erase(rest, file.blocks.end());
}

template <int dim>
bool GmshGeometry<dim>::is_beside_left_out(const std::vector<unsigned int> &vertices_of_face) const
{
  const auto found = left_out.find(vertices_of_face.front());
  return found != left_out.end() &&
         std::any_of(found->second.begin(), found->second.end(),
                     [&vertices_of_face](const auto &cell)
                     {
                       return std::includes(cell.begin(), cell.end(), vertices_of_face.begin(),
                                            vertices_of_face.end());
                     });
}

template <int dim>
void GmshGeometry<dim>::ignore_groups(GmshFile &file) const
{
  for (const std::string &name : parameters.ignored_groups)
  {
    bool exists = false;
    for (const unsigned int dimension : {dim - 1, dim})
    {
      std::map<int, unsigned int> place_of_tag;
      const std::vector<std::string> known = group_names(file, dimension, place_of_tag);
      for (const auto &[tag, place] : place_of_tag)
        if (known[place] == name)
        {
          exists = true;
          for (GmshFile::Block &block : file.blocks)
            if (block.dimension == dimension)
              block.groups.erase(std::remove(block.groups.begin(), block.groups.end(), tag),
                                 block.groups.end());
          file.groups.erase(std::remove_if(file.groups.begin(), file.groups.end(),
                                           [dimension, &name](const auto &group) {
                                             return group.dimension == dimension &&
                                                    group.name == name;
                                           }),
                            file.groups.end());
        }
    }
    if (!exists)
      refuse(0,
             "the mesh has no physical group '" + name + "' that 'Ignored groups' could leave out",
             "Correct the name, or remove it from 'Ignored groups'");
  }
}

template <int dim>
void GmshGeometry<dim>::check_elements(const GmshFile &file) const
{
  unsigned int order_of_cells = 0;
  for (const GmshFile::Block &block : file.blocks)
  {
    if (block.dimension > dim)
      refuse(block.line, "the mesh is three-dimensional, the Model is not",
             "Set Model = three-dimensional, or mesh with gmsh -2");
    if (block.dimension + 1 < dim)
      continue;
    const std::string where =
        " (" + entity_name(block.dimension) + " " + std::to_string(block.entity) + ")";
    const GmshElementType type = GmshElementType::of(block.type);
    if (const std::string unfit = plural(type.shape); !unfit.empty())
      refuse(block.line,
             "the mesh has " + unfit + where + "; Continua needs " +
                 (dim == 2 ? "quadrilaterals" : "hexahedra"),
             std::string("In the .geo file, make the ") +
                 (dim == 2 ? "surfaces Transfinite and 'Mesh.RecombineAll = 1;', or set "
                             "'Mesh.SubdivisionAlgorithm = 1;'"
                           : "surfaces and volumes Transfinite and 'Mesh.RecombineAll = 1;', or "
                             "set 'Mesh.SubdivisionAlgorithm = 2;'"));
    const Shape wanted = block.dimension == 1   ? Shape::line
                         : block.dimension == 2 ? Shape::quadrilateral
                                                : Shape::hexahedron;
    if (type.shape != wanted ||
        std::any_of(block.elements.begin(), block.elements.end(),
                    [&type](const auto &element) { return element.nodes.size() != type.n_nodes; }))
      refuse(block.line,
             "the mesh has elements of gmsh's type " + std::to_string(block.type) + where +
                 ", which Continua does not know",
             "Write the file with gmsh again, with elements of first or second order");
    if (parameters.straightens)
      order_of_cells = 1;
    else if (type.order > 2)
      refuse(block.line,
             "the mesh has elements of gmsh's type " + std::to_string(block.type) + where +
                 ", which are of an order above the second",
             "Set 'Mesh.ElementOrder = 2;' in the .geo file, or 'Straighten curved elements = "
             "true': the cells are straight between the corners, and small cells follow a curved "
             "wall");
    else if (block.dimension == dim)
    {
      if (order_of_cells > 0 && type.order != order_of_cells)
        refuse(block.line,
               "the mesh has cells of first and of second order" + where +
                   ", whose sides do not fit each other",
               "Mesh all of it with one order (Mesh.ElementOrder in the .geo file), or set "
               "'Straighten curved elements = true'");
      order_of_cells = type.order;
    }
  }
  if (std::none_of(file.blocks.begin(), file.blocks.end(),
                   [](const auto &block) { return block.dimension == dim; }))
    refuse(0,
           "the mesh has no " +
               std::string(dim == 2 ? "quadrilaterals (surfaces)" : "hexahedra (volumes)") +
               " in a physical group",
           "Declare Physical " + entity_name(dim) + "(\"NAME\") = {...}; and mesh with gmsh -" +
               std::to_string(dim) + ", or choose another Model than a " + in_dimensions(dim) +
               " one");
}

template <int dim>
void GmshGeometry<dim>::leave_corners(GmshFile &file)
{
  for (GmshFile::Block &block : file.blocks)
    for (GmshFile::Element &element : block.elements)
    {
      const std::size_t n_corners = std::size_t(1) << block.dimension;
      if (element.nodes.size() <= n_corners)
        continue;
      if (block.dimension == dim && !parameters.straightens)
        if (const auto unlike = curved_cells.add(element.nodes, vertices); !unlike.empty())
          refuse(block.line,
                 "the element " + std::to_string(element.tag) + " has another node between " +
                     "the corners around " + middle(unlike) +
                     " than its neighbour has: a gap or an overlap lies between the two",
                 "Mesh the geometry again, or set 'Straighten curved elements = true'");
      element.nodes.resize(n_corners);
    }
}

template <int dim>
void GmshGeometry<dim>::take_once(GmshFile &file, const unsigned int dimension) const
{
  std::map<int, unsigned int> place_of_tag;
  const std::vector<std::string> names = group_names(file, dimension, place_of_tag);
  std::map<std::vector<unsigned int>, int> group_of;
  // What is in a group and also in none belongs to the group.
  for (const bool is_grouped : {true, false})
    for (GmshFile::Block &block : file.blocks)
    {
      if (block.dimension != dimension || block.groups.empty() == is_grouped)
        continue;
      const int group = is_grouped ? block.groups.front() : 0;
      const auto is_copy = [&](const GmshFile::Element &element)
      {
        const auto [earlier, is_new] = group_of.emplace(sorted(element.nodes), group);
        if (!is_new && is_grouped && earlier->second != group)
        {
          const std::string &first = names[place_of_tag.at(earlier->second)],
                            &second = names[place_of_tag.at(group)];
          refuse(block.line,
                 "the element at " + middle(element.nodes) +
                     " stands there twice, in the physical group '" + first + "' and in '" +
                     second + "'",
                 "Keep it in one of them: set 'Ignored groups = " + quoted_name(second, "#,") +
                     "' (or the other, as is meant)");
        }
        return !is_new;
      };
      block.elements.erase(std::remove_if(block.elements.begin(), block.elements.end(), is_copy),
                           block.elements.end());
    }
  file.blocks.erase(std::remove_if(file.blocks.begin(), file.blocks.end(),
                                   [](const auto &block) { return block.elements.empty(); }),
                    file.blocks.end());
}

template <int dim>
std::vector<std::string> GmshGeometry<dim>::names(const GmshFile &file,
                                                  const unsigned int dimension,
                                                  std::map<int, unsigned int> &place_of_tag) const
{
  const std::string kind = "Physical " + entity_name(dimension);
  std::vector<std::string> names = group_names(file, dimension, place_of_tag);
  for (const GmshFile::Group &group : file.groups)
    if (group.dimension == dimension && std::count(names.begin(), names.end(), group.name) > 1)
      refuse(group.line,
             "two physical groups of " + entity_name(dimension) + "s have the name '" + group.name +
                 "', or one the name and one the number",
             "Name each once, with all its entities");

  // Each element must belong to one of them, but not every curve of a mesh is of interest.
  const bool names_the_rest = dimension == dim && !parameters.ungrouped_cells.empty();
  for (const GmshFile::Block &block : file.blocks)
    if (block.dimension == dimension && !block.elements.empty())
    {
      const std::string where = " (" + entity_name(dimension) + " " + std::to_string(block.entity) +
                                ", at " + middle(block.elements.front().nodes) + ")";
      if (block.groups.empty() && dimension == dim && !names_the_rest)
        refuse(block.line, "a cell belongs to no physical group" + where,
               "Declare " + kind + "(\"NAME\") = {" + std::to_string(block.entity) +
                   "}; in the .geo file, or set 'Ungrouped cells = NAME': the region of all such "
                   "cells");
      if (block.groups.size() > 1)
      {
        std::string list, others;
        for (const int tag : block.groups)
        {
          const std::string &name = names[place_of_tag.at(tag)];
          if (!list.empty())
            others += (others.empty() ? "" : ", ") + quoted_name(name, "#,");
          list += (list.empty() ? "'" : ", '") + name + "'";
        }
        refuse(block.line,
               "an element belongs to " + std::to_string(block.groups.size()) +
                   " physical groups, " + list + where,
               "Keep it in one of them: set 'Ignored groups = " + others +
                   "' (or the others, as is meant), or take the entity out of them in the .geo "
                   "file");
      }
    }
  for (const GmshFile::Group &group : file.groups)
    if (group.dimension == dimension && std::none_of(file.blocks.begin(), file.blocks.end(),
                                                     [&](const GmshFile::Block &block)
                                                     {
                                                       return block.dimension == dimension &&
                                                              !block.groups.empty() &&
                                                              block.groups.front() == group.tag;
                                                     }))
      refuse(group.line, "the physical group '" + group.name + "' has no elements",
             "Give it the entities that are meant, remove it, or set 'Ignored groups = " +
                 quoted_name(group.name, "#,") + "'");
  if (names_the_rest && std::any_of(file.blocks.begin(), file.blocks.end(),
                                    [](const GmshFile::Block &block)
                                    { return block.dimension == dim && block.groups.empty(); }))
    names.push_back(name_of_rest("Ungrouped cells", parameters.ungrouped_cells, names));
  return names;
}

template <int dim>
std::string GmshGeometry<dim>::name_of_rest(const std::string &entry,
                                            const std::string &name,
                                            const std::vector<std::string> &names) const
{
  if (std::find(names.begin(), names.end(), name) != names.end())
    refuse(0, "the name '" + name + "' of '" + entry + "' is that of a physical group",
           "Give another name");
  return name;
}

template <int dim>
void GmshGeometry<dim>::set_vertices(const GmshFile &file, const bool axisymmetric)
{
  for (const dealii::Point<3> &point : file.points)
  {
    dealii::Point<dim> vertex;
    for (unsigned int d = 0; d < dim; ++d)
      vertex[d] = point[d] * parameters.unit_length;
    vertices.push_back(vertex);
  }
  for (const GmshFile::Block &block : file.blocks)
    if (dim == 2 && block.dimension == dim)
      for (const GmshFile::Element &element : block.elements)
        for (const unsigned int v : element.nodes)
        {
          // Round-off of the drawing program.
          const double tolerance =
              1e-10 * (file.points[element.nodes[0]] - file.points[element.nodes[2]]).norm();
          if (std::abs(file.points[v][2]) > tolerance)
            refuse(block.line,
                   "the mesh does not lie in the plane z = 0 (z = " +
                       shortest_number(file.points[v][2]) + " at " + middle({v}) + ")",
                   "Draw it in the plane, or set Model = three-dimensional");
          if (axisymmetric && file.points[v][1] < -tolerance)
            refuse(block.line, "there is a negative radius (at " + middle({v}) + ")",
                   "In an axisymmetric model x is the axis and y >= 0 the radius; draw one half of "
                   "the axial section");
        }
}

template <int dim>
void GmshGeometry<dim>::set_cells(const GmshFile &file)
{
  std::map<int, unsigned int> region_of_tag;
  region_names = names(file, dim, region_of_tag);
  for (const GmshFile::Block &block : file.blocks)
    if (block.dimension == dim)
      for (const GmshFile::Element &element : block.elements)
      {
        std::vector<unsigned int> rows = in_rows<dim>(element.nodes);
        if (!orient<dim>(vertices, curved_cells, rows))
          refuse(block.line,
                 "the cell at " + middle(element.nodes) + " (element " +
                     std::to_string(element.tag) + ") is degenerate, not convex or twisted" +
                     (curved_cells.empty() ? "" : ", or its curved sides meet"),
                 "Look at the mesh with gmsh, and make it better there" +
                     std::string(curved_cells.empty()
                                     ? ""
                                     : ", with smaller cells or 'Mesh.HighOrderOptimize = 2;'"));
        dealii::CellData<dim> cell;
        cell.vertices.assign(rows.begin(), rows.end());
        // What is in no group has the last name.
        cell.material_id =
            block.groups.empty() ? region_names.size() - 1 : region_of_tag.at(block.groups.front());
        cells.push_back(cell);
      }
}

template <int dim>
typename GmshGeometry<dim>::Faces GmshGeometry<dim>::faces_of_cells() const
{
  Faces result;
  for (unsigned int c = 0; c < cells.size(); ++c)
    for (const unsigned int f : dealii::GeometryInfo<dim>::face_indices())
    {
      std::vector<unsigned int> rows;
      for (unsigned int v = 0; v < dealii::GeometryInfo<dim>::vertices_per_face; ++v)
        rows.push_back(cells[c].vertices[dealii::GeometryInfo<dim>::face_to_cell_vertices(f, v)]);
      Face &face = result[sorted(rows)];
      face.rows = rows;
      face.regions.insert(cells[c].material_id);
      if (++face.n_cells > 2)
        refuse(0, "more than two cells share the face at " + middle(rows),
               "Remove the cells that are there twice");
    }
  return result;
}

template <int dim>
void GmshGeometry<dim>::add_boundary_face(const std::vector<unsigned int> &rows,
                                          const unsigned int boundary)
{
  dealii::CellData<dim - 1> data;
  data.vertices.assign(rows.begin(), rows.end());
  data.boundary_id = boundary;
  if constexpr (dim == 2)
    faces.boundary_lines.push_back(data);
  else
    faces.boundary_quads.push_back(data);
}

template <int dim>
void GmshGeometry<dim>::set_faces(const GmshFile &file)
{
  std::map<int, unsigned int> place_of_tag;
  const std::vector<std::string> groups = names(file, dim - 1, place_of_tag);
  Faces faces_of_body = faces_of_cells();
  const auto sides = [](const Face &face)
  { return std::make_pair(*face.regions.begin(), *face.regions.rbegin()); };
  std::map<std::pair<unsigned int, unsigned int>, unsigned int> n_faces_between;
  for (const auto &[vertices_of_face, face] : faces_of_body)
    if (face.regions.size() == 2)
      ++n_faces_between[sides(face)];

  // By group: the faces on the outside, and how many there are between each two regions.
  std::vector<std::vector<std::vector<unsigned int>>> outside(groups.size());
  std::vector<std::map<std::pair<unsigned int, unsigned int>, unsigned int>> inside(groups.size());
  for (const GmshFile::Block &block : file.blocks)
    if (block.dimension == dim - 1 && !block.groups.empty())
      for (const GmshFile::Element &element : block.elements)
      {
        const unsigned int group = place_of_tag.at(block.groups.front());
        const auto found = faces_of_body.find(sorted(element.nodes));
        const bool is_outside = found != faces_of_body.end() && found->second.n_cells == 1;
        if (!is_outside && (found == faces_of_body.end() || found->second.regions.size() == 1))
          refuse(block.line,
                 "the physical group '" + groups[group] +
                     "' is neither on the outside nor between two regions (at " +
                     middle(element.nodes) + ")",
                 "Set 'Ignored groups = " + quoted_name(groups[group], "#,") + "', or take the " +
                     entity_name(dim - 1) + " " + std::to_string(block.entity) +
                     " out of the group in the .geo file");
        if (is_outside)
          outside[group].push_back(found->second.rows);
        else
          ++inside[group][sides(found->second)];
        if (!outside[group].empty() && !inside[group].empty())
          refuse(block.line,
                 "the physical group '" + groups[group] +
                     "' is partly on the outside and partly between two regions (here " +
                     (is_outside ? "on the outside" : "between two regions") + ", at " +
                     middle(element.nodes) + ")",
                 "Make two groups of it in the .geo file, or set 'Ignored groups = " +
                     quoted_name(groups[group], "#,") + "' and 'Ungrouped faces = NAME'");
        faces_of_body.erase(found);
      }

  for (std::size_t group = 0; group < groups.size(); ++group)
    if (!outside[group].empty())
    {
      for (const std::vector<unsigned int> &rows : outside[group])
        add_boundary_face(rows, boundary_names.size());
      boundary_names.push_back(groups[group]);
    }
    else
    {
      named_interfaces.push_back({groups[group], {}});
      for (const auto &[pair, n] : inside[group])
        named_interfaces.back().sides[pair] = n == n_faces_between.at(pair);
    }

  bool has_rest = false;
  for (const auto &[vertices_of_face, face] : faces_of_body)
  {
    if (face.n_cells != 1)
      continue;
    if (is_beside_left_out(vertices_of_face))
      refuse(0,
             "the face at " + middle(face.rows) + " lies between the region '" +
                 region_names[*face.regions.begin()] +
                 "' and a cell in no physical group, which is left out",
             "Set 'Ungrouped cells = NAME': the region of all such cells, or put the cell into a "
             "Physical " +
                 entity_name(dim) +
                 ". If it is meant to be left out, put the face into a Physical " +
                 entity_name(dim - 1));
    if (parameters.ungrouped_faces.empty())
      refuse(0, "the face at " + middle(face.rows) + " on the outside belongs to no physical group",
             "Put it into a Physical " + entity_name(dim - 1) +
                 " in the .geo file, or set 'Ungrouped faces = NAME': the boundary of all such "
                 "faces. If it is not meant to be outside, see that its other side is in a "
                 "Physical " +
                 entity_name(dim) + " and shares its " + (dim == 2 ? "curve" : "surface") +
                 " ('Coherence;')");
    if (!has_rest)
      boundary_names.push_back(name_of_rest("Ungrouped faces", parameters.ungrouped_faces, groups));
    has_rest = true;
    add_boundary_face(face.rows, boundary_names.size() - 1);
  }
}

template <int dim>
void GmshGeometry<dim>::delete_unused_vertices()
{
  const std::vector<dealii::CellData<dim>> before = cells;
  dealii::GridTools::delete_unused_vertices(vertices, cells, faces);
  std::map<unsigned int, unsigned int> new_numbers;
  for (std::size_t c = 0; c < cells.size(); ++c)
    for (std::size_t v = 0; v < cells[c].vertices.size(); ++v)
      new_numbers[before[c].vertices[v]] = cells[c].vertices[v];
  curved_cells.renumber(new_numbers);
}

template <int dim>
MeshExtent GmshGeometry<dim>::extent() const
{
  if (cells.empty())
    return {};
  // As long as a mesh of cubes that fills the box around the body.
  const dealii::BoundingBox<dim> box(vertices);
  double longest = 0.;
  for (unsigned int d = 0; d < dim; ++d)
    longest = std::max(longest, box.side_length(d));
  const double n_cells = cells.size(), size = std::pow(box.volume() / n_cells, 1. / dim);
  return {n_cells, std::max(1., std::min(n_cells, longest / size))};
}

template <int dim>
std::string GmshGeometry<dim>::middle(const std::vector<unsigned int> &indices) const
{
  dealii::Point<dim> sum;
  for (const unsigned int index : indices)
    sum += vertices[index];
  const char *const names[] = {"x = ", ", y = ", ", z = "};
  std::ostringstream text;
  for (unsigned int d = 0; d < dim; ++d)
    text << names[d] << sum[d] / (indices.size() * parameters.unit_length);
  return text.str();
}

template class GmshGeometry<2>;
template class GmshGeometry<3>;
} // namespace Continua
