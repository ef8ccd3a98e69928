#ifndef continua_linear_algebra_entry_sums_h
#define continua_linear_algebra_entry_sums_h

#include <continua/linear_algebra/unsymmetric_factor.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace Continua
{
/**
 * A matrix that is summed over and over from entries which come in the same order each time, such
 * as those of its cells: the first time they are sorted, and the place of each is kept, so that
 * later ones only add to it. If the order has changed, finish() notices it.
 *
 *   do
 *   {
 *     sums.begin(n);
 *     sums.add(row, column, value); ...
 *   } while (!sums.finish());
 */
class EntrySums
{
public:
  /// Begins a matrix of global size n.
  void begin(int n);
  void add(const int row, const int column, const double value)
  {
    checksum =
        (checksum ^ (static_cast<std::uint64_t>(row) << 32 | static_cast<std::uint32_t>(column))) *
        0x9E3779B97F4A7C15U;
    if (!is_known)
    {
      unsorted.rows.push_back(row);
      unsorted.columns.push_back(column);
      unsorted.values.push_back(value);
    }
    else if (n_added < places.size())
      sums.values[places[n_added]] += value;
    ++n_added;
  }
  /// False: the entries did not come in the order of before, which is forgotten; all of them must
  /// be added once more, from begin() on.
  bool finish();
  /// Each place once, sorted by columns and in a column by rows; after finish().
  const Triplets &matrix() const { return sums; }
  /// The places change: another mesh, other constraints.
  void forget();
  /// Of the places that are kept [bytes].
  double memory() const;

private:
  bool is_known = false;
  std::size_t n_added = 0;
  std::uint64_t checksum = 0, known_checksum = 0; ///< of rows and columns in their order
  std::vector<std::uint32_t> places;              ///< in `sums`, of the entries in their order
  Triplets unsorted, sums;

  void sort();
};
} // namespace Continua

#endif
