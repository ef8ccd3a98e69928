#ifndef continua_benchmarks_naive_step_h
#define continua_benchmarks_naive_step_h

#include <continua/finite_element/conditions/boundary_constraints.h>
#include <continua/finite_element/products/region_operators.h>
#include <continua/finite_element/solvers/step_system.h>
#include <continua/finite_element/space/space.h>

#include <deal.II/lac/sparse_direct.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/vector.h>

namespace Benchmarks
{
/**
 * How one would solve a step's system without thinking about it: the assembled matrix of velocity
 * and pressure, and deal.II's SparseDirectUMFPACK as it is. On one rank, for supports that hold
 * (homogeneous boundary constraints without masters) and meshes without hanging nodes.
 */
template <int dim>
class NaiveStep
{
public:
  NaiveStep(const Continua::Space<dim> &space,
            const std::vector<Continua::RegionOperators> &operators,
            const Continua::BoundaryConstraints<dim> &constraints,
            const Continua::SystemCoefficients &coefficients);

  unsigned long long n_entries() const { return matrix.n_nonzero_elements(); }
  void factorize() { solver.initialize(matrix); }
  /// The right-hand side must be zero at constrained velocities.
  void solve(dealii::Vector<double> &solution, const dealii::Vector<double> &right_hand_side) const
  {
    solver.vmult(solution, right_hand_side);
  }

private:
  dealii::SparsityPattern pattern;
  dealii::SparseMatrix<double> matrix;
  dealii::SparseDirectUMFPACK solver;
};
} // namespace Benchmarks

#endif
