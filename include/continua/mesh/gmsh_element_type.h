#ifndef continua_mesh_gmsh_element_type_h
#define continua_mesh_gmsh_element_type_h

#include <vector>

namespace Continua
{
/**
 * What a number of gmsh's for an element type stands for (gmsh reference manual 4.8, section 9.1,
 * and GmshDefines.h for the higher orders).
 */
struct GmshElementType
{
  enum class Shape
  {
    line,
    triangle,
    quadrilateral,
    tetrahedron,
    hexahedron,
    prism,
    pyramid,
    other
  };

  Shape shape = Shape::other;
  unsigned int n_nodes = 0; ///< the corners come first
  unsigned int order = 0;   ///< polynomial degree of the sides

  /// Of the number; a number without a row in the table is Shape::other.
  static GmshElementType of(unsigned int number);
};

/**
 * The corners between which each further node of a quadrilateral with 8 or 9 nodes, or of a
 * hexahedron with 20 or 27 nodes lies, in gmsh's order of nodes and corners: two corners for the
 * middle of an edge, four for the middle of a face, eight for the middle of a hexahedron (gmsh
 * reference manual 4.8, section 9.2). Of the smaller number of nodes the first rows count.
 */
template <int dim>
const std::vector<std::vector<unsigned int>> &corners_of_gmsh_nodes();
} // namespace Continua

#endif
