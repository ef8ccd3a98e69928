#ifndef continua_laboratory_artery_entry_h
#define continua_laboratory_artery_entry_h

#include <continua/base/units.h>
#include <continua/inference/fit_parameter.h>
#include <continua/materials/material.h>

#include <functional>
#include <string>
#include <vector>

namespace Continua
{
/// An entry of a layer of an artery that a test can determine.
struct ArteryEntry
{
  std::string key; ///< of the section of the material
  Dimension dimension;
  bool is_angle;          ///< [rad], written in degrees
  std::string strain_law; ///< that has it; empty: all
  double lower, upper;    ///< usual bounds, in SI
  FitParameter::Scale scale;
  std::function<double(const Material &)> value;
  /// The strain law must be made anew afterwards (Material::set_strain_law()).
  std::function<void(Material &, double)> set;

  /// "Pa", "rad", "1".
  std::string unit() const;
  /// The value with its unit as a parameter file has it.
  std::string text(double value) const;
};

/// Young's modulus, the constants of the strain laws, and the opening angle.
const std::vector<ArteryEntry> &artery_entries();

/// Null if there is none with this key.
const ArteryEntry *find_artery_entry(const std::string &key);
} // namespace Continua

#endif
