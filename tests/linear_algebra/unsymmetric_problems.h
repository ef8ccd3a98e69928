#ifndef continua_tests_linear_algebra_unsymmetric_problems_h
#define continua_tests_linear_algebra_unsymmetric_problems_h

// Unsymmetric systems whose solution is known, for the tests of the factors.

#include "symmetric_problems.h"

#include <continua/linear_algebra/unsymmetric_factor.h>

#include <cmath>
#include <vector>

namespace unsymmetric_problems
{
using Continua::Triplets;
using symmetric_problems::difference;
using symmetric_problems::manufactured;
using symmetric_problems::n_ranks;
using symmetric_problems::norm;
using symmetric_problems::owned_indices;
using symmetric_problems::rank;

/// [0 2 0; 3 0 1; 0 1 4], with one entry given in two parts: times (1, 2, 3) it is (4, 6, 14).
inline Triplets zero_diagonal()
{
  return {3, {0, 1, 1, 2, 2, 2}, {1, 0, 2, 1, 2, 2}, {2, 3, 1, 1, 1.5, 2.5}};
}

/// [1 2 3; 2 4 6; 1 0 1].
inline Triplets dependent_rows()
{
  return {3, {0, 0, 0, 1, 1, 1, 2, 2}, {0, 1, 2, 0, 1, 2, 0, 2}, {1, 2, 3, 2, 4, 6, 1, 1}};
}

/**
 * Convection and diffusion of three coupled unknowns a cell on m_x x m_y cells, neighbours up to
 * two cells away along the axes and diagonally beside; the rows of the second and third unknown
 * are 1e6 times and 1e-9 times as large as those of the first.
 */
inline Triplets cells(const int m_x, const int m_y)
{
  constexpr double scales[] = {1., 1e6, 1e-9};
  constexpr int neighbours[][2] = {{1, 0},  {-1, 0},  {0, 1}, {0, -1}, {1, 1}, {1, -1},
                                   {-1, 1}, {-1, -1}, {2, 0}, {-2, 0}, {0, 2}, {0, -2}};
  Triplets matrix;
  matrix.n = 3 * m_x * m_y;
  const auto add =
      [&](const int cell, const int a, const int other, const int b, const double value)
  {
    matrix.rows.push_back(3 * cell + a);
    matrix.columns.push_back(3 * other + b);
    matrix.values.push_back(scales[a] * value);
  };
  for (int j = 0; j < m_y; ++j)
    for (int i = 0; i < m_x; ++i)
    {
      const int cell = j * m_x + i;
      for (int a = 0; a < 3; ++a)
      {
        add(cell, a, cell, a, 10.);
        add(cell, a, cell, (a + 1) % 3, 1.);
      }
      for (const auto &[di, dj] : neighbours)
      {
        if (i + di < 0 || i + di >= m_x || j + dj < 0 || j + dj >= m_y)
          continue;
        const int other = cell + dj * m_x + di;
        for (int a = 0; a < 3; ++a)
        {
          add(cell, a, other, a, -0.7 + 0.2 * di - 0.1 * dj);
          add(cell, a, other, (a + 2) % 3, 0.1 * di * dj);
        }
      }
    }
  return matrix;
}

/**
 * A viscous liquid that flows slowly and is carried on by a given velocity, on m x m cells with
 * velocities at their faces and pressures in their middle: the diagonal of the pressures is zero
 * but for one.
 */
inline Triplets liquid(const int m)
{
  Triplets matrix;
  const int n_u = (m - 1) * m;
  matrix.n = 2 * n_u + m * m;
  const auto add = [&matrix](const int row, const int column, const double value)
  {
    matrix.rows.push_back(row);
    matrix.columns.push_back(column);
    matrix.values.push_back(value);
  };
  const auto pressure = [&](const int i, const int j) { return 2 * n_u + j * m + i; };
  // Component 0: between the cells (i, j) and (i + 1, j); component 1: turned.
  for (int component = 0; component < 2; ++component)
  {
    const auto velocity = [&](const int along, const int across)
    { return component * n_u + across * (m - 1) + along; };
    const auto cell = [&](const int along, const int across)
    { return component == 0 ? pressure(along, across) : pressure(across, along); };
    for (int along = 0; along < m - 1; ++along)
      for (int across = 0; across < m; ++across)
      {
        const int row = velocity(along, across);
        add(row, row, 4.5);
        for (int side = -1; side <= 1; side += 2)
        {
          if (along + side >= 0 && along + side < m - 1)
            add(row, velocity(along + side, across), -1. + 0.3 * side);
          if (across + side >= 0 && across + side < m)
            add(row, velocity(along, across + side), -1. - 0.2 * side);
          const int of_side = cell(along + (side + 1) / 2, across);
          add(row, of_side, side);
          add(of_side, row, -side);
        }
      }
  }
  add(pressure(0, 0), pressure(0, 0), 1.);
  return matrix;
}

/// As liquid(), with pressures at the nodes of cells of twice the width, each beside many
/// velocities: eliminating these first leaves large pivots on the diagonal. `m`: even.
inline Triplets liquid_with_few_pressures(const int m)
{
  Triplets matrix;
  const int n_u = (m - 1) * m, width = m / 2 + 1;
  matrix.n = 2 * n_u + width * width;
  const auto add = [&matrix](const int row, const int column, const double value)
  {
    matrix.rows.push_back(row);
    matrix.columns.push_back(column);
    matrix.values.push_back(value);
  };
  for (int component = 0; component < 2; ++component)
  {
    const auto velocity = [&](const int along, const int across)
    { return component * n_u + across * (m - 1) + along; };
    const auto pressure = [&](const int along, const int across)
    { return 2 * n_u + (component == 0 ? across * width + along : along * width + across); };
    for (int along = 0; along < m - 1; ++along)
      for (int across = 0; across < m; ++across)
      {
        const int row = velocity(along, across), node = std::min((along + 1) / 2, width - 2);
        add(row, row, 4.5);
        for (int side = -1; side <= 1; side += 2)
        {
          if (along + side >= 0 && along + side < m - 1)
            add(row, velocity(along + side, across), -1. + 0.3 * side);
          if (across + side >= 0 && across + side < m)
            add(row, velocity(along, across + side), -1. - 0.2 * side);
          for (int k = 0; k < 2; ++k)
          {
            const int of_node = pressure(node + (side + 1) / 2, across / 2 + k);
            const double value = side * (k == across % 2 ? 0.75 : 0.25);
            add(row, of_node, value);
            add(of_node, row, -value);
          }
        }
      }
  }
  add(2 * n_u, 2 * n_u, 1.);
  return matrix;
}

/// [0 B; B^T 0] with B of convection and diffusion on m x m cells: no pivot is on the diagonal.
inline Triplets without_diagonal(const int m)
{
  Triplets matrix;
  const int n = m * m;
  matrix.n = 2 * n;
  const auto add = [&](const int row, const int column, const double value)
  {
    matrix.rows.insert(matrix.rows.end(), {row, n + column});
    matrix.columns.insert(matrix.columns.end(), {n + column, row});
    matrix.values.insert(matrix.values.end(), {value, value});
  };
  for (int j = 0; j < m; ++j)
    for (int i = 0; i < m; ++i)
    {
      const int row = j * m + i;
      add(row, row, 4.5);
      for (int side = -1; side <= 1; side += 2)
      {
        if (i + side >= 0 && i + side < m)
          add(row, row + side, -1. + 0.3 * side);
        if (j + side >= 0 && j + side < m)
          add(row, row + side * m, -1. - 0.2 * side);
      }
    }
  return matrix;
}

/// Matrix times vector.
inline std::vector<double> multiply(const Triplets &matrix, const std::vector<double> &x)
{
  std::vector<double> y(matrix.n, 0.);
  for (std::size_t k = 0; k < matrix.rows.size(); ++k)
    y[matrix.rows[k]] += matrix.values[k] * x[matrix.columns[k]];
  return y;
}

/// This rank's share of the entries: each is split into two halves, which different ranks hold.
inline Triplets strewn(const Triplets &matrix)
{
  Triplets share;
  share.n = matrix.n;
  for (std::size_t k = 0; k < matrix.rows.size(); ++k)
    for (int half = 0; half < 2; ++half)
      if (static_cast<int>(k + half) % n_ranks() == rank())
      {
        share.rows.push_back(matrix.rows[k]);
        share.columns.push_back(matrix.columns[k]);
        share.values.push_back(0.5 * matrix.values[k]);
      }
  return share;
}

inline void factorize(Continua::UnsymmetricFactor &factor, const Triplets &matrix)
{
  factor.factorize(strewn(matrix), owned_indices(matrix.n));
}

/// Solves and gathers the solution on every rank.
inline std::vector<double> solve(Continua::UnsymmetricFactor &factor,
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

/// Factors and solves with the manufactured solution's right-hand side: |x - exact| / |exact|.
inline double relative_error(Continua::UnsymmetricFactor &factor, const Triplets &matrix)
{
  factorize(factor, matrix);
  const std::vector<double> exact = manufactured(matrix.n);
  return norm(difference(solve(factor, multiply(matrix, exact)), exact)) / norm(exact);
}
} // namespace unsymmetric_problems

#endif
