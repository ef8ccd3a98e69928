#ifndef continua_finite_element_cavity_volumes_h
#define continua_finite_element_cavity_volumes_h

#include <continua/continuum/problem.h>
#include <continua/finite_element/deformed_faces.h>
#include <continua/finite_element/space.h>

#include <vector>

namespace Continua
{
/**
 * The volumes that cavities enclose in finite deformation, by integrals over their surface alone.
 * With n out of the body,
 *
 *   V = - 1/2 int (y n_y + z n_z) da   in space, and likewise in axisymmetry for the whole
 *                                      circumference,
 *   V = - 1/2 int (x n_x + y n_y) ds   in the plane, for a unit of depth.
 *
 * This is the volume of a closed surface. Where symmetry or an end opens the surface, planes close
 * it on which the integrand is zero: in space those normal to x and those that contain the x axis,
 * in the plane lines through the origin.
 */
template <int dim>
class CavityVolumes
{
public:
  /// Both must outlive it.
  CavityVolumes(const Space<dim> &space, const Problem &problem);

  /// The mesh has changed.
  void reinit();
  /// By cavity, at a displacement [m^3]. Collective.
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
  DeformedFaces<dim> faces;

  /// The vector at a point whose flux out of a closed surface is its volume [m].
  dealii::Tensor<1, 3> flux_vector(const DeformedFacePoint<dim> &point,
                                   const dealii::Vector<double> &displacement) const;
  /// Its derivative by the coordinate along a direction.
  double flux_factor(unsigned int direction) const;
};
} // namespace Continua

#endif
