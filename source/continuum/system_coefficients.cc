#include <continua/continuum/system_coefficients.h>

#include <continua/base/nearly_equal.h>
#include <continua/continuum/branch_history.h>
#include <continua/continuum/bulk_history.h>

namespace Continua
{
bool SystemCoefficients::operator==(const SystemCoefficients &other) const
{
  return nearly_equal(mass, other.mass) && nearly_equal(stiffness, other.stiffness) &&
         nearly_equal(compressibility, other.compressibility) && left_out == other.left_out &&
         nearly_equal(support_stiffness, other.support_stiffness) &&
         nearly_equal(support_damping, other.support_damping) &&
         finds_steady_state == other.finds_steady_state;
}

void SystemCoefficients::set(const Problem &problem, const Step &step)
{
  for (std::vector<double> *list : {&mass, &stiffness, &compressibility})
    list->clear();
  for (const Material &material : problem.materials)
  {
    mass.push_back(step.a0 * material.density);
    const bool is_viscous = !material.is_solid() || !step.finds_steady_state;
    stiffness.push_back((is_viscous ? material.shear.viscosity : 0.) +
                        BranchHistory::step_stiffness(material, step));
    compressibility.push_back(BulkHistory::step_compressibility(material, step));
  }
  // In the mesh's shape springs of supports are free of force.
  const bool has_supports = problem.has_supports() && !step.finds_unloaded_shape;
  support_stiffness = has_supports ? BranchHistory::step_displacement(step) : 0.;
  support_damping = has_supports && !step.finds_steady_state ? 1. : 0.;
  finds_steady_state = step.finds_steady_state;
  left_out.clear();
}

void SystemCoefficients::leave_out(const unsigned int region)
{
  for (std::vector<double> *list : {&mass, &stiffness, &compressibility})
    (*list)[region] = 0.;
  left_out.resize(mass.size(), false);
  left_out[region] = true;
}

void SystemCoefficients::set_steady(const Problem &problem)
{
  const bool solid = !problem.materials.front().shear.branches.empty();
  for (std::vector<double> *list : {&mass, &stiffness, &compressibility})
    list->clear();
  for (const Material &material : problem.materials)
  {
    mass.push_back(0.);
    stiffness.push_back(solid ? material.long_term_shear_modulus() : material.shear.viscosity);
    compressibility.push_back(solid ? material.long_term_inverse_bulk_modulus() : 0.);
  }
  left_out.clear();
  support_stiffness = solid && problem.has_supports() ? 1. : 0.;
  support_damping = 0.;
  finds_steady_state = false;
}
} // namespace Continua
