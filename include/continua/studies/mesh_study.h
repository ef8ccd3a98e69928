#ifndef continua_studies_mesh_study_h
#define continua_studies_mesh_study_h

#include <continua/case/case.h>
#include <continua/studies/mesh_study_parameters.h>
#include <continua/studies/studied_run.h>
#include <continua/studies/study.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace Continua
{
/// A study that runs variants of the case of a parameter file on a sequence of meshes.
class MeshStudy : public Study
{
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

  MeshStudy(const AnalysisInput &input, const Kind &kind);

  std::vector<Variant> variants;

  /// To be called first. Reads the case of the file alone: what is wrong with it is not said of a
  /// variant. Throws InputError.
  void read_case(const MeshStudyParameters &parameters);
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
  /// One run: a variant on a mesh.
  struct Place
  {
    unsigned int variant, mesh;
  };

  const Kind kind;
  MeshStudyParameters parameters;

  template <int dim>
  void read_case_of();
  template <int dim>
  void read_variant_of(Variant &variant) const;
  /// Mesh by mesh, so that what fails or is misspelt shows early.
  std::vector<Place> places() const;
  double time_step(const Place &place) const; ///< [s]; 0: none
  PlannedRun plan_run(const Place &place, const std::string &output) const;
  std::vector<PlannedRun> plan_runs(const std::string &output) const override;
  std::optional<unsigned int> stating_group(unsigned int run) const override;
  std::unique_ptr<StudyReport> make_report(const std::vector<RunResult> &runs) const override;
  void describe_runs(Summary &summary) const override;
  /// Sets the entries that refine the mesh of the variant so often.
  virtual void
  refine_mesh(CommandLine &of_run, const Variant &variant, unsigned int mesh) const = 0;
  virtual std::unique_ptr<StudyReport>
  make_report_of(const std::vector<StudiedRun> &runs) const = 0;
};
} // namespace Continua

#endif
