#include <continua/base/input_error.h>
#include <continua/base/kept_signal_action.h>
#include <continua/base/lack_of_memory.h>
#include <continua/linear_algebra/packed_triangle.h>
#include <continua/linear_algebra/umfpack_factor.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <umfpack.h>
#include <utility>

namespace Continua
{
namespace
{
// Long, since the factor of a large matrix has more entries than an int counts.
using Index = SuiteSparse_long;

void check_umfpack(const Index status, const std::string &phase)
{
  if (status == UMFPACK_OK)
    return;
  std::string reason = "an internal error";
  if (status == UMFPACK_WARNING_singular_matrix)
    reason = "the matrix is singular";
  else if (status == UMFPACK_ERROR_out_of_memory)
    reason = lack_of_memory;
  else if (status == UMFPACK_ERROR_invalid_matrix)
    reason = "the matrix is invalid";
  throw RunError("UMFPACK, " + phase + ": " + reason + " (status " + std::to_string(status) + ").");
}

/// A matrix by columns.
struct Columns
{
  std::vector<Index> starts, rows;
  std::vector<double> values;
};

/// Of entries that are sorted by columns, and in a column by rows, each place once; else nothing.
std::optional<Columns> columns_of_sorted(const Triplets &matrix)
{
  for (std::size_t k = 1; k < matrix.rows.size(); ++k)
    if (std::make_pair(matrix.columns[k - 1], matrix.rows[k - 1]) >=
        std::make_pair(matrix.columns[k], matrix.rows[k]))
      return std::nullopt;
  Columns result;
  result.starts.assign(matrix.n + 1, 0);
  for (const int column : matrix.columns)
    ++result.starts[column + 1];
  std::partial_sum(result.starts.begin(), result.starts.end(), result.starts.begin());
  result.rows.assign(matrix.rows.begin(), matrix.rows.end());
  result.values = matrix.values;
  return result;
}

Columns sorted_by_columns(const Triplets &matrix)
{
  if (std::optional<Columns> sorted = columns_of_sorted(matrix))
    return std::move(*sorted);
  const std::vector<Index> rows(matrix.rows.begin(), matrix.rows.end());
  const std::vector<Index> columns(matrix.columns.begin(), matrix.columns.end());
  Columns result;
  result.starts.resize(matrix.n + 1);
  result.rows.resize(rows.size());
  result.values.resize(rows.size());
  check_umfpack(umfpack_dl_triplet_to_col(matrix.n, matrix.n, static_cast<Index>(rows.size()),
                                          rows.data(), columns.data(), matrix.values.data(),
                                          result.starts.data(), result.rows.data(),
                                          result.values.data(), nullptr),
                "sorting the entries");
  return result;
}

/// UMFPACK's handle.
struct Numeric
{
  void *handle = nullptr;
  ~Numeric() { free(); }
  void free() { umfpack_dl_free_numeric(&handle); }
  double n_entries() const
  {
    Index n_lower = 0, n_upper = 0, n_rows = 0, n_columns = 0, n_diagonal = 0;
    check_umfpack(umfpack_dl_get_lunz(&n_lower, &n_upper, &n_rows, &n_columns, &n_diagonal, handle),
                  "size of the factor");
    return static_cast<double>(n_lower) + static_cast<double>(n_upper);
  }
};

/// What the order of the unknowns is chosen by.
enum class Strategy
{
  symmetric, ///< the places of A + A^T, and pivots on the diagonal where they are large enough
  automatic  ///< as UMFPACK itself decides
};

/// Whether there is an entry (j, i) for each (i, j): in one pass, since the rows of a column are
/// sorted.
bool has_symmetric_places(const Columns &matrix)
{
  std::vector<Index> next(matrix.starts.begin(), matrix.starts.end() - 1);
  for (std::size_t column = 0; column < next.size(); ++column)
    for (Index k = matrix.starts[column]; k < matrix.starts[column + 1]; ++k)
    {
      const Index row = matrix.rows[k];
      Index &other = next[row];
      if (other == matrix.starts[row + 1] || matrix.rows[other] != static_cast<Index>(column))
        return false;
      ++other;
    }
  return true;
}

std::array<double, UMFPACK_CONTROL> controls(const Strategy strategy)
{
  std::array<double, UMFPACK_CONTROL> control;
  umfpack_dl_defaults(control.data());
  control[UMFPACK_ORDERING] = UMFPACK_ORDERING_BEST;
  if (strategy == Strategy::symmetric)
    control[UMFPACK_STRATEGY] = UMFPACK_STRATEGY_SYMMETRIC;
  return control;
}

Index make_numeric(const Columns &matrix, void *const symbolic, Numeric &numeric)
{
  // The strategy is a part of the analysis.
  const std::array<double, UMFPACK_CONTROL> control = controls(Strategy::automatic);
  std::array<double, UMFPACK_INFO> info{};
  return umfpack_dl_numeric(matrix.starts.data(), matrix.rows.data(), matrix.values.data(),
                            symbolic, &numeric.handle, control.data(), info.data());
}
} // namespace

/// The order of the unknowns, with the places of the entries that it is for.
struct UmfpackFactor::Analysis
{
  std::vector<Index> starts;
  std::vector<int> rows;
  Strategy strategy;
  void *symbolic = nullptr;
  /// Of the factor: what the symmetric strategy promises; with the other one those of the first
  /// factor, 0 before there is one.
  double n_entries = 0.;

