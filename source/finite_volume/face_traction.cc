#include <continua/finite_volume/face_traction.h>

namespace Continua
{
using namespace dealii;

template <int dim>
FaceTraction<dim>::FaceTraction(const CellWiseSpace<dim> &space,
                                const double stencil_ratio,
                                const double trace_ratio,
                                const bool replaced)
    : space(space), stencil_ratio(stencil_ratio), trace_ratio(trace_ratio), replaced(replaced)
{
}

template <int dim>
Stencil<Tensor<2, dim>> FaceTraction<dim>::operator()(const unsigned int face,
                                                      const unsigned int side) const
{
  return traction(face, side, stencil_ratio);
}

template <int dim>
Stencil<Tensor<2, dim>> FaceTraction<dim>::wide(const unsigned int face,
                                                const unsigned int side) const
{
  return traction(face, side, 0.);
}

template <int dim>
Stencil<Tensor<2, dim>> FaceTraction<dim>::traction(const unsigned int face,
                                                    const unsigned int side,
                                                    const double ratio) const
{
  const VolumeFace<dim> &surface = space.mesh.faces()[face];
  const Tensor<1, dim> normal = surface.outward(side);
  const Tensor<2, dim> identity = unit_symmetric_tensor<dim>();
  Stencil<Tensor<2, dim>> result;
  const auto gradient = space.velocity_face_gradient(face, side, replaced);
  for (const auto &[value, g] : gradient)
    // n.grad w, n.(grad w)^T and r n tr(grad w).
    result.add(value, (1. - ratio) * (g * normal) * identity + outer_product(g, normal) +
                          trace_ratio * outer_product(normal, g));
  // A face whose gradient is replaced has its own normal gradient in it already.
  if (ratio != 0.)
    for (const auto &[value, coefficient] : space.velocity_normal_gradient(face, side))
      result.add(value, ratio * coefficient * identity);
  Tensor<1, dim> radial;
  radial[1] = 1.;
  for (const auto &[value, factor] : space.face_hoop(face, side))
    result.add(value, trace_ratio * factor * outer_product(normal, radial));
  return result;
}

template <int dim>
Stencil<Tensor<1, dim>> FaceTraction<dim>::hoop(const unsigned int cell) const
{
  Stencil<Tensor<1, dim>> result;
  if (!space.is_axisymmetric())
    return result;
  for (const auto &[value, g] : space.velocity_gradient(cell))
    result.add(value, trace_ratio * g);
  Tensor<1, dim> radial;
  radial[1] = 1.;
  for (const auto &[value, factor] : space.cell_hoop(cell))
    result.add(value, (2. + trace_ratio) * factor * radial);
  return result;
}

template class FaceTraction<2>;
template class FaceTraction<3>;
} // namespace Continua
