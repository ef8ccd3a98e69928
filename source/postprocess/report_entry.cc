#include <continua/postprocess/report_entry.h>

namespace Continua
{
bool read_report_entry(ParameterSection section)
{
  bool has_report = false;
  section.add("Report", has_report,
              "Whether a finished run writes its report, report.html, at its end, as 'continua "
              "report' does. Where Python, VTK or Matplotlib are missing, it warns instead");
  return has_report;
}
} // namespace Continua
