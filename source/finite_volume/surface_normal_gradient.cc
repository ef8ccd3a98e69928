#include <continua/finite_volume/surface_normal_gradient.h>

namespace Continua
{
template <int dim>
SurfaceNormalGradient<dim>::SurfaceNormalGradient(const CellWiseMesh<dim> &mesh,
                                                  const ValueSpace<dim> &space,
                                                  const GaussGradient<dim> &gradient)
    : mesh(mesh), space(space), gradient(gradient)
{
}

template <int dim>
Stencil<double> SurfaceNormalGradient<dim>::operator()(const unsigned int face,
                                                       const unsigned int side) const
{
  const dealii::Tensor<1, dim> normal = mesh.faces()[face].outward(side);
  const dealii::Tensor<1, dim> distance = mesh.distance(face, side);
  Stencil<double> result = compact(face, side);
  // Where the line is along the normal but for round-off nothing is added to the stencil.
  const dealii::Tensor<1, dim> rest = normal - distance / (distance * normal);
  if (rest.norm() > 1e-10)
    result.add(rest, gradient.on_face(face, side));
  return result;
}

template <int dim>
Stencil<double> SurfaceNormalGradient<dim>::compact(const unsigned int face,
                                                    const unsigned int side) const
{
  const VolumeFace<dim> &on = mesh.faces()[face];
  const double coefficient = 1. / (mesh.distance(face, side) * on.outward(side));
  Stencil<double> result(space.beyond(face, side), coefficient);
  result.add(space.of_cell(on.cell(side)), -coefficient);
  return result;
}

template class SurfaceNormalGradient<2>;
template class SurfaceNormalGradient<3>;
} // namespace Continua
