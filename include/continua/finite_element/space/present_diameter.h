#ifndef continua_finite_element_space_present_diameter_h
#define continua_finite_element_space_present_diameter_h

#include <continua/linear_algebra/distributed_vector.h>

#include <deal.II/base/point.h>

#include <algorithm>

namespace Continua
{
/// The longest diagonal of a cell or a face of the velocity's DoFHandler as it is displaced [m];
/// of an undeformed one that is diameter(). `displacement`: with ghost entries [m].
template <int dim, typename Iterator>
double present_diameter(const Iterator &object, const DistributedVector &displacement)
{
  const auto place = [&](const unsigned int v)
  {
    dealii::Point<dim> result = object->vertex(v);
    for (unsigned int c = 0; c < dim; ++c)
      result[c] += displacement(object->vertex_dof_index(v, c));
    return result;
  };
  double largest = 0.;
  const unsigned int n = object->n_vertices();
  for (unsigned int v = 0; v < n / 2; ++v)
    largest = std::max(largest, place(v).distance(place(n - 1 - v)));
  return largest;
}
} // namespace Continua

#endif
