#ifndef continua_continuum_state_visitor_h
#define continua_continuum_state_visitor_h

#include <continua/linear_algebra/distributed_vector.h>

#include <cstddef>
#include <string>

namespace Continua
{
/// What the entries of a vector belong to.
enum class StateKind
{
  velocity,
  pressure,
  internal_metric, ///< at quadrature points, in finite deformation
  mesh_vertex      ///< of a mesh whose vertices move between steps
};

/// The name of a part of the state, put together only when somebody asks for it: a step that keeps
/// the state names nothing.
class StateName
{
public:
  StateName(const char *text) : text(text) {}
  /// "branch 3".
  StateName(const char *text, const unsigned int number)
      : text(text), first(static_cast<int>(number))
  {
  }
  /// "outlet 3, 2".
  StateName(const char *text, const unsigned int number, const unsigned int part)
      : text(text), first(static_cast<int>(number)), second(static_cast<int>(part))
  {
  }
  std::string str() const
  {
    std::string name = text;
    if (first >= 0)
      name.append(" ").append(std::to_string(first));
    if (second >= 0)
      name.append(", ").append(std::to_string(second));
    return name;
  }

private:
  const char *text;
  int first = -1, second = -1;
};

/**
 * What is done with the state: all that a step changes and the next one starts from. A solver lists
 * it once, by handing it to a visitor, always in the same order; whatever is done with the state
 * (sizes, saving, loading, keeping, giving back, carrying over to another mesh) is a visitor.
 */
class StateVisitor
{
public:
  virtual ~StateVisitor() = default;
  /// Whether branches hand in their vectors, one entry for each velocity of the body. Else they
  /// hand in the numbers at the nodes of their own region, which is what a step works with, and
  /// less.
  virtual bool takes_vectors() const = 0;

  /// A vector at the present time, and what it was one step before.
  virtual void levels(const StateName &name,
                      StateKind kind,
                      DistributedVector &present,
                      DistributedVector &older) = 0;
  /// A vector that has no past of its own.
  virtual void vector(const StateName &name, StateKind kind, DistributedVector &vector) = 0;
  /// n numbers at the present time and one step before: the same on every rank, or those of a
  /// branch at this rank's nodes where vectors are not taken.
  virtual void levels(const StateName &name, double *present, double *older, std::size_t n) = 0;
  /// A number, the same on every rank.
  virtual void value(const StateName &name, double &number) = 0;

  /// A flag or a count.
  template <typename Number>
  void value(const StateName &name, Number &number)
  {
    double copy = static_cast<double>(number);
    value(name, copy);
    number = static_cast<Number>(copy);
  }
};

/// A visitor to whom the state is a list of numbers: the owned entries of vectors, one vector after
/// the other.
class NumbersVisitor : public StateVisitor
{
public:
  bool takes_vectors() const final { return false; }
  void
  levels(const StateName &, StateKind, DistributedVector &present, DistributedVector &older) final
  {
    Assert(have_same_layout(present, older),
           dealii::ExcMessage("Two levels of a vector have different layouts."));
    take_levels(present.begin(), older.begin(), present.locally_owned_size());
  }
  void vector(const StateName &, StateKind, DistributedVector &vector) final
  {
    take_values(vector.begin(), vector.locally_owned_size());
  }
  void levels(const StateName &, double *present, double *older, const std::size_t n) final
  {
    take_levels(present, older, n);
  }
  using StateVisitor::value;
  void value(const StateName &, double &number) final { take_values(&number, 1); }

protected:
  /// n numbers at the present time, and what they were one step before.
  virtual void take_levels(double *present, double *older, std::size_t n) = 0;
  /// n numbers that have no past.
  virtual void take_values(double *numbers, std::size_t n) = 0;
};
} // namespace Continua

#endif
