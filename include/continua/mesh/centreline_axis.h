#ifndef continua_mesh_centreline_axis_h
#define continua_mesh_centreline_axis_h

#include <continua/mesh/vessel_axis.h>
#include <continua/vessel/centreline.h>

#include <memory>

namespace Continua
{
/// The axis of a vessel that has one centreline from end to end and no branch.
class CentrelineAxis : public VesselAxis<3>
{
public:
  explicit CentrelineAxis(const std::shared_ptr<const Centreline> &centreline);
  std::array<double, 2> range() const override;
  dealii::Point<3> point(double position) const override;
  dealii::Tensor<1, 3> tangent(double position) const override;
  double position(const dealii::Point<3> &point) const override;

private:
  const std::shared_ptr<const Centreline> centreline;
};
} // namespace Continua

#endif
