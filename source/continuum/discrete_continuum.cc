#include <continua/continuum/discrete_continuum.h>

#include <continua/continuum/field_list.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace Continua
{
template <int dim>
DiscreteContinuum<dim>::DiscreteContinuum(std::unique_ptr<Discretisation<dim>> discretisation,
                                          const Problem &problem,
                                          Log &log)
    : problem(problem),
      discretisation(std::move(discretisation)),
      stepping(problem, *this->discretisation, log)
{
}

template <int dim>
void DiscreteContinuum<dim>::initialise()
{
  velocities_of_liquids.reset();
  stepping.initialise();
}

template <int dim>
void DiscreteContinuum<dim>::transfer()
{
  velocities_of_liquids.reset();
  stepping.transfer();
}

template <int dim>
std::unique_ptr<VibrationOperator<dim>> DiscreteContinuum<dim>::vibration()
{
  stepping.share_state();
  return discretisation->vibration(
      {stepping.present_velocity(), stepping.present_displacement(), stepping.present_pressure()});
}

template <int dim>
std::unique_ptr<HarmonicSystem<dim>> DiscreteContinuum<dim>::harmonic_system()
{
  stepping.share_state();
  return discretisation->harmonic_system(
      {stepping.present_velocity(), stepping.present_displacement(), stepping.present_pressure(),
       stepping.present_mixtures(), stepping.time_of_loads()});
}

template <int dim>
std::vector<FieldComponent> DiscreteContinuum<dim>::fields() const
{
  return field_names<dim>(problem);
}

template <int dim>
unsigned int DiscreteContinuum<dim>::add_probe(const ProbeRequest<dim> &request)
{
  const unsigned int number = discretisation->probes().add(request);
  if (discretisation->probes().asks_for_forces())
    stepping.want_forces_at_nodes(discretisation->probes().regions_of_forces());
  return number;
}

template <int dim>
void DiscreteContinuum<dim>::evaluate_probes(std::vector<double> &values)
{
  FieldProbes<dim> &probes = discretisation->probes();
  probes.evaluate(
      stepping.state(),
      [this](const std::optional<unsigned int> region) -> const DistributedVector &
      { return stepping.forces_at_nodes(region); },
      values);
}

template <int dim>
double DiscreteContinuum<dim>::divergence()
{
  return discretisation->products().divergence(stepping.present_velocity());
}

template <int dim>
MotionExtremes DiscreteContinuum<dim>::motion_extremes()
{
  MotionExtremes extremes;
  discretisation->take_motion(stepping.state(), extremes);
  if (!velocities_of_liquids)
  {
    velocities_of_liquids.emplace();
    const std::vector<std::vector<unsigned int>> nodes = discretisation->velocity_nodes();
    for (unsigned int region = 0; region < nodes.size(); ++region)
      if (!problem.materials[region].is_solid())
        velocities_of_liquids->insert(velocities_of_liquids->end(), nodes[region].begin(),
                                      nodes[region].end());
  }
  const double *const velocity = stepping.present_velocity().begin();
  for (const unsigned int i : *velocities_of_liquids)
    extremes.liquid_speed = std::max(extremes.liquid_speed, std::abs(velocity[i]));
  std::vector<double> largest = {extremes.strain, extremes.rotation, extremes.wall_displacement,
                                 extremes.liquid_speed};
  dealii::Utilities::MPI::max(largest, problem.communicator, largest);
  extremes.strain = largest[0];
  extremes.rotation = largest[1];
  extremes.wall_displacement = largest[2];
  extremes.liquid_speed = largest[3];
  return extremes;
}

template <int dim>
std::map<std::string, std::string>
DiscreteContinuum<dim>::add_output(dealii::DataOut<dim> &data_out)
{
  return discretisation->add_output(stepping.state(), data_out);
}

template <int dim>
void DiscreteContinuum<dim>::indicators(const IndicatorRequest &request,
                                        dealii::Vector<float> &per_cell)
{
  const std::vector<double> port_pressures = request.kind == IndicatorRequest::Kind::traction_jump
                                                 ? stepping.port_pressures()
                                                 : std::vector<double>();
  discretisation->indicators(request, stepping.state(), port_pressures, stepping.time(), per_cell);
}

template <int dim>
double DiscreteContinuum<dim>::error_norm(const ComparedField field,
                                          const std::vector<Expression> &exact,
                                          const double time)
{
  return discretisation->error_norm(stepping.state(), field, exact, time);
}

template class DiscreteContinuum<2>;
template class DiscreteContinuum<3>;
} // namespace Continua
