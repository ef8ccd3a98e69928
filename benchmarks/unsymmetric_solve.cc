// What a solve with a kept factor of an unsymmetric matrix costs: UmfpackFactor, against the solves
// of UMFPACK and KLU themselves.
//
//   benchmark_unsymmetric_solve OUTPUT
//
// writes OUTPUT.txt and OUTPUT.md.

#include "measurement.h"

#include <continua/linear_algebra/unsymmetric_factor.h>

#include <deal.II/base/mpi.h>

#include <iostream>
#include <klu.h>
#include <memory>
#include <numeric>
#include <random>
#include <umfpack.h>

namespace Benchmarks
{
using namespace Continua;

constexpr unsigned int n_repetitions = 15;

/// The equations of cells with two velocities and, if there are three unknowns, a pressure: a
/// Laplacian and the wide divergence of the gradient, on neighbours up to two cells away, with rows
/// of very different scales.
Triplets cells(const int n_x, const int n_y, const int n_unknowns)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> about_one(0.9, 1.1);
  Triplets matrix;
  matrix.n = n_x * n_y * n_unknowns;
  const auto add = [&](const int i, const int j, const int a, const int d_i, const int d_j,
                       const int b, const double value)
  {
    if (i + d_i < 0 || i + d_i >= n_x || j + d_j < 0 || j + d_j >= n_y)
      return;
    matrix.rows.push_back((i + n_x * j) * n_unknowns + a);
    matrix.columns.push_back((i + d_i + n_x * (j + d_j)) * n_unknowns + b);
    matrix.values.push_back(value * about_one(random));
  };
  constexpr double stiffness = 2., gradient = 1e-6, divergence = 1e3, compression = 1e-5;
  for (int j = 0; j < n_y; ++j)
    for (int i = 0; i < n_x; ++i)
    {
      for (int a = 0; a < 2; ++a)
      {
        add(i, j, a, 0, 0, a, 1. + 4. * stiffness);
        for (const int side : {-1, 1})
        {
          for (const int axis : {0, 1})
          {
            const int d_i = axis == 0 ? side : 0, d_j = axis == 1 ? side : 0;
            add(i, j, a, d_i, d_j, a, -stiffness);
            add(i, j, a, 2 * d_i, 2 * d_j, a, -0.25 * stiffness);
          }
          for (const int other : {-1, 1})
          {
            add(i, j, a, side, other, a, 0.1 * stiffness);
            add(i, j, a, side, other, 1 - a, 0.25 * stiffness * side * other);
          }
          if (n_unknowns == 3)
          {
            const int d_i = a == 0 ? side : 0, d_j = a == 1 ? side : 0;
            add(i, j, a, d_i, d_j, 2, side * gradient);
            add(i, j, 2, d_i, d_j, a, side * divergence);
            add(i, j, 2, d_i, d_j, 2, -compression);
            add(i, j, 2, 2 * d_i, 2 * d_j, 2, 0.2 * compression);
          }
        }
      }
      if (n_unknowns == 3)
        add(i, j, 2, 0, 0, 2, 6. * compression);
    }
  return matrix;
}

/// Median processor time of a solve [s].
double solve_time(const int n, const std::function<void()> &solve)
{
  const int n_solves = 2 + 2000000 / n / 10;
  std::vector<double> times;
  for (unsigned int repetition = 0; repetition < n_repetitions; ++repetition)
    times.push_back(processor_time(
                        [&]()
                        {
                          for (int k = 0; k < n_solves; ++k)
                            solve();
                        }) /
                    n_solves);
  return median(times);
}

double packed(const Triplets &matrix, double &n_entries)
{
  const auto factor = make_unsymmetric_factor(DirectSolver::umfpack, MPI_COMM_WORLD);
  std::vector<int> owned(matrix.n);
  std::iota(owned.begin(), owned.end(), 0);
  factor->factorize(matrix, owned);
  n_entries = factor->n_entries();
  const std::vector<double> right_hand_side(matrix.n, 1.);
  std::vector<double> x(matrix.n);
  return solve_time(matrix.n,
                    [&]()
                    {
                      x = right_hand_side;
                      factor->solve(x);
                    });
}

