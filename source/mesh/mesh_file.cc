#include <continua/base/atomic_file.h>
#include <continua/base/input_error.h>
#include <continua/mesh/mesh_file.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace Continua
{
namespace
{
const std::string mark_of_mesh_file = "<!-- A mesh that continua wrote -->";

/// Types of cells in VTK.
constexpr unsigned int vtk_line = 3, vtk_quadrilateral = 9, vtk_hexahedron = 12;

/// The vertices of a line, quadrilateral or hexahedron of deal.II in the order of VTK.
constexpr std::array<unsigned int, 8> vtk_order = {{0, 1, 3, 2, 4, 5, 7, 6}};

struct MeshCells
{
  std::ostringstream connectivity, offsets, types, regions, boundaries;
  unsigned int offset = 0, n_cells = 0;

  /// `object`: a cell or a face.
  template <typename Accessor>
  void
  add(const Accessor &object, const unsigned int n_vertices, const int region, const int boundary)
  {
    for (unsigned int v = 0; v < n_vertices; ++v)
      connectivity << object->vertex_index(n_vertices == 2 ? v : vtk_order.at(v)) << ' ';
    connectivity << '\n';
    offsets << (offset += n_vertices) << '\n';
    types << (n_vertices == 2   ? vtk_line
              : n_vertices == 4 ? vtk_quadrilateral
                                : vtk_hexahedron)
          << '\n';
    regions << region << '\n';
    boundaries << boundary << '\n';
    ++n_cells;
  }
};

std::string
data_array(const std::string &type, const std::string &attributes, const std::string &values)
{
  return "<DataArray type=\"" + type + "\" " + attributes + " format=\"ascii\">\n" + values +
         "</DataArray>\n";
}

/// Texts as VTK has them: the numbers of their characters, each text ended by a zero.
std::string name_array(const std::string &name, const std::vector<std::string> &texts)
{
  std::ostringstream out;
  out << "<Array type=\"String\" Name=\"" << name << "\" NumberOfTuples=\"" << texts.size()
      << "\" format=\"ascii\">\n";
  for (const std::string &text : texts)
  {
    for (const char c : text)
      out << static_cast<int>(static_cast<unsigned char>(c)) << ' ';
    out << "0\n";
  }
  out << "</Array>\n";
  return out.str();
}
} // namespace

template <int dim>
std::string mesh_file(const dealii::Triangulation<dim> &triangulation,
                      const std::vector<std::string> &regions,
                      const std::vector<std::string> &boundaries)
{
  MeshCells cells;
  for (const auto &cell : triangulation.active_cell_iterators())
    cells.add(cell, dealii::GeometryInfo<dim>::vertices_per_cell,
              static_cast<int>(cell->material_id()), -1);
  for (const auto &cell : triangulation.active_cell_iterators())
    for (const auto &face : cell->face_iterators())
      if (face->at_boundary())
        cells.add(face, dealii::GeometryInfo<dim>::vertices_per_face, -1,
                  static_cast<int>(face->boundary_id()));

  std::ostringstream points;
  points.precision(17);
  const auto &vertices = triangulation.get_vertices();
  for (const dealii::Point<dim> &vertex : vertices)
    points << vertex[0] << ' ' << vertex[1] << ' ' << (dim == 3 ? vertex[dim - 1] : 0.) << '\n';

  std::ostringstream out;
  out << "<?xml version=\"1.0\"?>\n"
      << mark_of_mesh_file
      << "\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\">\n<UnstructuredGrid>\n<FieldData>\n"
      << name_array("regions", regions) << name_array("boundaries", boundaries)
      << "</FieldData>\n<Piece NumberOfPoints=\"" << vertices.size() << "\" NumberOfCells=\""
      << cells.n_cells << "\">\n<Points>\n"
      << data_array("Float64", "NumberOfComponents=\"3\"", points.str()) << "</Points>\n<Cells>\n"
      << data_array("Int32", "Name=\"connectivity\"", cells.connectivity.str())
      << data_array("Int32", "Name=\"offsets\"", cells.offsets.str())
      << data_array("UInt8", "Name=\"types\"", cells.types.str()) << "</Cells>\n<CellData>\n"
      << data_array("Int32", "Name=\"region\"", cells.regions.str())
      << data_array("Int32", "Name=\"boundary\"", cells.boundaries.str())
      << "</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  return out.str();
}

void write_mesh_file(const std::string &file, const std::string &text)
{
  if (std::filesystem::exists(file))
  {
    std::ifstream before(file);
    std::string line;
    std::getline(before, line);
    std::getline(before, line);
    if (line != mark_of_mesh_file)
      throw InputError({file, 0}, "", "the file exists, and --mesh did not write it",
                       "Name another file, or remove this one");
  }
  write_file_atomically(file, text);
}

template std::string mesh_file<2>(const dealii::Triangulation<2> &,
                                  const std::vector<std::string> &,
                                  const std::vector<std::string> &);
template std::string mesh_file<3>(const dealii::Triangulation<3> &,
                                  const std::vector<std::string> &,
                                  const std::vector<std::string> &);
} // namespace Continua
