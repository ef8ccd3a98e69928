#include <continua/studies/refinement_study.h>

#include <continua/studies/refinement_report.h>

#include <numeric>
#include <string>

namespace Continua
{
RefinementStudy::RefinementStudy(const AnalysisInput &input)
    : MeshStudy(input, {"Refinement study", "cycle", "refinement", false})
{
  parameters.read(file.root());
  read_case(parameters);
  std::vector<unsigned int> cycles(parameters.cycles + 1);
  std::iota(cycles.begin(), cycles.end(), 0u);
  QuantityNames of_runs;
  for (const std::string &name : parameters.variants)
  {
    variants.push_back(read_variant(name, cycles, {}));
    check(variants.back());
    of_runs.add(variants.back().quantities);
  }
  RefinementReport::name_quantities(parameters, of_runs, quantities);
  of_runs.refuse_unknown(section(), "Quantities", parameters.quantities);
  of_runs.refuse_unknown(section().subsection("Reference"), parameters.references);
  quantities.refuse_unknown(file, section().subsection("Expected"), parameters.expected);
}

void RefinementStudy::check(const Variant &variant) const
{
  if (variant.name == "uniform")
    check_divisions(variant, "Cycles", "Give fewer cycles");
  check_time_step(variant);
  if (variant.name == "adaptive" && parameters.analysis == "transient")
  {
    if (variant.adaptation.every_n_steps == 0 && variant.adaptation.initial_cycles == 0)
      section().refuse("Refinement",
                       "the section Adaptivity does not change the mesh of a run in time",
                       "Set Adaptivity/Every n steps, or Initial cycles");
    if (variant.adaptation.maximum_level + parameters.cycles > 25)
      section().refuse(
          "Cycles", "with Adaptivity/Maximum level the cells would be divided more than 25 times",
          "Give fewer cycles");
  }
}

void RefinementStudy::refine_mesh(CommandLine &of_run,
                                  const Variant &variant,
                                  const unsigned int cycle) const
{
  const AdaptationParameters &adaptation = variant.adaptation;
  const bool transient = parameters.analysis == "transient";
  if (variant.name == "uniform")
  {
    set_entry(of_run, "Mesh/Refinements", std::to_string(variant.refinements + cycle));
    if (transient)
    {
      set_entry(of_run, "Adaptivity/Every n steps", "0");
      set_entry(of_run, "Adaptivity/Initial cycles", "0");
    }
    else if (parameters.analysis == "steady")
      set_entry(of_run, "Adaptivity/Cycles", "0");
  }
  else if (transient)
  {
    set_entry(of_run, "Adaptivity/Maximum level", std::to_string(adaptation.maximum_level + cycle));
    if (adaptation.initial_cycles > 0)
      set_entry(of_run, "Adaptivity/Initial cycles",
                std::to_string(adaptation.initial_cycles + cycle));
    // The mesh changes at the same times.
    if (parameters.refine_time_step)
      set_entry(of_run, "Adaptivity/Every n steps",
                std::to_string(adaptation.every_n_steps << cycle));
  }
  else
    set_entry(of_run, "Adaptivity/Cycles", std::to_string(cycle));
}

std::unique_ptr<StudyReport>
RefinementStudy::make_report_of(const std::vector<StudiedRun> &runs) const
{
  return std::make_unique<RefinementReport>(parameters, n_dimensions(), runs);
}
} // namespace Continua
