#include <continua/base/input_error.h>
#include <continua/base/kept_signal_action.h>
#include <continua/base/lack_of_memory.h>
#include <continua/linear_algebra/cholmod_factor.h>
#include <continua/linear_algebra/factor_panels.h>
#include <continua/linear_algebra/singular_matrix.h>

#include <algorithm>
#include <cassert>
#include <cholmod.h>
#include <cmath>
#include <stdexcept>

namespace Continua
{
struct CholmodFactor::Data
{
  cholmod_common common;
  cholmod_factor *factor = nullptr;
  std::vector<int> owned;
  std::vector<int> starts, rows;    ///< of the matrix that was analysed, if it is kept
  FactorPanels panels;              ///< the numbers of the factor
  std::vector<int> places;          ///< of the owned indices in the factor's order
  std::vector<double> in_its_order; ///< right-hand side and solution of a solve
  std::size_t n_negative_pivots = 0;

  Data()
  {
    cholmod_start(&common);
    common.print = 0;
    common.supernodal = CHOLMOD_SIMPLICIAL;
    common.final_ll = false;
    common.grow2 = 0; // no room in the columns for updates of the factor
    // Both are tried, the one with fewer entries in the factor is taken.
    common.nmethods = 2;
    common.method[0].ordering = CHOLMOD_AMD;
    common.method[1].ordering = CHOLMOD_NESDIS;
    common.postorder = true;
  }

  ~Data()
  {
    cholmod_free_factor(&factor, &common);
    cholmod_finish(&common);
  }

  Data(const Data &) = delete;
  Data &operator=(const Data &) = delete;

  /// Whether the factor has the order of a matrix with these places.
  bool is_analysed(const cholmod_sparse &matrix) const
  {
    const auto *const its_starts = static_cast<const int *>(matrix.p);
    const auto *const its_rows = static_cast<const int *>(matrix.i);
    return factor != nullptr && starts.size() == matrix.ncol + 1 &&
           std::equal(starts.begin(), starts.end(), its_starts) &&
           std::equal(rows.begin(), rows.end(), its_rows);
  }
  void keep_places(const cholmod_sparse &matrix)
  {
    const auto *const its_starts = static_cast<const int *>(matrix.p);
    const auto *const its_rows = static_cast<const int *>(matrix.i);
    starts.assign(its_starts, its_starts + matrix.ncol + 1);
    rows.assign(its_rows, its_rows + starts.back());
  }

  void check(const std::string &phase) const
  {
    if (common.status == CHOLMOD_OK)
      return;
    std::string reason = "an internal error";
    if (common.status == CHOLMOD_OUT_OF_MEMORY)
      reason = lack_of_memory;
    else if (common.status == CHOLMOD_TOO_LARGE)
      reason = "the factor has more entries than a 32-bit index can count; choose mumps";
    else if (common.status == CHOLMOD_NOT_POSDEF)
      reason = "the matrix is singular";
    const std::string text =
        "CHOLMOD, " + phase + ": " + reason + " (status " + std::to_string(common.status) + ").";
    if (common.status == CHOLMOD_NOT_POSDEF)
      throw SingularMatrix(text);
    throw RunError(text);
  }

  /// Without pivoting a singular matrix shows in a pivot that is pure rounding error of its
  /// diagonal entry.
  void check_pivots(const std::vector<double> &diagonal) const
  {
    const auto *const order = static_cast<const int *>(factor->Perm);
    const auto *const starts = static_cast<const int *>(factor->p);
    const auto *const values = static_cast<const double *>(factor->x);
    for (std::size_t k = 0; k < factor->n; ++k)
    {
      // The diagonal D stands where the unit diagonal of L would.
      const double pivot = values[starts[k]];
      if (!std::isfinite(pivot))
        throw RunError("CHOLMOD, factorisation: the pivot of index " + std::to_string(order[k]) +
                       " is not finite; the matrix holds a NaN or an infinite entry.");
      if (std::abs(pivot) <= 1e-13 * std::abs(diagonal[order[k]]))
        throw SingularMatrix("CHOLMOD, factorisation: the matrix is singular, the pivot of index " +
                             std::to_string(order[k]) + " lost all its digits.");
    }
  }

