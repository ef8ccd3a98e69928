#ifndef continua_linear_algebra_factor_panels_h
#define continua_linear_algebra_factor_panels_h

#include <cstddef>
#include <vector>

namespace Continua
{
/**
 * A sparse factor L D L^T as dense panels, for many solves. Neighbouring columns of L whose rows
 * are nearly the same make a panel: the places of its rows are kept once for all of its columns,
 * and the few entries that a column lacks are zeros. In a wide panel a solve reads little more
 * than 8 bytes for an entry where compressed columns have 12, and it computes with two entries at a
 * time.
 */
class FactorPanels
{
public:
  FactorPanels() = default;
  /// Takes the factor over from compressed columns, as CHOLMOD keeps them: column j has `counts[j]`
  /// entries from `starts[j]` on, with ascending rows; its first one is D where the unit diagonal
  /// of L would stand. The rows of a column are contained in those of its parent, the column of its
  /// second entry.
  FactorPanels(int n, const int *starts, const int *counts, const int *rows, const double *values);

  /// Solves L D L^T x = b in the order of the factor; `x` holds b and has room for size() + 1
  /// numbers, the last of which is changed.
  void solve(double *x) const;
  std::size_t size() const { return inverse_diagonal.size(); }
  std::size_t n_panels() const { return panels.size(); }
  std::size_t memory() const; ///< [bytes]

private:
  struct Panel
  {
    int first;        ///< column
    int n_columns;    ///< at most widest
    int n_pairs;      ///< of columns, the last one filled up with zeros
    int n_rows;       ///< below the columns
    std::size_t rows; ///< where their places begin
    /// Where the entries begin: rows of the triangle from its second one on, then the rows below,
    /// each of n_pairs pairs.
    std::size_t values;
  };
  static constexpr int widest = 16;

  std::vector<Panel> panels;
  std::vector<int> rows;
  std::vector<double> values;
  std::vector<double> inverse_diagonal;

  void fill(const Panel &panel,
            const int *starts,
            const int *counts,
            const int *of_rows,
            const double *of_values);
  template <int n_pairs>
  void forward(const Panel &panel, double *x) const;
  template <int n_pairs>
  void backward(const Panel &panel, double *x) const;
};
} // namespace Continua

#endif
