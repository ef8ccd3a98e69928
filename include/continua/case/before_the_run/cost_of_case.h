#ifndef continua_case_before_the_run_cost_of_case_h
#define continua_case_before_the_run_cost_of_case_h

#include <continua/base/memory_limit.h>
#include <continua/case/before_the_run/cost_estimate.h>
#include <continua/case/case.h>

#include <string>
#include <vector>

namespace Continua
{
/// What the cost of a case depends on; the memory for the choice of the solver is that of the
/// case's outlook. Collective.
template <int dim>
CostInput cost_input(const Case<dim> &input);

/// What the choice of a linear step's solver depends on. Collective.
template <int dim>
SolverOutlook solver_outlook(const Case<dim> &input);

/// The estimate and what is to be said of the number of ranks, a sentence a line; nothing for an
/// analysis without fields. Collective.
template <int dim>
std::vector<std::string> cost_of(const Case<dim> &input);

/// What all ranks together may take: Mesh/Memory limit on each machine, or where that is zero what
/// memory_limit() says. Collective.
template <int dim>
MemoryLimit memory_limit_of(const Case<dim> &input);

/// Throws InputError, as said of the section Probes, if the histories of probes need more memory
/// than the run may take. After the probes are checked. Collective.
template <int dim>
void check_histories(const Case<dim> &input, const ParameterSection &probes);

/// Throws InputError if the case needs more memory than it may take. Collective.
template <int dim>
void check_memory(const Case<dim> &input, const ParameterSection &mesh);
} // namespace Continua

#endif
