#ifndef continua_studies_theory_model_h
#define continua_studies_theory_model_h

#include <continua/analysis/analysis_table.h>
#include <continua/studies/forward_model.h>
#include <continua/theory/kept_waves.h>

#include <string>
#include <vector>

namespace Continua
{
/**
 * Linear wave theory as a model. A question costs the reading of the case, the exact waves of
 * sections that were not asked for before, and their synthesis; waves that are known are kept, so
 * that another load, end or position needs no new dispersion.
 */
class TheoryModel : public ForwardModel
{
public:
  /// `command_line`: of the file. `n_threads`: so many theories at the same time, at least one.
  TheoryModel(const AnalysisTable &analyses,
              const CommandLine &command_line,
              unsigned int n_dimensions,
              unsigned int n_threads);

  std::vector<ForwardAnswer> answers(const std::vector<ForwardQuestion> &questions) override;
  std::string name() const override { return "linear wave theory"; }
  /// Why theory does not cover the case with these entries; empty if it does.
  std::string why_not(const std::vector<std::pair<std::string, std::string>> &settings);
  /// How often dispersion was computed.
  unsigned int n_dispersions() const { return kept.n_computed(); }

private:
  const AnalysisTable &analyses;
  CommandLine command_line;
  unsigned int n_dimensions, n_threads;
  KeptWaves kept;

  template <int dim>
  std::vector<ForwardAnswer> answers_of(const std::vector<ForwardQuestion> &questions);
};
} // namespace Continua

#endif
