#ifndef continua_network_solve_rows_h
#define continua_network_solve_rows_h

#include <vector>

namespace Continua
{
/// Of a small dense system: the numbers of a row, and behind them its right hand side.
using Rows = std::vector<std::vector<double>>;

/// Gauss's elimination with row pivots, in place. `solution` gets one number a row. False, and no
/// solution, if the system is singular.
[[nodiscard]] bool solve_rows(Rows &rows, std::vector<double> &solution);
} // namespace Continua

#endif
