#ifndef continua_finite_element_looking_traction_jump_h
#define continua_finite_element_looking_traction_jump_h

#include <continua/continuum/problem.h>
#include <continua/continuum/state.h>
#include <continua/finite_element/assembly/metric_history.h>
#include <continua/finite_element/space/space.h>

#include <deal.II/lac/vector.h>

#include <vector>

namespace Continua
{
/**
 * Refinement indicator: the jump of the traction n.sigma over the faces of a cell, inside a region
 * and across the interface alike (velocity gradients and pressure jump there by physics, the
 * traction does not), and on a boundary its difference to the prescribed traction: eta^2 = sum_F
 * h_F int_F |jump|^2 (half of it on interior faces). Sets `per_cell` of the owned cells to eta
 * [N/m^(1/2) in 2-D, N in 3-D]. `outlet_pressures`: of the outlets' ports, by condition; 0 of
 * others [Pa].
 */
template <int dim>
void traction_jump_indicators(const Space<dim> &space,
                              const Problem &problem,
                              const MetricHistory<dim> *metrics,
                              const State &state,
                              const std::vector<double> &outlet_pressures,
                              double time,
                              dealii::Vector<float> &per_cell);
} // namespace Continua

#endif
