#ifndef continua_postprocess_grid_convergence_h
#define continua_postprocess_grid_convergence_h

#include <string>
#include <vector>

namespace Continua
{
/// What is known of a discretisation before its values are seen.
struct ConvergenceOrders
{
  double assumed = 2.; ///< where the values do not tell the order: two meshes only
  double highest = 4.; ///< the highest that smooth solutions have; an observed one above is chance
};

/**
 * What the values of one quantity on finer and finer meshes say of their limit: the order with
 * which they converge, the limit by Richardson's extrapolation, and the error that the value on the
 * finest mesh is estimated to have, which is Roache's grid convergence index times the value (P. J.
 * Roache, J. Fluids Eng. 116, 1994). The same is taken as the error of the limit, which is safe.
 *
 * Of more than three meshes the three finest count. From cell sizes h1 < h2 < h3 and values f1, f2,
 * f3 the order p solves (f3 - f2) / (f2 - f1) = r21^p (r32^p - 1) / (r21^p - 1), r21 = h2/h1, r32 =
 * h3/h2 (I. B. Celik et al., J. Fluids Eng. 130, 2008). The limit is f1 + (f1 - f2) / (r21^p - 1)
 * and the error F times its distance from f1: F = 1.25 if p is plausible, from 0.5 to half an order
 * above the highest; else F = 3 with p moved to the nearer of 0.5 and the highest order; with two
 * meshes F = 3 with the assumed order.
 */
struct GridConvergence
{
  enum class Behaviour
  {
    too_few,     ///< less than two meshes: nothing can be said
    two_meshes,  ///< with the assumed order
    monotone,    ///< the differences keep their sign and shrink: an order is observed
    oscillatory, ///< they change their sign: no order; the limit is the finest value, the error the
                 ///< range of the three
    divergent,   ///< they keep their sign and do not shrink: neither order nor limit
    settled      ///< the last difference is round-off: the limit is the finest value
  };

  /// Cell sizes [any unit] and values from the coarsest mesh to the finest; `round_off`:
  /// differences up to this are none. Throws std::invalid_argument if they are not equally many or
  /// the cell sizes do not decrease.
  GridConvergence(const std::vector<double> &cell_sizes,
                  const std::vector<double> &values,
                  const ConvergenceOrders &orders,
                  double round_off);

  Behaviour behaviour = Behaviour::too_few;
  double order;                 ///< observed [1]; NaN unless monotone
  bool order_plausible = false; ///< always false where none is observed
  double limit;                 ///< in the unit of the values; NaN if divergent or too few
  double estimated_error;       ///< >= 0, in the unit of the values; NaN where the limit is

  /// "1.98", "0.30 ?" (not plausible), "two meshes", "oscillates", "diverges", "settled", "too
  /// few".
  std::string description() const;
};
} // namespace Continua

#endif
