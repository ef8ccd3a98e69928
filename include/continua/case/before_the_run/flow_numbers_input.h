#ifndef continua_case_before_the_run_flow_numbers_input_h
#define continua_case_before_the_run_flow_numbers_input_h

#include <continua/case/before_the_run/flow_numbers.h>
#include <continua/case/case.h>

namespace Continua
{
/**
 * Collects what FlowNumbers needs, but for the frequency of the load and a speed of waves in a
 * tube, from a case with convection. Prescribed velocities are taken at points of the coarse faces
 * and, where they depend on time, at 257 times from the start to the end. Sizes are those of the
 * coarse cells divided by 2 for each refinement of Mesh/Refinements. Where no velocity is
 * prescribed, the width is that of the first boundary through which the liquid can flow. No
 * communication.
 */
template <int dim>
FlowNumbersInput flow_numbers_input(const Case<dim> &input);
} // namespace Continua

#endif
