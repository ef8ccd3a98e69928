#ifndef continua_mesh_gmsh_geometry_h
#define continua_mesh_gmsh_geometry_h

#include <continua/mesh/geometry.h>

#include <deal.II/grid/tria_description.h>

#include <map>

namespace Continua
{
struct GmshFile;

/**
 * `gmsh`: a mesh of quadrilaterals or hexahedra from a file of gmsh (.msh in format 4.1, ASCII), or
 * a .geo file, which is meshed by the library of gmsh. The regions are the named physical groups of
 * dimension dim, the boundaries those of dimension dim - 1, in the order of the file. In
 * axisymmetry x is the axial and y >= 0 the radial coordinate. Faces stay straight under
 * refinement.
 */
template <int dim>
class GmshGeometry : public Geometry<dim>
{
public:
  struct Parameters
  {
    std::string file;
    double unit_length = 1.;          ///< what a coordinate of 1 in the file means [m]
    double meshing_time_limit = 600.; ///< of gmsh with a .geo file, by the wall clock [s]

    /// Throws InputError.
    static Parameters read(ParameterSection geometry, ParameterSection mesh, bool axisymmetric);
  };

  /// Reads (and meshes) the file; throws InputError. Without a file, as while the manual is made,
  /// one cell stands for the mesh.
  GmshGeometry(const Parameters &parameters, bool axisymmetric);

  std::vector<std::string> regions() const override;
  std::vector<std::string> boundaries() const override;
  void create(dealii::Triangulation<dim> &triangulation) const override;

private:
  [[noreturn]] void
  refuse(unsigned int line, const std::string &problem, const std::string &remedy) const;
  /// Throws InputError if an element type or the dimension of the mesh is none for this model.
  void check_elements(const GmshFile &file) const;
  /// The names of the groups of a dimension; `place_of_tag[tag]` becomes the place of the name.
  std::vector<std::string> names(const GmshFile &file,
                                 unsigned int dimension,
                                 std::map<int, unsigned int> &place_of_tag) const;
  void set_vertices(const GmshFile &file, bool axisymmetric);
  void set_cells(const GmshFile &file);
  void set_faces(const GmshFile &file);
  /// "x = 1, y = 2": the middle of some vertices, in the unit of the file.
  std::string middle(const std::vector<unsigned int> &indices) const;

  const Parameters parameters;
  std::vector<std::string> region_names;
  std::vector<std::string> boundary_names;
  std::vector<dealii::Point<dim>> vertices; ///< [m]
  std::vector<dealii::CellData<dim>> cells;
  dealii::SubCellData faces;
};
} // namespace Continua

#endif
