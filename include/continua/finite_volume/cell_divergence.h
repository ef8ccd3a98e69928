#ifndef continua_finite_volume_cell_divergence_h
#define continua_finite_volume_cell_divergence_h

#include <continua/finite_volume/gauss_gradient.h>

namespace Continua
{
/**
 * The divergence of a vector field in a cell by Gauss's theorem, integrated over the cell: sum over
 * its faces of area n . value (equation 3.8), with the areas of the body, so that in axisymmetry
 * the hoop term is in it. What flows out of one cell flows into the next.
 */
template <int dim>
class CellDivergence
{
public:
  CellDivergence(const CellMesh<dim> &mesh, const GaussGradient<dim> &gradient);

  /// The coefficient of a value is the vector that multiplies it [m^2].
  Stencil<dealii::Tensor<1, dim>> operator()(unsigned int cell) const;

private:
  const CellMesh<dim> &mesh;
  const GaussGradient<dim> &gradient;
};
} // namespace Continua

#endif
