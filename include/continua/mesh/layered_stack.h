#ifndef continua_mesh_layered_stack_h
#define continua_mesh_layered_stack_h

#include <continua/base/parameter_section.h>

#include <string>
#include <vector>

namespace Continua
{
/**
 * A fluid with the layers of a wall on top of it, along the y direction from y = 0: what the
 * layered channel and the tube have in common. Region 0 is the fluid, region i the i-th layer of
 * the wall counted from the fluid.
 */
struct LayeredStack
{
  double fluid_depth = 0.01;                      ///< [m]
  std::vector<double> wall_thicknesses = {0.001}; ///< of each layer, from the fluid outwards [m]
  unsigned int fluid_cells = 8;                   ///< across the fluid
  double fluid_grading = 1.; ///< size of the cell at the wall over that at y = 0
  std::vector<unsigned int> wall_cells = {
      1}; ///< across each layer; after reading as long as `wall_thicknesses`

  /// Reads `Wall cells`: a number for each layer or one for all. Throws InputError if there are
  /// others.
  void read_wall_cells(ParameterSection mesh);

  /// Cells of all layers, from y = 0 to the outermost surface.
  unsigned int n_cells() const;
  /// The coordinates of the vertices [m].
  std::vector<double> points() const;
  /// The region of the cell that is the `index`-th from y = 0.
  unsigned int region(unsigned int index) const;
  /**
   * The boundary id of a face of such a cell, by deal.II's face number: 0 and 1 for the fluid's
   * inlet and outlet, 2 and 3 for the wall's ends there, 4 and 5 for y = 0 and the outermost
   * surface, 6 and 7 for the sides along z.
   */
  unsigned int boundary(unsigned int index, unsigned int face) const;
  /// "fluid", "wall", or "fluid", "wall 1", "wall 2", ...
  std::vector<std::string> region_names() const;
};
} // namespace Continua

#endif
