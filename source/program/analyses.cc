#include <continua/program/analyses.h>

#include <continua/analysis/linear_wave_theory.h>
#include <continua/analysis/modal.h>
#include <continua/analysis/steady.h>
#include <continua/analysis/transient.h>

#include <deal.II/base/exceptions.h>

namespace Continua
{
namespace
{
template <int dim>
struct Row
{
  const char *name;
  const char *description;
  void (*perform)(Run<dim> &);
};

template <int dim>
const std::vector<Row<dim>> &table()
{
  static const std::vector<Row<dim>> rows = {
      {"transient", "Steps through time.", [](Run<dim> &run) { Transient<dim>(run).perform(); }},
      {"steady",
       "State at rest: one solve for a body that is all solid or all fluid, steps to rest for a "
       "mixture.",
       [](Run<dim> &run) { Steady<dim>(run).perform(); }},
      {"modal", "Frequencies and shapes of a solid body's free vibrations.",
       [](Run<dim> &run) { Modal<dim>(run).perform(); }},
      {"linear wave theory", "Linear waves of a tube at its stations, without a mesh.",
       [](Run<dim> &run) { LinearWaveTheory<dim>(run).perform(); }}};
  return rows;
}
} // namespace

std::vector<std::pair<std::string, std::string>> analysis_types()
{
  std::vector<std::pair<std::string, std::string>> types;
  for (const Row<2> &row : table<2>())
    types.emplace_back(row.name, row.description);
  // Of many runs, or of none: Comparison, RefinementStudy, SpinCoatingAnalysis and
  // MaterialLaboratory.
  types.emplace_back("comparison",
                     "The same case by both discretisations on several meshes: orders, limits and "
                     "whether they agree.");
  types.emplace_back(
      "refinement study",
      "The same case on finer and finer meshes, uniform and adaptive: errors, orders "
      "and what they cost.");
  types.emplace_back("spin coating", "How a tube is made: what the motors do along the rod.");
  types.emplace_back("material",
                     "What a solid is like: its complex modulus, and simulated material tests.");
  return types;
}

template <int dim>
void perform_analysis(Run<dim> &run)
{
  for (const Row<dim> &row : table<dim>())
    if (run.input.general.analysis == row.name)
      return row.perform(run);
  AssertThrow(false, dealii::ExcInternalError());
}

template void perform_analysis(Run<2> &);
template void perform_analysis(Run<3> &);
} // namespace Continua
