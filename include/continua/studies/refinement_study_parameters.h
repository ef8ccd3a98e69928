#ifndef continua_studies_refinement_study_parameters_h
#define continua_studies_refinement_study_parameters_h

#include <continua/base/expected_value.h>
#include <continua/base/parameter_section.h>

#include <string>
#include <vector>

namespace Continua
{
/// The section Refinement study: one case on finer and finer meshes, divided everywhere or where
/// the solution asks for it.
struct RefinementStudyParameters
{
  std::string analysis = "automatic"; ///< of the runs; transient, steady or modal after read()
  std::vector<std::string> ways = {"uniform"}; ///< uniform, adaptive or both
  unsigned int cycles = 3;                     ///< the finest; the file's own mesh is cycle 0
  bool refine_time_step = false;               ///< halved with each cycle
  std::vector<std::string> quantities;         ///< "PROBE: QUANTITY" or "QUANTITY"; empty: all
  std::vector<double> error_levels = {0.01};   ///< over the reference, for which unknowns are told
  /// What is known of quantities, to which their errors are; those of others are to the finest run.
  std::vector<ExpectedValue> references;
  std::vector<ExpectedValue> expected;

  /// Declares and reads; throws InputError. Needs the root to tell steady from transient.
  void read(ParameterSection root);
};
} // namespace Continua

#endif
