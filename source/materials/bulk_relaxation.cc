#include <continua/materials/bulk_relaxation.h>

namespace Continua
{
void set_bulk_branches(Material &material, const std::vector<BulkBranch> &branches)
{
  material.bulk_branches = branches;
  double sum = 0.;
  for (const BulkBranch &branch : branches)
    sum += branch.bulk_modulus;
  material.inverse_bulk_modulus = 1. / sum;
}

void relax_volume_as_shear(Material &material, const double poissons_ratio)
{
  const double inverse_ratio = 1.5 * (1. - 2. * poissons_ratio) / (1. + poissons_ratio);
  if (inverse_ratio == 0.)
  {
    material.bulk_branches.clear();
    material.inverse_bulk_modulus = 0.;
    return;
  }
  std::vector<BulkBranch> branches;
  for (const Branch &branch : material.branches)
    branches.push_back({branch.shear_modulus / inverse_ratio, branch.relaxation_time});
  set_bulk_branches(material, branches);
}
} // namespace Continua