  /// Takes the numbers of the factor over into panels; CHOLMOD keeps the order of the unknowns.
  void take_panels()
  {
    const auto *const order = static_cast<const int *>(factor->Perm);
    const auto *const its_starts = static_cast<const int *>(factor->p);
    const auto *const values = static_cast<const double *>(factor->x);
    const int n = static_cast<int>(factor->n);
    n_negative_pivots = 0;
    for (int k = 0; k < n; ++k)
      n_negative_pivots += values[its_starts[k]] < 0. ? 1 : 0;
    panels = FactorPanels(n, its_starts, static_cast<const int *>(factor->nz),
                          static_cast<const int *>(factor->i), values);
    std::vector<int> place_of_index(n);
    for (int k = 0; k < n; ++k)
      place_of_index[order[k]] = k;
    places.resize(n);
    for (int k = 0; k < n; ++k)
      places[k] = place_of_index[owned[k]];
    in_its_order.assign(n + 1, 0.);
    cholmod_change_factor(CHOLMOD_PATTERN, 0, 0, 0, 0, factor, &common);
    check("taking the factor over");
  }
};

CholmodFactor::CholmodFactor() : data(std::make_unique<Data>()) {}

CholmodFactor::~CholmodFactor() = default;

void CholmodFactor::factorize(SymmetricTriplets matrix, const std::vector<int> &owned)
{
  matrix.check(owned);
  if (owned.size() != static_cast<std::size_t>(matrix.n))
    throw std::invalid_argument("CholmodFactor works on one rank only, which owns every index");

  if (!keeps_analysis)
    data = std::make_unique<Data>();
  Data &d = *data;
  d.owned = owned;
  const std::size_t n = matrix.n;
  const std::size_t n_triplets = matrix.rows.size();

  cholmod_triplet triplets{};
  triplets.nrow = triplets.ncol = n;
  triplets.nzmax = triplets.nnz = n_triplets;
  // CHOLMOD reads only; its interface does not say so.
  triplets.i = const_cast<int *>(matrix.rows.data());
  triplets.j = const_cast<int *>(matrix.columns.data());
  triplets.x = const_cast<double *>(matrix.values.data());
  triplets.stype = -1; // the lower triangle
  triplets.itype = CHOLMOD_INT;
  triplets.xtype = CHOLMOD_REAL;
  triplets.dtype = CHOLMOD_DOUBLE;
  // `announce` may throw.
  const auto free_sparse = [&d](cholmod_sparse *of_matrix)
  { cholmod_free_sparse(&of_matrix, &d.common); };
  const std::unique_ptr<cholmod_sparse, decltype(free_sparse)> sparse(
      cholmod_triplet_to_sparse(&triplets, n_triplets, &d.common), free_sparse);
  d.check("sorting the entries");
  if (!d.is_analysed(*sparse))
  {
    cholmod_free_factor(&d.factor, &d.common);
    const KeptSignalAction kept;
    d.factor = cholmod_analyze(sparse.get(), &d.common);
    if (keeps_analysis)
      d.keep_places(*sparse);
  }
  d.panels = FactorPanels(); // not beside the new numbers
  // An entry is a number and the place of its row, and a number of a panel while these are made.
  if (announce && d.common.status == CHOLMOD_OK)
    announce({d.common.lnz, d.common.lnz * (2 * sizeof(double) + sizeof(int))});
  if (d.common.status == CHOLMOD_OK)
    cholmod_factorize(sparse.get(), d.factor, &d.common);
  d.check("factorisation");

  std::vector<double> diagonal(n, 0.);
  for (std::size_t k = 0; k < n_triplets; ++k)
    if (matrix.rows[k] == matrix.columns[k])
      diagonal[matrix.rows[k]] += matrix.values[k];
  d.check_pivots(diagonal);
  d.take_panels();
}

void CholmodFactor::solve(std::vector<double> &x)
{
  Data &d = *data;
  assert(x.size() == d.owned.size());
  for (std::size_t k = 0; k < x.size(); ++k)
    d.in_its_order[d.places[k]] = x[k];
  d.panels.solve(d.in_its_order.data());
  for (std::size_t k = 0; k < x.size(); ++k)
    x[k] = d.in_its_order[d.places[k]];
}

std::size_t CholmodFactor::count_negative_pivots() const
{
  return data->n_negative_pivots;
}

double CholmodFactor::n_entries() const
{
  return data->common.lnz;
}

double CholmodFactor::memory() const
{
  // Beside the panels, per column: permutation, counts, place, and a number of a solve.
  return static_cast<double>(data->panels.memory() + 20 * data->panels.size());
}

std::string CholmodFactor::name() const
{
  return "CHOLMOD, simplicial L D L^T";
}
} // namespace Continua
