#ifndef continua_studies_comparison_h
#define continua_studies_comparison_h

#include <continua/studies/comparison_parameters.h>
#include <continua/studies/mesh_study.h>

#include <memory>
#include <vector>

namespace Continua
{
/**
 * `Analysis = comparison`: runs the case of a parameter file in two variants - by both
 * discretisations, unless the section Comparison says otherwise - on a sequence of meshes, and
 * reports what they say of the same quantities (ComparisonReport).
 */
class Comparison : public MeshStudy
{
public:
  /// Reads the case in both variants, without its finer meshes. Throws InputError.
  explicit Comparison(const AnalysisInput &input);

private:
  ComparisonParameters parameters;

  void refine_mesh(CommandLine &of_run, const Variant &variant, unsigned int mesh) const override;
  std::unique_ptr<StudyReport> make_report_of(const std::vector<StudiedRun> &runs) const override;
};
} // namespace Continua

#endif
