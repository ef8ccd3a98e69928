#ifndef continua_finite_element_terms_tested_h
#define continua_finite_element_terms_tested_h

#include <deal.II/base/tensor.h>

namespace Continua
{
/**
 * What a term gives at a point, per volume of the body: it is multiplied by the values and the
 * gradients of the test functions v of momentum and by the values of the test functions q of
 * volume. `Number`: double, or several points at once.
 */
template <int dim, typename Number = double>
struct Tested
{
  dealii::Tensor<1, dim, Number> by_value;    ///< of v [N/m^3]
  dealii::Tensor<2, dim, Number> by_gradient; ///< of v, [component][direction] [Pa]
  Number of_volume = 0.;                      ///< by the value of q [1/s]

  /// Adds a mean stress [Pa]: it is multiplied by div v. `hoop`: 1/r in axisymmetry, else 0 [1/m].
  void add_mean_stress(const Number &stress, const Number &hoop)
  {
    for (unsigned int c = 0; c < dim; ++c)
      by_gradient[c][c] += stress;
    by_value[1] += stress * hoop;
  }
  /// Adds a stress with its component along the circumference [Pa]: it is multiplied by grad v.
  void
  add_stress(const dealii::Tensor<2, dim, Number> &stress, const Number &across, const Number &hoop)
  {
    by_gradient += stress;
    by_value[1] += across * hoop;
  }

  Tested &operator+=(const Tested &other)
  {
    by_value += other.by_value;
    by_gradient += other.by_gradient;
    of_volume += other.of_volume;
    return *this;
  }
  Tested &operator*=(const Number &factor)
  {
    by_value *= factor;
    by_gradient *= factor;
    of_volume *= factor;
    return *this;
  }
};
} // namespace Continua

#endif
