#ifndef continua_mesh_vessel_branch_h
#define continua_mesh_vessel_branch_h

#include <continua/mesh/vessel_axis.h>
#include <continua/vessel/tube_law.h>

#include <memory>
#include <string>
#include <vector>

namespace Continua
{
/// A stretch of a vessel between two of its ends, or between an end and where it divides.
template <int dim>
struct VesselBranch
{
  /// An end of the branch at which the vessel ends.
  struct End
  {
    std::string fluid, wall; ///< the names of its boundaries; a rigid vessel has no `wall`
    double position;         ///< along the law [m]
  };
  std::string name;                            ///< empty where there is one only
  TubeLaw law;                                 ///< along the axis
  std::shared_ptr<const VesselAxis<dim>> axis; ///< null: the x axis
  std::vector<End> ends;
};
} // namespace Continua

#endif
