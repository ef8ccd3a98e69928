#ifndef continua_mesh_branch_axis_h
#define continua_mesh_branch_axis_h

#include <continua/mesh/vessel_axis.h>

namespace Continua
{
/// The straight axis of a branch of a vessel that divides, of which the part where the branch is a
/// round tube counts.
class BranchAxis : public VesselAxis<3>
{
public:
  /// Positions count from `begin`; the branch is a tube of that outer radius within `tube`; all in
  /// m.
  BranchAxis(const dealii::Point<3> &begin,
             const dealii::Point<3> &end,
             const std::array<double, 2> &tube,
             double outer_radius);
  std::array<double, 2> range() const override { return tube; }
  dealii::Point<3> point(double position) const override;
  dealii::Tensor<1, 3> tangent(double /* position */) const override { return direction; }
  double position(const dealii::Point<3> &point) const override;

private:
  const dealii::Point<3> begin;
  const dealii::Tensor<1, 3> direction;
  const std::array<double, 2> tube;
  const double outer_radius;
};
} // namespace Continua

#endif
