#ifndef continua_program_analyses_h
#define continua_program_analyses_h

#include <continua/analysis/run.h>

#include <string>
#include <utility>
#include <vector>

namespace Continua
{
/// The analyses that exist: name and a line of description, for the manual and `Analysis`.
std::vector<std::pair<std::string, std::string>> analysis_types();

/// Performs the analysis that the case asks for.
template <int dim>
void perform_analysis(Run<dim> &run);
} // namespace Continua

#endif
