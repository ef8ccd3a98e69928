#ifndef continua_finite_element_terms_flow_face_point_h
#define continua_finite_element_terms_flow_face_point_h

#include <continua/finite_element/terms/point_change.h>

#include <deal.II/base/tensor.h>

#include <algorithm>

namespace Continua
{
/// The state of a liquid at a point of a face, at the present place.
template <int dim>
struct FlowFacePoint
{
  double weight = 0.;              ///< da of the point [m^2]
  dealii::Tensor<1, dim> normal;   ///< n, out of the body
  dealii::Tensor<1, dim> traction; ///< that is given, or of a cavity [Pa]
  dealii::Tensor<1, dim> velocity; ///< U [m/s]
  double through = 0.;             ///< (U - W) . n, W of the mesh [m/s]
  // Where what is given is the total pressure of liquid that flows in, else 0.
  double density = 0.;         ///< rho(p) [kg/m^3]
  double compressibility = 0.; ///< c(p) [1/Pa]

  /// min((U - W) . n, 0) [m/s].
  double inflow() const { return std::min(through, 0.); }
};

/// A change of the unknowns of a liquid there, with what follows from it. The mesh is held.
template <int dim>
struct FlowFaceChange
{
  dealii::Tensor<1, dim> velocity;
  double inflow = 0., density = 0.;

  FlowFaceChange(const FlowFacePoint<dim> &point, const PointChange<dim> &change)
      : velocity(change.velocity),
        inflow(point.through < 0. ? change.velocity * point.normal : 0.),
        density(point.density * point.compressibility * change.pressure)
  {
  }
};
} // namespace Continua

#endif
