#include <continua/linear_algebra/entry_sums.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace Continua
{
namespace
{
/// The entries in the order of their keys, 0 to n - 1, and of equal keys in the order that is
/// given.
std::vector<std::uint32_t>
ordered_by(const std::vector<int> &keys, const std::vector<std::uint32_t> &order, const int n)
{
  std::vector<std::size_t> next(n + 1, 0);
  for (const int key : keys)
    ++next[key + 1];
  std::partial_sum(next.begin(), next.end(), next.begin());
  std::vector<std::uint32_t> result(order.size());
  for (const std::uint32_t entry : order)
    result[next[keys[entry]]++] = entry;
  return result;
}
} // namespace

void EntrySums::begin(const int n)
{
  if (n != sums.n)
    forget();
  sums.n = n;
  n_added = 0;
  checksum = 0;
  std::fill(sums.values.begin(), sums.values.end(), 0.);
}

void EntrySums::forget()
{
  is_known = false;
  places = {};
  sums = {};
  unsorted = {};
}

bool EntrySums::finish()
{
  if (!is_known)
  {
    sort();
    return true;
  }
  if (n_added == places.size() && checksum == known_checksum)
    return true;
  forget();
  return false;
}

void EntrySums::sort()
{
  const std::size_t n_entries = unsorted.rows.size();
  if (n_entries >= std::numeric_limits<std::uint32_t>::max())
    throw std::length_error("EntrySums: more entries than a 32-bit index can count");
  for (const std::vector<int> *const indices : {&unsorted.rows, &unsorted.columns})
    if (std::any_of(indices->begin(), indices->end(),
                    [this](const int index) { return index < 0 || index >= sums.n; }))
      throw std::invalid_argument("EntrySums: an entry lies outside the matrix");
  std::vector<std::uint32_t> order(n_entries);
  std::iota(order.begin(), order.end(), 0U);
  order = ordered_by(unsorted.rows, order, sums.n);
  order = ordered_by(unsorted.columns, order, sums.n);
  places.resize(n_entries);
  int row = -1, column = -1;
  for (const std::uint32_t entry : order)
  {
    if (unsorted.rows[entry] != row || unsorted.columns[entry] != column)
    {
      row = unsorted.rows[entry];
      column = unsorted.columns[entry];
      sums.rows.push_back(row);
      sums.columns.push_back(column);
    }
    places[entry] = static_cast<std::uint32_t>(sums.rows.size() - 1);
  }
  // In the order in which later sums add, so that equal entries give equal sums.
  sums.values.assign(sums.rows.size(), 0.);
  for (std::size_t entry = 0; entry < n_entries; ++entry)
    sums.values[places[entry]] += unsorted.values[entry];
  unsorted = {};
  known_checksum = checksum;
  is_known = true;
}

double EntrySums::memory() const
{
  return sizeof(std::uint32_t) * static_cast<double>(places.capacity()) +
         (2 * sizeof(int) + sizeof(double)) * static_cast<double>(sums.values.capacity());
}
} // namespace Continua
