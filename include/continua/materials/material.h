#ifndef continua_materials_material_h
#define continua_materials_material_h

#include <continua/base/parameter_section.h>
#include <continua/materials/compression.h>
#include <continua/materials/model.h>
#include <continua/materials/prestretch.h>
#include <continua/materials/shear.h>
#include <continua/materials/strain_law.h>
#include <continua/materials/strain_law_parameters.h>
#include <continua/materials/volume_law.h>

#include <complex>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace Continua
{
/**
 * What tells one part of the continuum from another: density, compression and shear, nothing else.
 * The operator does not know whether it is a fluid or a solid.
 */
struct Material
{
  std::string type;    ///< the row of the table it was read from
  double density = 0.; ///< rho [kg/m^3]
  /// Where a power law's volume change relaxes like its shear: incompressible until the branches
  /// are there.
  Compression compression;
  Shear shear;
  double volume_exponent = 0.;    ///< n of the VolumeLaw [1]
  double reference_pressure = 0.; ///< p0 of it [Pa]
  /// Of a solid with Deformation::finite, else null: its spring that never relaxes, beside which
  /// the branches are neo-Hookean (internal_metric.h).
  std::shared_ptr<const StrainLaw> strain_law;
  StrainLawParameters strain_law_parameters; ///< of it
  Prestretch prestretch;                     ///< beside such a law

  /// Of a fluid that is convected.
  VolumeLaw volume_law() const
  {
    return {inverse_bulk_modulus(), volume_exponent, reference_pressure};
  }
  /// The phase field: 1 where the material has branches, 0 where it has none (equation 7.5 of the
  /// thesis).
  double phase() const { return is_solid() ? 1. : 0.; }
  /// Whether shear is resisted by more than viscosity.
  bool is_solid() const { return shear.is_solid(); }
  bool is_incompressible() const { return compression.is_incompressible(); }
  bool has_power_law() const { return shear.power_law.has_value(); }
  /// Whether shear stress or pressure relaxes.
  bool relaxes() const { return shear.relaxes() || compression.relaxes(); }
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
  /// Of Shear [Pa] and of Compression [1/Pa].
  double long_term_shear_modulus() const { return shear.long_term_modulus(); }
  double instantaneous_shear_modulus() const { return shear.instantaneous_modulus(); }
  double inverse_bulk_modulus() const { return compression.inverse_bulk_modulus(); }
  double long_term_inverse_bulk_modulus() const
  {
    return compression.long_term_inverse_bulk_modulus();
  }
  /// Makes the law of finite deformation by the parameters and the branches that there are.
  void set_strain_law();
  /// Speed of longitudinal waves sqrt((K + 4/3 mu)/rho) [m/s]; infinite if incompressible.
  double longitudinal_speed() const;
};

/// The laws that exist: name and a line of description, for the manual and `Type`.
std::vector<std::pair<std::string, std::string>> material_types();

/// Reads a child of the section Materials; only the entries of its `Type` are declared. Throws
/// InputError.
Material read_material(ParameterSection section, Model model);
/// Reads the law of finite deformation of a solid that was read, whose long-term shear modulus it
/// takes; leaves a liquid as it is. Throws InputError.
void read_strain_law(ParameterSection section, Material &material);
} // namespace Continua

#endif
