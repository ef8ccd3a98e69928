#ifndef continua_finite_volume_cell_loads_h
#define continua_finite_volume_cell_loads_h

#include <continua/continuum/problem.h>
#include <continua/finite_volume/face_conditions.h>
#include <continua/linear_algebra/distributed_vector.h>

#include <array>
#include <vector>

namespace Continua
{
/**
 * The loads in the momentum equations: body forces on cells, tractions on faces, at the cells' and
 * faces' centres. What is constant is integrated once; what is a function of time alone is one unit
 * vector times that function.
 */
template <int dim>
class CellLoads
{
public:
  CellLoads(const CellSpace<dim> &space,
            const Problem &problem,
            const FaceConditions<dim> &face_conditions);

  /// Integrates on the present mesh.
  void build();
  /// Adds the loads at this time [N].
  void add(double time, DistributedVector &momentum) const;
  /// Whether a load jumps between the two times [s].
  bool jumps(double begin, double end) const;

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

  const CellSpace<dim> &space;
  const Problem &problem;
  const FaceConditions<dim> &face_conditions;
  std::vector<Item> items; ///< time-dependent ones
  DistributedVector constant;

  /// Adds direction w(point, time), with w = 1 if `waveform` is null.
  void integrate(const Item &item,
                 const Waveform *waveform,
                 double time,
                 DistributedVector &target) const;
  void watch_points(Item &item) const;
};
} // namespace Continua

#endif
