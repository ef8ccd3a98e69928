#ifndef continua_tests_finite_element_numbers_of_cell_h
#define continua_tests_finite_element_numbers_of_cell_h

// Numbers at the points of a cell for the tests of terms at several points, the same on every
// machine.

#include <continua/finite_element/space/numbers_at_points.h>

#include <deal.II/base/tensor.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace numbers_of_cell
{
/// Numbers without any order, from -1 to 1.
inline std::vector<double> numbers(const std::size_t n, const double phase)
{
  std::vector<double> result(n);
  for (std::size_t k = 0; k < n; ++k)
    result[k] = std::sin(phase + 1.7 * k + 0.01 * k * k);
  return result;
}

/// Of a field with some components: all of its numbers, of which each component has some to spare.
struct Field
{
  std::size_t n_points, component_size;
  std::vector<double> values;

  Field(const std::size_t n_points, const unsigned int n_components, const double phase)
      : n_points(n_points),
        component_size(4 * n_points + 3),
        values(numbers(n_components * component_size, phase))
  {
  }
  Continua::NumbersAtPoints<const double> view() const { return {values.data(), component_size}; }
  double at(const unsigned int component, const unsigned int number, const unsigned int q) const
  {
    return values[component * component_size + number * n_points + q];
  }
  template <int dim>
  dealii::Tensor<1, dim> value(const unsigned int q) const
  {
    dealii::Tensor<1, dim> result;
    for (unsigned int c = 0; c < dim; ++c)
      result[c] = at(c, 0, q);
    return result;
  }
  template <int dim>
  dealii::Tensor<1, dim> gradient(const unsigned int component,
                                  const unsigned int q,
                                  const dealii::Tensor<2, dim> &inverse_jacobian) const
  {
    dealii::Tensor<1, dim> result;
    for (unsigned int d = 0; d < dim; ++d)
      for (unsigned int s = 0; s < dim; ++s)
        result[d] += at(component, s + 1, q) * inverse_jacobian[s][d];
    return result;
  }
};

/// The largest difference.
inline double distance(const std::vector<double> &a, const std::vector<double> &b)
{
  double largest = 0.;
  for (std::size_t k = 0; k < a.size(); ++k)
    largest = std::max(largest, std::abs(a[k] - b[k]));
  return largest;
}
} // namespace numbers_of_cell

#endif
