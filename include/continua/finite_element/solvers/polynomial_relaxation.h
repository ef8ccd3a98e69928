#ifndef continua_finite_element_solvers_polynomial_relaxation_h
#define continua_finite_element_solvers_polynomial_relaxation_h

#include <continua/finite_element/conditions/boundary_constraints.h>
#include <continua/finite_element/products/linear_velocities.h>
#include <continua/finite_element/products/polynomial_cycle.h>
#include <continua/finite_element/solvers/matrix_free_relaxation.h>
#include <continua/finite_element/space/space.h>

#include <memory>
#include <string>
#include <vector>

namespace Continua
{
/// A PolynomialCycle for the velocities outside the stiff block: of a fluid whose viscosity evens
/// velocities out over many cells within a step, for which a polynomial alone would need many
/// iterations.
template <int dim>
class PolynomialRelaxation : public MatrixFreeRelaxation<dim>
{
public:
  using typename MatrixFreeRelaxation<dim>::Product;

  /// See MatrixFreeRelaxation and PolynomialCycle. Space and constraints must outlive it.
  /// Collective.
  PolynomialRelaxation(const Product &cells,
                       const Space<dim> &space,
                       const BoundaryConstraints<dim> &constraints,
                       const typename Product::Coefficients &coefficients,
                       const std::vector<unsigned int> &fluid,
                       double most_factor_bytes);

  std::string name() const { return cycle->name(); }

private:
  using typename MatrixFreeRelaxation<dim>::Vector;

  const Space<dim> &space;
  const BoundaryConstraints<dim> &constraints;
  const double most_factor_bytes;
  LinearVelocities<dim> linear_velocities;
  std::unique_ptr<PolynomialCycle<dim>> cycle;

  void make(const Vector &diagonal) override;
  void apply(Vector &solution, const Vector &right_hand_side) override;
};
} // namespace Continua

#endif
