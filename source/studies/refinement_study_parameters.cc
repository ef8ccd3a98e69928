#include <continua/studies/refinement_study_parameters.h>

#include <algorithm>

namespace Continua
{
void RefinementStudyParameters::read(ParameterSection root)
{
  ParameterSection section = root.subsection("Refinement study");
  section.add_choice("Analysis", analysis, {"automatic", "transient", "steady", "modal"},
                     "What the runs do; automatic: transient if the file has a section Time, modal "
                     "if it has a section Modal, else steady.");
  section.add("Refinement", variants,
              "How the mesh becomes finer: uniform - all cells of the file's mesh are divided once "
              "more with each cycle; adaptive - as Adaptivity says, with one cycle more (at rest) "
              "or one level more (in time); or both.");
  section.add("Cycles", cycles, "How many finer meshes there are besides the file's own [1].", 1,
              20);
  section.add("Refine the time step", refine_time_step,
              "Whether the time step is halved with each cycle, too.");
  section.add("Quantities", quantities,
              "What is looked at, as in Expected (tip: frequency); empty: every quantity but those "
              "that tell errors or counts.");
  section.add("Error levels", error_levels, Dimensions::none,
              "Relative errors for which the unknowns that they take are told.",
              Range{0., 1., true, true});
  ParameterSection reference = section.subsection("Reference");
  for (const auto &[key, text] : reference.add_free_entries(
           "PROBE: QUANTITY = VALUE UNIT, the value to which errors are; of others, and with "
           "nothing or 'finest' as the value, it is that of the run with the most unknowns."))
    try
    {
      if (text != "finest" && !text.empty())
        references.push_back(parse_expected_value(key, text + " +- 0"));
    }
    catch (const std::invalid_argument &error)
    {
      reference.refuse(key, error.what(), "Write 'PROBE: QUANTITY = VALUE UNIT'");
    }
  expected = read_expected(section.subsection("Expected"));

  if (analysis == "automatic")
    analysis = root.has_subsection("Time")    ? "transient"
               : root.has_subsection("Modal") ? "modal"
                                              : "steady";
  for (const std::string &variant : variants)
    if (variant != "uniform" && variant != "adaptive")
      section.refuse("Refinement", "there is no refinement '" + variant + "'",
                     "Write uniform, adaptive or both");
  if (variants.empty() ||
      (variants.size() > 1 && (variants.size() > 2 || variants[0] == variants[1])))
    section.refuse("Refinement", "one way or both are named, each once",
                   "Write 'set Refinement = uniform, adaptive'");
  if (refine_time_step && analysis != "transient")
    section.refuse("Refine the time step", "a " + analysis + " analysis has no time step",
                   "Remove the entry");
  if (analysis == "modal" &&
      std::find(variants.begin(), variants.end(), "adaptive") != variants.end())
    section.refuse("Refinement", "a modal analysis has no indicator to adapt the mesh by",
                   "Write 'set Refinement = uniform'");
}
} // namespace Continua
