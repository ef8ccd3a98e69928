#ifndef continua_mesh_grading_h
#define continua_mesh_grading_h

#include <continua/base/parameter_section.h>

#include <vector>

namespace Continua
{
/// The ratios of cell sizes that a mesh entry accepts: beyond them the cells are useless slivers.
inline constexpr Range grading_range{1e-3, 1e3, false, false};

/**
 * Appends the ends of `n_cells` cells between `points.back()` and `end`; the cell sizes are a
 * geometric sequence whose last member is `ratio` times the first. The last point is `end` to the
 * last bit. All lengths in metres.
 */
void append_graded_cells(std::vector<double> &points,
                         double end,
                         unsigned int n_cells,
                         double ratio);

/**
 * The `n_cells` + 1 vertex coordinates between `begin` and `end` [m], graded geometrically and
 * symmetrically from both ends to the middle; the cells at the ends have `ratio` times the size of
 * those in the middle.
 */
std::vector<double>
symmetrically_graded_points(double begin, double end, unsigned int n_cells, double ratio);
} // namespace Continua

#endif
