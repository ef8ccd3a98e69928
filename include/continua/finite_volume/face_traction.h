#ifndef continua_finite_volume_face_traction_h
#define continua_finite_volume_face_traction_h

#include <continua/finite_volume/cell_wise_space.h>

namespace Continua
{
/**
 * The traction on a face, per area and unit modulus, that the field w causes [Pa for w in Pa m]:
 *
 *   t = kappa (n.grad w)_compact + n.(grad w)^T + r n tr(grad w) - (kappa - 1) n.grad w,
 *
 * (equations 3.36 to 3.41), with kappa = c/mu the stencil coefficient and the gradients of the
 * last three interpolated to the face. r is lambda/mu, or -2/3 where the pressure is apart; the
 * trace has the hoop term in axisymmetry. In the limit of fine meshes kappa has no part in it. On a
 * face with its own value both gradients are those of the cell on the side.
 */
template <int dim>
class FaceTraction
{
public:
  /// `replaced`: whether the cell's gradient on a face with its own value gets that face's normal
  /// gradient for its normal part; kappa then has no part in those faces at all.
  FaceTraction(const CellWiseSpace<dim> &space,
               double stencil_ratio,
               double trace_ratio,
               bool replaced);

  /// t_a = sum over values of T[a][b] w_b, on the outward side of the cell on `side` [1/m].
  Stencil<dealii::Tensor<2, dim>> operator()(unsigned int face, unsigned int side) const;
  /// The same on the wide stencil throughout (kappa = 0).
  Stencil<dealii::Tensor<2, dim>> wide(unsigned int face, unsigned int side) const;
  /// Stress round the axis in a cell, 2 w_r/r + r tr(grad w), as vectors that multiply w; empty if
  /// not axisymmetric.
  Stencil<dealii::Tensor<1, dim>> hoop(unsigned int cell) const;

private:
  const CellWiseSpace<dim> &space;
  double stencil_ratio, trace_ratio;
  bool replaced;

  Stencil<dealii::Tensor<2, dim>>
  traction(unsigned int face, unsigned int side, double ratio) const;
};
} // namespace Continua

#endif
