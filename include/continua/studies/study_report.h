#ifndef continua_studies_study_report_h
#define continua_studies_study_report_h

#include <continua/base/output_directory.h>
#include <continua/base/summary.h>

#include <string>
#include <vector>

namespace Continua
{
/// What a study makes of its runs.
class StudyReport
{
public:
  virtual ~StudyReport() = default;

  /// The tables for the log. No wall times.
  virtual std::vector<std::string> lines() const = 0;
  /// Adds what is said of the quantities of the runs. What does not exist is not added.
  virtual void add_quantities(Summary &summary) const = 0;
  /// Writes the tables and the citations into the folder, on one rank.
  virtual void write(const OutputDirectory &directory) const = 0;
};
} // namespace Continua

#endif
