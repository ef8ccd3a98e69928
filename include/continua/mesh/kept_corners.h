#ifndef continua_mesh_kept_corners_h
#define continua_mesh_kept_corners_h

#include <deal.II/base/point.h>
#include <deal.II/grid/tria.h>

#include <string>
#include <vector>

namespace Continua
{
/// The largest angle at which the faces of one surface of a coarse mesh meet.
template <int dim>
struct KeptCorner
{
  std::string surface; ///< "the boundary 'outer'", "the interface of 'fluid' and 'wall'"
  double angle = 0.;   ///< between the normals [rad]
  dealii::Point<dim> place;
};

/**
 * The corners that division of the cells keeps: on the boundaries and interfaces of a mesh from a
 * file a curve is a row of straight faces, and new vertices come into the middle of these. A finer
 * mesh then goes to the polygon and not to the curve. Curved cells of second order meet at a
 * smaller angle, which falls with the third power of their size. Faces that know their curve
 * (another manifold) do not count, since their new vertices lie on it.
 *
 * An angle between faces of one name counts from `smallest_curved` to `largest_curved`: less is
 * round-off or nearly straight, more is taken for a corner that is meant; so are edges where the
 * name changes. Of each surface the largest angle; in 2-D at vertices, in 3-D along lines.
 */
constexpr double smallest_curved = 1. * 3.14159265358979323846 / 180.;
constexpr double largest_curved = 40. * 3.14159265358979323846 / 180.;

template <int dim>
std::vector<KeptCorner<dim>> kept_corners(const dealii::Triangulation<dim> &coarse_mesh,
                                          const std::vector<std::string> &regions,
                                          const std::vector<std::string> &boundaries);

/// What a run has to say of them; empty if there are none.
template <int dim>
std::string warning_of(const std::vector<KeptCorner<dim>> &corners);
} // namespace Continua

#endif
