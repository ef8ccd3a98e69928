#ifndef continua_continuum_load_list_h
#define continua_continuum_load_list_h

#include <continua/continuum/problem.h>
#include <continua/linear_algebra/distributed_vector.h>

#include <array>
#include <vector>

namespace Continua
{
/**
 * The loads of a problem on a discretisation: tractions on boundaries and body forces. What is
 * constant is integrated once; what is a function of time alone is one unit vector times that
 * function; only what depends on both time and place is integrated again at each time. A
 * discretisation may leave out loads that are terms of its equations; jumps() knows these, too.
 */
class LoadList
{
public:
  /// `problem` must outlive it.
  explicit LoadList(const Problem &problem) : problem(problem) {}
  virtual ~LoadList() = default;

  /// Integrates on the present mesh.
  void build();
  /// Adds the loads at this time to `forces` [N].
  void add(double time, DistributedVector &forces) const;
  /// Adds the loads of one condition at this time, of -1 the body force [N].
  void add_of(int condition, double time, DistributedVector &forces) const;
  /// Whether a load jumps between the two times [s]. Collective.
  bool jumps(double begin, double end) const;

protected:
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
  const Problem &problem;

  /// The outward normal of a condition's faces, as an item of unit size.
  static Item along_normal(unsigned int condition);
  /// Zeros on the present mesh.
  virtual DistributedVector zero_forces() const = 0;
  /// Adds the forces of the item's direction times w(point, time), with w = 1 if `waveform` is
  /// null.
  virtual void integrate(const Item &item,
                         const Waveform *waveform,
                         double time,
                         DistributedVector &forces) const = 0;
  /// Points where it acts: one in each of this rank's cells, or faces.
  virtual std::vector<std::array<double, 3>> places(const Item &item) const = 0;

private:
  std::vector<Item> items; ///< time-dependent ones
  DistributedVector constant;

  std::vector<Item> all_items() const;
  void watch_points(Item &item) const;
};
} // namespace Continua

#endif
