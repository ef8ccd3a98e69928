#include <continua/studies/comparison.h>

#include <continua/base/input_error.h>
#include <continua/studies/comparison_report.h>

#include <string>

namespace Continua
{
Comparison::Comparison(const AnalysisInput &input)
    : MeshStudy(input, {"Comparison", "mesh", "compared", true})
{
  parameters.read(file.root());
  read_case(parameters);
  for (unsigned int number = 0; number < 2; ++number)
  {
    const std::string &value = parameters.values[number];
    try
    {
      variants.push_back(read_variant(parameters.name(number), parameters.meshes_of(number),
                                      {{parameters.entry, value}}));
    }
    catch (const InputError &error)
    {
      section().refuse(
          "Values",
          "with " + parameters.entry + " = " + value + " the case is refused: " + error.what(), "");
    }
    check_time_step(variants.back());
    check_divisions(variants.back(), number == 0 ? "Meshes" : "Meshes of the second",
                    "Give fewer divisions");
  }
  if (folder_name(variants[0].name) == folder_name(variants[1].name))
    section().refuse("Values", "the folders of the two would have the same name",
                     "Write the values otherwise");
  QuantityNames of_runs;
  for (const Variant &variant : variants)
  {
    variant.quantities.refuse_unknown(section(), "Quantities", parameters.quantities);
    of_runs.add(variant.quantities);
  }
  ComparisonReport::name_quantities(parameters, of_runs, quantities);
  quantities.refuse_unknown(file, section().subsection("Expected"), parameters.expected);
}

void Comparison::refine_mesh(CommandLine &of_run,
                             const Variant &variant,
                             const unsigned int mesh) const
{
  set_entry(of_run, "Mesh/Refinements", std::to_string(variant.refinements + mesh));
}

std::unique_ptr<StudyReport> Comparison::make_report_of(const std::vector<StudiedRun> &runs) const
{
  std::vector<ConvergenceOrders> orders(variants.size());
  for (std::size_t i = 0; i < variants.size(); ++i)
  {
    // At best, as displacements at vertices by elements of degree k: 2 k.
    orders[i].highest = 2. * variants[i].velocities_per_cell;
    if (parameters.refine_time_step && variants[i].time.scheme == Scheme::euler_implicit)
      orders[i].assumed = 1.;
  }
  return std::make_unique<ComparisonReport>(parameters, orders, runs);
}
} // namespace Continua
