#ifndef continua_studies_comparison_h
#define continua_studies_comparison_h

#include <continua/analysis/analysis_table.h>
#include <continua/base/log.h>
#include <continua/base/output_directory.h>
#include <continua/case/case.h>
#include <continua/studies/comparison_parameters.h>
#include <continua/studies/comparison_report.h>
#include <continua/studies/run_series.h>

#include <string>
#include <vector>

namespace Continua
{
/**
 * `Analysis = comparison`: runs the case of a parameter file by two ways - both discretisations,
 * unless the section Comparison says otherwise - on a sequence of meshes, each run in a folder of
 * its own, and reports what they say of the same quantities (ComparisonReport). A run that fails is
 * reported with its reason; the others go on.
 */
class Comparison : public Analysis
{
public:
  /// Reads the case by either way, without its finer meshes. Throws InputError.
  explicit Comparison(const AnalysisInput &input);
  bool has_own_table() const override { return true; }

private:
  /// One of the two ways to compute the case.
  struct Way
  {
    CommandLine command_line; ///< with its entries set, on the file's own mesh
    std::string identity;     ///< of the case, on the file's own mesh
    QuantityNames quantities; ///< that a run of it can state
    ConvergenceOrders orders;
    unsigned int refinements; ///< of the file's own mesh
    TimeParameters time;
  };
  /// One run.
  struct Plan
  {
    PlannedRun run;
    unsigned int way;
    unsigned int mesh;
    double time_step; ///< [s]; 0: none
  };

  const AnalysisTable &analyses;
  ComparisonParameters parameters;
  std::vector<std::string> input_files;
  unsigned int dimension;
  double volume = 0.; ///< [m^dim] of the mesh
  std::vector<Way> ways;
  QuantityNames quantities; ///< that the comparison can state

  /// With --restart the runs that are finished are taken as they are; see RunSeries. Throws
  /// RunError at the end if a run failed.
  void compute(const OutputDirectory &directory, Log &log, Summary &summary) override;
  template <int dim>
  void read_ways();
  template <int dim>
  Way read_way(unsigned int way) const;
  Plan plan_run(unsigned int way, unsigned int mesh, const std::string &output) const;
  /// The runs in their order: mesh by mesh, so that what fails or is misspelt shows early.
  std::vector<Plan> plans(const std::string &output) const;
  void report(const std::vector<ComparedRun> &runs,
              const std::vector<RunResult> &results,
              const OutputDirectory &directory,
              Log &log,
              Summary &summary) const;
};
} // namespace Continua

#endif
