#ifndef continua_finite_element_terms_tested_on_face_h
#define continua_finite_element_terms_tested_on_face_h

#include <deal.II/base/tensor.h>

namespace Continua
{
/// What a term gives at a point of a face, per area: it is multiplied by the values of the test
/// functions v of momentum.
template <int dim>
struct TestedOnFace
{
  dealii::Tensor<1, dim> by_value; ///< of v [Pa]

  TestedOnFace &operator+=(const TestedOnFace &other)
  {
    by_value += other.by_value;
    return *this;
  }
};
} // namespace Continua

#endif
