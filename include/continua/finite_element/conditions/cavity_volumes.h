#ifndef continua_finite_element_conditions_cavity_volumes_h
#define continua_finite_element_conditions_cavity_volumes_h

#include <continua/continuum/problem.h>
#include <continua/finite_element/space/deformed_faces.h>
#include <continua/finite_element/space/space.h>

#include <map>
#include <vector>

namespace Continua
{
/**
 * The volumes of cavities in finite deformation, by integrals over surfaces alone. An empty one is
 * enclosed by its boundary: with n out of the body,
 *
 *   V = - 1/2 int (y n_y + z n_z) da   in space, and likewise in axisymmetry for the whole
 *                                      circumference,
 *   V = - 1/2 int (x n_x + y n_y) ds   in the plane, for a unit of depth.
 *
 * This is the volume of a closed surface. Where symmetry or an end opens the surface, planes close
 * it on which the integrand is zero: in space those normal to x and those that contain the x axis,
 * in the plane lines through the origin.
 *
 * Where the boundary is an opening of a liquid, the cavity is that whole body of liquid, with all
 * that is connected by faces. Its surface is closed: its boundaries, and its faces beside solids.
 * With n out of the liquid the volume is the same integral without the minus. It changes by the
 * motion of the solids alone, since the mesh slides along its other faces or stays there.
 */
template <int dim>
class CavityVolumes
{
public:
  /// Both must outlive it.
  CavityVolumes(const Space<dim> &space, const Problem &problem);

  /// The mesh has changed.
  void reinit();
  /// By cavity, at a displacement of the mesh, in solids that of matter [m^3]. Collective.
  std::vector<double> volumes(const DistributedVector &displacement);
  /// Sets the derivative of a volume by the displacement, and the forces of a pressure of 1 Pa,
  /// -int v . n da, both with the hanging nodes condensed [m^2]. Collective.
  void linearise(unsigned int cavity,
                 const DistributedVector &displacement,
                 DistributedVector &derivative,
                 DistributedVector &force);

private:
  const Space<dim> &space;
  const Problem &problem;
  DeformedFaces<dim> faces;    ///< on which the pressures act
  DeformedFaces<dim> surfaces; ///< that enclose the volumes
  std::vector<bool> is_filled; ///< by cavity: with liquid
  /// Of liquids: the cavity of a body, by the coarse cell.
  std::map<unsigned int, unsigned int> cavity_of_coarse_cell;
  std::vector<bool> is_of_solid; ///< of each owned velocity

  /// Finds the bodies of liquid behind openings, and the velocities of solids.
  void find_bodies_of_liquid();
  /// The cavity to whose surface a face belongs, or -1.
  int cavity_of_face(const typename DeformedFaces<dim>::Cell &cell, unsigned int face) const;

  /// Of the flux out of the body that has the surface: -1 of an empty cavity.
  double sign(const unsigned int cavity) const { return is_filled[cavity] ? 1. : -1.; }
  /// The vector at a point whose flux out of a closed surface is its volume [m].
  dealii::Tensor<1, 3> flux_vector(const DeformedFacePoint<dim> &point,
                                   const dealii::Vector<double> &displacement) const;
  /// Its derivative by the coordinate along a direction.
  double flux_factor(unsigned int direction) const;
};
} // namespace Continua

#endif
