#include <continua/linear_algebra/factor_panels.h>

#include <algorithm>
#include <array>
#include <cstring>

namespace Continua
{
namespace
{
/// Zeros that a panel may have, over its entries: each of them costs as much as an entry.
constexpr double largest_share_of_zeros = 0.2;

/// Two numbers that the processor treats at once.
using Pair __attribute__((vector_size(16))) = double;

Pair load(const double *const from)
{
  Pair pair;
  std::memcpy(&pair, from, sizeof pair);
  return pair;
}

void store(const Pair pair, double *const to)
{
  std::memcpy(to, &pair, sizeof pair);
}
} // namespace

FactorPanels::FactorPanels(const int n,
                           const int *const starts,
                           const int *const counts,
                           const int *const of_rows,
                           const double *const of_values)
{
  inverse_diagonal.resize(n);
  for (int column = 0; column < n; ++column)
    inverse_diagonal[column] = 1. / of_values[starts[column]];
  std::size_t n_rows = 0, n_values = 0;
  for (int first = 0; first < n;)
  {
    int n_columns = 1;
    double n_entries = counts[first] - 1;
    while (n_columns < widest)
    {
      // The next column belongs to the panel if it is the parent of the last one and fills the
      // others with few zeros.
      const int last = first + n_columns - 1, next = last + 1;
      if (counts[last] < 2 || of_rows[starts[last] + 1] != next)
        break;
      const double with_next = n_entries + counts[next] - 1;
      const double of_panel = 0.5 * n_columns * (n_columns + 1.) +
                              static_cast<double>(n_columns + 1) * (counts[next] - 1);
      if (of_panel - with_next > largest_share_of_zeros * of_panel)
        break;
      n_entries = with_next;
      ++n_columns;
    }
    const int n_pairs = (n_columns + 1) / 2, n_below = counts[first + n_columns - 1] - 1;
    panels.push_back({first, n_columns, n_pairs, n_below, n_rows, n_values});
    n_rows += n_below;
    n_values += static_cast<std::size_t>(2 * n_pairs) * (n_columns - 1 + n_below);
    first += n_columns;
  }
  rows.resize(n_rows);
  values.assign(n_values, 0.);
  for (const Panel &panel : panels)
    fill(panel, starts, counts, of_rows, of_values);
}

void FactorPanels::fill(const Panel &panel,
                        const int *const starts,
                        const int *const counts,
                        const int *const of_rows,
                        const double *const of_values)
{
  const int end = panel.first + panel.n_columns, last = end - 1, width = 2 * panel.n_pairs;
  const auto rows_begin = rows.begin() + static_cast<std::ptrdiff_t>(panel.rows);
  std::copy_n(of_rows + starts[last] + 1, panel.n_rows, rows_begin);
  double *const triangle = values.data() + panel.values;
  double *const below = triangle + static_cast<std::size_t>(width) * (panel.n_columns - 1);
  for (int c = 0; c < panel.n_columns; ++c)
  {
    const int column = panel.first + c;
    std::size_t place = 0;
    for (int k = starts[column] + 1; k < starts[column] + counts[column]; ++k)
    {
      const int row = of_rows[k];
      if (row < end)
        triangle[static_cast<std::size_t>(width) * (row - panel.first - 1) + c] = of_values[k];
      else
      {
        while (rows_begin[static_cast<std::ptrdiff_t>(place)] != row)
          ++place;
        below[width * place + c] = of_values[k];
      }
    }
  }
}

template <int n_pairs>
void FactorPanels::forward(const Panel &panel, double *const x) const
{
  constexpr int width = 2 * n_pairs;
  const double *entries = values.data() + panel.values;
  double *const of_panel = x + panel.first;
  for (int row = 1; row < panel.n_columns; ++row, entries += width)
  {
    double sum = 0.;
    for (int c = 0; c < row; ++c)
      sum += entries[c] * of_panel[c];
    of_panel[row] -= sum;
  }
  Pair known[n_pairs];
  for (std::ptrdiff_t p = 0; p < n_pairs; ++p)
    known[p] = load(of_panel + 2 * p);
  const int *const places = rows.data() + panel.rows;
  for (int row = 0; row < panel.n_rows; ++row, entries += width)
  {
    Pair sum = load(entries) * known[0];
    for (std::ptrdiff_t p = 1; p < n_pairs; ++p)
      sum += load(entries + 2 * p) * known[p];
    x[places[row]] -= sum[0] + sum[1];
  }
}

template <int n_pairs>
void FactorPanels::backward(const Panel &panel, double *const x) const
{
  constexpr int width = 2 * n_pairs;
  const double *const triangle = values.data() + panel.values;
  const double *entries = triangle + static_cast<std::size_t>(width) * (panel.n_columns - 1);
  double *const of_panel = x + panel.first;
  const int *const places = rows.data() + panel.rows;
  Pair sums[n_pairs] = {};
  for (int row = 0; row < panel.n_rows; ++row, entries += width)
  {
    const double of_row = x[places[row]];
    const Pair factor = {of_row, of_row};
    for (std::ptrdiff_t p = 0; p < n_pairs; ++p)
      sums[p] += load(entries + 2 * p) * factor;
  }
  for (std::ptrdiff_t p = 0; p < n_pairs; ++p)
    store(load(of_panel + 2 * p) - sums[p], of_panel + 2 * p);
  for (int row = panel.n_columns - 1; row > 0; --row)
    for (int c = 0; c < row; ++c)
      of_panel[c] -= triangle[static_cast<std::size_t>(width) * (row - 1) + c] * of_panel[row];
}

void FactorPanels::solve(double *const x) const
{
  using Work = void (FactorPanels::*)(const Panel &, double *) const;
  // By the number of pairs less one.
  static const std::array<Work, widest / 2> forwards = {
      {&FactorPanels::forward<1>, &FactorPanels::forward<2>, &FactorPanels::forward<3>,
       &FactorPanels::forward<4>, &FactorPanels::forward<5>, &FactorPanels::forward<6>,
       &FactorPanels::forward<7>, &FactorPanels::forward<8>}};
  static const std::array<Work, widest / 2> backwards = {
      {&FactorPanels::backward<1>, &FactorPanels::backward<2>, &FactorPanels::backward<3>,
       &FactorPanels::backward<4>, &FactorPanels::backward<5>, &FactorPanels::backward<6>,
       &FactorPanels::backward<7>, &FactorPanels::backward<8>}};
  x[size()] = 0.; // beside the last column
  for (const Panel &panel : panels)
    (this->*forwards[panel.n_pairs - 1])(panel, x);
  for (std::size_t i = 0; i < size(); ++i)
    x[i] *= inverse_diagonal[i];
  for (auto panel = panels.rbegin(); panel != panels.rend(); ++panel)
    (this->*backwards[panel->n_pairs - 1])(*panel, x);
}

std::size_t FactorPanels::memory() const
{
  return panels.size() * sizeof(Panel) + rows.size() * sizeof(int) +
         (values.size() + inverse_diagonal.size()) * sizeof(double);
}
} // namespace Continua
