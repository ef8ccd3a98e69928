#ifndef continua_mesh_grading_h
#define continua_mesh_grading_h

#include <continua/base/parameter_section.h>

#include <array>
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
 * The `n_cells` + 1 vertex coordinates between `begin` and `end` [m] of cells that are equal but
 * for a zone at each end: its first cell has the length `end_cells[0]` (`end_cells[1]` at `end`)
 * [m], and each next one is `growth` times as long, until the equal cells would be exceeded. An
 * infinite length, or one above that of the equal cells, makes no zone. Where `n_cells` growing
 * cells are too short to reach from end to end, all of them are longer in the same proportion.
 */
std::vector<double> points_with_end_zones(double begin,
                                          double end,
                                          unsigned int n_cells,
                                          const std::array<double, 2> &end_cells,
                                          double growth);

/**
 * The ratio for `append_graded_cells` with which the last of `n_cells` cells is `last` times as
 * long as all of them together; at least so large that neighbours differ by a factor of
 * `largest_growth`, at most 1.
 */
double ratio_for_last_cell(unsigned int n_cells, double last, double largest_growth);
} // namespace Continua

#endif
