#ifndef continua_mesh_tube_manifold_h
#define continua_mesh_tube_manifold_h

#include <continua/vessel/centreline.h>
#include <continua/vessel/tube_law.h>

#include <deal.II/grid/manifold.h>

#include <memory>

namespace Continua
{
/**
 * The shape of a tube between the vertices of its mesh: new points of refined and of curved cells
 * lie where they would in a tube of inner radius one and outer radius two, of which the tube is the
 * image by its law. So its surfaces and the interfaces of its layers are round and follow D(z) and
 * h(z), and sections stay plane.
 *
 * In two dimensions, x the axis and y the radius, the chart is (x, s) with s the radius over the
 * inner one in the fluid and one plus the depth over the wall's thickness in the wall. In three
 * dimensions, x the axis, it is, in the `core` of the cross-section, (x, y, z) with y and z over
 * the inner radius, and in its `rings` (x, rho, u) of TubeCrossSection. The two agree on the
 * surface between core and rings.
 *
 * A tube in three dimensions may have a centreline, on which its axis comes to lie: x is the
 * position along it, y the distance along the frame's normal, z that along its binormal.
 */
template <int dim>
class TubeManifold : public dealii::ChartManifold<dim, dim, dim>
{
public:
  enum class Part
  {
    core,
    rings
  };

  /// `centreline`: as long as the tube; null, the x axis.
  TubeManifold(const TubeLaw &law,
               Part part,
               const std::shared_ptr<const Centreline> &centreline = nullptr);

  std::unique_ptr<dealii::Manifold<dim>> clone() const override;
  dealii::Point<dim> pull_back(const dealii::Point<dim> &place) const override;
  dealii::Point<dim> push_forward(const dealii::Point<dim> &chart_point) const override;

  /// The radius [m] where the scaled radius is s, at x [m] along the axis.
  static double radius(const TubeLaw &law, double x, double s);

private:
  const TubeLaw law;
  const Part part;
  const std::shared_ptr<const Centreline> centreline;
};
} // namespace Continua

#endif
