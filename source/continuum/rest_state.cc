#include <continua/continuum/rest_state.h>

#include <continua/continuum/tube_directions.h>

namespace Continua
{
using namespace dealii;

template <int dim>
RestState rest_state_at(const Material &material,
                        const Model model,
                        const Point<dim> &place,
                        const double share)
{
  const TubeDirections directions = tube_directions_at<dim>(model, place);
  RestState state;
  if (material.strain_law != nullptr && material.strain_law_parameters.has_fibres())
    state.fibres = material.strain_law_parameters.fibres(directions.axis, directions.circumference);
  state.prestretch = material.prestretch.inverse(directions.axis, directions.circumference, share);
  state.volume_ratio = material.prestretch.volume_ratio(share);
  return state;
}

template RestState rest_state_at(const Material &, Model, const Point<2> &, double);
template RestState rest_state_at(const Material &, Model, const Point<3> &, double);
} // namespace Continua
