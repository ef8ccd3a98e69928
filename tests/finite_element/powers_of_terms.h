#ifndef tests_finite_element_powers_of_terms_h
#define tests_finite_element_powers_of_terms_h

#include <continua/continuum/nonlinear_terms.h>
#include <continua/continuum/step_solution.h>
#include <continua/linear_algebra/distributed_vector.h>

#include <string>

namespace Continua
{
/// The powers of the terms of a region with a velocity, of one rank.
template <typename Terms>
NonlinearPowers powers_of(Terms &terms,
                          const StepSolution &state,
                          const DistributedVector &velocity,
                          const unsigned int region = 0,
                          const TermsTaken taken = TermsTaken::all)
{
  NonlinearPowers powers;
  terms.add_powers(region, state, velocity, taken, powers, nullptr);
  return powers;
}

/// Their forces [N].
template <typename Terms>
DistributedVector forces_of(Terms &terms, const StepSolution &state, const unsigned int region = 0)
{
  DistributedVector forces;
  forces.reinit(state.velocity);
  NonlinearPowers powers;
  terms.add_powers(region, state, state.velocity, TermsTaken::all, powers, &forces);
  return forces;
}

inline double sum_of(const NonlinearPowers &powers)
{
  return powers.convection + powers.inflow + powers.inertia + powers.stabilisation +
         powers.viscosity + powers.strain + powers.compression + powers.load;
}

/// Of terms that the region 0 alone has: what is summed at points is the power of the forces, and
/// these are the rows of the residual.
template <typename Terms>
void check_powers(const std::string &name,
                  Terms &terms,
                  const StepSolution &state,
                  const DistributedVector &velocity)
{
  const DistributedVector forces = forces_of(terms, state);
  check::relative(name + ": powers at points and of the forces",
                  sum_of(powers_of(terms, state, velocity)), forces * velocity, 1e-12);
  DistributedVector momentum, volume;
  momentum.reinit(state.velocity);
  volume.reinit(state.pressure);
  terms.add(state, momentum, volume);
  momentum.add(-1., forces);
  check::absolute(name + ": forces and rows of momentum",
                  momentum.linfty_norm() / forces.linfty_norm(), 0., 1e-13);
  const NonlinearPowers carrying = powers_of(terms, state, velocity, 0, TermsTaken::carrying),
                        others = powers_of(terms, state, velocity, 0, TermsTaken::not_carrying);
  check::is_true(name + ": others among what carries",
                 sum_of(carrying) == carrying.convection + carrying.inflow);
  check::is_true(name + ": what carries among the others",
                 others.convection == 0. && others.inflow == 0.);
  check::relative(name + ": both", sum_of(carrying) + sum_of(others), forces * velocity, 1e-12);
}
} // namespace Continua

#endif
