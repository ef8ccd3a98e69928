#ifndef continua_studies_study_h
#define continua_studies_study_h

#include <continua/analysis/analysis_table.h>
#include <continua/base/log.h>
#include <continua/base/output_directory.h>
#include <continua/case/case.h>
#include <continua/studies/run_series.h>
#include <continua/studies/study_parameters.h>
#include <continua/studies/study_report.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace Continua
{
/**
 * An analysis that runs variants of the case of a parameter file on a sequence of meshes, each run
 * in a folder of its own, and reports what the runs state. A run that fails is reported with its
 * reason; the others go on.
 */
class Study : public Analysis
{
public:
  bool has_own_table() const override { return true; }

protected:
  /// What the kinds of study differ in.
  struct Kind
  {
    std::string section;  ///< of the file
    std::string mesh;     ///< what a mesh is called in the titles of the runs
    std::string variants; ///< the key of the variants' names in the summary
    bool checks_each;     ///< each variant states what is asked for; else the first run of all does
  };
  /// The case with some entries set, on the file's own mesh.
  struct Variant
  {
    std::string name;
    std::vector<unsigned int> meshes; ///< how often the file's mesh is refined, increasing
    CommandLine command_line;         ///< with its entries
    std::string identity;             ///< of the case
    QuantityNames quantities;         ///< that a run can state
    unsigned int refinements;         ///< Mesh/Refinements
    unsigned int velocities_per_cell; ///< along an edge
    AdaptationParameters adaptation;
    TimeParameters time; ///< of a transient analysis
  };

  Study(const AnalysisInput &input, Kind kind);

  std::vector<Variant> variants;
  QuantityNames quantities; ///< that the study can state

  ParameterSection section() const { return file.root().subsection(kind.section); }
  unsigned int n_dimensions() const { return dimension; }
  /// To be called first. Reads the case of the file alone: what is wrong with it is not said of a
  /// variant. Throws InputError.
  void read_case(const StudyParameters &parameters);
  /// Reads the case with these entries, each "Section/Key" and a value. Throws InputError.
  Variant read_variant(const std::string &name,
                       const std::vector<unsigned int> &meshes,
                       const std::vector<std::pair<std::string, std::string>> &entries) const;
  /// Throws InputError if the time step of the variant cannot be refined.
  void check_time_step(const Variant &variant) const;
  /// Throws InputError, for the entry `key`, if the cells of the variant would be divided too
  /// often.
  void
  check_divisions(const Variant &variant, const std::string &key, const std::string &remedy) const;

private:
  struct Plan
  {
    PlannedRun run;
    unsigned int variant, mesh;
    double time_step; ///< [s]; 0: none
  };

  const AnalysisTable &analyses;
  const Kind kind;
  StudyParameters parameters;
  std::vector<std::string> input_files;
  unsigned int dimension;
  double volume = 0.; ///< [m^dim] of the mesh

  template <int dim>
  void read_case_of();
  template <int dim>
  void read_variant_of(Variant &variant) const;
  /// Mesh by mesh, so that what fails or is misspelt shows early.
  std::vector<Plan> plan_runs(const std::string &output) const;
  Plan plan_run(unsigned int variant, unsigned int mesh, const std::string &output) const;
  /// With --restart the runs that are finished are taken as they are; see RunSeries. Throws
  /// RunError at the end if a run failed.
  void compute(const OutputDirectory &directory, Log &log, Summary &summary) override;
  /// Sets the entries that refine the mesh of the variant so often.
  virtual void
  refine_mesh(CommandLine &of_run, const Variant &variant, unsigned int mesh) const = 0;
  virtual std::unique_ptr<StudyReport> make_report(const std::vector<StudiedRun> &runs) const = 0;
};
} // namespace Continua

#endif
