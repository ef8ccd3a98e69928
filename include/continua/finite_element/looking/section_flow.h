#ifndef continua_finite_element_looking_section_flow_h
#define continua_finite_element_looking_section_flow_h

#include <continua/finite_element/space/space.h>
#include <continua/mesh/vessel_axis.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <memory>
#include <set>
#include <vector>

namespace Continua
{
/**
 * The flow rate through a plane section of a liquid, as the discrete equation of mass balance has
 * it: with a pressure test function q that is 1 upstream of the section and 0 downstream,
 *
 *     Q = -integral of v . grad q,
 *
 * so that Q is to round-off what enters at the boundaries upstream less what the liquid there
 * stores by its walls' motion and by its compression. The integral of the velocity over the plane
 * itself is no such number: Taylor-Hood elements conserve mass in this weak sense only.
 *
 * q falls over a few cells about the section. It is a sum of up to four ramps, each as wide as the
 * longest cell there, nodal interpolants in the pressure space, with factors that make the mean
 * over the section's surroundings exact for flow rates that are cubic polynomials of the distance
 * (of a lower degree where the liquid is only a few cells long). Near an end of the liquid the
 * ramps lie on one side. Along a vessel with an axis of its own the distance is that along the
 * axis, and its other parts and branches do not count. On a mesh that moves q moves with it: Q
 * is what flows through the plane in which the section is at that moment.
 */
template <int dim>
class SectionFlow
{
public:
  /// Of the regions (material ids; empty: all) through the plane; the flow along `normal`, of any
  /// length, counts as positive. `axis`: of the vessel, or null. For the present mesh.
  SectionFlow(const Space<dim> &space,
              const std::set<unsigned int> &regions,
              const dealii::Point<dim> &point,
              const dealii::Tensor<1, dim> &normal,
              const std::shared_ptr<const VesselAxis<dim>> &axis = nullptr);

  /// Adds to `weights` what an entry of the velocity contributes [m^2, in the plane m]; of a mesh
  /// that moves with q at this displacement (with ghosts). False, on all ranks, if the plane misses
  /// the regions. Collective.
  bool add_weights(DistributedVector &weights,
                   const DistributedVector *mesh_displacement = nullptr);

private:
  const Space<dim> &space;
  const std::set<unsigned int> regions;
  const dealii::Point<dim> point;
  const dealii::Tensor<1, dim> normal;
  const std::shared_ptr<const VesselAxis<dim>> axis;
  double position = 0.; ///< of the section along the axis [m]
  /// The distances of a cell's vertices from the section, the least and the largest, by
  /// active_cell_index() [m]; not numbers if the cell belongs to another branch, as a whole or in
  /// part, to another rank, or to a region that does not count.
  std::vector<std::array<double, 2>> ranges;

  /// q on the mesh, with ghosts; made once.
  DistributedVector function;

  /// From the section along the axis, or along the normal [m]; not a number in another branch.
  double distance(const dealii::Point<dim> &place) const;
  /// Of length one, that in which the distance grows.
  dealii::Tensor<1, dim> direction(const dealii::Point<dim> &place) const;
  /// The places of the ramps along the normal.
  struct Ramps
  {
    double width = 0.;           ///< [m]
    std::vector<double> centres; ///< [m]
    double begin() const { return centres.front() - 0.5 * width; }
    double end() const { return centres.back() + 0.5 * width; }
    /// 1 before the ramp, 0 behind it.
    double value(unsigned int ramp, double distance) const;
  };
  void find_ranges();
  /// Whether a cell of this range may reach into the ramps: curved cells and hanging nodes reach a
  /// little farther than their vertices. False in another branch.
  static bool is_near(const Ramps &ramps, const std::array<double, 2> &range);
  bool counts(const typename dealii::Triangulation<dim>::cell_iterator &cell) const;
  /// No ramps if the plane misses the regions.
  Ramps ramps() const;
  /// Makes q.
  void set_function(const Ramps &ramps);
  /// The factors of the ramps, whose nodal values are given.
  std::vector<double> factors(const Ramps &ramps,
                              const std::vector<DistributedVector> &nodal_values) const;
  /// Calls `add`(cell of the velocity, its values, gradients of the function of the nodal values)
  /// for every cell of this rank that the ramps touch; `with_gradients`: of the velocity, too.
  template <typename Add>
  void for_cells(const Ramps &ramps,
                 const std::vector<DistributedVector> &nodal_values,
                 bool with_gradients,
                 const Add &add) const;
};
} // namespace Continua

#endif
