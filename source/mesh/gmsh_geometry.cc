#include <continua/base/input_file.h>
#include <continua/mesh/gmsh_file.h>
#include <continua/mesh/gmsh_geometry.h>
#include <continua/mesh/gmsh_mesher.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <stdexcept>

namespace Continua
{
namespace
{
/// gmsh's numbers of the element types: those read, and those that are often met instead.
constexpr unsigned int type_line = 1, type_triangle = 2, type_quadrilateral = 3,
                       type_tetrahedron = 4, type_hexahedron = 5, type_prism = 6, type_pyramid = 7,
                       type_point = 15;

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

/// Makes the cell positively oriented; false if it is twisted, not convex or has no volume.
template <int dim>
bool orient(const std::vector<dealii::Point<dim>> &points, std::vector<unsigned int> &cell)
{
  constexpr unsigned int n = dealii::GeometryInfo<dim>::vertices_per_cell;
  dealii::Point<dim> vertices[n];
  dealii::Tensor<0, dim> determinants[n];
  for (unsigned int v = 0; v < n; ++v)
    vertices[v] = points[cell[v]];
  dealii::GeometryInfo<dim>::alternating_form_at_vertices(vertices, determinants);
  const auto is_positive = [](const double determinant) { return determinant > 0.; };
  const auto is_negative = [](const double determinant) { return determinant < 0.; };
  if (std::all_of(determinants, determinants + n, is_negative))
  {
    // A surface whose loop runs clockwise: exchange the two directions.
    for (unsigned int v = 0; v < n; v += 4)
      std::swap(cell[v + 1], cell[v + 2]);
    return true;
  }
  return std::all_of(determinants, determinants + n, is_positive);
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
      "Mesh of quadrilaterals or hexahedra: a .msh file of gmsh in format 4.1, ASCII, or a .geo "
      "file, which is meshed for the run. Its named physical groups are the regions (surfaces; in "
      "three dimensions volumes) and the boundaries (curves; surfaces)");
  geometry.require("File");
  const std::string extension = std::filesystem::path(parameters.file).extension().string();
  if (!parameters.file.empty() && extension != ".msh" && extension != ".geo")
    geometry.refuse("File",
                    "'" + parameters.file + "' is called neither .msh nor .geo, the files of gmsh",
                    "Give a file of gmsh; it makes one of many others (gmsh FILE -save -format "
                    "msh41 -o FILE.msh)");
  geometry.add("Unit length", parameters.unit_length, Dimensions::length,
               "What a coordinate of 1 in the file means: 1 mm if it is drawn in millimetres [m]",
               Range::positive());
  geometry.add("Meshing time limit", parameters.meshing_time_limit, Dimensions::time,
               "The wall time after which gmsh is stopped that meshes a .geo file [s]",
               Range::positive());
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
  const GmshFile file = read_file(parameters.file, dim, parameters.meshing_time_limit);
  check_elements(file);
  set_vertices(file, axisymmetric);
  set_cells(file);
  set_faces(file);
  dealii::GridTools::delete_unused_vertices(vertices, cells, faces);
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
void GmshGeometry<dim>::check_elements(const GmshFile &file) const
{
  bool has_cells = false;
  for (const GmshFile::Block &block : file.blocks)
  {
    if (block.dimension > dim)
      refuse(block.line, "the mesh is three-dimensional, the Model is not",
             "Set Model = three-dimensional, or mesh with gmsh -2");
    if (block.dimension + 1 < dim)
      continue;
    has_cells = has_cells || block.dimension == dim;
    const std::string where =
        " (" + entity_name(block.dimension) + " " + std::to_string(block.entity) + ")";
    if (block.type == type_triangle || block.type == type_tetrahedron || block.type == type_prism ||
        block.type == type_pyramid)
      refuse(block.line,
             std::string("the mesh has ") +
                 (block.type == type_triangle      ? "triangles"
                  : block.type == type_tetrahedron ? "tetrahedra"
                  : block.type == type_prism       ? "prisms"
                                                   : "pyramids") +
                 where + "; Continua needs " + (dim == 2 ? "quadrilaterals" : "hexahedra"),
             std::string("In the .geo file, make the ") +
                 (dim == 2 ? "surfaces Transfinite and 'Mesh.RecombineAll = 1;', or set "
                             "'Mesh.SubdivisionAlgorithm = 1;'"
                           : "surfaces and volumes Transfinite and 'Mesh.RecombineAll = 1;', or "
                             "set 'Mesh.SubdivisionAlgorithm = 2;'"));
    const unsigned int type = block.dimension == 1   ? type_line
                              : block.dimension == 2 ? type_quadrilateral
                                                     : type_hexahedron;
    const std::size_t n_vertices = std::size_t(1) << block.dimension;
    if (block.type != type ||
        std::any_of(block.elements.begin(), block.elements.end(),
                    [&](const auto &element) { return element.size() != n_vertices; }))
      refuse(block.line,
             "the mesh has elements of gmsh's type " + std::to_string(block.type) + where +
                 ", which are not straight-sided (of first order)",
             "Set 'Mesh.ElementOrder = 1;' in the .geo file; small cells follow a curved wall");
  }
  if (!has_cells)
    refuse(0,
           "the mesh has no " +
               std::string(dim == 2 ? "quadrilaterals (surfaces)" : "hexahedra (volumes)") +
               " in a physical group",
           "Declare Physical " + entity_name(dim) + "(\"NAME\") = {...}; and mesh with gmsh -" +
               std::to_string(dim) + ", or choose another Model than a " + in_dimensions(dim) +
               " one");
}

template <int dim>
std::vector<std::string> GmshGeometry<dim>::names(const GmshFile &file,
                                                  const unsigned int dimension,
                                                  std::map<int, unsigned int> &place_of_tag) const
{
  std::vector<std::string> names;
  for (const GmshFile::Group &group : file.groups)
    if (group.dimension == dimension)
    {
      const std::string kind = "Physical " + entity_name(dimension);
      if (group.name.empty())
        refuse(group.line, kind + " " + std::to_string(group.tag) + " has an empty name",
               "Write " + kind + "(\"NAME\") = {...};");
      if (std::find(names.begin(), names.end(), group.name) != names.end())
        refuse(group.line,
               "two physical groups of " + entity_name(dimension) + "s have the name '" +
                   group.name + "'",
               "Name each once, with all its entities");
      place_of_tag[group.tag] = names.size();
      names.push_back(group.name);
    }

  // Each element must belong to one of them, but not every curve of a mesh is of interest.
  for (const GmshFile::Block &block : file.blocks)
    if (block.dimension == dimension && !block.elements.empty())
    {
      const std::string where = " (" + entity_name(dimension) + " " + std::to_string(block.entity) +
                                ", at " + middle(block.elements.front()) + ")";
      const std::string kind = "Physical " + entity_name(dimension);
      if (block.groups.empty() && dimension == dim)
        refuse(block.line, "a cell belongs to no physical group" + where,
               "Declare " + kind + "(\"NAME\") = {" + std::to_string(block.entity) + "};");
      if (block.groups.size() > 1)
        refuse(block.line,
               "an element belongs to " + std::to_string(block.groups.size()) + " physical groups" +
                   where,
               "Keep it in one");
      for (const int tag : block.groups)
        if (place_of_tag.count(tag) == 0)
          refuse(block.line, kind + " " + std::to_string(tag) + " has no name" + where,
                 "Write " + kind + "(\"NAME\") = {...};");
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
             "Give it the entities that are meant, or remove it");
  return names;
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
      for (const auto &element : block.elements)
        for (const unsigned int v : element)
        {
          // Round-off of the drawing program.
          const double tolerance =
              1e-10 * (file.points[element[0]] - file.points[element[2]]).norm();
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
      for (const std::vector<unsigned int> &element : block.elements)
      {
        std::vector<unsigned int> rows = in_rows<dim>(element);
        if (!orient<dim>(vertices, rows))
          refuse(block.line,
                 "the cell at " + middle(element) + " is degenerate, not convex or twisted",
                 "Look at the mesh with gmsh, and make it better there");
        dealii::CellData<dim> cell;
        cell.vertices.assign(rows.begin(), rows.end());
        cell.material_id = region_of_tag.at(block.groups.front());
        cells.push_back(cell);
      }
}

template <int dim>
void GmshGeometry<dim>::set_faces(const GmshFile &file)
{
  std::map<int, unsigned int> boundary_of_tag;
  boundary_names = names(file, dim - 1, boundary_of_tag);

  // How many cells have a face, by its vertices; then whether an outer face has a name.
  std::map<std::vector<unsigned int>, unsigned int> n_cells_of_face;
  for (const dealii::CellData<dim> &cell : cells)
    for (const unsigned int f : dealii::GeometryInfo<dim>::face_indices())
    {
      std::vector<unsigned int> face;
      for (unsigned int v = 0; v < dealii::GeometryInfo<dim>::vertices_per_face; ++v)
        face.push_back(cell.vertices[dealii::GeometryInfo<dim>::face_to_cell_vertices(f, v)]);
      if (++n_cells_of_face[sorted(face)] > 2)
        refuse(0, "more than two cells share the face at " + middle(face),
               "Remove the cells that are there twice");
    }

  for (const GmshFile::Block &block : file.blocks)
    if (block.dimension == dim - 1 && !block.groups.empty())
      for (const std::vector<unsigned int> &element : block.elements)
      {
        const unsigned int boundary = boundary_of_tag.at(block.groups.front());
        const auto face = n_cells_of_face.find(sorted(element));
        if (face == n_cells_of_face.end() || face->second != 1)
          refuse(block.line,
                 "the physical group '" + boundary_names[boundary] +
                     "' is not on the outside (at " + middle(element) + ")",
                 "Take the " + entity_name(dim - 1) + " " + std::to_string(block.entity) +
                     " out of the group; the interface between two regions needs no name");
        n_cells_of_face.erase(face);
        dealii::CellData<dim - 1> data;
        data.boundary_id = boundary;
        if constexpr (dim == 2)
        {
          data.vertices.assign(element.begin(), element.end());
          faces.boundary_lines.push_back(data);
        }
        else
        {
          const std::vector<unsigned int> rows = in_rows<2>(element);
          data.vertices.assign(rows.begin(), rows.end());
          faces.boundary_quads.push_back(data);
        }
      }
  for (const auto &[face, n_cells] : n_cells_of_face)
    if (n_cells == 1)
      refuse(0, "the face at " + middle(face) + " on the outside belongs to no physical group",
             "Put it into a Physical " + entity_name(dim - 1) +
                 ", and if it is not meant to be outside, see that its other side is in a "
                 "Physical " +
                 entity_name(dim) + " and shares its " + (dim == 2 ? "curve" : "surface") +
                 " ('Coherence;')");
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
