#ifndef continua_materials_internal_metric_h
#define continua_materials_internal_metric_h

#include <continua/materials/strain_law.h>

namespace Continua
{
/*
 * A relaxing Maxwell branch at finite strain. A symmetric tensor A, the internal metric, is 1 in a
 * stress-free body and forgets:
 *
 *   dA/dt = (Cb^-1 - A)/tau,   Cb = J^-2/3 F^T F,   stress mu J^-2/3 dev(F A F^T)
 *
 * A stays symmetric and positive definite. A relaxed body has A = Cb^-1 and no stress, since
 * dev(F Cb^-1 F^T) = 0. At small strains this is the linear branch of Shear. At constant volume
 * F A F^T obeys the upper-convected Maxwell model (Oldroyd, Proc. R. Soc. A 200 (1950) 523).
 */

/**
 * The weights of a step of `ratio` x = (duration)/tau that is exact where Cb^-1 is linear in time:
 * with e = exp(-x) and g = (1 - e)/x
 *
 *   A_new = A_plus + (1 - g) Cb_new^-1,   A_plus = e A_old + (g - e) Cb_old^-1
 *
 * They are not negative and their sum is 1.
 */
struct MetricWeights
{
  /// x = 0 (tau is infinite) and an infinite x are allowed.
  explicit MetricWeights(double ratio);

  double old_metric;  ///< e
  double old_inverse; ///< g - e
  double new_inverse; ///< 1 - g
};

/// Cb^-1 = J^2/3 F^-1 F^-T [1].
dealii::SymmetricTensor<2, 3> inverse_isochoric_metric(const PointStrain &strain);

/// A_plus [1], which alone gives the stress at the end of the step: what the new strain adds is a
/// pressure.
dealii::SymmetricTensor<2, 3> kept_metric(const MetricWeights &weights,
                                          const dealii::SymmetricTensor<2, 3> &old_metric,
                                          const dealii::SymmetricTensor<2, 3> &old_inverse);

/// A_new [1].
dealii::SymmetricTensor<2, 3> new_metric(const MetricWeights &weights,
                                         const dealii::SymmetricTensor<2, 3> &kept,
                                         const dealii::SymmetricTensor<2, 3> &new_inverse);

/// Energy of a branch per reference volume, mu/2 (tr(Cb A) - 3 - ln det A) [J/m^3]; 0 if and only
/// if A = Cb^-1.
double metric_energy(double shear_modulus,
                     const PointStrain &strain,
                     const dealii::SymmetricTensor<2, 3> &metric);

/// What the branch turns into heat per reference volume,
/// mu/(2 tau) (tr(A^-1 Cb^-1) + tr(Cb A) - 6) [W/m^3]; never negative.
double metric_dissipation(double shear_modulus,
                          double relaxation_time,
                          const PointStrain &strain,
                          const dealii::SymmetricTensor<2, 3> &metric);
} // namespace Continua

#endif
