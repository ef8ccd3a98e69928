#ifndef continua_continuum_motion_extremes_h
#define continua_continuum_motion_extremes_h

#include <deal.II/base/tensor.h>

#include <mpi.h>

namespace Continua
{
struct Problem;

/// How far a state is from rest: largest values over the body.
struct MotionExtremes
{
  double strain = 0.;            ///< principal, of solids, by magnitude [1]
  double rotation = 0.;          ///< of solids [rad]
  double wall_displacement = 0.; ///< across its surface, of a solid's face beside a liquid [m]
  double liquid_speed = 0.;      ///< largest component of a liquid's velocity [m/s]
  double wall_area = 0.; ///< of the undeformed faces of solids beside liquids [m^2], in a plane [m]
  /// Twice the volume of the undeformed liquids over the area of their walls: the radius of a tube,
  /// the height of a channel between two walls [m]. 0 without liquids or walls.
  double liquid_radius = 0.;
  double mesh_volume_ratio = 1.; ///< the least J of a mesh that moves, of all steps until now [1]
  double mesh_volume_time = 0.;  ///< at which the mesh had it [s]
};

/// Takes a point of a solid into the extremes, by the gradient of its displacement and in
/// axisymmetry u_r/r. With small deformation the strain is that of the symmetric part, and the
/// rotation the vector of the antisymmetric one. With finite deformation the strain is the
/// principal stretch less 1, and the rotation the angle of the polar decomposition.
template <int dim>
void take_point_of_solid(const dealii::Tensor<2, dim> &gradient,
                         double hoop,
                         const Problem &problem,
                         unsigned int region,
                         MotionExtremes &extremes);

/// Whether the liquid of a region sticks at a boundary that does not move along its normal.
bool is_wall(const Problem &problem, unsigned int boundary, unsigned int region);

/// The undeformed liquids and their walls [m^3, m^2], in a plane model [m^2, m].
struct LiquidSizes
{
  double volume = 0.;
  double area = 0.;           ///< of all walls
  double area_of_solids = 0.; ///< of the walls that are solids

  /// Of all ranks, from their parts. Collective.
  void sum(MPI_Comm communicator);
  /// Sets what the extremes have of the sizes.
  void set(MotionExtremes &extremes) const;
};
} // namespace Continua

#endif
