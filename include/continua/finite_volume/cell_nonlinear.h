#ifndef continua_finite_volume_cell_nonlinear_h
#define continua_finite_volume_cell_nonlinear_h

#include <continua/continuum/nonlinear_system.h>
#include <continua/finite_volume/cell_convection.h>
#include <continua/finite_volume/cell_linear_system.h>
#include <continua/finite_volume/cell_system.h>
#include <continua/finite_volume/face_conditions.h>

#include <string>
#include <vector>

namespace Continua
{
/// The convective terms of liquids, as corrections of the linear ones, and their tangent.
template <int dim>
class CellNonlinear : public NonlinearSystem
{
public:
  /// All must outlive it.
  CellNonlinear(const CellSystem<dim> &system,
                const std::vector<CellOperators> &operators,
                CellConvection<dim> &convection,
                CellLinearSystem<dim> &linear_system);

  /// Measures what judges residuals, on a mesh that has changed or moved. Collective.
  void reinit();

  bool is_in(unsigned int region) const override;
  void add(const BalancedStep &state, DistributedVector &momentum, DistributedVector &mass) override
  {
    convection.add(state, momentum, mass);
  }
  ResidualScales residual_scales(const DistributedVector &velocity,
                                 const DistributedVector &pressure) const override;
  std::string place_of_largest(const DistributedVector &momentum,
                               const DistributedVector &mass,
                               bool of_momentum) const override;
  bool linearise(const BalancedStep &state) override;
  void add_powers(const unsigned int region,
                  const BalancedStep &state,
                  const DistributedVector &of_velocity,
                  const TermsTaken taken,
                  NonlinearPowers &powers,
                  DistributedVector *const momentum) override
  {
    convection.add_powers(region, state, of_velocity, taken, powers, momentum);
  }
  NonlinearEnergy energy(const unsigned int region, const State &state) override
  {
    return convection.energy_of(region, state.velocity, state.pressure);
  }

private:
  const CellSystem<dim> &system;
  const std::vector<CellOperators> &operators;
  CellConvection<dim> &convection;
  CellLinearSystem<dim> &linear_system;
  double divergence_norm = 0., gradient_norm = 0.; ///< of B and G
  /// The least viscosity over distance of a face whose traction is given [Pa s/m].
  double face_resistance = 0.;
};
} // namespace Continua

#endif
