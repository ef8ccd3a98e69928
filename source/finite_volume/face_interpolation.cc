#include <continua/finite_volume/face_interpolation.h>

namespace Continua
{
template <int dim>
FaceInterpolation<dim>::FaceInterpolation(const CellWiseMesh<dim> &mesh,
                                          const ValueSpace<dim> &space,
                                          const double blending)
    : mesh(mesh), space(space), blending(blending)
{
  Assert(blending >= 0. && blending <= 1., dealii::ExcMessage("gamma is between 0 and 1."));
}

template <int dim>
Stencil<double> FaceInterpolation<dim>::operator()(const unsigned int face,
                                                   const unsigned int side,
                                                   const double flux) const
{
  const VolumeFace<dim> &on = mesh.faces()[face];
  if (on.has_value())
    return {space.of_face(face, side), 1.};
  Stencil<double> value;
  if (blending > 0.)
  {
    value.add(space.of_cell(on.owner), blending * on.owner_weight);
    value.add(space.of_cell(on.neighbour), blending * (1. - on.owner_weight));
  }
  if (blending < 1.)
    value.add(space.of_cell(flux >= 0. ? on.owner : on.neighbour), 1. - blending);
  return value;
}

template class FaceInterpolation<2>;
template class FaceInterpolation<3>;
} // namespace Continua
