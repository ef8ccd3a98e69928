#include <continua/mesh/adaptation.h>

#include <deal.II/base/mpi.h>
#include <deal.II/distributed/grid_refinement.h>

#include <cmath>

namespace Continua
{
using namespace dealii;

void AdaptationParameters::read(ParameterSection section, const bool transient)
{
  if (transient)
  {
    section.add("Every n steps", every_n_steps,
                "Steps between two changes of the mesh; 0 keeps the mesh [1].");
    section.add("End time", end_time, Dimensions::time, "Time after which the mesh stays as it is.",
                Range::not_negative());
  }
  else
    section.add("Cycles", cycles,
                "How often the mesh is refined by the solution on it and solved again [1].");
  section.add_choice(
      "Strategy", strategy, {"number", "sum"},
      "Whether the fractions are of the number of cells, or of the sum of the indicators.");
  section.add("Refine fraction", refine_fraction, Dimensions::none,
              "Fraction with the largest traction jump that is refined.",
              Range{0., 1., false, false});
  section.add("Coarsen fraction", coarsen_fraction, Dimensions::none,
              "Fraction with the smallest traction jump that is coarsened.",
              Range{0., 1., false, false});
  section.add("Maximum level", maximum_level, "How often a coarse cell may be divided [1].", 0, 25);
  section.add("Minimum level", minimum_level,
              "How often every coarse cell stays divided at least [1].", 0, 25);
  if (refine_fraction + coarsen_fraction > 1.)
    section.refuse("Refine fraction", "the fractions to refine and to coarsen exceed 1 together",
                   "Make them smaller");
  if (minimum_level > maximum_level)
    section.refuse("Minimum level", "the minimum level exceeds the maximum level", "Swap them");
}

template <int dim>
bool flag_cells(parallel::distributed::Triangulation<dim> &triangulation,
                Vector<float> indicators,
                const AdaptationParameters &parameters)
{
  for (float &indicator : indicators)
    if (indicator > 0.)
    {
      const double unit = std::pow(10., std::floor(std::log10(indicator)) - 2.);
      indicator = std::round(indicator / unit) * unit;
    }
  if (parameters.strategy == "number")
    parallel::distributed::GridRefinement::refine_and_coarsen_fixed_number(
        triangulation, indicators, parameters.refine_fraction, parameters.coarsen_fraction);
  else
    parallel::distributed::GridRefinement::refine_and_coarsen_fixed_fraction(
        triangulation, indicators, parameters.refine_fraction, parameters.coarsen_fraction);
  int flagged = 0;
  for (const auto &cell : triangulation.active_cell_iterators())
    if (cell->is_locally_owned())
    {
      if (cell->level() >= static_cast<int>(parameters.maximum_level))
        cell->clear_refine_flag();
      if (cell->level() <= static_cast<int>(parameters.minimum_level))
        cell->clear_coarsen_flag();
      if (cell->refine_flag_set() || cell->coarsen_flag_set())
        flagged = 1;
    }
  return Utilities::MPI::max(flagged, triangulation.get_communicator()) == 1;
}

template bool
flag_cells(parallel::distributed::Triangulation<2> &, Vector<float>, const AdaptationParameters &);
template bool
flag_cells(parallel::distributed::Triangulation<3> &, Vector<float>, const AdaptationParameters &);
} // namespace Continua
