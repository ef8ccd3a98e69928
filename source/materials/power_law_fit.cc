#include <continua/materials/power_law_fit.h>

#include <continua/materials/bulk_relaxation.h>

#include <sstream>
#include <stdexcept>

namespace Continua
{
namespace
{
PronySeries fit_law(const ComplexModulus &law,
                    const PronyFitParameters &parameters,
                    const double lowest_frequency,
                    const double highest_frequency)
{
  if (parameters.n_branches == 0)
    return fit_prony_series_within(law, lowest_frequency, highest_frequency, parameters.tolerance);
  const PronySeries series =
      fit_prony_series(law, lowest_frequency, highest_frequency, parameters.n_branches);
  if (!(series.error <= parameters.tolerance))
  {
    std::ostringstream text;
    text << "a Prony series of " << parameters.n_branches << " branches follows the law within "
         << series.error << " only";
    throw std::range_error(text.str());
  }
  return series;
}
} // namespace

void take_branches(Material &material, const PronySeries &series)
{
  material.shear.branches = {Branch{series.spring}};
  for (std::size_t k = 0; k < series.moduli.size(); ++k)
    material.shear.branches.push_back(Branch{series.moduli[k], series.times[k]});
  const std::optional<double> &poissons_ratio = material.shear.power_law->poissons_ratio;
  if (poissons_ratio)
    relax_volume_as_shear(material, *poissons_ratio);
  if (material.strain_law != nullptr)
    material.set_strain_law();
}

PronySeries
fit_power_law(Material &material, const double lowest_frequency, const double highest_frequency)
{
  // Of a law with c = 1 Pa: round-off does not depend on c then, and walls that differ by their c
  // share the internal displacements of their branches.
  const double scale = material.shear.power_law->modulus;
  Material unit = material;
  unit.shear.power_law->modulus = 1.;
  unit.compression = Compression::elastic(unit.inverse_bulk_modulus() * scale);
  PronySeries series =
      fit_law([&unit](const double omega) { return unit.complex_shear_modulus(omega); },
              material.shear.power_law->prony_fit, lowest_frequency, highest_frequency);

  series.spring *= scale;
  for (double &modulus : series.moduli)
    modulus *= scale;
  take_branches(material, series);
  return series;
}
} // namespace Continua
