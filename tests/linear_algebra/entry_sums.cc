// Sums of entries at the same places: sorted, equal to those of a map, the same bits each time, and
// other places are noticed.

#include <continua/linear_algebra/entry_sums.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

#include "../unit_test.h"

namespace test_of_entry_sums
{
using namespace Continua;

namespace
{
struct Entry
{
  int row, column;
  double value;
};

std::vector<Entry> random_entries(const unsigned int seed, const unsigned int seed_of_values)
{
  std::mt19937 places(seed), values(seed_of_values);
  std::vector<Entry> result;
  for (unsigned int k = 0; k < 2000; ++k)
  {
    const int row = static_cast<int>(places() % 30), column = static_cast<int>(places() % 30);
    result.push_back({row, column, static_cast<double>(values() % 1000) / 7.});
  }
  return result;
}

/// How often all entries had to be added.
unsigned int sum(EntrySums &sums, const std::vector<Entry> &entries)
{
  unsigned int n = 0;
  do
  {
    sums.begin(30);
    for (const Entry &entry : entries)
      sums.add(entry.row, entry.column, entry.value);
    ++n;
  } while (!sums.finish());
  return n;
}

double largest_difference(const EntrySums &sums, const std::vector<Entry> &entries)
{
  std::map<std::pair<int, int>, double> expected; // by column, then row
  for (const Entry &entry : entries)
    expected[{entry.column, entry.row}] += entry.value;
  const Triplets &matrix = sums.matrix();
  if (matrix.values.size() != expected.size())
    return 1e300;
  double difference = 0.;
  std::size_t k = 0;
  for (const auto &[place, value] : expected)
  {
    if (matrix.columns[k] != place.first || matrix.rows[k] != place.second)
      return 1e300;
    difference = std::max(difference, std::abs(matrix.values[k++] - value));
  }
  return difference;
}
} // namespace

UNIT_TEST(entry_sums)
{
  EntrySums sums;
  const std::vector<Entry> first = random_entries(1, 2), second = random_entries(1, 3);
  check::absolute("added once", sum(sums, first), 1., 0.);
  check::absolute("sorted sums", largest_difference(sums, first), 0., 1e-11);
  const std::vector<double> values = sums.matrix().values;
  check::absolute("other values at the same places, added once", sum(sums, second), 1., 0.);
  check::absolute("their sums", largest_difference(sums, second), 0., 1e-11);
  sum(sums, first);
  check::is_true("the same bits", sums.matrix().values == values);
  check::is_true("memory", sums.memory() > 4. * 2000.);

  // The same entries in another order, one more, one less.
  std::vector<Entry> swapped = first;
  std::swap(swapped[5], swapped[6]);
  check::absolute("another order, added twice", sum(sums, swapped), 2., 0.);
  check::absolute("its sums", largest_difference(sums, swapped), 0., 1e-11);
  std::vector<Entry> longer = first;
  longer.push_back({29, 29, 1.});
  check::absolute("one more, added twice", sum(sums, longer), 2., 0.);
  check::absolute("sums with one more", largest_difference(sums, longer), 0., 1e-11);
  check::absolute("one less, added twice", sum(sums, first), 2., 0.);
  check::absolute("sums with one less", largest_difference(sums, first), 0., 1e-11);
  sums.forget();
  check::absolute("forgotten, added once", sum(sums, second), 1., 0.);
  check::absolute("sums after that", largest_difference(sums, second), 0., 1e-11);
  sums.begin(3);
  sums.add(3, 0, 1.);
  check::throws<std::invalid_argument>(
      "an entry outside", [&]() { sums.finish(); }, "outside the matrix");
}
} // namespace test_of_entry_sums
