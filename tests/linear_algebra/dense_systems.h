#ifndef continua_tests_linear_algebra_dense_systems_h
#define continua_tests_linear_algebra_dense_systems_h

// Small dense matrices as distributed ones, for what is compared with elimination in a full matrix.

#include <continua/linear_algebra/distributed_vector.h>

#include <deal.II/base/index_set.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_sparsity_pattern.h>
#include <deal.II/lac/trilinos_vector.h>
#include <deal.II/lac/vector.h>

#include <cmath>
#include <iostream>

namespace dense_systems
{
using Continua::DistributedVector;
using Full = dealii::FullMatrix<double>;
using List = dealii::Vector<double>;
using Sparse = dealii::TrilinosWrappers::SparseMatrix;

/// Only rank 0 prints.
inline void quiet_other_ranks()
{
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    std::cout.setstate(std::ios::failbit);
}

/// This rank's share of n rows: one range after the other.
inline dealii::IndexSet owned(const unsigned int n)
{
  return dealii::Utilities::create_evenly_distributed_partitioning(
      dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD),
      dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD), n);
}

/// The entries that are not zero, and the diagonal.
inline void distribute(const Full &full, Sparse &sparse)
{
  const dealii::IndexSet rows = owned(full.m()), columns = owned(full.n());
  dealii::TrilinosWrappers::SparsityPattern pattern(rows, columns, MPI_COMM_WORLD, full.n());
  for (const auto i : rows)
    for (unsigned int j = 0; j < full.n(); ++j)
      if (full(i, j) != 0. || i == j)
        pattern.add(i, j);
  pattern.compress();
  sparse.reinit(pattern);
  for (const auto i : rows)
    for (unsigned int j = 0; j < full.n(); ++j)
      if (full(i, j) != 0. || i == j)
        sparse.set(i, j, full(i, j));
  sparse.compress(dealii::VectorOperation::insert);
}

inline Sparse copy_of(const Sparse &sparse)
{
  Sparse result;
  result.copy_from(sparse);
  return result;
}

inline DistributedVector distributed(const List &list)
{
  DistributedVector result(owned(list.size()), MPI_COMM_WORLD);
  unsigned int k = 0;
  for (const auto i : owned(list.size()))
    result.begin()[k++] = list[i];
  return result;
}

/// All entries on every rank.
inline List gathered(const DistributedVector &vector)
{
  List result(vector.size());
  unsigned int k = 0;
  for (const auto i : owned(vector.size()))
    result[i] = vector.begin()[k++];
  MPI_Allreduce(MPI_IN_PLACE, result.begin(), static_cast<int>(result.size()), MPI_DOUBLE, MPI_SUM,
                MPI_COMM_WORLD);
  return result;
}

/// By elimination.
inline List solve(const Full &matrix, const List &right_hand_side)
{
  Full inverse(matrix);
  inverse.gauss_jordan();
  List result(right_hand_side.size());
  inverse.vmult(result, right_hand_side);
  return result;
}

inline double distance(List a, const List &b)
{
  a -= b;
  return a.linfty_norm();
}

/// Whole numbers from -5 to 5.
inline List numbers(const unsigned int n, const unsigned int seed = 0)
{
  List result(n);
  for (unsigned int i = 0; i < n; ++i)
    result[i] = static_cast<int>((7 * i + 3 * seed) % 11) - 5;
  return result;
}

/// The stiffness of a chain of n masses on springs of stiffness `stiff` before the middle and 1
/// behind it, its ends held, plus a mass.
inline Full chain(const unsigned int n, const double stiff, const double mass)
{
  Full result(n, n);
  for (unsigned int spring = 0; spring <= n; ++spring)
  {
    const double stiffness = spring < n / 2 ? stiff : 1.;
    if (spring > 0)
      result(spring - 1, spring - 1) += stiffness;
    if (spring < n)
      result(spring, spring) += stiffness;
    if (spring > 0 && spring < n)
    {
      result(spring - 1, spring) -= stiffness;
      result(spring, spring - 1) -= stiffness;
    }
  }
  for (unsigned int i = 0; i < n; ++i)
    result(i, i) += mass;
  return result;
}

/// Differences: row i is -1 at i and 1 at i + 1.
inline Full differences(const unsigned int n)
{
  Full result(n, n + 1);
  for (unsigned int i = 0; i < n; ++i)
  {
    result(i, i) = -1.;
    result(i, i + 1) = 1.;
  }
  return result;
}
} // namespace dense_systems

#endif