/// The same matrix by columns, for the libraries themselves.
struct Columns
{
  std::vector<int> starts, rows;
  std::vector<double> values;
};

Columns by_columns(const Triplets &matrix)
{
  Columns result{std::vector<int>(matrix.n + 1), std::vector<int>(matrix.rows.size()),
                 std::vector<double>(matrix.rows.size())};
  umfpack_di_triplet_to_col(matrix.n, matrix.n, static_cast<int>(matrix.rows.size()),
                            matrix.rows.data(), matrix.columns.data(), matrix.values.data(),
                            result.starts.data(), result.rows.data(), result.values.data(),
                            nullptr);
  return result;
}

double umfpack(const int n, const Columns &matrix)
{
  std::vector<double> control(UMFPACK_CONTROL);
  umfpack_di_defaults(control.data());
  control[UMFPACK_IRSTEP] = 0;
  control[UMFPACK_ORDERING] = UMFPACK_ORDERING_BEST;
  void *symbolic = nullptr, *numeric = nullptr;
  umfpack_di_symbolic(n, n, matrix.starts.data(), matrix.rows.data(), matrix.values.data(),
                      &symbolic, control.data(), nullptr);
  umfpack_di_numeric(matrix.starts.data(), matrix.rows.data(), matrix.values.data(), symbolic,
                     &numeric, control.data(), nullptr);
  std::vector<int> integers(n);
  std::vector<double> work(n), x(n), right_hand_side(n, 1.);
  const double time = solve_time(
      n,
      [&]()
      {
        umfpack_di_wsolve(UMFPACK_A, matrix.starts.data(), matrix.rows.data(), matrix.values.data(),
                          x.data(), right_hand_side.data(), numeric, control.data(), nullptr,
                          integers.data(), work.data());
      });
  umfpack_di_free_symbolic(&symbolic);
  umfpack_di_free_numeric(&numeric);
  return time;
}

double klu(const int n, Columns &matrix)
{
  klu_common common;
  klu_defaults(&common);
  klu_symbolic *symbolic = klu_analyze(n, matrix.starts.data(), matrix.rows.data(), &common);
  klu_numeric *numeric =
      klu_factor(matrix.starts.data(), matrix.rows.data(), matrix.values.data(), symbolic, &common);
  std::vector<double> x(n), right_hand_side(n, 1.);
  const double time = solve_time(n,
                                 [&]()
                                 {
                                   x = right_hand_side;
                                   klu_solve(symbolic, numeric, n, 1, x.data(), &common);
                                 });
  klu_free_numeric(&numeric, &common);
  klu_free_symbolic(&symbolic, &common);
  return time;
}
} // namespace Benchmarks

int main(int argc, char **argv)
{
  using namespace Benchmarks;
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  if (argc != 2)
  {
    std::cerr << "benchmark_unsymmetric_solve OUTPUT" << std::endl;
    return 2;
  }
  Report report("A solve with the factor of an unsymmetric matrix");
  describe_machine(report);
  describe_libraries(report);
  report.start_table("Processor time of a solve in microseconds",
                     {"cells", "unknowns", "entries a row", "entries of the factor",
                      "UmfpackFactor", "UMFPACK", "KLU"});
  for (const auto &[n_x, n_y] : {std::pair(40, 10), std::pair(160, 40)})
    for (const int n_unknowns : {2, 3})
    {
      const Triplets matrix = cells(n_x, n_y, n_unknowns);
      Columns columns = by_columns(matrix);
      double n_entries = 0.;
      const double time = packed(matrix, n_entries);
      report.row({std::to_string(n_x) + " x " + std::to_string(n_y), std::to_string(matrix.n),
                  number(static_cast<double>(matrix.rows.size()) / matrix.n), number(n_entries),
                  number(1e6 * time), number(1e6 * umfpack(matrix.n, columns)),
                  number(1e6 * klu(matrix.n, columns))});
    }
  report.finish(argv[1]);
  return 0;
}
