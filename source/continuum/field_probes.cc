#include <continua/continuum/field_probes.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <stdexcept>

namespace Continua
{
using namespace dealii;

template <int dim>
FieldProbes<dim>::FieldProbes(const Problem &problem)
    : problem(problem), definitions(field_list<dim>(problem.model))
{
}

template <int dim>
unsigned int FieldProbes<dim>::add(const ProbeRequest<dim> &request)
{
  Probe probe{request, {}, {}};
  if (!request.has_no_field())
  {
    const auto field = std::find_if(definitions.begin(), definitions.end(),
                                    [&](const FieldDefinition<dim> &candidate)
                                    { return candidate.name.name == request.field; });
    if (field == definitions.end())
      throw std::invalid_argument("there is no field '" + request.field + "'");
    probe.field = *field;
    if (request.is_section())
      probe.field.axis = {request.point, request.normal / request.normal.norm()};
  }
  build(probe);
  probes.push_back(probe);
  return probes.size() - 1;
}

template <int dim>
void FieldProbes<dim>::rebuild()
{
  for (Probe &probe : probes)
    build(probe);
}

template <int dim>
bool FieldProbes<dim>::counts(const ProbeRequest<dim> &request, const unsigned int region)
{
  return request.region_ids.empty() || request.region_ids.count(region) > 0;
}

template <int dim>
void FieldProbes<dim>::build(Probe &probe) const
{
  using Kind = typename ProbeRequest<dim>::Kind;
  Collector weights = collector();
  double measure = 0.;
  switch (probe.request.kind)
  {
  case Kind::point:
    measure = add_point(probe.request, probe.field, weights);
    if (measure == 0.)
      throw std::invalid_argument("the point is not inside the mesh");
    break;
  case Kind::boundary_mean:
  case Kind::boundary_integral:
    measure = add_boundary(probe.request, probe.field, weights);
    if (measure == 0.)
      throw std::invalid_argument("the boundary has no faces there");
    break;
  case Kind::section_mean:
  case Kind::section_integral:
  case Kind::rim_mean:
    measure = add_section(probe.request, probe.field, weights);
    if (measure == 0.)
      throw std::invalid_argument("a section without area");
    break;
  case Kind::section_flow:
    measure = add_flow(probe.request, weights);
    if (measure == 0.)
      throw std::invalid_argument("a section without area");
    break;
  case Kind::volume_mean:
  case Kind::volume_integral:
    measure = add_volume(probe.request, probe.field, weights);
    if (measure == 0.)
      throw std::invalid_argument("the region has no cells");
    break;
  case Kind::volume_change:
    measure = add_interface(probe.request, weights);
    if (measure == 0.)
      throw std::invalid_argument("the region has no surface with another one");
    break;
  case Kind::boundary_force:
    measure = add_force(probe.request, weights);
    if (measure == 0.)
      throw std::invalid_argument("the boundary has no faces there");
    break;
  }
  const bool is_whole = probe.request.is_integral() || probe.request.has_no_field();
  probe.weights = ProbeWeights(weights, is_whole ? 1. : 1. / measure);
}

template <int dim>
bool FieldProbes<dim>::asks_for_forces() const
{
  return std::any_of(probes.begin(), probes.end(),
                     [](const Probe &probe)
                     { return probe.request.kind == ProbeRequest<dim>::Kind::boundary_force; });
}

template <int dim>
void FieldProbes<dim>::evaluate(const State &state,
                                const DistributedVector *const forces,
                                std::vector<double> &values) const
{
  sums.clear();
  for (const Probe &probe : probes)
    sums.push_back(probe.weights.share(state, forces, problem.materials));
  values.resize(probes.size());
  Utilities::MPI::sum(sums, problem.communicator, values);
}

template class FieldProbes<2>;
template class FieldProbes<3>;
} // namespace Continua
