#include <continua/finite_volume/cell_laplacian.h>

namespace Continua
{
template <int dim>
CellLaplacian<dim>::CellLaplacian(const CellMesh<dim> &mesh,
                                  const GaussGradient<dim> &gradient,
                                  const SurfaceNormalGradient<dim> &normal_gradient)
    : mesh(mesh), gradient(gradient), normal_gradient(normal_gradient)
{
}

template <int dim>
Stencil<double> CellLaplacian<dim>::compact(const unsigned int cell) const
{
  Stencil<double> laplacian;
  for (const unsigned int f : mesh.cells()[cell].faces)
    laplacian.add(mesh.faces()[f].area, normal_gradient(f, mesh.side(f, cell)));
  return laplacian;
}

template <int dim>
Stencil<double> CellLaplacian<dim>::wide(const unsigned int cell) const
{
  Stencil<double> laplacian;
  for (const unsigned int f : mesh.cells()[cell].faces)
  {
    const VolumeFace<dim> &face = mesh.faces()[f];
    const unsigned int side = mesh.side(f, cell);
    const dealii::Tensor<1, dim> area = face.area * face.outward(side);
    laplacian.add(area, gradient.on_face(f, side));
  }
  return laplacian;
}

template class CellLaplacian<2>;
template class CellLaplacian<3>;
} // namespace Continua
