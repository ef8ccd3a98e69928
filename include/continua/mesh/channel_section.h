#ifndef continua_mesh_channel_section_h
#define continua_mesh_channel_section_h

#include <deal.II/grid/tria.h>

#include <set>

namespace Continua
{
/// A boundary across a plane channel, from wall to wall or from a wall to the middle.
struct ChannelSection
{
  dealii::Point<2> middle;        ///< [m]
  double half_gap = 0.;           ///< [m]
  double fraction = 1.;           ///< 1 or 1/2: the part of the gap that the mesh has
  dealii::Tensor<1, 2> direction; ///< across the channel, of length 1, towards larger y (or x)
};

/**
 * The straight line that the faces of a boundary next to the given regions make. Where an end of it
 * touches one of the `symmetry` boundaries the middle of the channel is there, else it is between
 * the ends. Looks at the coarse cells, which every rank has. Throws std::invalid_argument, with a
 * reason that a user understands, if the faces are not one straight line, or if both of its ends
 * lie on a symmetry boundary.
 */
ChannelSection find_channel_section(const dealii::Triangulation<2> &triangulation,
                                    dealii::types::boundary_id boundary,
                                    const std::set<unsigned int> &regions,
                                    const std::set<dealii::types::boundary_id> &symmetry);
} // namespace Continua

#endif
