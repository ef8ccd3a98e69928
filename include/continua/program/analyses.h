#ifndef continua_program_analyses_h
#define continua_program_analyses_h

#include <continua/analysis/analysis_table.h>

namespace Continua
{
/// The analyses that exist. The program, the entry Analysis and the manual know them from here.
const AnalysisTable &analyses();
} // namespace Continua

#endif
