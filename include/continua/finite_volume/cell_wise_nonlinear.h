#ifndef continua_finite_volume_cell_wise_nonlinear_h
#define continua_finite_volume_cell_wise_nonlinear_h

#include <continua/continuum/nonlinear_system.h>
#include <continua/finite_volume/cell_wise_convection.h>
#include <continua/finite_volume/cell_wise_linear_system.h>
#include <continua/finite_volume/cell_wise_system.h>
#include <continua/finite_volume/face_conditions.h>

#include <string>
#include <vector>

namespace Continua
{
/// The convective terms of liquids, as corrections of the linear ones, and their tangent.
template <int dim>
class CellWiseNonlinear : public NonlinearSystem
{
public:
  /// All must outlive it.
  CellWiseNonlinear(const CellWiseSystem<dim> &system,
                    const std::vector<CellWiseOperators> &operators,
                    CellWiseConvection<dim> &convection,
                    CellWiseLinearSystem<dim> &linear_system);

  /// Measures what judges residuals, on a mesh that has changed or moved. Collective.
  void reinit();

  bool is_in(unsigned int region) const override;
  void add(const StepSolution &state, DistributedVector &momentum, DistributedVector &mass) override
  {
    convection.add(state, momentum, mass);
  }
  ResidualScales residual_scales(const DistributedVector &velocity,
                                 const DistributedVector &pressure) const override;
  std::string place_of_largest(const DistributedVector &momentum,
                               const DistributedVector &mass,
                               bool of_momentum) const override;
  bool linearise(const StepSolution &state) override;
  void add_powers(const unsigned int region,
                  const StepSolution &state,
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
  const CellWiseSystem<dim> &system;
  const std::vector<CellWiseOperators> &operators;
  CellWiseConvection<dim> &convection;
  CellWiseLinearSystem<dim> &linear_system;
  double divergence_norm = 0., gradient_norm = 0.; ///< of B and G
  /// The least viscosity over distance of a face whose traction is given [Pa s/m].
  double face_resistance = 0.;
};
} // namespace Continua

#endif
