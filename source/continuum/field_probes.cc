#include <continua/continuum/field_probes.h>

#include <continua/base/collective.h>
#include <continua/signal/sign_change.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace Continua
{
using namespace dealii;

namespace
{
/// Why a request has no point.
template <typename Kind>
std::string what_is_missing(const Kind kind)
{
  switch (kind)
  {
  case Kind::point:
    return "the point is not inside the mesh";
  case Kind::boundary_mean:
  case Kind::boundary_integral:
  case Kind::boundary_force:
  case Kind::sign_change:
    return "the boundary has no faces there";
  case Kind::volume_mean:
  case Kind::volume_integral:
    return "the region has no cells";
  case Kind::volume_change:
    return "the region has no surface with another one";
  default:
    return "a section without area";
  }
}
} // namespace

template <int dim>
FieldProbes<dim>::FieldProbes(const Problem &problem)
    : problem(problem), definitions(field_list<dim>(problem))
{
}

template <int dim>
unsigned int FieldProbes<dim>::add(const ProbeRequest<dim> &request)
{
  Probe probe{request, {}, {}};
  if (request.is_of_cavity())
    probe.cavity = cavity_of(request);
  if (!request.has_no_field())
  {
    std::vector<FieldDefinition<dim>> all = definitions;
    if (!request.boundary_ids.empty() || !request.neighbour_ids.empty())
      for (const FieldDefinition<dim> &field : wall_field_list<dim>())
        all.push_back(field);
    const auto field = std::find_if(all.begin(), all.end(),
                                    [&](const FieldDefinition<dim> &candidate)
                                    { return candidate.name.name == request.field; });
    if (field == all.end())
      throw std::invalid_argument("there is no field '" + request.field + "'");
    probe.field = *field;
    if (request.is_section())
      probe.field.axis = {request.point, request.normal / request.normal.norm()};
    probe.is_sampled = needs_samples(request, probe.field);
  }
  probe.follows_mesh = follows_mesh(request, probe.field);
  probes.push_back(probe);
  try
  {
    build(probes.size() - 1);
  }
  catch (...)
  {
    probes.pop_back();
    throw;
  }
  return probes.size() - 1;
}

template <int dim>
void FieldProbes<dim>::rebuild()
{
  forget_mesh();
  for (unsigned int number = 0; number < probes.size(); ++number)
    build(number);
}

template <int dim>
bool FieldProbes<dim>::counts(const ProbeRequest<dim> &request, const unsigned int region)
{
  return request.region_ids.empty() || request.region_ids.count(region) > 0;
}

template <int dim>
unsigned int FieldProbes<dim>::cavity_of(const ProbeRequest<dim> &request) const
{
  const std::vector<unsigned int> conditions = problem.unknown_pressures();
  const auto found = std::find_if(conditions.begin(), conditions.end(),
                                  [&](const unsigned int number)
                                  {
                                    const BoundaryCondition &condition = problem.conditions[number];
                                    return condition.is_cavity() &&
                                           request.boundary_ids.count(condition.boundary_id) > 0;
                                  });
  if (found == conditions.end())
    throw std::invalid_argument("the boundary encloses no cavity");
  return found - conditions.begin();
}

template <int dim>
void FieldProbes<dim>::build(const unsigned int number)
{
  Probe &probe = probes[number];
  Collector weights = collector();
  const double measure = set_points(number, weights);
  // What is fixed in space need not be where the body is.
  if (measure == 0. && !probe.request.is_fixed_in_space)
    throw std::invalid_argument(what_is_missing(probe.request.kind));
  const bool is_total = probe.request.is_integral() || probe.request.has_no_field();
  probe.factor = is_total || measure == 0. ? 1. : 1. / measure;
  probe.weights = ProbeWeights(weights, probe.factor);
}

template <int dim>
double FieldProbes<dim>::set_points(const unsigned int number, Collector &weights)
{
  const Probe &probe = probes[number];
  probe_being_built = number;
  if (probe.is_sampled)
    begin_samples(number);
  const double measure = add_points(probe, weights);
  if (probe.is_sampled)
    end_samples();
  return measure;
}

template <int dim>
double FieldProbes<dim>::add_points(const Probe &probe, Collector &collector) const
{
  using Kind = typename ProbeRequest<dim>::Kind;
  switch (probe.request.kind)
  {
  case Kind::point:
    return add_point(probe.request, probe.field, collector);
  case Kind::boundary_mean:
  case Kind::boundary_integral:
  case Kind::sign_change:
    return add_boundary(probe.request, probe.field, collector);
  case Kind::section_mean:
  case Kind::section_integral:
  case Kind::rim_mean:
    return add_section(probe.request, probe.field, collector);
  case Kind::section_flow:
    return add_flow(probe.request, collector);
  case Kind::volume_mean:
  case Kind::volume_integral:
    return add_volume(probe.request, probe.field, collector);
  case Kind::volume_change:
    return add_interface(probe.request, collector);
  case Kind::boundary_force:
    return add_force(probe.request, collector);
  case Kind::cavity_pressure:
  case Kind::cavity_volume:
    return 1.; // no points
  }
  return 0.;
}

template <int dim>
const ProbeWeights &FieldProbes<dim>::weights_of(const unsigned int number) const
{
  const Probe &probe = probes[number];
  const ProbeRequest<dim> &request = probe.request;
  if (probe.is_sampled || probe.follows_mesh || request.is_of_cavity() ||
      request.kind == ProbeRequest<dim>::Kind::boundary_force)
    throw std::invalid_argument("the probe is no sum of unknowns with fixed weights");
  return probe.weights;
}

template <int dim>
bool FieldProbes<dim>::asks_for_forces() const
{
  return std::any_of(probes.begin(), probes.end(),
                     [](const Probe &probe)
                     { return probe.request.kind == ProbeRequest<dim>::Kind::boundary_force; });
}

template <int dim>
std::set<unsigned int> FieldProbes<dim>::regions_of_forces() const
{
  std::set<unsigned int> regions;
  for (const Probe &probe : probes)
    if (probe.request.kind == ProbeRequest<dim>::Kind::boundary_force &&
        !probe.request.neighbour_ids.empty())
      regions.insert(probe.request.region_ids.begin(), probe.request.region_ids.end());
  return regions;
}

template <int dim>
void FieldProbes<dim>::evaluate(
    const State &state,
    const std::function<const DistributedVector &(std::optional<unsigned int>)> &forces,
    std::vector<double> &values)
{
  if (std::any_of(probes.begin(), probes.end(),
                  [](const Probe &probe) { return probe.is_sampled || probe.follows_mesh; }))
    take_state(state);
  for (unsigned int number = 0; number < probes.size(); ++number)
    if (probes[number].follows_mesh && !probes[number].is_sampled)
      build(number);
    else if (probes[number].request.is_fixed_in_space)
    {
      Collector no_weights = collector();
      set_points(number, no_weights);
    }
  const bool is_first = Utilities::MPI::this_mpi_process(problem.communicator) == 0;
  sums.clear();
  // By which means of the present shape are divided.
  std::vector<double> measures(probes.size(), 0.);
  std::vector<bool> is_divided(probes.size(), false);
  for (unsigned int number = 0; number < probes.size(); ++number)
  {
    const Probe &probe = probes[number];
    const ProbeRequest<dim> &request = probe.request;
    if (request.is_of_cavity())
    {
      const CavityState &cavity = (*state.cavities)[probe.cavity];
      sums.push_back(!is_first                                                ? 0.
                     : request.kind == ProbeRequest<dim>::Kind::cavity_volume ? cavity.volume
                                                                              : cavity.pressure);
      continue;
    }
    if (!probe.is_sampled)
    {
      const DistributedVector *of_nodes = nullptr;
      if (request.kind == ProbeRequest<dim>::Kind::boundary_force)
        of_nodes = &forces(request.neighbour_ids.empty()
                               ? std::optional<unsigned int>()
                               : std::optional<unsigned int>(*request.region_ids.begin()));
      sums.push_back(probe.weights.share(state, of_nodes, problem.materials));
      continue;
    }
    samples.clear();
    sample(number, samples);
    if (request.kind == ProbeRequest<dim>::Kind::sign_change)
    {
      const double coordinate = sign_change(request, samples);
      sums.push_back(is_first ? coordinate : 0.);
      continue;
    }
    double sum = 0., measure = 0.;
    for (const Sample &point : samples)
    {
      sum += point.weight * point.value;
      measure += point.weight;
    }
    is_divided[number] = probe.follows_mesh && !request.is_integral();
    measures[number] = measure;
    sums.push_back(is_divided[number] ? sum : probe.factor * sum);
  }
  sums.insert(sums.end(), measures.begin(), measures.end());
  values.resize(sums.size());
  Utilities::MPI::sum(sums, problem.communicator, values);
  for (unsigned int number = 0; number < probes.size(); ++number)
    if (const double measure = values[probes.size() + number]; is_divided[number])
      values[number] =
          measure != 0. ? values[number] / measure : std::numeric_limits<double>::quiet_NaN();
  values.resize(probes.size());
}

template <int dim>
double FieldProbes<dim>::sign_change(const ProbeRequest<dim> &request,
                                     const std::vector<Sample> &of_rank) const
{
  std::vector<double> numbers;
  for (const Sample &point : of_rank)
    if (point.coordinate >= request.range.first && point.coordinate <= request.range.second)
      numbers.insert(numbers.end(), {point.coordinate, point.value});
  std::vector<std::pair<double, double>> points;
  for (const std::vector<double> &of_one : all_gather(problem.communicator, numbers))
    for (std::size_t i = 0; i < of_one.size(); i += 2)
      points.emplace_back(of_one[i], of_one[i + 1]);
  return find_sign_change(points, request.number);
}

template class FieldProbes<2>;
template class FieldProbes<3>;
} // namespace Continua
