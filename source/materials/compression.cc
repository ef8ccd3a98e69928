#include <continua/materials/compression.h>

#include <algorithm>
#include <cmath>

namespace Continua
{
Compression Compression::elastic(const double inverse_bulk_modulus)
{
  Compression result;
  result.kind_of_compression = inverse_bulk_modulus == 0. ? Kind::incompressible : Kind::elastic;
  result.inverse_modulus = inverse_bulk_modulus;
  return result;
}

Compression Compression::relaxing(const std::vector<BulkBranch> &branches)
{
  Compression result;
  result.kind_of_compression = Kind::relaxing;
  result.branches = branches;
  double sum = 0.;
  for (const BulkBranch &branch : branches)
    sum += branch.bulk_modulus;
  result.inverse_modulus = 1. / sum;
  return result;
}

bool Compression::relaxes() const
{
  return std::any_of(branches.begin(), branches.end(),
                     [](const BulkBranch &branch) { return !std::isinf(branch.relaxation_time); });
}

double Compression::long_term_inverse_bulk_modulus() const
{
  if (kind_of_compression != Kind::relaxing)
    return inverse_modulus;
  double sum = 0.;
  for (const BulkBranch &branch : branches)
    if (std::isinf(branch.relaxation_time))
      sum += branch.bulk_modulus;
  return 1. / sum;
}
} // namespace Continua
