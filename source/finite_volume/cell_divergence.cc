#include <continua/finite_volume/cell_divergence.h>

namespace Continua
{
template <int dim>
CellDivergence<dim>::CellDivergence(const CellMesh<dim> &mesh, const GaussGradient<dim> &gradient)
    : mesh(mesh), gradient(gradient)
{
}

template <int dim>
Stencil<dealii::Tensor<1, dim>> CellDivergence<dim>::operator()(const unsigned int cell) const
{
  Stencil<dealii::Tensor<1, dim>> divergence;
  for (const unsigned int f : mesh.cells()[cell].faces)
  {
    const VolumeFace<dim> &face = mesh.faces()[f];
    const unsigned int side = mesh.side(f, cell);
    const dealii::Tensor<1, dim> area = face.area * face.outward(side);
    divergence.add(area, gradient.face_value(f, side));
  }
  return divergence;
}

template class CellDivergence<2>;
template class CellDivergence<3>;
} // namespace Continua
