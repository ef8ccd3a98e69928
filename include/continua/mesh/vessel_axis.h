#ifndef continua_mesh_vessel_axis_h
#define continua_mesh_vessel_axis_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>

namespace Continua
{
/**
 * The axis of a vessel, or of a branch of one, along which stations stand. A place on it is told by
 * its position [m].
 */
template <int dim>
class VesselAxis
{
public:
  virtual ~VesselAxis() = default;
  /// Between which positions stations may stand [m].
  virtual std::array<double, 2> range() const = 0;
  virtual dealii::Point<dim> point(double position) const = 0;       ///< [m]
  virtual dealii::Tensor<1, dim> tangent(double position) const = 0; ///< of length one
  /// At which position a point of the vessel lies [m]: in the plane across the axis there. Not a
  /// number if the point belongs to another branch.
  virtual double position(const dealii::Point<dim> &point) const = 0;
};
} // namespace Continua

#endif
