#ifndef continua_linear_algebra_gmres_data_h
#define continua_linear_algebra_gmres_data_h

#include <deal.II/base/config.h>
#include <deal.II/lac/solver_gmres.h>

namespace Continua
{
/**
 * What deal.II's GMRES is told: a basis of so many vectors, the preconditioner at the right, and
 * modified Gram-Schmidt.
 *
 * From 9.6 on deal.II's own choice is another one (delayed classical Gram-Schmidt), which takes the
 * norm of a new vector from a difference of squares. With a preconditioner that is nearly the
 * inverse, as a factor in single precision is, this norm is small, and round-off is all that is
 * left of it. The solver then says that it has converged to 1e-12 where the residual is 1e-8.
 */
template <typename Vector>
typename dealii::SolverGMRES<Vector>::AdditionalData gmres_data(const unsigned int basis_size)
{
#if DEAL_II_VERSION_GTE(9, 6, 0)
  typename dealii::SolverGMRES<Vector>::AdditionalData data(basis_size, true);
  data.orthogonalization_strategy =
      dealii::LinearAlgebra::OrthogonalizationStrategy::modified_gram_schmidt;
  return data;
#else
  // Two further vectors are counted.
  return typename dealii::SolverGMRES<Vector>::AdditionalData(basis_size + 2, true);
#endif
}

/// The same for the flexible GMRES, whose preconditioner may change and is at the right always.
template <typename Vector>
typename dealii::SolverFGMRES<Vector>::AdditionalData fgmres_data(const unsigned int basis_size)
{
  typename dealii::SolverFGMRES<Vector>::AdditionalData data(basis_size);
#if DEAL_II_VERSION_GTE(9, 6, 0)
  data.orthogonalization_strategy =
      dealii::LinearAlgebra::OrthogonalizationStrategy::modified_gram_schmidt;
#endif
  return data;
}
} // namespace Continua

#endif
