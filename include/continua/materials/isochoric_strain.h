#ifndef continua_materials_isochoric_strain_h
#define continua_materials_isochoric_strain_h

#include <continua/materials/strain_law.h>

namespace Continua
{
/// F^T F - 1 [1] without the round-off of F^T F at small strains.
dealii::SymmetricTensor<2, 3> twice_green_strain(const dealii::Tensor<2, 3> &gradient);

/// The part of a deformation that changes the shape: J^-1/3 F.
struct IsochoricStrain
{
  explicit IsochoricStrain(const PointStrain &strain);

  double factor;                      ///< J^-2/3 [1]
  dealii::SymmetricTensor<2, 3> left; ///< Bb = J^-2/3 F F^T [1]
  /// tr Bb - 3 [1], of second order in the strain: its relative round-off at a strain e is that of
  /// F over e, where the difference itself would lose e^2.
  double first_excess;

  /// (tr^2 Bb - tr Bb^2)/2 - 3 [1], to the same accuracy.
  double second_excess() const;

private:
  dealii::SymmetricTensor<2, 3> left_excess; ///< Bb - 1
};
} // namespace Continua

#endif
