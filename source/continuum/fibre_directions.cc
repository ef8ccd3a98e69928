#include <continua/continuum/fibre_directions.h>

#include <cmath>

namespace Continua
{
using namespace dealii;

template <int dim>
std::vector<Tensor<1, 3>>
fibres_at(const Material &material, const Model model, const Point<dim> &place)
{
  if (material.strain_law == nullptr || !material.strain_law_parameters.has_fibres())
    return {};
  Tensor<1, 3> axis, circumference;
  // What turns into the circumference: the two coordinates across the axis.
  const auto set_around = [&](const unsigned int first, const unsigned int second)
  {
    const double distance = std::hypot(place[first], place[second]);
    circumference[first] = distance > 0. ? -place[second] / distance : 0.;
    circumference[second] = distance > 0. ? place[first] / distance : 1.;
  };
  if (model == Model::axisymmetric)
  {
    axis[0] = 1.;
    circumference[2] = 1.;
  }
  else if constexpr (dim == 3)
  {
    axis[0] = 1.;
    set_around(1, 2);
  }
  else
  {
    axis[2] = 1.;
    set_around(0, 1);
  }
  return material.strain_law_parameters.fibres(axis, circumference);
}

template std::vector<Tensor<1, 3>> fibres_at(const Material &, Model, const Point<2> &);
template std::vector<Tensor<1, 3>> fibres_at(const Material &, Model, const Point<3> &);
} // namespace Continua
