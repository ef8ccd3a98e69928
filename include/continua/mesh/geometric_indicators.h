#ifndef continua_mesh_geometric_indicators_h
#define continua_mesh_geometric_indicators_h

#include <continua/signal/expression.h>

#include <deal.II/grid/tria.h>
#include <deal.II/lac/vector.h>

#include <vector>

namespace Continua
{
/**
 * 1 in cells that have a vertex nearer than `width` [m] to an interface of fluid and solid, or a
 * face on it, 0 in the others. `is_solid`: by material id. The distance is that to the faces of the
 * coarse mesh, whose chords stand for arcs; exact for segments and rectangles. One an active cell;
 * only owned ones count.
 */
template <int dim>
dealii::Vector<float> interface_band(const dealii::Triangulation<dim> &triangulation,
                                     const std::vector<bool> &is_solid,
                                     double width);

/// The largest value of a function at the centre and the vertices of each active cell, at `time`
/// [s]; only owned ones count.
template <int dim>
dealii::Vector<float> expression_indicator(const dealii::Triangulation<dim> &triangulation,
                                           const Expression &expression,
                                           double time);
} // namespace Continua

#endif
