#include <continua/base/input_error.h>
#include <continua/linear_algebra/umfpack_factor.h>

#include <array>
#include <cassert>
#include <stdexcept>
#include <umfpack.h>

namespace Continua
{
struct UmfpackFactor::Data
{
  std::array<double, UMFPACK_CONTROL> control;
  std::array<double, UMFPACK_INFO> info{};
  void *numeric = nullptr;
  std::vector<int> owned;
  // Long, since the factor of a large matrix has more entries than an int counts.
  std::vector<SuiteSparse_long> column_starts, rows;
  std::vector<double> values;
  // Kept between solves.
  std::vector<double> right_hand_side, solution, workspace;
  std::vector<SuiteSparse_long> index_workspace;

  ~Data() { umfpack_dl_free_numeric(&numeric); }

  void check(const SuiteSparse_long status, const std::string &phase) const
  {
    if (status == UMFPACK_OK)
      return;
    std::string reason = "an internal error";
    if (status == UMFPACK_WARNING_singular_matrix)
      reason = "the matrix is singular";
    else if (status == UMFPACK_ERROR_out_of_memory)
      reason = "out of memory";
    else if (status == UMFPACK_ERROR_invalid_matrix)
      reason = "the matrix is invalid";
    throw RunError("UMFPACK, " + phase + ": " + reason + " (status " + std::to_string(status) +
                   ").");
  }
};

UmfpackFactor::UmfpackFactor() : data(std::make_unique<Data>()) {}

UmfpackFactor::~UmfpackFactor() = default;

void UmfpackFactor::factorize(const SymmetricTriplets &matrix, const std::vector<int> &owned)
{
  matrix.check(owned);
  if (owned.size() != static_cast<std::size_t>(matrix.n))
    throw std::invalid_argument("UmfpackFactor works on one rank only, which owns every index");

  data = std::make_unique<Data>();
  data->owned = owned;
  umfpack_dl_defaults(data->control.data());
  data->control[UMFPACK_IRSTEP] = 0;

  // UMFPACK wants both triangles.
  std::vector<SuiteSparse_long> triplet_rows(matrix.rows.begin(), matrix.rows.end());
  std::vector<SuiteSparse_long> triplet_columns(matrix.columns.begin(), matrix.columns.end());
  std::vector<double> triplet_values = matrix.values;
  for (std::size_t k = 0; k < matrix.rows.size(); ++k)
    if (matrix.rows[k] != matrix.columns[k])
    {
      triplet_rows.push_back(matrix.columns[k]);
      triplet_columns.push_back(matrix.rows[k]);
      triplet_values.push_back(matrix.values[k]);
    }
  const SuiteSparse_long n = matrix.n;
  data->column_starts.resize(n + 1);
  data->rows.resize(triplet_rows.size());
  data->values.resize(triplet_rows.size());
  data->check(umfpack_dl_triplet_to_col(n, n, static_cast<SuiteSparse_long>(triplet_rows.size()),
                                        triplet_rows.data(), triplet_columns.data(),
                                        triplet_values.data(), data->column_starts.data(),
                                        data->rows.data(), data->values.data(), nullptr),
              "sorting the entries");

  void *symbolic = nullptr;
  data->check(umfpack_dl_symbolic(n, n, data->column_starts.data(), data->rows.data(),
                                  data->values.data(), &symbolic, data->control.data(),
                                  data->info.data()),
              "analysis");
  const SuiteSparse_long status =
      umfpack_dl_numeric(data->column_starts.data(), data->rows.data(), data->values.data(),
                         symbolic, &data->numeric, data->control.data(), data->info.data());
  umfpack_dl_free_symbolic(&symbolic);
  data->check(status, "factorisation");

  data->right_hand_side.resize(n);
  data->solution.resize(n);
  data->workspace.resize(n);
  data->index_workspace.resize(n);
}

void UmfpackFactor::solve(std::vector<double> &x)
{
  Data &d = *data;
  assert(x.size() == d.owned.size());
  for (std::size_t k = 0; k < x.size(); ++k)
    d.right_hand_side[d.owned[k]] = x[k];
  // `info` keeps what the factorisation wrote, hence none here.
  d.check(umfpack_dl_wsolve(UMFPACK_A, d.column_starts.data(), d.rows.data(), d.values.data(),
                            d.solution.data(), d.right_hand_side.data(), d.numeric,
                            d.control.data(), nullptr, d.index_workspace.data(),
                            d.workspace.data()),
          "solution");
  for (std::size_t k = 0; k < x.size(); ++k)
    x[k] = d.solution[d.owned[k]];
}

double UmfpackFactor::n_entries() const
{
  return data->info[UMFPACK_LNZ] + data->info[UMFPACK_UNZ];
}

double UmfpackFactor::memory() const
{
  return data->info[UMFPACK_NUMERIC_SIZE] * data->info[UMFPACK_SIZE_OF_UNIT];
}

std::string UmfpackFactor::name() const
{
  return "UMFPACK, L U";
}
} // namespace Continua
