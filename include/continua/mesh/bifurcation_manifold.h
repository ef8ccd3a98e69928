#ifndef continua_mesh_bifurcation_manifold_h
#define continua_mesh_bifurcation_manifold_h

#include <continua/mesh/bifurcation_shape.h>

#include <deal.II/grid/manifold.h>

#include <memory>

namespace Continua
{
/**
 * One tube of a BifurcationShape between the vertices of its mesh: new points of refined and of
 * curved cells lie where the shape has them. The chart is, in the `core` of the cross-section, the
 * place (a, y, z) of the shape, and in its `rings` (a, rho, u) of TubeCrossSection. The two agree
 * on the surface between core and rings, and those of two tubes on the half-surface between them.
 */
class BifurcationManifold : public dealii::ChartManifold<3, 3, 3>
{
public:
  enum class Part
  {
    core,
    rings
  };

  BifurcationManifold(const std::shared_ptr<const BifurcationShape> &shape,
                      unsigned int tube,
                      Part part);

  std::unique_ptr<dealii::Manifold<3>> clone() const override;
  dealii::Point<3> pull_back(const dealii::Point<3> &point) const override;
  dealii::Point<3> push_forward(const dealii::Point<3> &chart_point) const override;

private:
  const std::shared_ptr<const BifurcationShape> shape;
  const unsigned int tube;
  const Part part;
};
} // namespace Continua

#endif
