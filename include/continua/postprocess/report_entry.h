#ifndef continua_postprocess_report_entry_h
#define continua_postprocess_report_entry_h

#include <continua/base/parameter_section.h>

namespace Continua
{
/// Declares and reads `Report` in the section Output: whether a finished run writes its report,
/// which the program does when the analysis has ended.
bool read_report_entry(ParameterSection section);
} // namespace Continua

#endif
