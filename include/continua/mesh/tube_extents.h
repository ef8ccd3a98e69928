#ifndef continua_mesh_tube_extents_h
#define continua_mesh_tube_extents_h

#include <deal.II/grid/tria.h>

#include <array>
#include <set>
#include <vector>

namespace Continua
{
/**
 * The measures of a fluid-filled tube along the x axis, found in the coarse mesh whatever geometry
 * made it: of an axisymmetric one (r is y) or a solid of revolution in three dimensions, whole or
 * in part (r is the distance from the x axis).
 */
struct TubeExtents
{
  struct Layer
  {
    unsigned int region = 0; ///< material id
    double thickness = 0.;   ///< [m]
  };
  /// The section at one end of the tube.
  struct End
  {
    double x = 0.;                   ///< [m]
    double inner_radius = 0.;        ///< [m]
    std::vector<Layer> layers;       ///< of the wall, from the inner to the outer one
    double wall_cell = 0.;           ///< largest axial extent of a cell of the wall at this end [m]
    unsigned int fluid_boundary = 0; ///< boundary id of the fluid's faces there
    unsigned int fluid_region = 0;   ///< material id of the fluid on the axis
    /// Boundary id of the wall's faces there.
    unsigned int wall_boundary = 0;
  };
  std::array<End, 2> ends;
  unsigned int outer_boundary = 0; ///< boundary id of the wall's outer surface
  unsigned int outer_region = 0;   ///< material id of the wall there
  double axial_cell = 0.;          ///< largest axial extent of a cell of the fluid [m]
  double normal_cell = 0.;         ///< largest thickness of a fluid's cell at the wall [m]

  double length() const { return ends[1].x - ends[0].x; } ///< [m]
};

/**
 * Fills `extents` and returns true if the cells of level 0 make a tube: the fluid reaches from the
 * axis to one wall around it, both from one end to the other, with plane ends and round sections
 * there. `fluids`: the material ids of the fluid regions; the others are solid. Cell sizes are
 * those of the coarse cells. No communication.
 */
template <int dim>
bool find_tube(const dealii::Triangulation<dim> &triangulation,
               const std::set<unsigned int> &fluids,
               TubeExtents &extents);
} // namespace Continua

#endif
