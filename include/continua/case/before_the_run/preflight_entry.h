#ifndef continua_case_before_the_run_preflight_entry_h
#define continua_case_before_the_run_preflight_entry_h

#include <string>
#include <vector>

namespace Continua
{
/// One line of what is said before a run.
struct PreflightEntry
{
  std::string name;
  double value = 0.;
  std::string unit; ///< SI, "1" if none
  std::string remark;
};

/// The value with four digits and a unit that suits its size: "3.2 mm".
std::string quantity_text(double value, const std::string &unit);

/// The entries as lines of text below a title, aligned.
std::vector<std::string> preflight_text(const std::string &title,
                                        const std::vector<PreflightEntry> &entries);
} // namespace Continua

#endif
