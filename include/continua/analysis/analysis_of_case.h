#ifndef continua_analysis_analysis_of_case_h
#define continua_analysis_analysis_of_case_h

#include <continua/analysis/analysis_table.h>
#include <continua/analysis/run.h>

#include <memory>
#include <string>
#include <vector>

namespace Continua
{
/// An analysis of one case: makes a Run of the case and performs it.
template <int dim>
class AnalysisOfCase : public Analysis
{
public:
  /// `perform_run`: what the analysis does in a run. Throws InputError.
  AnalysisOfCase(const AnalysisInput &input, void (*perform_run)(Run<dim> &));

  bool has_checkpoints() const override { return input.analysis.has_checkpoints; }
  void check_restart(const OutputDirectory &directory) const override;
  std::vector<std::string> outline() const override;
  void write_mesh(const std::string &mesh_file) override;
  QuantityNames quantity_names() const override { return input.quantities; }
  double estimated_memory() const override;

private:
  Case<dim> input;
  void (*perform_run)(Run<dim> &);

  /// If the run fails, what was computed stays, the summary says that and why, and the exception
  /// goes on.
  void compute(const OutputDirectory &directory, Log &log, Summary &summary) override;
};

/// The row of an analysis of one case. `Type<dim>` is made of a Run, and has a perform() that
/// performs it and the static functions check() and name_quantities() of AnalysisTraits.
template <template <int> class Type>
AnalysisRow row_of_case(const std::string &name,
                        const std::string &description,
                        const std::vector<std::string> &sections,
                        const Motion motion,
                        const bool has_fields,
                        const bool has_checkpoints)
{
  const auto make = [](const AnalysisInput &input) -> std::unique_ptr<Analysis>
  {
    if (n_dimensions(model_of(input.general.model)) == 2)
      return std::make_unique<AnalysisOfCase<2>>(input,
                                                 [](Run<2> &run) { Type<2>(run).perform(); });
    return std::make_unique<AnalysisOfCase<3>>(input, [](Run<3> &run) { Type<3>(run).perform(); });
  };
  return {name,
          description,
          sections,
          make,
          {name, motion, has_fields, has_checkpoints, &Type<2>::check, &Type<2>::name_quantities,
           nullptr},
          {name, motion, has_fields, has_checkpoints, &Type<3>::check, &Type<3>::name_quantities,
           nullptr}};
}
} // namespace Continua

#endif
