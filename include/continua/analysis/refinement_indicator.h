#ifndef continua_analysis_refinement_indicator_h
#define continua_analysis_refinement_indicator_h

#include <continua/case/case.h>
#include <continua/continuum/continuum_solver.h>

namespace Continua
{
/**
 * The indicator that the section Adaptivity asks for, of each active cell, at `time` [s]; only
 * owned ones count. That of the solution is over its largest value if it is compared with a
 * threshold; of a combined one each is, without what is negative, times its weight. Collective.
 */
template <int dim>
dealii::Vector<float>
refinement_indicator(const Case<dim> &input, ContinuumSolver<dim> &solver, double time);
} // namespace Continua

#endif
