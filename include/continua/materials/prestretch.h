#ifndef continua_materials_prestretch_h
#define continua_materials_prestretch_h

#include <continua/base/parameter_section.h>

#include <deal.II/base/tensor.h>

namespace Continua
{
/**
 * How the wall of a tube is stretched in the shape of the mesh: F0 takes a piece of the mesh to its
 * stress-free state, which need not fit its neighbours. Along the axis it is 1/(axial prestretch),
 * around the tube the angle of the opened ring over a full turn, and 1 across the wall. With an
 * opening angle alpha the mesh has the radii of the opened ring, whose sector has the angle 2 pi -
 * alpha (G. A. Holzapfel, T. C. Gasser, R. W. Ogden, J. Elasticity 61 (2000) 1, section 3). The
 * elastic deformation is F F0^-1.
 */
struct Prestretch
{
  double axial = 1.;         ///< length in the mesh over the stress-free one [1]
  double opening_angle = 0.; ///< alpha [rad]

  /// Declares and reads both in the section of a material. Throws InputError.
  void read(ParameterSection &section);
  bool exists() const { return axial != 1. || opening_angle != 0.; }
  /// F0^-1 [1]; unit vectors at right angles. `share`: how much of F0 - 1 there is, 0 to 1.
  dealii::Tensor<2, 3> inverse(const dealii::Tensor<1, 3> &axis,
                               const dealii::Tensor<1, 3> &circumference,
                               double share) const;
  /// det F0 [1].
  double volume_ratio(double share) const;

private:
  double along(double share) const;
  double around(double share) const;
};
} // namespace Continua

#endif
