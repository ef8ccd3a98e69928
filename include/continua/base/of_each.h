#ifndef continua_base_of_each_h
#define continua_base_of_each_h

#include <deal.II/base/vectorization.h>

#include <cstddef>

namespace Continua
{
/// A function of one number at each of several that are computed at once.
template <typename Function>
double of_each(const Function &function, const double number)
{
  return function(number);
}
template <typename Function, std::size_t width>
dealii::VectorizedArray<double, width>
of_each(const Function &function, const dealii::VectorizedArray<double, width> &numbers)
{
  dealii::VectorizedArray<double, width> result;
  for (unsigned int lane = 0; lane < width; ++lane)
    result[lane] = function(numbers[lane]);
  return result;
}
} // namespace Continua

#endif
