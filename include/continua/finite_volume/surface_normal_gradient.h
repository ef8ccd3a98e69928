#ifndef continua_finite_volume_surface_normal_gradient_h
#define continua_finite_volume_surface_normal_gradient_h

#include <continua/finite_volume/gauss_gradient.h>

namespace Continua
{
/**
 * n . gradient on a face, outward from the cell on one side: (value_N - value_P)/(d . n) on the
 * compact stencil (equation 3.7, the over-relaxed form of it), plus (n - d/(d . n)) . gradient,
 * interpolated, where the line of centres d is not along the normal. On a face with its own value
 * that value stands for value_N and d leads to the face's centre.
 */
template <int dim>
class SurfaceNormalGradient
{
public:
  SurfaceNormalGradient(const CellWiseMesh<dim> &mesh,
                        const ValueSpace<dim> &space,
                        const GaussGradient<dim> &gradient);

  /// [1/m]
  Stencil<double> operator()(unsigned int face, unsigned int side = 0) const;
  /// Its part on the compact stencil alone: all of it on orthogonal meshes.
  Stencil<double> compact(unsigned int face, unsigned int side = 0) const;

private:
  const CellWiseMesh<dim> &mesh;
  const ValueSpace<dim> &space;
  const GaussGradient<dim> &gradient;
};
} // namespace Continua

#endif
