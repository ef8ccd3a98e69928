#ifndef continua_finite_element_taylor_hood_vibration_h
#define continua_finite_element_taylor_hood_vibration_h

#include <continua/continuum/problem.h>
#include <continua/continuum/vibration_operator.h>
#include <continua/finite_element/conditions/boundary_constraints.h>
#include <continua/finite_element/products/region_operators.h>
#include <continua/finite_element/solvers/step_system.h>
#include <continua/finite_element/space/space.h>

#include <vector>

namespace Continua
{
/**
 * Free vibrations of the Taylor-Hood discretisation. The unknowns are the velocity dofs, in the
 * sense of displacements; K - shift M with its pressure is the system of a step with -shift rho for
 * the inertia, mu for alpha and 1/K for the compressibility.
 */
template <int dim>
class TaylorHoodVibration : public VibrationOperator<dim>
{
public:
  TaylorHoodVibration(const Space<dim> &space,
                      const Problem &problem,
                      const std::vector<RegionOperators> &operators,
                      const BoundaryConstraints<dim> &constraints,
                      StepSystem<dim> &system,
                      const VibratingState &state);

  unsigned int n_local_unknowns() const override { return space.velocity_owned.n_elements(); }
  std::vector<unsigned int> directions() const override;
  bool is_symmetric() const override { return true; }
  void multiply_mass(const std::vector<double> &x, std::vector<double> &y) override;
  std::vector<double>
  momentum(const std::function<dealii::Tensor<1, dim>(const dealii::Point<dim> &)> &field) override;
  void set_shift(double shift) override;
  void solve(std::vector<double> &x) override;
  std::size_t n_below_shift() const override;
  void set_shape(const std::vector<double> &x, double eigenvalue) override;

private:
  const Space<dim> &space;
  const Problem &problem;
  const std::vector<RegionOperators> &operators;
  const BoundaryConstraints<dim> &constraints;
  StepSystem<dim> &system;
  VibratingState state;
  double shift = 0.;
  const DistributedVector zero;
  DistributedVector displacement, force, product, pressure, mass; ///< work space

  /// `force` = T^T M u of the `displacement` u.
  void weigh();
  /// `displacement` and `pressure` of the `force`.
  void solve_system();
};
} // namespace Continua

#endif
