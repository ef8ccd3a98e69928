#ifndef continua_continuum_state_visitor_h
#define continua_continuum_state_visitor_h

#include <continua/linear_algebra/distributed_vector.h>

#include <cstddef>

namespace Continua
{
/// What is done with all that a step changes; the parts of a solver hand it in, always in the same
/// order and, on one mesh, of the same sizes.
class StateVisitor
{
public:
  virtual ~StateVisitor() = default;
  /// n numbers at the present time, and what they were one step before.
  virtual void levels(double *present, double *older, std::size_t n) = 0;
  /// n numbers that have no past.
  virtual void values(double *numbers, std::size_t n) = 0;

  /// The owned entries of vectors.
  void levels(DistributedVector &present, DistributedVector &older)
  {
    Assert(have_same_layout(present, older),
           dealii::ExcMessage("Two levels of a vector have different layouts."));
    levels(present.begin(), older.begin(), present.locally_owned_size());
  }
  void values(DistributedVector &vector) { values(vector.begin(), vector.locally_owned_size()); }
  /// A number or a flag.
  template <typename Number>
  void value(Number &number)
  {
    double copy = static_cast<double>(number);
    values(&copy, 1);
    number = static_cast<Number>(copy);
  }
};
} // namespace Continua

#endif
