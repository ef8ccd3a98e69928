#ifndef continua_mesh_adaptation_h
#define continua_mesh_adaptation_h

#include <continua/base/parameter_section.h>

#include <deal.II/distributed/tria.h>
#include <deal.II/lac/vector.h>

#include <limits>
#include <string>

namespace Continua
{
/// The section Adaptivity: how the mesh follows the solution.
struct AdaptationParameters
{
  unsigned int cycles = 0; ///< of a steady analysis: how often solve, estimate, refine is repeated
  unsigned int every_n_steps = 0; ///< of a transient one; 0: the mesh stays
  double refine_fraction = 0.3;   ///< of the cells, or of the indicators' sum
  double coarsen_fraction = 0.03;
  std::string strategy = "number"; ///< number | sum
  unsigned int maximum_level = 10;
  unsigned int minimum_level = 0;
  double end_time = std::numeric_limits<double>::infinity(); ///< [s] after which the mesh stays

  /// Declares and reads; throws InputError.
  void read(ParameterSection section, bool transient);
};

/**
 * Flags cells for refinement and coarsening by their indicators (one an active cell; only the owned
 * ones count). The indicators are rounded to three digits first, so that cells which are alike by
 * symmetry are treated alike, on any number of ranks. Returns whether any cell is flagged.
 * Collective.
 */
template <int dim>
bool flag_cells(dealii::parallel::distributed::Triangulation<dim> &triangulation,
                dealii::Vector<float> indicators,
                const AdaptationParameters &parameters);
} // namespace Continua

#endif
