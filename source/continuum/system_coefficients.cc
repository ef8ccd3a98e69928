#include <continua/continuum/system_coefficients.h>

#include <continua/base/nearly_equal.h>
#include <continua/continuum/branch_history.h>
#include <continua/continuum/bulk_history.h>

namespace Continua
{
bool SystemCoefficients::operator==(const SystemCoefficients &other) const
{
  return nearly_equal(mass, other.mass) && nearly_equal(stiffness, other.stiffness) &&
         nearly_equal(compressibility, other.compressibility);
}

void SystemCoefficients::set(const std::vector<Material> &materials, const Step &step)
{
  for (std::vector<double> *list : {&mass, &stiffness, &compressibility})
    list->clear();
  for (const Material &material : materials)
  {
    mass.push_back(step.a0 * material.density);
    stiffness.push_back(material.shear.viscosity + BranchHistory::step_stiffness(material, step));
    compressibility.push_back(BulkHistory::step_compressibility(material, step));
  }
}

void SystemCoefficients::set_steady(const std::vector<Material> &materials)
{
  const bool solid = !materials.front().shear.branches.empty();
  for (std::vector<double> *list : {&mass, &stiffness, &compressibility})
    list->clear();
  for (const Material &material : materials)
  {
    mass.push_back(0.);
    stiffness.push_back(solid ? material.long_term_shear_modulus() : material.shear.viscosity);
    compressibility.push_back(solid ? material.long_term_inverse_bulk_modulus() : 0.);
  }
}
} // namespace Continua
