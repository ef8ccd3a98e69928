#ifndef continua_theory_bar_law_h
#define continua_theory_bar_law_h

#include <continua/base/units.h>
#include <continua/materials/material.h>

#include <string>
#include <utility>
#include <vector>

namespace Continua
{
/// A constant of a law.
struct BarLawConstant
{
  std::string name; ///< "Young's modulus", "Shear moduli 2": key and place in the list of the key
  Dimension dimension;
};

/**
 * A law of a solid whose constants tests of a bar determine. Poisson's ratio is given, since a bar
 * does not show it; of laws that relax it is the same at all times.
 */
struct BarLaw
{
  std::string type;            ///< of a material: "hookean", "prony", ...; a row of types()
  unsigned int n_branches = 0; ///< of prony, at least one
  double poissons_ratio = 0.5; ///< [1]

  /// hookean, kelvin-voigt, maxwell, prony, power law.
  static const std::vector<std::string> &types();
  /// The constants in their order: of prony Young's modulus (of the spring that never relaxes), the
  /// shear moduli, the relaxation times.
  std::vector<BarLawConstant> constants() const;
  /// The material of these constants, in SI, without density. A power law has no branches.
  Material material(const std::vector<double> &constants) const;
  /// "a Prony series of 2 branches", "a power law".
  std::string description() const;
  /// The entries of a material in a parameter file, with units: key and value, but for the density.
  std::vector<std::pair<std::string, std::string>>
  entries(const std::vector<double> &constants) const;
};
} // namespace Continua

#endif
