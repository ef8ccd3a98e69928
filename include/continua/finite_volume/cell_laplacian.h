#ifndef continua_finite_volume_cell_laplacian_h
#define continua_finite_volume_cell_laplacian_h

#include <continua/finite_volume/surface_normal_gradient.h>

namespace Continua
{
/**
 * div grad of a scalar in a cell, integrated over the cell: `compact` by the normal gradients on
 * the faces (equations 3.9 to 3.11), `wide` by the cells' gradients interpolated to the faces (3.12
 * and 3.13). They differ by what a checkerboard has: the wide one does not see it.
 */
template <int dim>
class CellLaplacian
{
public:
  CellLaplacian(const CellMesh<dim> &mesh,
                const GaussGradient<dim> &gradient,
                const SurfaceNormalGradient<dim> &normal_gradient);

  Stencil<double> compact(unsigned int cell) const; ///< [m]
  Stencil<double> wide(unsigned int cell) const;    ///< [m]

private:
  const CellMesh<dim> &mesh;
  const GaussGradient<dim> &gradient;
  const SurfaceNormalGradient<dim> &normal_gradient;
};
} // namespace Continua

#endif
