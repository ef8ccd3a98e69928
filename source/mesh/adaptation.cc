#include <continua/mesh/adaptation.h>

#include <deal.II/base/mpi.h>
#include <deal.II/distributed/grid_refinement.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace Continua
{
using namespace dealii;

namespace
{
/// In a function, so that it is there when another file's static data read parameters.
const Words<Indicator> &indicator_words()
{
  static const Words<Indicator> words = {{"traction jump", Indicator::traction_jump},
                                         {"kelly", Indicator::kelly},
                                         {"interface band", Indicator::interface_band},
                                         {"expression", Indicator::expression}};
  return words;
}

/// An entry that is set and plays no part is a misunderstanding.
void refuse_idle(const ParameterSection &section,
                 const std::string &key,
                 const bool used,
                 const std::string &owner)
{
  if (!used && section.given(key))
    section.refuse(key, "this entry belongs to " + owner + ", which is not chosen",
                   "Remove the entry, or choose " + owner);
}
} // namespace

bool AdaptationParameters::uses(const Indicator indicator) const
{
  return std::find(indicators.begin(), indicators.end(), indicator) != indicators.end();
}

bool AdaptationParameters::is_geometric() const
{
  return !uses(Indicator::traction_jump) && !uses(Indicator::kelly);
}

void AdaptationParameters::read(ParameterSection section, const bool transient)
{
  if (transient)
  {
    section.add("Every n steps", every_n_steps,
                "Steps between two changes of the mesh; 0 keeps the mesh [1].");
    section.add("Initial cycles", initial_cycles,
                "How often the mesh is changed before the start; by an indicator of the solution "
                "after steps as between two changes, which are then taken anew [1].");
    section.add("End time", end_time, Dimensions::time, "Time after which the mesh stays as it is.",
                Range::not_negative());
  }
  else
    section.add("Cycles", cycles,
                "How often the mesh is refined by the solution on it and solved again [1].");
  read_indicators(section);
  read_strategy(section);
  section.add("Maximum level", maximum_level, "How often a coarse cell may be divided [1].", 0, 25);
  section.add("Minimum level", minimum_level,
              "How often every coarse cell stays divided at least [1].", 0, 25);
  if (minimum_level > maximum_level)
    section.refuse("Minimum level", "the minimum level exceeds the maximum level", "Swap them");
}

void AdaptationParameters::read_indicators(ParameterSection section)
{
  std::optional<Indicator> indicator = Indicator::traction_jump; // none: combined
  Words<std::optional<Indicator>> choices(indicator_words().begin(), indicator_words().end());
  choices.emplace_back("combined", std::nullopt);
  add_choice(
      section, "Indicator", indicator, choices,
      "What tells where the mesh is too coarse: traction jump - of the stress vector across faces "
      "and at loaded boundaries; kelly - of a field's normal derivative across faces inside each "
      "region; interface band - 1 near an interface of fluid and solid, else 0; expression - of "
      "place and time; combined - the sum of several, each over its largest value.");
  std::vector<std::string> several;
  section.add(
      "Indicators", several,
      "Of a combined indicator: two or more of the others (traction jump, interface band).");
  std::vector<double> given_weights;
  section.add("Weights", given_weights, Dimensions::none,
              "Of a combined indicator: a factor for each of Indicators; empty: 1 for all.",
              Range::not_negative());
  add_choice(section, "Indicator field", kelly_field,
             {{"velocity", IndicatorField::velocity},
              {"displacement", IndicatorField::displacement},
              {"pressure", IndicatorField::pressure}},
             "Of kelly: the field whose normal derivative is looked at.");
  section.add(
      "Band width", band_width, Dimensions::length,
      "Of an interface band: cells with a vertex that is nearer to the interface count, and "
      "those at it.",
      Range::not_negative());
  add_expression(section, "Expression", expression, Dimensions::none,
                 "Of an expression: f(x, y, z, t) in SI; the largest value at a cell's centre and "
                 "vertices counts. By default a cell is refined where it is positive and coarsened "
                 "where it is not.");

  const bool combined = !indicator;
  refuse_idle(section, "Indicators", combined, "Indicator = combined");
  refuse_idle(section, "Weights", combined, "Indicator = combined");
  if (combined)
  {
    section.require("Indicators");
    const std::vector<std::string> singles = choices_of(indicator_words());
    for (unsigned int i = 0; i < several.size(); ++i)
    {
      if (std::find(singles.begin(), singles.end(), several[i]) == singles.end())
        section.refuse("Indicators", "there is no indicator '" + several[i] + "'",
                       "Name two or more of traction jump, kelly, interface band, expression");
      if (std::find(several.begin(), several.begin() + i, several[i]) != several.begin() + i)
        section.refuse("Indicators", "'" + several[i] + "' is named twice", "Name each once");
    }
    if (several.size() == 1)
      section.refuse("Indicators", "one indicator alone is not combined",
                     "Set Indicator = " + several[0]);
    if (given_weights.empty())
      given_weights.assign(several.size(), 1.);
    if (given_weights.size() != several.size())
      section.refuse("Weights",
                     "there are " + std::to_string(given_weights.size()) + " weights for " +
                         std::to_string(several.size()) + " indicators",
                     "Give as many as Indicators");
    if (!given_weights.empty() && std::all_of(given_weights.begin(), given_weights.end(),
                                              [](const double weight) { return weight == 0.; }))
      section.refuse("Weights", "no indicator has a weight", "Give one of them more than 0");
    indicators.clear();
    for (const std::string &word : several)
      indicators.push_back(value_of(indicator_words(), word));
    weights = given_weights;
  }
  else
    indicators = {*indicator};
  refuse_idle(section, "Indicator field", uses(Indicator::kelly), "the indicator kelly");
  refuse_idle(section, "Band width", uses(Indicator::interface_band),
              "the indicator interface band");
  refuse_idle(section, "Expression", uses(Indicator::expression), "the indicator expression");
  if (uses(Indicator::interface_band))
    section.require("Band width");
  if (uses(Indicator::expression))
    section.require("Expression");
}

void AdaptationParameters::read_strategy(ParameterSection section)
{
  std::optional<AdaptationStrategy> choice; // none: automatic
  add_choice(section, "Strategy", choice,
             {{"automatic", std::nullopt},
              {"number", AdaptationStrategy::number},
              {"sum", AdaptationStrategy::sum},
              {"threshold", AdaptationStrategy::threshold}},
             "Which cells are refined and coarsened: fractions of the number of cells; "
             "fractions of the indicators' sum; those above and below thresholds. "
             "Automatic: thresholds where no indicator looks at the solution, else number.");
  section.add("Refine fraction", refine_fraction, Dimensions::none,
              "Fraction with the largest indicator that is refined.", Range{0., 1., false, false});
  section.add("Coarsen fraction", coarsen_fraction, Dimensions::none,
              "Fraction with the smallest indicator that is coarsened.",
              Range{0., 1., false, false});
  section.add("Refine above", refine_above, Dimensions::none,
              "Of a threshold: cells with a larger indicator are refined. Indicators of the "
              "solution are over their largest value, so that this is from 0 to 1.");
  section.add("Coarsen below", coarsen_below, Dimensions::none,
              "Of a threshold: cells with no larger indicator are coarsened.");
  strategy =
      choice.value_or(is_geometric() ? AdaptationStrategy::threshold : AdaptationStrategy::number);
  const bool threshold = strategy == AdaptationStrategy::threshold;
  if (!threshold && is_geometric())
    section.refuse("Strategy",
                   "an indicator that does not look at the solution has the same value in many "
                   "cells, of which a fraction would be chosen by chance",
                   "Set Strategy = threshold");
  for (const char *key : {"Refine fraction", "Coarsen fraction"})
    refuse_idle(section, key, !threshold, "Strategy = number or sum");
  for (const char *key : {"Refine above", "Coarsen below"})
    refuse_idle(section, key, threshold, "Strategy = threshold");
  if (threshold && !is_geometric())
  {
    section.require("Refine above");
    section.require("Coarsen below");
  }
  if (!threshold && refine_fraction + coarsen_fraction > 1.)
    section.refuse("Refine fraction", "the fractions to refine and to coarsen exceed 1 together",
                   "Make them smaller");
  if (coarsen_below > refine_above)
    section.refuse("Coarsen below", "cells between the two would be both refined and coarsened",
                   "Make it at most Refine above");
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
  if (parameters.strategy == AdaptationStrategy::number)
    parallel::distributed::GridRefinement::refine_and_coarsen_fixed_number(
        triangulation, indicators, parameters.refine_fraction, parameters.coarsen_fraction);
  else if (parameters.strategy == AdaptationStrategy::sum)
    parallel::distributed::GridRefinement::refine_and_coarsen_fixed_fraction(
        triangulation, indicators, parameters.refine_fraction, parameters.coarsen_fraction);
  else
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned())
      {
        // As floats: 0.1 of the parameter file is not above 0.1 of an indicator.
        const float indicator = indicators[cell->active_cell_index()];
        if (indicator > static_cast<float>(parameters.refine_above))
          cell->set_refine_flag();
        else if (indicator <= static_cast<float>(parameters.coarsen_below))
          cell->set_coarsen_flag();
      }
  for (const auto &cell : triangulation.active_cell_iterators())
    if (cell->is_locally_owned())
    {
      if (cell->level() >= static_cast<int>(parameters.maximum_level))
        cell->clear_refine_flag();
      if (cell->level() <= static_cast<int>(parameters.minimum_level))
        cell->clear_coarsen_flag();
    }
  // Takes the flags back that lead to nothing: a cell to coarsen whose siblings stay.
  triangulation.prepare_coarsening_and_refinement();
  int flagged = 0;
  for (const auto &cell : triangulation.active_cell_iterators())
    if (cell->is_locally_owned() && (cell->refine_flag_set() || cell->coarsen_flag_set()))
      flagged = 1;
  return Utilities::MPI::max(flagged, triangulation.get_communicator()) == 1;
}

template bool
flag_cells(parallel::distributed::Triangulation<2> &, Vector<float>, const AdaptationParameters &);
template bool
flag_cells(parallel::distributed::Triangulation<3> &, Vector<float>, const AdaptationParameters &);
} // namespace Continua
