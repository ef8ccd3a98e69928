#include <continua/materials/bulk_relaxation.h>

#include <vector>

namespace Continua
{
void relax_volume_as_shear(Material &material, const double poissons_ratio)
{
  const double inverse_ratio = 1.5 * (1. - 2. * poissons_ratio) / (1. + poissons_ratio);
  if (inverse_ratio == 0.)
  {
    material.compression = Compression();
    return;
  }
  std::vector<BulkBranch> branches;
  for (const Branch &branch : material.shear.branches)
    branches.push_back({branch.shear_modulus / inverse_ratio, branch.relaxation_time});
  material.compression = Compression::relaxing(branches);
}
} // namespace Continua
