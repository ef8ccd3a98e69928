#ifndef continua_studies_refinement_study_parameters_h
#define continua_studies_refinement_study_parameters_h

#include <continua/base/parameter_section.h>
#include <continua/studies/mesh_study_parameters.h>

#include <string>
#include <vector>

namespace Continua
{
/// The section Refinement study: one case on finer and finer meshes, divided everywhere or where
/// the solution asks for it. `analysis` is transient, steady or modal.
struct RefinementStudyParameters : MeshStudyParameters
{
  std::vector<std::string> variants = {"uniform"}; ///< uniform, adaptive or both
  unsigned int cycles = 3;                         ///< the finest; the file's own mesh is cycle 0
  std::vector<double> error_levels = {0.01}; ///< over the reference, for which unknowns are told
  /// What is known of quantities, to which their errors are; those of others are to the finest run.
  std::vector<ExpectedValue> references;

  /// Declares and reads; throws InputError. Needs the root to tell steady from transient.
  void read(ParameterSection root);
};
} // namespace Continua

#endif
