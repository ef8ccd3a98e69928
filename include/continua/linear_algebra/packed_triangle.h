#ifndef continua_linear_algebra_packed_triangle_h
#define continua_linear_algebra_packed_triangle_h

#include <cstddef>
#include <cstdint>
#include <vector>

namespace Continua
{
/**
 * A sparse triangular matrix packed for many substitutions. Neighbouring rows of a factor have
 * nearly the same columns, so eight rows are held together: one index and eight values for every
 * column that any of them has, and the inverse of the 8 x 8 triangle on the diagonal. One entry of
 * the vector then serves eight rows, whose sums are independent and go into vector registers.
 */
class PackedTriangle
{
public:
  static constexpr std::size_t block = 8;

  /// A triangle by rows or by columns, as UMFPACK has them: its diagonal included, the entries of
  /// the i-th one are `indices` and `values` from starts[i] to starts[i+1], in any order. All
  /// columns <= row (lower) or all >= row (upper). Takes no memory beside what is kept.
  void take_lower_by_rows(const std::vector<std::int64_t> &starts,
                          const std::vector<std::int64_t> &indices,
                          const std::vector<double> &values);
  void take_upper_by_columns(const std::vector<std::int64_t> &starts,
                             const std::vector<std::int64_t> &indices,
                             const std::vector<double> &values);

  /// The length of the vector that solve() takes: the number of rows, rounded up to whole blocks.
  std::size_t padded_size() const { return diagonal.size() / block; }

  /// Replaces the right-hand side by the solution. What lies beyond the number of rows must be
  /// zero, and stays so.
  void solve(double *x) const;

  double memory() const; ///< bytes

private:
  bool lower = true;
  std::vector<std::size_t> block_starts; ///< into block_columns
  std::vector<int> block_columns;
  std::vector<double> block_values; ///< negative; eight for each of block_columns
  std::vector<double> diagonal;     ///< inverse triangles, by columns

  /// Sizes everything for these numbers of columns of blocks.
  void begin(bool is_lower, std::size_t n_rows, const std::vector<std::size_t> &n_columns);
  /// Replaces the triangles on the diagonal by their inverses.
  void invert_diagonal();
  void solve_block(std::size_t b, double *x) const;
};
} // namespace Continua

#endif
