#ifndef continua_tests_linear_algebra_symmetric_problems_h
#define continua_tests_linear_algebra_symmetric_problems_h

// Symmetric systems whose solution is known, for the tests of the factors.

#include <continua/linear_algebra/symmetric_factor.h>

#include <algorithm>
#include <cmath>
#include <mpi.h>
#include <vector>

namespace symmetric_problems
{
using Continua::SymmetricTriplets;

inline void add(SymmetricTriplets &matrix, const int i, const int j, const double value)
{
  matrix.rows.push_back(std::max(i, j));
  matrix.columns.push_back(std::min(i, j));
  matrix.values.push_back(value);
}

/// [2 0 -1; 0 1 2; -1 2 -3]: times (1, 2, 3) it is (-1, 8, -6).
inline SymmetricTriplets small_indefinite()
{
  return {3, {0, 1, 2, 2, 2}, {0, 1, 0, 1, 2}, {2, 1, -1, 2, -3}};
}

/// [1 2 3; 2 4 6; 3 6 9].
inline SymmetricTriplets rank_one()
{
  return {3, {0, 1, 1, 2, 2, 2}, {0, 0, 1, 0, 1, 2}, {1, 2, 4, 3, 6, 9}};
}

/// The five-point Laplacian of m x m nodes inside a square, less `shift`, has the eigenvalues
/// 4 - 2 cos(i pi/(m + 1)) - 2 cos(j pi/(m + 1)) - shift: so many of them are negative.
inline SymmetricTriplets five_points(const int m, const double shift)
{
  SymmetricTriplets matrix;
  matrix.n = m * m;
  for (int j = 0; j < m; ++j)
    for (int i = 0; i < m; ++i)
    {
      add(matrix, j * m + i, j * m + i, 4. - shift);
      if (i + 1 < m)
        add(matrix, j * m + i, j * m + i + 1, -1.);
      if (j + 1 < m)
        add(matrix, j * m + i, (j + 1) * m + i, -1.);
    }
  return matrix;
}

inline std::size_t n_negative_of_five_points(const int m, const double shift)
{
  std::size_t n_negative = 0;
  for (int j = 1; j <= m; ++j)
    for (int i = 1; i <= m; ++i)
      n_negative +=
          4. - 2. * std::cos(i * M_PI / (m + 1)) - 2. * std::cos(j * M_PI / (m + 1)) < shift;
  return n_negative;
}

/// The graph Laplacian of a square of m x m nodes: its rows sum to zero. `shift` is added to the
/// diagonal.
inline SymmetricTriplets laplacian(const int m, const double shift)
{
  SymmetricTriplets matrix;
  matrix.n = m * m;
  const auto edge = [&](const int a, const int b, const double weight)
  {
    add(matrix, a, a, weight);
    add(matrix, b, b, weight);
    add(matrix, a, b, -weight);
  };
  for (int j = 0; j < m; ++j)
    for (int i = 0; i < m; ++i)
    {
      const double weight = 1. / (1 + i + 3 * j);
      if (i + 1 < m)
        edge(j * m + i, j * m + i + 1, weight);
      if (j + 1 < m)
        edge(j * m + i, (j + 1) * m + i, weight);
      add(matrix, j * m + i, j * m + i, shift);
    }
  return matrix;
}

/**
 * Finite differences on a staggered m x m grid of the compressible Stokes problem [A -B^T; -B -C]:
 * velocities on the faces (walls below, above and to the left, free to the right), pressures in the
 * cells. A = inertia + alpha Laplacian with alpha = 1e9 in the lower left quarter and 1 elsewhere;
 * C = compressibility. Without compressibility C vanishes, and its diagonal entries are absent. A
 * closed box (wall to the right, too) without compressibility is singular: constant pressure.
 */
inline SymmetricTriplets
saddle_point(const int m, const double inertia, const double compressibility, const bool closed)
{
  const int n_x = closed ? m - 1 : m; // columns of horizontal velocities, the first at i = 1
  const int n_u = n_x * m, n_v = m * (m - 1);
  SymmetricTriplets matrix;
  matrix.n = n_u + n_v + m * m;
  const auto u = [&](const int i, const int j)
  { return (i >= 1 && i <= n_x) ? j * n_x + i - 1 : -1; };
  const auto v = [&](const int i, const int j)
  { return (j >= 1 && j <= m - 1) ? n_u + (j - 1) * m + i : -1; };
  const auto p = [&](const int i, const int j) { return n_u + n_v + j * m + i; };
  const auto viscous = [&](const int a, const int b, const int i, const int j)
  {
    const double alpha = (i < m / 2 && j < m / 2) ? 1e9 : 1.;
    for (const int k : {a, b})
      if (k >= 0)
        add(matrix, k, k, alpha);
    if (a >= 0 && b >= 0)
      add(matrix, a, b, -alpha);
  };
  for (int j = 0; j < m; ++j)
    for (int i = 0; i < m; ++i)
    {
      viscous(u(i, j), u(i + 1, j), i, j);
      viscous(v(i, j), v(i, j + 1), i, j);
      if (j + 1 < m)
        viscous(u(i + 1, j), u(i + 1, j + 1), i, j);
      if (i + 1 < m)
        viscous(v(i, j + 1), v(i + 1, j + 1), i, j);
      const int faces[] = {u(i, j), u(i + 1, j), v(i, j), v(i, j + 1)};
      for (int f = 0; f < 4; ++f)
        if (faces[f] >= 0)
        {
          add(matrix, faces[f], faces[f], 0.5 * inertia);
          add(matrix, p(i, j), faces[f], f % 2 == 0 ? m : -m); // -B
        }
      if (compressibility > 0)
        add(matrix, p(i, j), p(i, j), -compressibility);
    }
  return matrix;
}

/// Matrix times vector.
inline std::vector<double> multiply(const SymmetricTriplets &matrix, const std::vector<double> &x)
{
  std::vector<double> y(matrix.n, 0.);
  for (std::size_t k = 0; k < matrix.rows.size(); ++k)
  {
    y[matrix.rows[k]] += matrix.values[k] * x[matrix.columns[k]];
    if (matrix.rows[k] != matrix.columns[k])
      y[matrix.columns[k]] += matrix.values[k] * x[matrix.rows[k]];
  }
  return y;
}

inline double norm(const std::vector<double> &x)
{
  double sum = 0;
  for (const double value : x)
    sum += value * value;
  return std::sqrt(sum);
}

inline std::vector<double> difference(std::vector<double> x, const std::vector<double> &y)
{
  for (std::size_t i = 0; i < x.size(); ++i)
    x[i] -= y[i];
  return x;
}

/// Whole numbers from -5 to 5.
inline std::vector<double> manufactured(const int n)
{
  std::vector<double> x(n);
  for (int i = 0; i < n; ++i)
    x[i] = (7 * i) % 11 - 5;
  return x;
}

inline int n_ranks()
{
  int result = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &result);
  return result;
}

