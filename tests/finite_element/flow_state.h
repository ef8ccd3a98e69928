#ifndef continua_tests_finite_element_flow_state_h
#define continua_tests_finite_element_flow_state_h

// A state of a flow for the unit tests of convection.

#include "small_problem.h"

#include <continua/continuum/step_solution.h>

#include <cmath>

namespace flow_state
{
using namespace Continua;
using namespace dealii;

template <int dim>
double wave(const Point<dim> &x, const double phase)
{
  double sum = phase;
  for (unsigned int c = 0; c < dim; ++c)
    sum += (1.3 + 0.7 * c + 0.2 * phase) * x[c];
  return std::sin(sum);
}

/// A state without any symmetry.
template <int dim>
StepSolution make_state(const Space<dim> &space)
{
  const auto vector = [&](const double phase)
  {
    return small_problem::interpolated<dim>(space,
                                            [phase](const Point<dim> &x)
                                            {
                                              Tensor<1, dim> value;
                                              for (unsigned int c = 0; c < dim; ++c)
                                                value[c] = wave(x, phase + 2. * c);
                                              return value;
                                            });
  };
  const auto scalar = [&](const double phase)
  {
    return small_problem::interpolated_pressure<dim>(
        space, [phase](const Point<dim> &x, unsigned int) { return wave(x, phase); });
  };
  StepSolution state;
  state.step = backward_differencing_step(0., 0.1, 0.1, Update::implicit);
  state.velocity = vector(0.);
  state.acceleration = vector(1.);
  state.pressure = scalar(2.);
  state.pressure_rate = scalar(3.);
  return state;
}
} // namespace flow_state

#endif
