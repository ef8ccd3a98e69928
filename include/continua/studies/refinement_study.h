#ifndef continua_studies_refinement_study_h
#define continua_studies_refinement_study_h

#include <continua/analysis/analysis_table.h>
#include <continua/case/case.h>
#include <continua/studies/refinement_report.h>
#include <continua/studies/refinement_study_parameters.h>

#include <string>
#include <vector>

namespace Continua
{
/**
 * `Analysis = refinement study`: runs the case of a parameter file on finer and finer meshes,
 * divided everywhere or where the indicator asks for it, each run in a folder of its own, and
 * reports the errors of its quantities over the unknowns (RefinementReport).
 */
class RefinementStudy : public Analysis
{
public:
  /// Reads the case by each way, without its finer meshes. Throws InputError.
  explicit RefinementStudy(const AnalysisInput &input);
  bool has_own_table() const override { return true; }

private:
  /// The file by one of the ways.
  struct Way
  {
    CommandLine command_line; ///< of cycle 0
    std::string identity;     ///< of the case of cycle 0
    QuantityNames quantities; ///< that a run of it can state
    unsigned int refinements;
    AdaptationParameters adaptation;
    TimeParameters time;
  };

  const AnalysisTable &analyses;
  RefinementStudyParameters parameters;
  std::vector<std::string> input_files;
  unsigned int dimension;
  double volume = 0.; ///< [m^dim] of the mesh
  std::vector<Way> ways;
  QuantityNames quantities; ///< that the study can state

  /// With --restart the runs that are finished are taken as they are; see RunSeries. Throws
  /// RunError at the end if a run failed.
  void compute(const OutputDirectory &directory, Log &log, Summary &summary) override;
  template <int dim>
  void read_ways();
  template <int dim>
  Way read_way(const std::string &name) const;
  void check(const Way &way, const std::string &name, const ParameterSection &section) const;
  double time_step(const Way &way, unsigned int cycle) const;
  PlannedRun plan_run(unsigned int way, unsigned int cycle, const std::string &output) const;
  void refine(CommandLine &of_run, unsigned int way, unsigned int cycle) const;
};
} // namespace Continua

#endif
