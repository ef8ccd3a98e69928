#include <continua/base/input_error.h>
#include <continua/base/kept_signal_action.h>
#include <continua/base/lack_of_memory.h>
#include <continua/base/memory_use.h>
#include <continua/linear_algebra/mumps_solver.h>
#include <continua/linear_algebra/singular_matrix.h>

#include <cassert>
#include <cmath>
#include <cstring>
#include <dmumps_c.h>
#include <numeric>
#include <smumps_c.h>
#include <stdexcept>
#include <type_traits>
#include <zmumps_c.h>

namespace Continua
{
namespace
{
/// From here on the factorisation decides how much memory a run needs, and takes seconds [bytes].
constexpr double large_factor = 1e8;

// MUMPS's values of `job`.
constexpr int job_initialise = -1;
constexpr int job_terminate = -2;
constexpr int job_analyse = 1;
constexpr int job_factorise = 2;
constexpr int job_solve = 3;

/// What INFOG(1) means, for the values that a user may meet.
std::string reason(const int code)
{
  switch (code)
  {
  case -6:
  case -10:
    return "the matrix is singular";
  case -5:
  case -7:
  case -13:
    return lack_of_memory;
  case -8:
  case -9:
  case -17:
  case -20:
    return "the working space is too small even after it was enlarged";
  case -19:
    return "the working space is larger than allowed";
  default:
    return "an internal error";
  }
}

/// MUMPS counts the entries of large factors in millions, with a minus.
double count_of(const int entries)
{
  return entries >= 0 ? entries : -1e6 * entries;
}

/// MUMPS's interface for a kind of numbers.
template <typename Number>
struct MumpsInterface;

template <>
struct MumpsInterface<double>
{
  using Structure = DMUMPS_STRUC_C;
  static void call(Structure &structure) { dmumps_c(&structure); }
  static MPI_Datatype type() { return MPI_DOUBLE; }
};

template <>
struct MumpsInterface<float>
{
  using Structure = SMUMPS_STRUC_C;
  static void call(Structure &structure) { smumps_c(&structure); }
  static MPI_Datatype type() { return MPI_FLOAT; }
};

template <>
struct MumpsInterface<std::complex<double>>
{
  using Structure = ZMUMPS_STRUC_C;
  static void call(Structure &structure) { zmumps_c(&structure); }
  static MPI_Datatype type() { return MPI_C_DOUBLE_COMPLEX; }
};

/// Numbers as MUMPS has them: a complex one is a structure of two.
template <typename Number>
auto entries_of(Number *const numbers)
{
  using Entry = std::remove_pointer_t<decltype(MumpsInterface<Number>::Structure::a_loc)>;
  static_assert(sizeof(Entry) == sizeof(Number), "MUMPS has other numbers.");
  return reinterpret_cast<Entry *>(numbers);
}
} // namespace

template <typename Number>
struct MumpsSolver<Number>::Data
{
  using Interface = MumpsInterface<Number>;

  MPI_Comm communicator;
  int n_ranks = 1;
  typename Interface::Structure mumps;
  std::vector<int> owned;
  std::vector<int> kept_rows, kept_columns; ///< from 1, of a pattern that is kept

  // Kept between solves. One rank: the right-hand side and solution in global order.
  std::vector<Number> global_vector;
  // Several ranks: `owned` from 1, MUMPS's own distribution of the solution, and the exchange from
  // that to `owned`.
  std::vector<int> owned_from_one, solution_indices;
  std::vector<Number> local_solution, send_buffer, receive_buffer;
  std::vector<int> send_order, receive_order;
  std::vector<int> send_counts, send_starts, receive_counts, receive_starts;

  Data(const MumpsSymmetry symmetry, const MPI_Comm communicator) : communicator(communicator)
  {
    MPI_Comm_size(communicator, &n_ranks);
    std::memset(&mumps, 0, sizeof(mumps));
    mumps.sym = symmetry == MumpsSymmetry::unsymmetric ? 0 : 2;
    mumps.par = 1; // rank 0 works, too
    mumps.comm_fortran = MPI_Comm_c2f(communicator);
    run(job_initialise, "start");
    for (const int output : {1, 2, 3})
      icntl(output) = -1;
    icntl(4) = 0;
  }

