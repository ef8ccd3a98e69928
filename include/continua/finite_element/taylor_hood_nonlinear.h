#ifndef continua_finite_element_taylor_hood_nonlinear_h
#define continua_finite_element_taylor_hood_nonlinear_h

#include <continua/continuum/nonlinear_system.h>
#include <continua/continuum/problem.h>
#include <continua/finite_element/assembly/linear_products.h>
#include <continua/finite_element/assembly/region_terms.h>
#include <continua/finite_element/motion/moving_mesh.h>
#include <continua/finite_element/solvers/linear_systems.h>
#include <continua/finite_element/space/space.h>

#include <string>

namespace Continua
{
/// The terms of regions that are not linear, the mesh that moves with them, and their tangent, in
/// finite elements.
template <int dim>
class TaylorHoodNonlinear : public NonlinearSystem
{
public:
  /// All must outlive it. `moving_mesh`: null where the mesh stays.
  TaylorHoodNonlinear(const Space<dim> &space,
                      const Problem &problem,
                      const LinearProducts<dim> &products,
                      RegionTerms<dim> &terms,
                      LinearSystems<dim> &systems,
                      MovingMesh<dim> *moving_mesh);

  bool is_in(unsigned int region) const override;
  bool has_all_terms() const override { return true; }

  void move_mesh(StepSolution &state) override;
  void set_mesh_change(const Step &step,
                       const DistributedVector &of_velocity,
                       DistributedVector &of_mesh_displacement) override;
  void check_mesh(const StepSolution &state) override;

  void add(const StepSolution &state, DistributedVector &momentum, DistributedVector &mass) override
  {
    terms.add(state, momentum, mass);
  }
  ResidualScales residual_scales(const DistributedVector &velocity,
                                 const DistributedVector &pressure) const override;
  std::string place_of_largest(const DistributedVector &momentum,
                               const DistributedVector &mass,
                               bool of_momentum) const override;

  bool linearise(const StepSolution &state) override { return systems.linearise(state); }
  bool solves_with_kept_derivative() const override { return systems.has_iterative_tangent(); }
  void forget_linearisation() override;
  bool has_derivative_products() const override { return !systems.has_iterative_tangent(); }
  void keep_derivative(const StepSolution &state) override { systems.keep_derivative(state); }
  void add_derivative_product(const DistributedVector &velocity,
                              const DistributedVector &pressure,
                              DistributedVector &momentum,
                              DistributedVector &mass) override
  {
    terms.add_derivative_product(velocity, pressure, momentum, mass);
  }

  void add_powers(const unsigned int region,
                  const StepSolution &state,
                  const DistributedVector &of_velocity,
                  const TermsTaken taken,
                  NonlinearPowers &powers,
                  DistributedVector *const momentum) override
  {
    terms.add_powers(region, state, of_velocity, taken, powers, momentum);
  }
  NonlinearEnergy energy(const unsigned int region, const State &state) override
  {
    return terms.energy_of(region, state);
  }
  double relaxation_power(const unsigned int region) const override
  {
    return terms.relaxation_power(region);
  }

private:
  const Space<dim> &space;
  const Problem &problem;
  const LinearProducts<dim> &products;
  RegionTerms<dim> &terms;
  LinearSystems<dim> &systems;
  MovingMesh<dim> *const moving_mesh;
};
} // namespace Continua

#endif
