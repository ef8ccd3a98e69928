#ifndef continua_analysis_harmonic_checks_h
#define continua_analysis_harmonic_checks_h

#include <continua/base/parameter_section.h>
#include <continua/case/case.h>

namespace Continua
{
/// Refuses what a HarmonicSystem has not: whatever is not linear, the cell-wise path, a stream,
/// cavities, iterative solvers. `remedy`: another way, "use Analysis = transient". Throws
/// InputError.
template <int dim>
void check_harmonic_body(const Case<dim> &input, ParameterSection root, const std::string &remedy);
} // namespace Continua

#endif
