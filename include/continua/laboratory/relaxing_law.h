#ifndef continua_laboratory_relaxing_law_h
#define continua_laboratory_relaxing_law_h

#include <continua/materials/shear.h>
#include <continua/materials/strain_law.h>

#include <vector>

namespace Continua
{
/**
 * A hyperelastic law beside Maxwell branches (internal_metric.h), at one point and within one step:
 * tau of both, for the strain at the end of the step. The branches begin free of stress.
 */
class RelaxingLaw : public StrainLaw
{
public:
  /// `law` must outlive this; of the branches only those that relax count.
  RelaxingLaw(const StrainLaw &law, const std::vector<Branch> &branches);

  /// Begins a step of that duration [s]; 0 for a strain that is there at once.
  void begin_step(double duration);
  /// Ends the step with that strain.
  void end_step(const PointStrain &strain);

  void set_stress(const PointStrain &strain, dealii::SymmetricTensor<2, 3> &stress) const override;
  void set_tangent(const PointStrain &strain,
                   dealii::SymmetricTensor<2, 3> &stress,
                   dealii::SymmetricTensor<4, 3> &tangent) const override;
  /// With that of the branches, before the new strain relaxes.
  double energy(const PointStrain &strain) const override;
  double shear_modulus() const override;
  bool has_own_mean_stress() const override { return law.has_own_mean_stress(); }
  void set_mean_stress(const PointStrain &strain,
                       double &mean_stress,
                       dealii::SymmetricTensor<2, 3> &derivative) const override;

private:
  const StrainLaw &law;
  std::vector<Branch> branches;
  std::vector<dealii::SymmetricTensor<2, 3>> metrics;      ///< at the start of the step
  std::vector<dealii::SymmetricTensor<2, 3>> kept_metrics; ///< of the step
  dealii::SymmetricTensor<2, 3> old_inverse;               ///< Cb^-1 at the start of the step
  dealii::SymmetricTensor<2, 3> weighted; ///< sum of mu_k times the kept metrics [Pa]
  double duration = 0.;                   ///< [s]
};
} // namespace Continua

#endif
