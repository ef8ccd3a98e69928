#ifndef continua_studies_refinement_study_h
#define continua_studies_refinement_study_h

#include <continua/studies/mesh_study.h>
#include <continua/studies/refinement_study_parameters.h>

#include <memory>
#include <vector>

namespace Continua
{
/**
 * `Analysis = refinement study`: runs the case of a parameter file on finer and finer meshes,
 * divided everywhere or where the indicator asks for it, and reports the errors of its quantities
 * over the unknowns (RefinementReport). The variants are the ways of refinement.
 */
class RefinementStudy : public MeshStudy
{
public:
  /// Reads the case, without its finer meshes. Throws InputError.
  explicit RefinementStudy(const AnalysisInput &input);

private:
  RefinementStudyParameters parameters;

  void check(const Variant &variant) const;
  void refine_mesh(CommandLine &of_run, const Variant &variant, unsigned int mesh) const override;
  std::unique_ptr<StudyReport> make_report_of(const std::vector<StudiedRun> &runs) const override;
};
} // namespace Continua

#endif
