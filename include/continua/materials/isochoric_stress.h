#ifndef continua_materials_isochoric_stress_h
#define continua_materials_isochoric_stress_h

#include <deal.II/base/symmetric_tensor.h>

namespace Continua
{
/**
 * The tangent C [Pa] of StrainLaw for a stress tau = dev(t) that depends on J^-1/3 F alone, where
 * the fictitious stress t [Pa] changes by dt = c : e + g t + t g^T:
 *
 *   C = 2/3 (tr(t) P - tau x 1 - 1 x tau) + P : c : P,   P = I - 1/3 1 x 1
 *
 * (Holzapfel, Nonlinear Solid Mechanics (2000), section 6.6). This is the part without c.
 */
dealii::SymmetricTensor<4, 3> isochoric_tangent(double fictitious_trace,
                                                const dealii::SymmetricTensor<2, 3> &stress);

/// a x b; deal.II's outer_product() takes three times as long.
dealii::SymmetricTensor<4, 3> dyadic_product(const dealii::SymmetricTensor<2, 3> &a,
                                             const dealii::SymmetricTensor<2, 3> &b);

/// P : c : P of a tensor with major symmetry.
dealii::SymmetricTensor<4, 3> deviator_of_both(const dealii::SymmetricTensor<4, 3> &tensor);

/// b b, where deal.II's product of two symmetric tensors is b : b.
dealii::SymmetricTensor<2, 3> square(const dealii::SymmetricTensor<2, 3> &b);

/// The tensor c with c : e = b e b.
dealii::SymmetricTensor<4, 3> both_sides_product(const dealii::SymmetricTensor<2, 3> &b);
} // namespace Continua

#endif