  Analysis(const Columns &matrix, const Strategy wanted)
      : starts(matrix.starts), rows(matrix.rows.begin(), matrix.rows.end()), strategy(wanted)
  {
    analyse(matrix);
    if (strategy == Strategy::automatic || info[UMFPACK_PATTERN_SYMMETRY] == 1.)
      return;
    umfpack_dl_free_symbolic(&symbolic);
    strategy = Strategy::automatic;
    analyse(matrix);
  }
  ~Analysis() { umfpack_dl_free_symbolic(&symbolic); }
  Analysis(const Analysis &) = delete;
  Analysis &operator=(const Analysis &) = delete;
  bool is_for(const Columns &matrix) const
  {
    return starts == matrix.starts &&
           std::equal(rows.begin(), rows.end(), matrix.rows.begin(), matrix.rows.end());
  }

private:
  std::array<double, UMFPACK_INFO> info{};

  void analyse(const Columns &matrix)
  {
    const std::array<double, UMFPACK_CONTROL> control = controls(strategy);
    const auto n = static_cast<Index>(starts.size() - 1);
    const KeptSignalAction kept;
    check_umfpack(umfpack_dl_symbolic(n, n, starts.data(), matrix.rows.data(), matrix.values.data(),
                                      &symbolic, control.data(), info.data()),
                  "analysis");
    n_entries = strategy == Strategy::symmetric ? info[UMFPACK_SYMMETRIC_LUNZ] : 0.;
  }
};

struct UmfpackFactor::Data
{
  // L U = P R A Q: the k-th pivot row is index row_order[k], the k-th pivot column column_order[k].
  PackedTriangle lower, upper;
  std::vector<int> row_order, column_order; ///< places in `owned`
  std::vector<double> row_scales;           ///< by pivot
  std::vector<double> work;
  double n_entries = 0.;

