#include <continua/finite_volume/gauss_gradient.h>

#include <deal.II/grid/grid_tools.h>

#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

namespace Continua
{
template <int dim>
GaussGradient<dim>::GaussGradient(const CellMesh<dim> &mesh, const ValueSpace<dim> &space)
    : mesh(mesh), space(space)
{
}

template <int dim>
void GaussGradient<dim>::build()
{
  using Gradient = dealii::Tensor<1, dim>;
  of_cell.assign(mesh.cells().size(), Stencil<Gradient>());
  for (unsigned int c = 0; c < mesh.n_owned_cells(); ++c)
    for (const unsigned int f : mesh.cells()[c].faces)
    {
      const unsigned int side = mesh.side(f, c);
      const VolumeFace<dim> &face = mesh.faces()[f];
      const Gradient factor = face.plane_area / mesh.cells()[c].plane_volume * face.outward(side);
      of_cell[c].add(factor, face_value(f, side));
    }

  using Entries = std::vector<std::pair<unsigned int, Gradient>>;
  dealii::GridTools::exchange_cell_data_to_ghosts<Entries, dealii::DoFHandler<dim>>(
      mesh.cell_dofs,
      [&](const auto &cell)
      {
        const auto &stencil = of_cell[mesh.cell_number(cell)];
        return Entries(stencil.begin(), stencil.end());
      },
      [&](const auto &cell, const Entries &entries)
      {
        for (const auto &entry : entries)
          of_cell[mesh.cell_number(cell)].add(entry.first, entry.second);
      });
}

template <int dim>
Stencil<dealii::Tensor<1, dim>> GaussGradient<dim>::on_face(const unsigned int face,
                                                            const unsigned int side) const
{
  const VolumeFace<dim> &on = mesh.faces()[face];
  if (on.has_value())
    return of_cell[on.cell(side)];
  Stencil<dealii::Tensor<1, dim>> gradient;
  gradient.add(on.owner_weight, of_cell[on.owner]);
  gradient.add(1. - on.owner_weight, of_cell[on.neighbour]);
  return gradient;
}

template <int dim>
Stencil<double> GaussGradient<dim>::face_value(const unsigned int face,
                                               const unsigned int side) const
{
  return FaceInterpolation<dim>(mesh, space)(face, side);
}

template class GaussGradient<2>;
template class GaussGradient<3>;
} // namespace Continua
