#include <continua/continuum/sparse_entries.h>

namespace Continua
{
SparseEntries::SparseEntries(const DistributedVector &vector)
{
  const double *const values = vector.begin();
  for (unsigned int i = 0; i < vector.locally_owned_size(); ++i)
    if (values[i] != 0.)
      entries.emplace_back(i, values[i]);
}

double SparseEntries::product(const DistributedVector &vector) const
{
  const double *const values = vector.begin();
  double sum = 0.;
  for (const auto &[index, value] : entries)
    sum += value * values[index];
  return sum;
}

void SparseEntries::add_to(DistributedVector &vector, const double factor) const
{
  for (const auto &[index, value] : entries)
    vector.begin()[index] += factor * value;
}

void SparseEntries::copy_to(DistributedVector &vector, const double factor) const
{
  for (const auto &[index, value] : entries)
    vector.begin()[index] = factor * value;
}
} // namespace Continua