  ~Data()
  {
    mumps.job = job_terminate;
    Interface::call(mumps);
  }

  Data(const Data &) = delete;
  Data &operator=(const Data &) = delete;

  /// The control numbered as in MUMPS's manual.
  int &icntl(const int number) { return mumps.icntl[number - 1]; }

  [[noreturn]] void fail(const std::string &phase) const
  {
    const int code = mumps.infog[0];
    const std::string text = "MUMPS, " + phase + ": " + reason(code) +
                             " (INFOG(1) = " + std::to_string(code) +
                             ", INFOG(2) = " + std::to_string(mumps.infog[1]) + ").";
    if (code == -6 || code == -10)
      throw SingularMatrix(text);
    throw RunError(text);
  }

  void run(const int job, const std::string &phase)
  {
    mumps.job = job;
    const KeptSignalAction kept;
    Interface::call(mumps);
    if (mumps.infog[0] < 0)
      fail(phase);
  }

  /// Factors, with more working space as long as MUMPS asks for it.
  void factorize()
  {
    constexpr int largest_percentage = 2000;
    while (true)
    {
      mumps.job = job_factorise;
      Interface::call(mumps);
      const int code = mumps.infog[0];
      const bool too_small = code == -8 || code == -9 || code == -17 || code == -20;
      if (!too_small || icntl(14) >= largest_percentage)
        break;
      icntl(14) *= 2;
    }
    if (mumps.infog[0] < 0)
      fail("factorisation");
    const int n_null_pivots = mumps.infog[27];
    if (n_null_pivots > 0)
      throw SingularMatrix("MUMPS, factorisation: the matrix is singular (INFOG(28) = " +
                           std::to_string(n_null_pivots) + " pivots are zero).");
  }