inline int rank()
{
  int result = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &result);
  return result;
}

/// The indices of this rank: strewn over the ranks, in falling order.
inline std::vector<int> owned_indices(const int n)
{
  std::vector<int> owned;
  for (int i = n - 1; i >= 0; --i)
    if ((5 * i + 2) % n_ranks() == rank())
      owned.push_back(i);
  return owned;
}

/// This rank's share of the entries: each is split into two halves, which different ranks hold.
inline SymmetricTriplets strewn(const SymmetricTriplets &matrix)
{
  SymmetricTriplets share;
  share.n = matrix.n;
  for (std::size_t k = 0; k < matrix.rows.size(); ++k)
    for (int half = 0; half < 2; ++half)
      if (static_cast<int>(k + half) % n_ranks() == rank())
        add(share, matrix.rows[k], matrix.columns[k], 0.5 * matrix.values[k]);
  return share;
}

inline void factorize(Continua::SymmetricFactor &factor, const SymmetricTriplets &matrix)
{
  factor.factorize(strewn(matrix), owned_indices(matrix.n));
}

/// Solves and gathers the solution on every rank.
inline std::vector<double> solve(Continua::SymmetricFactor &factor,
                                 const std::vector<double> &right_hand_side)
{
  const int n = static_cast<int>(right_hand_side.size());
  const std::vector<int> owned = owned_indices(n);
  std::vector<double> x(owned.size());
  for (std::size_t k = 0; k < owned.size(); ++k)
    x[k] = right_hand_side[owned[k]];
  factor.solve(x);
  std::vector<double> solution(n, 0.);
  for (std::size_t k = 0; k < owned.size(); ++k)
    solution[owned[k]] = x[k];
  MPI_Allreduce(MPI_IN_PLACE, solution.data(), n, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  return solution;
}

/// Factors, solves with the manufactured solution's right-hand side: |b - K x| / |b|.
inline double relative_residual(Continua::SymmetricFactor &factor, const SymmetricTriplets &matrix)
{
  factorize(factor, matrix);
  const std::vector<double> b = multiply(matrix, manufactured(matrix.n));
  return norm(difference(multiply(matrix, solve(factor, b)), b)) / norm(b);
}
} // namespace symmetric_problems

#endif
