#ifndef continua_materials_material_h
#define continua_materials_material_h

#include <continua/base/parameter_section.h>
#include <continua/materials/model.h>
#include <continua/materials/prony_fit_parameters.h>

#include <complex>
#include <limits>
#include <string>
#include <utility>
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

/// One spring of the pressure that relaxes: p_k = -K_k e_k, de_k/dt = div U - e_k / tau_k. An
/// infinite tau makes it an elastic one and e the dilatation.
struct BulkBranch
{
  double bulk_modulus = 0.;                                         ///< K [Pa]
  double relaxation_time = std::numeric_limits<double>::infinity(); ///< tau [s]
};

/**
 * What tells one part of the continuum from another: density, bulk modulus, viscosity and branches,
 * nothing else. A fluid has no branches, a Hookean solid one that never relaxes and no viscosity;
 * the operator does not know which it is.
 */
struct Material
{
  std::string type;    ///< the row of the table it was read from
  double density = 0.; ///< rho [kg/m^3]
  /// 1/K [1/Pa]; 0 is incompressible. Where the volume change relaxes too, K is the instantaneous
  /// modulus: the sum over the bulk branches.
  double inverse_bulk_modulus = 0.;
  double viscosity = 0.; ///< eta [Pa s]
  std::vector<Branch> branches;
  std::vector<BulkBranch> bulk_branches; ///< empty: the volume changes elastically, by 1/K
  /// Power-law relaxation of Young's modulus, Y(t) = c (t/s)^-n (equation 5.2 of the thesis): c
  /// [Pa], 0 if there is none, and n. Wave theory takes the law itself; a run takes the branches
  /// that are fitted to it (fit_power_law()).
  double power_law_modulus = 0.;
  double power_law_exponent = 0.;
  /// Poisson's ratio of a power law whose volume change relaxes like its shear; negative: the
  /// volume changes elastically, by 1/K.
  double power_law_poissons_ratio = -1.;
  PronyFitParameters prony_fit; ///< how the branches of a power law are found
  /// Mean pressure over the unknown p: 1, but in plane stress (1+nu)/(1+2nu), where p is an
  /// auxiliary.
  double pressure_factor = 1.;
  /// eps_zz over eps_xx + eps_yy in plane stress: -nu/(1-nu); not used elsewhere.
  double thickness_strain_factor = 0.;

  /// The phase field: 1 where the material has branches, 0 where it has none (equation 7.5 of the
  /// thesis).
  double phase() const { return is_solid() ? 1. : 0.; }
  /// Whether shear is resisted by more than viscosity.
  bool is_solid() const { return !branches.empty() || power_law_modulus > 0.; }
  /// Whether a branch forgets: shear stress or pressure relaxes.
  bool relaxes() const;
  /**
   * Shear stress over shear strain in harmonic motion exp(i omega t) [Pa]: i omega eta + sum_k mu_k
   * i omega tau_k / (1 + i omega tau_k), or of a power law Y(omega)/(3 - Y(omega)/(3 K)) with
   * Y(omega) = c Gamma(1 - n) (i omega)^n (5.6). omega [1/s] may be complex; 0 is excepted for a
   * power law. A fluid is thus a solid of modulus i omega eta.
   */
  std::complex<double> complex_shear_modulus(const std::complex<double> &omega) const;
  /// 1/K in harmonic motion exp(i omega t) [1/Pa]: 1/sum_k K_k i omega tau_k / (1 + i omega tau_k)
  /// where the volume change relaxes, else 1/K.
  std::complex<double> complex_inverse_bulk_modulus(const std::complex<double> &omega) const;
  /// 9 K mu / (3 K + mu) of the same [Pa].
  std::complex<double> complex_young_modulus(const std::complex<double> &omega) const;
  /// Sum of the moduli of the branches that never relax [Pa].
  double long_term_shear_modulus() const;
  /// Sum of the moduli of all branches [Pa].
  double instantaneous_shear_modulus() const;
  /// 1/sum of the bulk moduli that never relax [1/Pa]; infinite if there are bulk branches and all
  /// of them relax.
  double long_term_inverse_bulk_modulus() const;
  /// Speed of longitudinal waves sqrt((K + 4/3 mu)/rho) [m/s]; infinite if incompressible.
  double longitudinal_speed() const;
};

/// The laws that exist: name and a line of description, for the manual and `Type`.
std::vector<std::pair<std::string, std::string>> material_types();

/// Reads a child of the section Materials; only the entries of its `Type` are declared. Throws
/// InputError.
Material read_material(ParameterSection section, Model model);
} // namespace Continua

#endif
