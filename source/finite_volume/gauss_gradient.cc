#include <continua/finite_volume/gauss_gradient.h>
#include <continua/mesh/ghost_exchange.h>

#include <algorithm>

namespace Continua
{
template <int dim>
GaussGradient<dim>::GaussGradient(const CellWiseMesh<dim> &mesh, const ValueSpace<dim> &space)
    : mesh(mesh), space(space)
{
}

template <int dim>
void GaussGradient<dim>::build()
{
  const unsigned int n_owned = mesh.n_owned_cells();
  first.assign(mesh.cells().size(), {});
  for (unsigned int c = 0; c < n_owned; ++c)
  {
    const auto &faces = mesh.cells()[c].faces;
    if (std::any_of(faces.begin(), faces.end(),
                    [&](const unsigned int f) { return offset(f).norm_square() > 0.; }))
      first[c] = least_squares(c);
  }
  exchange(first);

  of_cell.assign(mesh.cells().size(), {});
  for (unsigned int c = 0; c < n_owned; ++c)
    for (const unsigned int f : mesh.cells()[c].faces)
    {
      const unsigned int side = mesh.side(f, c);
      const VolumeFace<dim> &face = mesh.faces()[f];
      const dealii::Tensor<1, dim> factor =
          face.shape(side).plane_area / mesh.cells()[c].plane_volume * face.outward(side);
      of_cell[c].add(factor, face_value(f, side));
    }
  exchange(of_cell);
}

template <int dim>
dealii::Tensor<1, dim> GaussGradient<dim>::offset(const unsigned int face) const
{
  const VolumeFace<dim> &on = mesh.faces()[face];
  if (on.has_value())
    return {};
  const dealii::Tensor<1, dim> offset =
      on.centre - mesh.cells()[on.owner].centre - (1. - on.owner_weight) * on.distance;
  return offset.norm() > 1e-10 * on.distance.norm() ? offset : dealii::Tensor<1, dim>();
}

template <int dim>
Stencil<dealii::Tensor<1, dim>> GaussGradient<dim>::least_squares(const unsigned int cell) const
{
  // Weighted with the inverse square of the distance, which makes it independent of how thin a cell
  // is.
  dealii::Tensor<2, dim> matrix;
  for (const unsigned int f : mesh.cells()[cell].faces)
  {
    const dealii::Tensor<1, dim> distance = mesh.distance(f, mesh.side(f, cell));
    matrix += dealii::outer_product(distance, distance) / distance.norm_square();
  }
  const dealii::Tensor<2, dim> inverse = dealii::invert(matrix);
  Stencil<dealii::Tensor<1, dim>> gradient;
  for (const unsigned int f : mesh.cells()[cell].faces)
  {
    const unsigned int side = mesh.side(f, cell);
    const dealii::Tensor<1, dim> distance = mesh.distance(f, side);
    const dealii::Tensor<1, dim> coefficient = inverse * distance / distance.norm_square();
    gradient.add(space.beyond(f, side), coefficient);
    gradient.add(space.of_cell(cell), -1. * coefficient);
  }
  return gradient;
}

template <int dim>
Stencil<dealii::Tensor<1, dim>> GaussGradient<dim>::between(const unsigned int face,
                                                            const Gradients &gradients) const
{
  const VolumeFace<dim> &on = mesh.faces()[face];
  Stencil<dealii::Tensor<1, dim>> gradient;
  gradient.add(on.owner_weight, gradients[on.owner]);
  gradient.add(1. - on.owner_weight, gradients[on.neighbour]);
  return gradient;
}

template <int dim>
void GaussGradient<dim>::exchange(Gradients &gradients) const
{
  // An entry's number, then its vector.
  exchange_with_ghosts<dim>(
      mesh.triangulation,
      [&](const auto &cell)
      {
        std::vector<double> numbers;
        for (const auto &entry : gradients[mesh.cell_number(cell)])
        {
          numbers.push_back(entry.first);
          for (unsigned int c = 0; c < dim; ++c)
            numbers.push_back(entry.second[c]);
        }
        return numbers;
      },
      [&](const auto &cell, const std::vector<double> &numbers)
      {
        for (std::size_t i = 0; i < numbers.size(); i += 1 + dim)
        {
          dealii::Tensor<1, dim> vector;
          for (unsigned int c = 0; c < dim; ++c)
            vector[c] = numbers[i + 1 + c];
          gradients[mesh.cell_number(cell)].add(static_cast<unsigned int>(numbers[i]), vector);
        }
      });
}

template <int dim>
Stencil<dealii::Tensor<1, dim>> GaussGradient<dim>::on_face(const unsigned int face,
                                                            const unsigned int side) const
{
  const VolumeFace<dim> &on = mesh.faces()[face];
  return on.has_value() ? of_cell[on.cell(side)] : between(face, of_cell);
}

template <int dim>
Stencil<double> GaussGradient<dim>::face_value(const unsigned int face,
                                               const unsigned int side) const
{
  Stencil<double> value = FaceInterpolation<dim>(mesh, space)(face, side);
  const dealii::Tensor<1, dim> offset = this->offset(face);
  if (offset.norm_square() > 0.)
    value.add(offset, between(face, first));
  return value;
}

template class GaussGradient<2>;
template class GaussGradient<3>;
} // namespace Continua