  /// Frees UMFPACK's factor when it has it.
  void take(Numeric &numeric, Index n, const std::vector<int> &owned);
};

void UmfpackFactor::Data::take(Numeric &numeric, const Index n, const std::vector<int> &owned)
{
  Index n_lower = 0, n_upper = 0, n_rows = 0, n_columns = 0, n_diagonal = 0;
  check_umfpack(
      umfpack_dl_get_lunz(&n_lower, &n_upper, &n_rows, &n_columns, &n_diagonal, numeric.handle),
      "size of the factor");
  n_entries = static_cast<double>(n_lower) + static_cast<double>(n_upper);

  // One triangle at a time: beside the other one and UMFPACK's own.
  std::vector<Index> starts(n + 1);
  {
    // By rows.
    std::vector<Index> columns(n_lower);
    std::vector<double> values(n_lower);
    check_umfpack(umfpack_dl_get_numeric(starts.data(), columns.data(), values.data(), nullptr,
                                         nullptr, nullptr, nullptr, nullptr, nullptr, nullptr,
                                         nullptr, numeric.handle),
                  "reading the factor");
    lower.take_lower_by_rows(starts, columns, values);
  }
  {
    // By columns.
    std::vector<Index> rows(n_upper), p(n), q(n);
    std::vector<double> values(n_upper), scales(n);
    Index scales_are_reciprocal = 0;
    check_umfpack(umfpack_dl_get_numeric(nullptr, nullptr, nullptr, starts.data(), rows.data(),
                                         values.data(), p.data(), q.data(), nullptr,
                                         &scales_are_reciprocal, scales.data(), numeric.handle),
                  "reading the factor");
    numeric.free();
    upper.take_upper_by_columns(starts, rows, values);
    std::vector<int> place(n);
    for (Index k = 0; k < n; ++k)
      place[owned[k]] = static_cast<int>(k);
    row_order.resize(n);
    column_order.resize(n);
    row_scales.resize(n);
    for (Index k = 0; k < n; ++k)
    {
      row_order[k] = place[p[k]];
      column_order[k] = place[q[k]];
      row_scales[k] = scales_are_reciprocal ? scales[p[k]] : 1. / scales[p[k]];
    }
  }
  work.assign(lower.padded_size(), 0.);
}

UmfpackFactor::UmfpackFactor() : data(std::make_unique<Data>()) {}

UmfpackFactor::~UmfpackFactor() = default;

void UmfpackFactor::factorize(const Triplets &matrix, const std::vector<int> &owned)
{
  matrix.check(owned);
  if (owned.size() != static_cast<std::size_t>(matrix.n))
    throw std::invalid_argument("UmfpackFactor works on one rank only, which owns every index");

  data = nullptr; // the old factor goes before the new one is made
  data = std::make_unique<Data>();
  Columns columns = sorted_by_columns(matrix);
  if (!analysis || !analysis->is_for(columns))
  {
    analysis = nullptr;
    analysis = std::make_unique<Analysis>(
        columns, has_symmetric_places(columns) ? Strategy::symmetric : Strategy::automatic);
  }
  Numeric numeric;
  Index status = make_numeric(columns, analysis->symbolic, numeric);
  if (analysis->strategy == Strategy::symmetric &&
      (status == UMFPACK_WARNING_singular_matrix || status == UMFPACK_ERROR_out_of_memory ||
       (status == UMFPACK_OK && numeric.n_entries() > most_growth * analysis->n_entries)))
  {
    // Too few pivots on the diagonal. A factor that grows may take all memory.
    numeric.free();
    analysis = nullptr;
    analysis = std::make_unique<Analysis>(columns, Strategy::automatic);
    status = make_numeric(columns, analysis->symbolic, numeric);
  }
  check_umfpack(status, "factorisation");
  // The largest memory is that of UMFPACK's factor beside the packed one.
  columns = {};
  data->take(numeric, matrix.n, owned);
  if (analysis->n_entries == 0.)
    analysis->n_entries = data->n_entries;
  else if (data->n_entries > most_growth * analysis->n_entries)
    analysis = nullptr;
}

void UmfpackFactor::forget_analysis()
{
  analysis = nullptr;
}

void UmfpackFactor::solve(std::vector<double> &x)
{
  Data &d = *data;
  const std::size_t n = d.row_order.size();
  assert(x.size() == n);
  for (std::size_t k = 0; k < n; ++k)
    d.work[k] = d.row_scales[k] * x[d.row_order[k]];
  d.lower.solve(d.work.data());
  d.upper.solve(d.work.data());
  for (std::size_t k = 0; k < n; ++k)
    x[d.column_order[k]] = d.work[k];
}

double UmfpackFactor::n_entries() const
{
  return data->n_entries;
}

double UmfpackFactor::memory() const
{
  const auto n = static_cast<double>(data->row_order.size());
  // Without UMFPACK's own part of the analysis, which is smaller.
  const double of_analysis = analysis
                                 ? static_cast<double>(sizeof(Index) * analysis->starts.size() +
                                                       sizeof(int) * analysis->rows.size())
                                 : 0.;
  return data->lower.memory() + data->upper.memory() + n * (2 * sizeof(int) + 2 * sizeof(double)) +
         of_analysis;
}

std::string UmfpackFactor::name() const
{
  return "UMFPACK, L U";
}
} // namespace Continua
