#ifndef continua_mesh_adaptation_h
#define continua_mesh_adaptation_h

#include <continua/base/words.h>
#include <continua/mesh/indicator_field.h>
#include <continua/signal/expression.h>

#include <deal.II/distributed/tria.h>
#include <deal.II/lac/vector.h>

#include <limits>
#include <vector>

namespace Continua
{
/// What tells where the mesh is too coarse.
enum class Indicator
{
  traction_jump,
  kelly,
  interface_band,
  expression
};

/// Which cells are refined and coarsened.
enum class AdaptationStrategy
{
  number,   ///< fractions of the number of cells
  sum,      ///< fractions of the indicators' sum
  threshold ///< those above and below thresholds
};

/// The section Adaptivity: how the mesh follows the solution.
struct AdaptationParameters
{
  unsigned int cycles = 0; ///< of a steady analysis: how often solve, estimate, refine is repeated
  unsigned int every_n_steps = 0;  ///< of a transient one; 0: the mesh stays
  unsigned int initial_cycles = 0; ///< of a transient one: changes before the start
  std::vector<Indicator> indicators = {Indicator::traction_jump}; ///< more than one if combined
  std::vector<double> weights = {1.};                             ///< as many
  IndicatorField kelly_field = IndicatorField::velocity;
  double band_width = 0.; ///< [m]
  Expression expression;  ///< of place and time; positive refines
  AdaptationStrategy strategy = AdaptationStrategy::number;
  double refine_fraction = 0.3;   ///< of the cells, or of the indicators' sum
  double coarsen_fraction = 0.03; ///< likewise
  double refine_above = 0.;       ///< of a threshold
  double coarsen_below = 0.;      ///< up to which cells are coarsened
  unsigned int maximum_level = 10;
  unsigned int minimum_level = 0;
  double end_time = std::numeric_limits<double>::infinity(); ///< [s] after which the mesh stays

  /// Declares and reads; throws InputError.
  void read(ParameterSection section, bool transient);
  bool uses(Indicator indicator) const;
  /// Whether no indicator looks at the solution.
  bool is_geometric() const;
  /// Whether the mesh is changed at all.
  bool changes_mesh() const { return cycles > 0 || every_n_steps > 0 || initial_cycles > 0; }

private:
  void read_indicators(ParameterSection section);
  void read_strategy(ParameterSection section);
};

/**
 * Flags cells for refinement and coarsening by their indicators (one an active cell; only the owned
 * ones count). The indicators are rounded to three digits first, so that cells which are alike by
 * symmetry are treated alike, on any number of ranks. Flags are those that the mesh can follow:
 * execute_coarsening_and_refinement() may come next. Returns whether any cell is flagged.
 * Collective.
 */
template <int dim>
bool flag_cells(dealii::parallel::distributed::Triangulation<dim> &triangulation,
                dealii::Vector<float> indicators,
                const AdaptationParameters &parameters);
} // namespace Continua

#endif
