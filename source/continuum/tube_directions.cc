#include <continua/continuum/tube_directions.h>

#include <cmath>

namespace Continua
{
using namespace dealii;

template <int dim>
TubeDirections tube_directions_at(const Model model, const Point<dim> &place)
{
  TubeDirections directions;
  // What turns into the circumference: the two coordinates across the axis.
  const auto set_around = [&](const unsigned int first, const unsigned int second)
  {
    const double distance = std::hypot(place[first], place[second]);
    directions.circumference[first] = distance > 0. ? -place[second] / distance : 0.;
    directions.circumference[second] = distance > 0. ? place[first] / distance : 1.;
  };
  if (model == Model::axisymmetric)
  {
    directions.axis[0] = 1.;
    directions.circumference[2] = 1.;
  }
  else if constexpr (dim == 3)
  {
    directions.axis[0] = 1.;
    set_around(1, 2);
  }
  else
  {
    directions.axis[2] = 1.;
    set_around(0, 1);
  }
  return directions;
}

template TubeDirections tube_directions_at(Model, const Point<2> &);
template TubeDirections tube_directions_at(Model, const Point<3> &);
} // namespace Continua
