#ifndef continua_mesh_gmsh_file_h
#define continua_mesh_gmsh_file_h

#include <deal.II/base/point.h>

#include <cstddef>
#include <string>
#include <vector>

namespace Continua
{
/**
 * What a mesh file of gmsh in ASCII holds (formats MSH 1, 2, 4.0 and 4.1, gmsh reference manual
 * 4.8, sections 9.1 and 9.2): points, elements by geometrical entity, and the physical groups with
 * their names. Partitions are left out: Continua makes its own. GridIn of deal.II reads the same
 * files, but drops the names, takes a group's tag from a curve that the group holds with a minus
 * sign as it stands, and does not say which entity it cannot read.
 */
struct GmshFile
{
  /// A physical group that has a name.
  struct Group
  {
    unsigned int dimension = 0; ///< 0 points, 1 curves, 2 surfaces, 3 volumes
    int tag = 0;                ///< its number, unique in its dimension
    std::string name;
    unsigned int line = 0; ///< of the file
  };

  struct Element
  {
    std::size_t tag = 0;             ///< its number in the file
    std::vector<unsigned int> nodes; ///< their places in `points`, in gmsh's order
  };

  /// The elements of one type on one geometrical entity (a curve, a surface, ...).
  struct Block
  {
    unsigned int dimension = 0;
    int entity = 0;          ///< tag of the geometrical entity
    unsigned int type = 0;   ///< gmsh's number of the element type
    std::vector<int> groups; ///< tags of the entity's physical groups
    std::vector<Element> elements;
    unsigned int line = 0; ///< of the file
  };

  std::vector<Group> groups; ///< in the order of the file
  std::vector<Block> blocks;
  std::vector<dealii::Point<3>> points; ///< in the file's unit of length

  /**
   * Reads the text of a file; `name` stands in the messages. Throws InputError with line and remedy
   * if it has another format or is damaged: a number that is not finite, too large, or not whole
   * where it counts or names something.
   */
  static GmshFile read(const std::string &text, const std::string &name);
};
} // namespace Continua

#endif
