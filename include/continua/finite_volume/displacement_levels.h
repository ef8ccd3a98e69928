#ifndef continua_finite_volume_displacement_levels_h
#define continua_finite_volume_displacement_levels_h

#include <continua/continuum/state_visitor.h>
#include <continua/linear_algebra/distributed_vector.h>
#include <continua/time_integration/step.h>

#include <array>

namespace Continua
{
/**
 * Displacements of earlier times, and what second time derivatives the displacement form makes of
 * them: Euler's (D - 2 D_o + D_oo)/dt^2 (equation 3.42), or the one of second order over four
 * levels, (2 D - 5 D_o + 4 D_oo - D_ooo)/dt^2 (3.43), as soon as four levels are known at one
 * distance.
 */
class DisplacementLevels
{
public:
  /// d2D/dt2 = own D + sum of known[i] D_i, and dD/dt likewise.
  struct Derivatives
  {
    double second_own = 0.; ///< [1/s^2]
    std::array<double, 3> second_known{};
    double first_own = 0.; ///< [1/s]
    std::array<double, 3> first_known{};
  };

  bool is_started() const { return size_old > 0.; }
  /// All levels from the present one and its velocity: the body moved uniformly before.
  void start(const DistributedVector &displacement, const DistributedVector &velocity, double size);
  /// Of a step; `second_order`: the four levels where they are there. A step of another size than
  /// the last is Euler's, with D_oo moved to the new distance.
  Derivatives derivatives(const Step &step, bool second_order) const;
  /// sum of known[i] D_i.
  void combine(const std::array<double, 3> &known, DistributedVector &sum) const;
  /// Takes the displacement of the end of the step as the newest level.
  void advance(const Step &step, const DistributedVector &displacement);

  /// Hands over all that a step changes.
  void visit(StateVisitor &visitor);

private:
  std::array<DistributedVector, 3> levels; ///< the newest first
  double size_old = 0.;                    ///< [s] between the levels
  unsigned int n_equal = 0;                ///< levels known at that distance, beside the newest
};
} // namespace Continua

#endif
