#include <continua/finite_element/solvers/harmonic_loads.h>

#include <continua/base/input_error.h>

#include <algorithm>
#include <complex>

namespace Continua
{
namespace
{
bool has_load(const std::vector<Waveform> &waveforms)
{
  return std::any_of(waveforms.begin(), waveforms.end(),
                     [](const Waveform &waveform) { return !waveform.is_zero(); });
}

bool has_load_in_time(const std::vector<Waveform> &waveforms)
{
  return std::any_of(waveforms.begin(), waveforms.end(),
                     [](const Waveform &waveform) { return waveform.depends_on_time(); });
}

/// Of the values at rest.
std::vector<std::complex<double>> real_numbers(const DistributedVector &vector)
{
  return std::vector<std::complex<double>>(vector.begin(), vector.end());
}
} // namespace

template <int dim>
std::vector<HarmonicLoadSource> HarmonicLoads<dim>::sources() const
{
  std::vector<HarmonicLoadSource> result;
  const InteriorData &interior = problem.interior;
  if (has_load(interior.body_force) || has_load(interior.acceleration))
    result.push_back(
        {"body force", -1,
         has_load_in_time(interior.body_force) || has_load_in_time(interior.acceleration)});
  for (unsigned int c = 0; c < problem.conditions.size(); ++c)
  {
    const BoundaryCondition &condition = problem.conditions[c];
    bool is_loaded = !condition.normal.is_zero() || !condition.tangential.is_zero(),
         is_in_time = condition.normal.depends_on_time() || condition.tangential.depends_on_time();
    const auto add = [&](const Waveform &waveform)
    {
      is_loaded = is_loaded || !waveform.is_zero();
      is_in_time = is_in_time || waveform.depends_on_time();
    };
    if (condition.free_flow)
      add(condition.free_flow->rate);
    for (const Outlet &outlet : problem.outlets)
      if (outlet.conditions[0] == c)
        add(outlet.pressure_behind);
    if (is_loaded)
      result.push_back({condition.name, static_cast<int>(c), is_in_time});
  }
  return result;
}

template <int dim>
HarmonicLoad HarmonicLoads<dim>::load_of(const HarmonicLoadSource &source, const double time) const
{
  HarmonicLoad load;
  DistributedVector vector = space.velocity_vector();
  load_list.add_of(source.condition, time, vector);
  if (equations.loaded_body() != nullptr && source.condition >= 0)
    vector.add(1., equations.loaded_body()->following_forces(source.condition, time));
  load.forces = real_numbers(vector);
  if (source.condition < 0)
    return load;
  const BoundaryCondition &condition = problem.conditions[source.condition];
  constraints.evaluate_of(condition, time, vector);
  load.velocities = real_numbers(vector);
  const double origin[3] = {0., 0., 0.};
  load.ports.assign(ports.size(), 0.);
  for (const Outlet &outlet : problem.outlets)
    for (unsigned int port = 0; port < ports.size(); ++port)
      if (static_cast<int>(outlet.conditions[0]) == source.condition &&
          ports.conditions()[port] == outlet.conditions[0])
        load.ports[port] = outlet.pressure_behind(origin, time);
  for (unsigned int port = 0; port < ports.size(); ++port)
    if (ports.is_free_flow(port) && static_cast<int>(ports.conditions()[port]) == source.condition)
      load.ports[port] = condition.free_flow->fraction * condition.free_flow->rate(origin, time);
  return load;
}

template <int dim>
HarmonicLoad HarmonicLoads<dim>::unit_load(const unsigned int condition) const
{
  HarmonicLoad load;
  load.ports.assign(ports.size(), 0.);
  for (unsigned int port = 0; port < ports.size(); ++port)
    if (ports.conditions()[port] == condition)
    {
      load.ports[port] = 1.;
      return load;
    }
  if (problem.conditions[condition].normal.kind != BoundaryPart::Kind::traction)
    throw RunError("a unit load of the boundary '" + problem.conditions[condition].name +
                   "' needs a pressure there: its velocity is given");
  DistributedVector flow = equations.flow_of_velocities(condition);
  flow *= -1.;
  load.forces = real_numbers(flow);
  return load;
}

template class HarmonicLoads<2>;
template class HarmonicLoads<3>;
} // namespace Continua
