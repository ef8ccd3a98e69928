#ifndef continua_mesh_coordinates_h
#define continua_mesh_coordinates_h

#include <deal.II/base/point.h>

#include <array>

namespace Continua
{
/// The coordinates of a point [m], those that there are none of in two dimensions zero.
template <int dim>
std::array<double, 3> coordinates(const dealii::Point<dim> &point)
{
  std::array<double, 3> result = {{0., 0., 0.}};
  for (unsigned int c = 0; c < dim; ++c)
    result[c] = point[c];
  return result;
}
} // namespace Continua

#endif
