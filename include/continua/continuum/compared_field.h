#ifndef continua_continuum_compared_field_h
#define continua_continuum_compared_field_h

#include <continua/continuum/problem.h>
#include <continua/linear_algebra/distributed_vector.h>
#include <continua/signal/expression.h>

#include <deal.II/base/point.h>

#include <array>
#include <functional>
#include <vector>

namespace Continua
{
/// A field of the state that can be compared with functions of place and time. Values: Cartesian
/// components of velocity [m/s] and displacement [m]; the pressure [Pa]; xx, yy, zz, xy and in
/// three dimensions xz, yz of the stress [Pa].
enum class ComparedField
{
  velocity,
  displacement,
  pressure,
  stress
};

/// What the values of a field are made of besides the pressure: of the stress the mixture of each
/// region, of the pressure nothing, else the field itself. `ghosted`: gives a copy with ghost
/// entries; `mixture`: the same of a region's. Collective.
std::vector<DistributedVector>
vectors_of(ComparedField field,
           const Problem &problem,
           const DistributedVector &velocity,
           const DistributedVector &displacement,
           const std::function<DistributedVector(const DistributedVector &)> &ghosted,
           const std::function<DistributedVector(unsigned int region)> &mixture);

/// |values - exact|^2 at a point and a time [s], over the components that `exact` has.
template <int dim>
double squared_difference(const std::array<double, 6> &values,
                          const std::vector<Expression> &exact,
                          const dealii::Point<dim> &point,
                          double time);
} // namespace Continua

#endif
