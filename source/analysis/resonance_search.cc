#include <continua/analysis/resonance_search.h>

#include <continua/analysis/random_field.h>
#include <continua/base/interruption.h>
#include <continua/base/lack_of_memory.h>
#include <continua/frequency/frequency_refinement.h>
#include <continua/frequency/rational_approximation.h>
#include <continua/linear_algebra/singular_matrix.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <sstream>
#include <string>

namespace Continua
{
using namespace dealii;

namespace
{
using Complex = std::complex<double>;

/// Of the central difference to s, over |s|: its error and that of round-off are 1e-10.
constexpr double step_of_difference = 1e-4;
/// Newton's method ends when s changes by no more than this part.
constexpr double last_change = 1e-9;
constexpr unsigned int most_corrections = 15;
/// The forces that are left of a resonance.
constexpr double largest_residual = 1e-6;
/// Resonances nearer to each other than this part of s are one, found twice.
constexpr double nearest_resonances = 1e-7;
/// Samples are known to this part: poles are sought down to it.
constexpr double noise_of_samples = 1e-9;
/// Responses are computed at s = omega (i + this): a resonance without damping is no wider than its
/// distance from there.
constexpr double tilt_of_frequencies = 0.03;
/// Candidates may lie this far outside the band and the damping that is sought.
constexpr double slack_of_candidates = 0.1;

/// Whether EndImpedance says so: there is no resonance where it has no wave.
bool names_end(const std::string &text)
{
  return text.find("the tube behind the absorbing end") != std::string::npos ||
         text.find("the impedance of a tube's end") != std::string::npos;
}

Complex point_of(const double frequency)
{
  return 2. * numbers::PI * frequency * Complex(tilt_of_frequencies, 1.);
}

/// The longest side of the box round all places [m]. Collective.
template <int dim>
double extent(const std::vector<VelocityPlace<dim>> &places, const MPI_Comm communicator)
{
  double longest = 0.;
  for (unsigned int d = 0; d < dim; ++d)
  {
    double least = std::numeric_limits<double>::max(), most = -least;
    for (const VelocityPlace<dim> &place : places)
    {
      least = std::min(least, place.point[d]);
      most = std::max(most, place.point[d]);
    }
    longest = std::max(longest, Utilities::MPI::max(most, communicator) -
                                    Utilities::MPI::min(least, communicator));
  }
  return longest;
}
} // namespace

double Resonance::natural_frequency() const
{
  return std::abs(s) / (2. * numbers::PI);
}

double Resonance::frequency() const
{
  return s.imag() / (2. * numbers::PI);
}

double Resonance::damping_ratio() const
{
  return Continua::damping_ratio(s);
}

double Resonance::quality_factor() const
{
  return 0.5 / damping_ratio();
}

template <int dim>
ResonanceSearch<dim>::ResonanceSearch(HarmonicSystem<dim> &system,
                                      const ResonanceParameters &parameters,
                                      const std::vector<unsigned int> &unit_loads,
                                      const MPI_Comm communicator,
                                      Log &log)
    : system(system),
      parameters(parameters),
      unit_loads(unit_loads),
      communicator(communicator),
      log(log)
{
}

template <int dim>
void ResonanceSearch<dim>::stop_if_asked() const
{
  SignalWatch::stop_if_asked(communicator,
                             "in the search for resonances, which begins anew with --overwrite");
}

template <int dim>
Complex ResonanceSearch<dim>::product(const HarmonicLoad &load,
                                      const HarmonicSolution &solution) const
{
  Complex sum = 0.;
  for (std::size_t i = 0; i < load.forces.size(); ++i)
    sum += load.forces[i] * solution.displacement[i];
  sum = Utilities::MPI::sum(sum, communicator);
  // Every rank has the ports. A pressure behind an outlet works on the volume that has left.
  for (std::size_t port = 0; port < load.ports.size(); ++port)
    sum -= load.ports[port] * solution.port_flow_rates[port] / solution.s;
  return sum;
}

template <int dim>
Complex ResonanceSearch<dim>::product(const HarmonicSolution &forces,
                                      const HarmonicSolution &solution) const
{
  Complex sum = 0.;
  for (std::size_t i = 0; i < forces.displacement.size(); ++i)
    sum += forces.displacement[i] * solution.displacement[i];
  for (std::size_t i = 0; i < forces.pressure.size(); ++i)
    sum += forces.pressure[i] * solution.pressure[i];
  return Utilities::MPI::sum(sum, communicator);
}

template <int dim>
double ResonanceSearch<dim>::size(const std::vector<Complex> &values) const
{
  double sum = 0.;
  for (const Complex &value : values)
    sum += std::norm(value);
  return std::sqrt(Utilities::MPI::sum(sum, communicator));
}

template <int dim>
HarmonicSolution ResonanceSearch<dim>::derivative(const Complex s, const HarmonicSolution &u)
{
  const double step = step_of_difference * std::abs(s);
  HarmonicSolution above, below;
  system.multiply(s + step, u, above.displacement, above.pressure);
  system.multiply(s - step, u, below.displacement, below.pressure);
  above.add(-1., below);
  HarmonicSolution result;
  result.add(0.5 / step, above);
  return result;
}

template <int dim>
void ResonanceSearch<dim>::make_loads()
{
  const std::vector<bool> is_free = system.free_velocities();
  const std::vector<VelocityPlace<dim>> places = system.velocity_places();
  // The same in each run, and on any number of ranks.
  std::mt19937_64 generator(1);
  const double size_of_body = extent(places, communicator);
  std::vector<HarmonicLoad> rough;
  for (const std::vector<unsigned int> &nodes : system.velocity_nodes())
    for (unsigned int k = 0; k < parameters.loads_in_a_region; ++k)
    {
      const RandomField<dim> field(generator, size_of_body);
      HarmonicLoad load;
      load.forces.assign(system.n_local_velocities(), 0.);
      for (const unsigned int node : nodes)
        if (is_free[node])
          load.forces[node] = field.value(places[node].point, places[node].component);
      rough.push_back(load);
    }
  const Complex middle(0., 2. * numbers::PI * std::sqrt(parameters.lowest * parameters.highest));
  // A little right of the axis, where a body without damping has its modes.
  const Complex s = middle * std::polar(1., -0.1);
  system.factor(s);
  for (const HarmonicSolution &solution : system.solve(rough))
  {
    HarmonicLoad smooth;
    for (const Complex &force : derivative(s, solution).displacement)
      smooth.forces.emplace_back(force.real());
    const double scale = size(smooth.forces);
    if (!(scale > 0.))
      continue;
    for (Complex &force : smooth.forces)
      force /= scale;
    loads.push_back(smooth);
  }
  for (const unsigned int condition : unit_loads)
    loads.push_back(system.unit_load(condition));
}

template <int dim>
std::vector<Complex> ResonanceSearch<dim>::find_candidates()
{
  const auto responses_at = [&](const std::vector<double> &frequencies)
  {
    std::vector<Complex> points;
    points.reserve(frequencies.size());
    for (const double frequency : frequencies)
      points.push_back(point_of(frequency));
    std::vector<std::vector<Complex>> responses(points.size());
    system.solve_at(
        points, [&](std::size_t) { return loads; },
        [&](const std::size_t number, const std::vector<HarmonicLoad> &,
            const std::vector<HarmonicSolution> &solutions)
        {
          for (std::size_t i = 0; i < loads.size(); ++i)
            for (std::size_t j = 0; j <= i; ++j)
              responses[number].push_back(product(loads[i], solutions[j]));
        });
    stop_if_asked();
    return responses;
  };
  FrequencyRefinementOptions refinement;
  refinement.tolerance = parameters.tolerance;
  refinement.most_frequencies = parameters.most_frequencies;
  refinement.tilt = tilt_of_frequencies;
  refinement.first_frequencies = std::min(9u, parameters.most_frequencies);
  // The response to a resonance at an end of the band is known from both of its sides.
  const FrequencyRefinement band(parameters.lowest / (1. + slack_of_candidates),
                                 parameters.highest * (1. + slack_of_candidates), true,
                                 responses_at, refinement);
  frequencies_used = band.frequencies().size();
  difference_at_checks = band.difference_at_checks();
  has_converged = band.has_converged();

  std::vector<Complex> points;
  std::vector<std::vector<Complex>> responses(band.responses().front().size());
  for (std::size_t k = 0; k < band.frequencies().size(); ++k)
  {
    points.push_back(point_of(band.frequencies()[k]));
    for (std::size_t r = 0; r < responses.size(); ++r)
      responses[r].push_back(band.responses()[k][r]);
  }
  std::vector<Complex> candidates;
  const auto add_poles = [&](const RationalApproximation &approximation)
  {
    for (const Complex &pole : approximation.poles())
    {
      Resonance candidate;
      candidate.s = pole;
      const double natural = candidate.natural_frequency();
      const bool is_new = std::none_of(candidates.begin(), candidates.end(),
                                       [&](const Complex &other)
                                       { return std::abs(pole - other) < 1e-3 * std::abs(pole); });
      // Poles right of the axis are those of noise, or of a resonance without damping.
      if (is_new && pole.imag() > 0. && natural > parameters.lowest / (1. + slack_of_candidates) &&
          natural < parameters.highest * (1. + slack_of_candidates) &&
          std::abs(candidate.damping_ratio()) <
              std::min(1., (1. + slack_of_candidates) * parameters.largest_damping_ratio))
        candidates.push_back(pole);
    }
  };
  RationalOptions fine;
  fine.tolerance = noise_of_samples;
  add_poles(RationalApproximation(points, responses, fine));
  add_poles(band.approximation());
  return candidates;
}

template <int dim>
void ResonanceSearch<dim>::factor_beside(Complex &s)
{
  // At the resonance there is no factor. One beside it is as good: the correction takes it back.
  for (const double distance : {0., 1e-9, 1e-8, 1e-7, 1e-6, 1e-5})
    try
    {
      system.factor(s * (1. + distance));
      s *= 1. + distance;
      return;
    }
    catch (const SingularMatrix &)
    {
      if (distance == 1e-5)
        throw;
    }
}

template <int dim>
bool ResonanceSearch<dim>::correct(Resonance &resonance, HarmonicLoad load)
{
  double change = 1.;
  while (resonance.corrections < most_corrections)
  {
    factor_beside(resonance.s);
    HarmonicSolution u = system.solve({load})[0];
    ++resonance.corrections;
    const double scale = size(u.displacement);
    if (!(scale > 0.) || !std::isfinite(scale))
      return false;
    HarmonicSolution unit;
    unit.s = resonance.s;
    unit.add(1. / scale, u);
    // b.u of the solution, which the scale divides.
    const Complex left = product(load, u) / scale / scale;
    const HarmonicSolution next = derivative(resonance.s, unit);
    const Complex slope = product(next, unit);
    const Complex step = left / slope;
    if (!std::isfinite(std::abs(step)))
      return false;
    resonance.s -= step;
    change = std::abs(step) / std::abs(resonance.s);
    unit.s = resonance.s;
    resonance.shape = unit;
    if (change <= last_change)
      break;
    // One that leaves is none, or another candidate's.
    if (change > 0.5 || !(resonance.s.imag() > 0.))
      return false;
    load = HarmonicLoad();
    const double size_of_next = size(next.displacement);
    for (const Complex &force : next.displacement)
      load.forces.push_back(force / size_of_next);
  }
  if (change > 1e-8)
    return false;
  HarmonicSolution left;
  system.multiply(resonance.s, resonance.shape, left.displacement, left.pressure);
  resonance.residual =
      size(left.displacement) /
      (std::abs(resonance.s) * size(derivative(resonance.s, resonance.shape).displacement));
  return resonance.residual < largest_residual;
}

template <int dim>
bool ResonanceSearch<dim>::is_sought(const Resonance &resonance) const
{
  return resonance.natural_frequency() >= parameters.lowest &&
         resonance.natural_frequency() <= parameters.highest &&
         std::abs(resonance.damping_ratio()) < parameters.largest_damping_ratio;
}

template <int dim>
std::vector<Resonance> ResonanceSearch<dim>::find()
{
  make_loads();
  const std::vector<Complex> candidates = find_candidates();
  candidates_tried = candidates.size();
  HarmonicLoad all;
  for (std::size_t k = 0; k < loads.size(); ++k)
    if (!loads[k].forces.empty())
      all.add(1. + 0.1 * k, loads[k]);
  all.ports.clear();
  std::vector<Resonance> found;
  for (const Complex &candidate : candidates)
  {
    stop_if_asked();
    Resonance resonance;
    resonance.s = candidate;
    bool converged = false;
    try
    {
      converged = correct(resonance, all);
    }
    catch (const Interrupted &)
    {
      throw;
    }
    catch (const RunError &error)
    {
      const std::string text = error.what();
      // That says nothing of the candidate.
      if (text.find(lack_of_memory) != std::string::npos)
        throw;
      if (names_end(text))
        log.detail(text);
      else
        log.warning("a candidate was left out: " + text);
    }
    std::ostringstream text;
    text << "Candidate s = " << candidate.real() << " + " << candidate.imag() << " i 1/s: "
         << (!converged              ? "no resonance"
             : !is_sought(resonance) ? "a resonance that is not sought"
                                     : "a resonance")
         << " after " << resonance.corrections << " factors";
    log.detail(text.str());
    const bool is_new = std::none_of(
        found.begin(), found.end(),
        [&](const Resonance &other)
        { return std::abs(resonance.s - other.s) < nearest_resonances * std::abs(other.s); });
    if (converged && is_sought(resonance) && is_new)
      found.push_back(resonance);
  }
  std::sort(found.begin(), found.end(),
            [](const Resonance &a, const Resonance &b)
            { return a.natural_frequency() < b.natural_frequency(); });
  return found;
}

template class ResonanceSearch<2>;
template class ResonanceSearch<3>;
} // namespace Continua
