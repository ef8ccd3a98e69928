#ifndef continua_theory_bar_law_h
#define continua_theory_bar_law_h

#include <continua/base/units.h>
#include <continua/materials/material.h>

#include <memory>
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
class BarLaw
{
public:
  using Entries = std::vector<std::pair<std::string, std::string>>;

  /// Poisson's ratio [1], up to 0.5.
  explicit BarLaw(const double poissons_ratio) : poissons_ratio(poissons_ratio) {}
  virtual ~BarLaw() = default;
  /// The Type of its material in a parameter file.
  virtual std::string type() const = 0;
  /// "a Prony series of 2 branches", "a power law".
  virtual std::string description() const { return "a " + type() + " solid"; }
  /// The constants in their order: of a Prony series Young's modulus (of the spring that never
  /// relaxes), the shear moduli, the relaxation times.
  virtual std::vector<BarLawConstant> constants() const = 0;
  /// The material of these constants, in SI, without density. A power law has no branches.
  virtual Material material(const std::vector<double> &constants) const = 0;
  /// The entries of a material in a parameter file, with units: key and value, but for the density.
  virtual Entries entries(const std::vector<double> &constants) const = 0;
  /// The constants with a modulus of 1 Pa and this time [s] or exponent [1]. A law with branches
  /// throws std::logic_error.
  virtual std::vector<double> unit_constants(double time_or_exponent) const = 0;
  /// Springs that relax beside the one that never does.
  virtual unsigned int n_branches() const { return 0; }
  /// Whether it is a Prony series, of any number of branches.
  virtual bool is_series() const { return false; }
  /// Whether a test of relaxation shows all constants.
  virtual bool is_shown_by_relaxation() const { return true; }

protected:
  bool is_compressible() const { return poissons_ratio < 0.5; }

  const double poissons_ratio; ///< [1]
};

/// The types of laws: hookean, kelvin-voigt, maxwell, prony, power law.
std::vector<std::string> bar_law_types();

/// A law by its type. Only a Prony series has branches, one at least. Throws std::logic_error for a
/// type that there is not.
std::shared_ptr<const BarLaw>
make_bar_law(const std::string &type, double poissons_ratio = 0.5, unsigned int n_branches = 1);

/// The Prony series of that many branches; of none, a Hookean solid.
std::shared_ptr<const BarLaw> make_series_of_bar(double poissons_ratio, unsigned int n_branches);
} // namespace Continua

#endif
