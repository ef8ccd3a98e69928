#ifndef continua_finite_element_loads_h
#define continua_finite_element_loads_h

#include <continua/continuum/problem.h>
#include <continua/finite_element/space.h>

#include <array>
#include <vector>

namespace Continua
{
/**
 * The loads on the velocity's test functions: prescribed tractions int v . t and the body force int
 * v . rho b. What is constant is assembled once; what is a function of time alone is one unit
 * vector times that function; only what depends on both time and place is integrated again at each
 * time.
 */
template <int dim>
class Loads
{
public:
  Loads(const Space<dim> &space, const Problem &problem);

  /// Assembles on the present mesh.
  void build();
  /// Adds the loads at this time to `residual` (hanging nodes condensed) [N].
  void add(double time, DistributedVector &residual) const;
  /// int v . n over the faces of a condition: the flow rate out of the body that each velocity
  /// stands for (hanging nodes condensed) [m^2].
  DistributedVector flow_of_velocities(unsigned int condition) const;
  /// Whether a load jumps between the two times [s].
  bool jumps(double begin, double end) const;
  /// The traction that is prescribed on a face at a point [Pa], of the parts that are natural;
  /// others are zero.
  static dealii::Tensor<1, dim> prescribed_traction(const BoundaryCondition &condition,
                                                    const dealii::Point<dim> &point,
                                                    const dealii::Tensor<1, dim> &normal,
                                                    double time);

private:
  /// One waveform with where it acts.
  struct Item
  {
    const Waveform *waveform;
    int condition;    ///< -1: body force
    bool normal_part; ///< of the condition; else its tangential part
    int component;    ///< Cartesian, or -1: along the normal
    double sign;
    bool times_density;                                ///< a body force given as an acceleration
    DistributedVector unit;                            ///< only of items that depend on time alone
    std::vector<std::array<double, 3>> watched_points; ///< where jumps() looks
  };
  const Space<dim> &space;
  const Problem &problem;
  std::vector<Item> items; ///< time-dependent ones
  DistributedVector constant;

  void watch_points(Item &item) const;
  /// Adds int v . direction w(point, time), with w = 1 if `waveform` is null.
  void assemble(const Item &item,
                const Waveform *waveform,
                double time,
                DistributedVector &target) const;
};
} // namespace Continua

#endif
