#include <continua/network/nonlinear_tube_waves.h>

#include <continua/base/input_error.h>
#include <continua/network/tube_wall.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace Continua
{
namespace
{
constexpr unsigned int fewest_cells = 8;

/// The section at z [m]: that of a segment in its middle, linear between them and beyond.
TubeSection section_at(const TubeWaveProblem &problem, const double z)
{
  const std::vector<TubeSegment> &segments = problem.segments;
  if (segments.size() == 1)
    return segments.front().section;
  std::size_t i = 0;
  double middle = 0.5 * segments[0].length, next = 0.;
  for (;; ++i, middle = next)
  {
    next = middle + 0.5 * (segments[i].length + segments[i + 1].length);
    if (z <= next || i + 2 == segments.size())
      break;
  }
  const TubeSection &left = segments[i].section, &right = segments[i + 1].section;
  const double share = (z - middle) / (next - middle);
  TubeSection section = left;
  section.inner_radius += share * (right.inner_radius - left.inner_radius);
  for (std::size_t layer = 0; layer < section.layers.size(); ++layer)
    section.layer_thicknesses[layer] +=
        share * (right.layer_thicknesses[layer] - left.layer_thicknesses[layer]);
  return section;
}

WallTheory wall_theory_of(const WaveLevel level)
{
  return level == WaveLevel::womersley || level == WaveLevel::membrane ? WallTheory::thin
                                                                       : WallTheory::thick;
}

FlowLaw flow_law_of(const Material &liquid)
{
  FlowLaw law;
  law.density = liquid.density;
  law.viscosity = liquid.shear.viscosity;
  law.remembers = law.viscosity > 0.;
  law.gravity = 0.;
  return law;
}

TerminalLaw law_of_load(const Impedance &load)
{
  if (load.n_ports() != 1 || load.terms.size() > 1 ||
      (!load.terms.empty() && !(load.terms.front().rate > 0.)))
    throw std::domain_error("has an outlet that is neither a resistance nor a windkessel");
  TerminalLaw law;
  law.resistance = load.direct(0, 0);
  law.type = TerminalLaw::Type::resistance;
  if (!load.terms.empty())
  {
    const Impedance::Term &term = load.terms.front();
    law.type = TerminalLaw::Type::windkessel;
    law.compliance = 1. / term.residue(0, 0);
    law.distal_resistance = term.residue(0, 0) / term.rate;
  }
  return law;
}

TerminalLaw law_of_outlet(const TubeWaveProblem &problem)
{
  using Outlet = TubeWaveProblem::Outlet;
  TerminalLaw law;
  switch (problem.outlet)
  {
  case Outlet::open:
    law.type = TerminalLaw::Type::pressure;
    law.value = [](double) { return 0.; };
    break;
  case Outlet::matched:
  case Outlet::absorbing:
    law.type = TerminalLaw::Type::absorbing;
    break;
  case Outlet::loaded:
    return law_of_load(problem.load);
  default: // closed, or divided, where vessels meet and the law is of no use
    break;
  }
  return law;
}

bool is_same(const WallRelaxation &a, const WallRelaxation &b)
{
  constexpr double tolerance = 1e-9;
  bool same = a.branches.size() == b.branches.size() &&
              std::abs(a.damping_time - b.damping_time) <= tolerance * a.damping_time;
  for (std::size_t k = 0; same && k < a.branches.size(); ++k)
    same = std::abs(a.branches[k].share - b.branches[k].share) <= tolerance * a.branches[k].share;
  return same;
}
} // namespace

NonlinearTubeWaves::NonlinearTubeWaves(const TubeWaveProblem &problem,
                                       const std::function<double(double)> &inlet,
                                       const Settings &settings)
    : inlet(inlet), settings(settings)
{
  if (!(settings.cell_length > 0.))
    throw std::invalid_argument("The cells of a vessel have no length.");
  add(problem, 0);
  make();
}

void NonlinearTubeWaves::add(const TubeWaveProblem &problem, const unsigned int from)
{
  const WallTheory theory = wall_theory_of(problem.level);
  const TubeWall first(problem.segments.front().section, theory);
  for (const TubeSegment &segment : problem.segments)
    if (!is_same(first.relaxation(), TubeWall(segment.section, theory).relaxation()))
      throw std::domain_error("has a wall that relaxes in another way along the tube, since what "
                              "is around it has another share");
  const unsigned int to = tubes.empty() ? 1 : tubes.back().to + 1;
  tubes.push_back({problem, from, to,
                   std::max(fewest_cells, static_cast<unsigned int>(std::ceil(
                                              problem.length() / settings.cell_length - 1e-9)))});
  // Nodes are numbered as the tubes are, so that those of branches of branches follow.
  for (const TubeWaveProblem &branch : problem.branches)
    add(branch, to);
}

Network NonlinearTubeWaves::make() const
{
  std::vector<Network::Edge> edges;
  std::vector<TerminalLaw> laws(1);
  laws.front().type = tubes.front().problem.inlet == TubeWaveProblem::Inlet::pressure
                          ? TerminalLaw::Type::pressure
                          : TerminalLaw::Type::flow_rate;
  laws.front().value = inlet;
  for (std::size_t t = 0; t < tubes.size(); ++t)
  {
    const TubeWaveProblem &problem = tubes[t].problem;
    VesselDescription description;
    description.name = t == 0 ? "tube" : "branch " + std::to_string(t);
    description.length = problem.length();
    description.n_cells = tubes[t].n_cells;
    edges.push_back({TubeWall::make(
                         description, flow_law_of(problem.segments.front().section.fluid),
                         [&problem](const double z) { return section_at(problem, z); },
                         wall_theory_of(problem.level), -settings.mean_pressure),
                     tubes[t].from, tubes[t].to});
    laws.push_back(law_of_outlet(problem));
  }
  Network network(std::move(edges), laws);
  try
  {
    network.start_at_rest(0.);
  }
  catch (const std::domain_error &)
  {
    throw std::domain_error("has a wall that does not bear the mean pressure, or an area under "
                            "it that is less than 1/81 or more than 3 times that of the mesh");
  }
  return network;
}

unsigned int NonlinearTubeWaves::n_cells() const
{
  unsigned int sum = 0;
  for (const Tube &tube : tubes)
    sum += tube.n_cells;
  return sum;
}

std::vector<WaveHistory> NonlinearTubeWaves::histories(const std::vector<double> &stations,
                                                       const std::vector<double> &times,
                                                       const unsigned int branch) const
{
  if (branch >= tubes.size())
    throw std::invalid_argument("There is no such branch.");
  const TubeWaveProblem &problem = tubes[branch].problem;
  Network network = make();
  struct Station
  {
    TubeWall wall;
    double diameter, hoop_stress; ///< at rest
  };
  const auto diameter_of = [](const double area) { return 2. * std::sqrt(area / FlowLaw::pi); };
  std::vector<Station> linear;
  for (const double z : stations)
  {
    const TubeWall wall(section_at(problem, z), wall_theory_of(problem.level));
    const double diameter = diameter_of(network.vessel(branch).values(z).area);
    linear.push_back({wall, diameter, wall.hoop_stress(settings.mean_pressure, 0.5 * diameter)});
  }
  std::vector<WaveHistory> histories(stations.size());
  const auto record = [&](const std::size_t s, const Vessel::Values &values)
  {
    const Station &station = linear[s];
    const double diameter = diameter_of(values.area);
    WaveHistory &history = histories[s];
    history.pressure.push_back(values.pressure);
    history.axis_pressure.push_back(values.pressure);
    history.flow_rate.push_back(values.flow);
    history.wall_distension.push_back(diameter - station.diameter);
    history.wall_shear_stress.push_back(values.wall_shear_stress);
    history.hoop_stress.push_back(
        station.wall.hoop_stress(values.pressure + settings.mean_pressure, 0.5 * diameter) -
        station.hoop_stress);
  };
  std::string end;
  for (const double time : times)
  {
    if (end.empty())
      try
      {
        network.advance(time, settings.courant_number);
      }
      catch (const StepFailure &error)
      {
        end = error.what();
        if (settings.mean_pressure != 0.)
          end += ". Pressures count from the mean pressure";
      }
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t s = 0; s < stations.size(); ++s)
      record(s, end.empty() ? network.vessel(branch).values(stations[s])
                            : Vessel::Values{none, none, none, none});
  }
  for (WaveHistory &history : histories)
    history.end = end;
  return histories;
}
} // namespace Continua