  void plan_exchange();
};

template <typename Number>
void MumpsSolver<Number>::Data::plan_exchange()
{
  int rank = 0;
  MPI_Comm_rank(communicator, &rank);
  std::vector<int> owner(mumps.n, -1);
  std::vector<int> position(mumps.n, -1);
  for (std::size_t k = 0; k < owned.size(); ++k)
  {
    owner[owned[k]] = rank;
    position[owned[k]] = static_cast<int>(k);
  }
  MPI_Allreduce(MPI_IN_PLACE, owner.data(), mumps.n, MPI_INT, MPI_MAX, communicator);

  send_counts.assign(n_ranks, 0);
  for (const int index : solution_indices)
    ++send_counts[owner[index - 1]];
  receive_counts.assign(n_ranks, 0);
  MPI_Alltoall(send_counts.data(), 1, MPI_INT, receive_counts.data(), 1, MPI_INT, communicator);
  send_starts.assign(n_ranks, 0);
  receive_starts.assign(n_ranks, 0);
  std::partial_sum(send_counts.begin(), send_counts.end() - 1, send_starts.begin() + 1);
  std::partial_sum(receive_counts.begin(), receive_counts.end() - 1, receive_starts.begin() + 1);

  std::vector<int> next = send_starts;
  std::vector<int> sent_indices(solution_indices.size());
  send_order.resize(solution_indices.size());
  for (std::size_t k = 0; k < solution_indices.size(); ++k)
  {
    const int place = next[owner[solution_indices[k] - 1]]++;
    send_order[place] = static_cast<int>(k);
    sent_indices[place] = solution_indices[k] - 1;
  }
  receive_order.resize(owned.size());
  MPI_Alltoallv(sent_indices.data(), send_counts.data(), send_starts.data(), MPI_INT,
                receive_order.data(), receive_counts.data(), receive_starts.data(), MPI_INT,
                communicator);
  for (int &index : receive_order)
    index = position[index];
  send_buffer.resize(send_order.size());
  receive_buffer.resize(receive_order.size());
}

template <typename Number>
MumpsSolver<Number>::MumpsSolver(const MumpsSymmetry symmetry,
                                 const MumpsScaling scaling,
                                 const MPI_Comm communicator)
    : symmetry(symmetry), scaling(scaling), communicator(communicator)
{
}

template <typename Number>
MumpsSolver<Number>::~MumpsSolver() = default;

template <typename Number>
FactorEstimate MumpsSolver<Number>::analyse_from_one(const int n,
                                                     std::vector<int> &rows,
                                                     std::vector<int> &columns,
                                                     Number *const values)
{
  data = nullptr; // the old factor goes before the new one is made
  data = std::make_unique<Data>(symmetry, communicator);
  Data &d = *data;
  d.mumps.n = n;
  d.mumps.nnz_loc = static_cast<MUMPS_INT8>(rows.size());
  d.mumps.irn_loc = rows.data();
  d.mumps.jcn_loc = columns.data();
  d.mumps.a_loc = entries_of(values);
  d.icntl(18) = 3; // entries distributed in any way
  d.icntl(28) = 1; // sequential, hence reproducible, analysis
  d.icntl(7) = 5;  // METIS; a MUMPS built without it (Debian's) takes PORD instead
  if (scaling == MumpsScaling::none)
    d.icntl(8) = 0;
  if (counts_pivots)
    d.icntl(13) = 1; // no ScaLAPACK, see the header
  if (computes_determinant)
    d.icntl(33) = 1;
  d.icntl(10) = 0;         // no iterative refinement
  d.icntl(24) = 1;         // find the zero pivots of a singular matrix
  d.mumps.cntl[2] = 1e-13; // what counts as zero, relative to the scaled matrix
  if (symmetry == MumpsSymmetry::quasi_definite)
    d.mumps.cntl[0] = 0.; // no pivoting
  d.run(job_analyse, "analysis");
  d.mumps.irn_loc = d.mumps.jcn_loc = nullptr;
  d.mumps.a_loc = nullptr;
  return {count_of(d.mumps.infog[19]), 1e6 * d.mumps.infog[16]};
}

template <typename Number>
FactorEstimate
MumpsSolver<Number>::analyse(const int n, std::vector<int> rows, std::vector<int> columns)
{
  for (std::vector<int> *const indices : {&rows, &columns})
    for (int &index : *indices)
      ++index;
  const FactorEstimate estimate = analyse_from_one(n, rows, columns, nullptr);
  data = nullptr;
  return estimate;
}

template <typename Number>
void MumpsSolver<Number>::factorize(const int n,
                                    std::vector<int> rows,
                                    std::vector<int> columns,
                                    std::vector<Number> values,
                                    const std::vector<int> &owned,
                                    const std::function<void(const FactorEstimate &)> &announce)
{
  const long n_owned = owned.size();
  long n_owned_of_all = 0;
  MPI_Allreduce(&n_owned, &n_owned_of_all, 1, MPI_LONG, MPI_SUM, communicator);
  if (n_owned_of_all != n)
    throw std::invalid_argument("MUMPS: each index must be owned by one rank");

  for (int &row : rows)
    ++row;
  for (int &column : columns)
    ++column;
  const FactorEstimate estimate = analyse_from_one(n, rows, columns, values.data());
  if (announce) // it may throw
    announce(estimate);
  Data &d = *data;
  d.owned = owned;
  d.mumps.irn_loc = rows.data();
  d.mumps.jcn_loc = columns.data();
  d.mumps.a_loc = entries_of(values.data());
  if (estimate.memory > large_factor)
    return_freed_memory(); // of the analysis
  d.factorize();
  d.mumps.irn_loc = d.mumps.jcn_loc = nullptr;
  d.mumps.a_loc = nullptr;

  d.mumps.nrhs = 1;
  if (d.n_ranks == 1)
  {
    d.global_vector.resize(n);
    d.mumps.rhs = entries_of(d.global_vector.data());
    d.mumps.lrhs = n;
    return;
  }

  d.owned_from_one = owned;
  for (int &index : d.owned_from_one)
    ++index;
  d.icntl(20) = 10; // right-hand side distributed by the caller
  d.icntl(21) = 1;  // solution distributed as MUMPS likes
  d.mumps.nloc_rhs = d.mumps.lrhs_loc = static_cast<int>(owned.size());
  d.mumps.irhs_loc = d.owned_from_one.data();
  d.mumps.lsol_loc = d.mumps.info[22];
  d.solution_indices.resize(d.mumps.lsol_loc);
  d.local_solution.resize(d.mumps.lsol_loc);
  d.mumps.isol_loc = d.solution_indices.data();
  d.mumps.sol_loc = entries_of(d.local_solution.data());
  // MUMPS says with the first solution how it distributes them.
  std::vector<Number> zero(owned.size(), Number());
  d.mumps.rhs_loc = entries_of(zero.data());
  d.run(job_solve, "solution");
  d.plan_exchange();
}

template <typename Number>
FactorEstimate
MumpsSolver<Number>::keep_pattern(const int n, std::vector<int> rows, std::vector<int> columns)
{
  for (std::vector<int> *const indices : {&rows, &columns})
    for (int &index : *indices)
      ++index;
  const FactorEstimate estimate = analyse_from_one(n, rows, columns, nullptr);
  assert(data->n_ranks == 1);
  data->kept_rows = std::move(rows);
  data->kept_columns = std::move(columns);
  if (estimate.memory > large_factor)
    return_freed_memory(); // of the analysis
  return estimate;
}

template <typename Number>
void MumpsSolver<Number>::factorize_values(std::vector<Number> &values)
{
  Data &d = *data;
  assert(values.size() == d.kept_rows.size());
  d.mumps.irn_loc = d.kept_rows.data();
  d.mumps.jcn_loc = d.kept_columns.data();
  d.mumps.a_loc = entries_of(values.data());
  d.factorize();
  d.mumps.a_loc = nullptr;
}

template <typename Number>
void MumpsSolver<Number>::solve_columns(std::vector<Number> &columns, const int n_columns)
{
  Data &d = *data;
  assert(columns.size() == static_cast<std::size_t>(d.mumps.n) * n_columns);
  d.mumps.nrhs = n_columns;
  d.mumps.lrhs = d.mumps.n;
  d.mumps.rhs = entries_of(columns.data());
  d.run(job_solve, "solution");
}

template <typename Number>
std::complex<double> MumpsSolver<Number>::log_determinant() const
{
  assert(computes_determinant);
  const auto &mumps = data->mumps;
  const std::complex<double> mantissa(mumps.rinfog[11], mumps.rinfog[12]);
  return std::log(mantissa) + mumps.infog[33] * std::log(2.);
}

template <typename Number>
void MumpsSolver<Number>::solve(std::vector<Number> &x)
{
  Data &d = *data;
  assert(x.size() == d.owned.size());
  if (d.n_ranks == 1)
  {
    for (std::size_t k = 0; k < x.size(); ++k)
      d.global_vector[d.owned[k]] = x[k];
    d.run(job_solve, "solution");
    for (std::size_t k = 0; k < x.size(); ++k)
      x[k] = d.global_vector[d.owned[k]];
    return;
  }

  d.mumps.rhs_loc = entries_of(x.data());
  d.run(job_solve, "solution");
  for (std::size_t k = 0; k < d.send_order.size(); ++k)
    d.send_buffer[k] = d.local_solution[d.send_order[k]];
  MPI_Alltoallv(d.send_buffer.data(), d.send_counts.data(), d.send_starts.data(),
                Data::Interface::type(), d.receive_buffer.data(), d.receive_counts.data(),
                d.receive_starts.data(), Data::Interface::type(), d.communicator);
  for (std::size_t k = 0; k < d.receive_order.size(); ++k)
    x[d.receive_order[k]] = d.receive_buffer[k];
}

template <typename Number>
double MumpsSolver<Number>::n_entries() const
{
  return count_of(data->mumps.infog[28]);
}

template <typename Number>
std::size_t MumpsSolver<Number>::n_negative_pivots() const
{
  return data->mumps.infog[11];
}

template <typename Number>
double MumpsSolver<Number>::memory() const
{
  return 1e6 * data->mumps.infog[21]; // megabytes used in the factorisation, over all ranks
}

template class MumpsSolver<double>;
template class MumpsSolver<float>;
template class MumpsSolver<std::complex<double>>;
} // namespace Continua
