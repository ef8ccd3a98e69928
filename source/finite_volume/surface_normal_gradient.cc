#include <continua/finite_volume/surface_normal_gradient.h>

namespace Continua
{
template <int dim>
SurfaceNormalGradient<dim>::SurfaceNormalGradient(const CellMesh<dim> &mesh,
                                                  const ValueSpace<dim> &space,
                                                  const GaussGradient<dim> &gradient)
    : mesh(mesh), space(space), gradient(gradient)
{
}

template <int dim>
Stencil<double> SurfaceNormalGradient<dim>::operator()(const unsigned int face,
                                                       const unsigned int side) const
{
  const VolumeFace<dim> &on = mesh.faces()[face];
  const dealii::Tensor<1, dim> normal = on.outward(side);
  const dealii::Tensor<1, dim> distance = on.has_value()
                                              ? on.centre - mesh.cells()[on.cell(side)].centre
                                              : (side == 0 ? on.distance : -1. * on.distance);
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
  const unsigned int cell = on.cell(side);
  const bool own = on.has_value();
  const double along =
      own ? (on.centre - mesh.cells()[cell].centre) * on.outward(side) : on.distance * on.normal;
  Stencil<double> result(own ? space.of_face(face, side) : space.of_cell(on.cell(1 - side)),
                         1. / along);
  result.add(space.of_cell(cell), -1. / along);
  return result;
}

template class SurfaceNormalGradient<2>;
template class SurfaceNormalGradient<3>;
} // namespace Continua
