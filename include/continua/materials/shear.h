#ifndef continua_materials_shear_h
#define continua_materials_shear_h

#include <continua/materials/flow_curve.h>
#include <continua/materials/prony_fit_parameters.h>

#include <complex>
#include <limits>
#include <optional>
#include <vector>

namespace Continua
{
/**
 * One spring (with its dash pot) of a solid: stress 2 mu dev(sym grad D), dD/dt = U - D / tau. An
 * infinite tau makes it a Hookean spring and D the displacement.
 */
struct Branch
{
  double shear_modulus = 0.;                                        ///< mu [Pa]
  double relaxation_time = std::numeric_limits<double>::infinity(); ///< tau [s]
};

/// Power-law relaxation of Young's modulus, Y(t) = c (t/1 s)^-n (equation 5.2 of the thesis). Wave
/// theory takes the law itself; a run takes the branches that are fitted to it (fit_power_law()).
struct PowerLaw
{
  double modulus = 0.;  ///< c [Pa]
  double exponent = 0.; ///< n [1]
  /// Of a volume change that relaxes like the shear; none: the volume changes by the material's
  /// compression.
  std::optional<double> poissons_ratio;
  PronyFitParameters prony_fit; ///< how the branches are found

  /// Y(omega) = c Gamma(1 - n) (i omega)^n (5.6) [Pa].
  std::complex<double> young_modulus(const std::complex<double> &i_omega) const;
};

/// How a material resists a change of its shape. A fluid has a viscosity alone, a Hookean solid one
/// branch that never relaxes.
struct Shear
{
  double viscosity = 0.; ///< eta; with a flow curve that at rest [Pa s]
  /// Of a liquid whose viscosity depends on the rate of shear.
  std::optional<FlowCurve> flow_curve;
  std::vector<Branch> branches;
  std::optional<PowerLaw> power_law;

  /// Whether shear is resisted by more than viscosity.
  bool is_solid() const { return !branches.empty() || power_law; }
  /// Whether the stress relaxes. That of a power law does, also before its branches are there.
  bool relaxes() const;
  /// Sum of the moduli of the branches that never relax [Pa].
  double long_term_modulus() const;
  /// Sum of the moduli of all branches [Pa].
  double instantaneous_modulus() const;
};
} // namespace Continua

#endif
