#ifndef continua_continuum_tube_directions_h
#define continua_continuum_tube_directions_h

#include <continua/materials/model.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

namespace Continua
{
/// The unit directions of a tube at a place of the mesh. The axis is the x axis, in plane strain
/// the line through the origin across the plane. On the axis itself, where no circumference exists,
/// any one is taken.
struct TubeDirections
{
  dealii::Tensor<1, 3> axis, circumference;
};

template <int dim>
TubeDirections tube_directions_at(Model model, const dealii::Point<dim> &place);
} // namespace Continua

#endif
