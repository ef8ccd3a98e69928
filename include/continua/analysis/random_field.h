#ifndef continua_analysis_random_field_h
#define continua_analysis_random_field_h

#include <deal.II/base/point.h>

#include <array>
#include <random>
#include <vector>

namespace Continua
{
/**
 * A random vector field: of each component the sum of plane waves of random directions, lengths and
 * phases. The logarithms of the lengths are equally probable from the size of a body to a hundredth
 * of it. The field depends on the place alone, so that it is the same for any numbering of nodes
 * and any number of ranks.
 */
template <int dim>
class RandomField
{
public:
  /// `size`: of the body [m]. The generator goes on by a fixed number of steps.
  RandomField(std::mt19937_64 &generator, double size);

  /// A component of about the size one at a place [m].
  double value(const dealii::Point<dim> &place, unsigned int component) const;

private:
  struct Wave
  {
    dealii::Tensor<1, dim> wave_vector; ///< [rad/m]
    double phase;                       ///< [rad]
  };
  std::array<std::vector<Wave>, dim> waves; ///< by component
};
} // namespace Continua

#endif
