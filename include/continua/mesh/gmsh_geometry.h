#ifndef continua_mesh_gmsh_geometry_h
#define continua_mesh_gmsh_geometry_h

#include <continua/mesh/geometry.h>
#include <continua/mesh/second_order_nodes.h>

#include <deal.II/grid/tria_description.h>

#include <map>
#include <set>

namespace Continua
{
struct GmshFile;

/**
 * `gmsh`: a mesh of quadrilaterals or hexahedra from a file of gmsh (.msh, ASCII), or a .geo file,
 * which is meshed by the library of gmsh. The regions are the physical groups of dimension dim, the
 * boundaries and the named interfaces those of dimension dim - 1: first those with a name, in the
 * order of the file, then those whose name is their number, in its order. In axisymmetry x is the
 * axial and y >= 0 the radial coordinate. Cells of first order stay straight under refinement;
 * cells of second order (8 or 9, in three dimensions 20 or 27 nodes) keep the shape of the file.
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
    std::vector<std::string> ignored_groups = {}; ///< by name, of regions and boundaries
    std::string ungrouped_cells = {};             ///< how cells in no group are called; empty: no
    std::string ungrouped_faces = {};             ///< the same of faces on the outside
    bool straightens = false; ///< whether the corners alone of a curved element are taken

    /// Throws InputError.
    static Parameters read(ParameterSection geometry, ParameterSection mesh, bool axisymmetric);
  };

  /// Reads (and meshes) the file; throws InputError. Without a file, as while the manual is made,
  /// one cell stands for the mesh.
  GmshGeometry(const Parameters &parameters, bool axisymmetric);

  std::vector<std::string> regions() const override;
  std::vector<std::string> boundaries() const override;
  std::vector<NamedInterface> interfaces() const override;
  void create(dealii::Triangulation<dim> &triangulation) const override;
  MeshExtent extent() const override;

private:
  [[noreturn]] void
  refuse(unsigned int line, const std::string &problem, const std::string &remedy) const;
  /// Throws InputError if an element type or the dimension of the mesh is none for this model.
  void check_elements(const GmshFile &file) const;
  /// Moves the nodes between the corners from the elements to `curved_cells`.
  void leave_corners(GmshFile &file);
  /// As gmsh writes a mesh of a geometry: where there are physical groups, what is in none is left
  /// out, but for cells that are to be a region.
  void leave_ungrouped_out(GmshFile &file);
  /// Whether a face, by its vertices in increasing order, is one of a cell that is left out.
  bool is_beside_left_out(const std::vector<unsigned int> &vertices_of_face) const;
  /// Takes the groups out that are to be ignored. Throws InputError if there is none of the name.
  void ignore_groups(GmshFile &file) const;
  /// Takes an element of this dimension once that the file has twice. Throws InputError if it is in
  /// two groups.
  void take_once(GmshFile &file, unsigned int dimension) const;
  /// The names of the groups of a dimension; `place_of_tag[tag]` becomes the place of the name.
  std::vector<std::string> names(const GmshFile &file,
                                 unsigned int dimension,
                                 std::map<int, unsigned int> &place_of_tag) const;
  void set_vertices(const GmshFile &file, bool axisymmetric);
  void set_cells(const GmshFile &file);
  /// `name` for what is in no group; throws InputError if a group has it.
  std::string name_of_rest(const std::string &entry,
                           const std::string &name,
                           const std::vector<std::string> &names) const;
  struct Face
  {
    std::vector<unsigned int> rows; ///< its vertices in deal.II's order
    std::set<unsigned int> regions; ///< of its cells
    unsigned int n_cells = 0;
  };
  /// By their vertices in increasing order.
  using Faces = std::map<std::vector<unsigned int>, Face>;
  Faces faces_of_cells() const;
  void add_boundary_face(const std::vector<unsigned int> &rows, unsigned int boundary);
  void set_faces(const GmshFile &file);
  void delete_unused_vertices();
  /// "x = 1, y = 2": the middle of some vertices, in the unit of the file.
  std::string middle(const std::vector<unsigned int> &indices) const;

  const Parameters parameters;
  std::vector<std::string> region_names;
  std::vector<std::string> boundary_names;
  std::vector<NamedInterface> named_interfaces;
  std::vector<dealii::Point<dim>> vertices; ///< [m]
  std::vector<dealii::CellData<dim>> cells;
  dealii::SubCellData faces;
  SecondOrderNodes<dim> curved_cells;
  /// Of each vertex: the cells that are left out, by their vertices in increasing order.
  std::map<unsigned int, std::vector<std::vector<unsigned int>>> left_out;
};
} // namespace Continua

#endif
