#include <continua/analysis/periodic_mean.h>

#include <continua/analysis/harmonic_tables.h>
#include <continua/analysis/mean_of_loads.h>
#include <continua/base/input_error.h>
#include <continua/base/interruption.h>
#include <continua/base/parameter_text.h>
#include <continua/linear_algebra/singular_matrix.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>

namespace Continua
{
using namespace dealii;

namespace
{
/// The mean is that of loads which have grown with exp(s t) since ever, s being at most this part
/// of the angular frequency of the period, and of the rate of the slowest relaxation. Twice this s
/// takes the first order of it off.
constexpr double growth_of_mean = 1e-4, growth_over_rate = 1e-3;
/// By which s falls where two means differ, and how often.
constexpr double fall_of_growth = 0.1;
constexpr unsigned int most_falls = 5;
/// Of the largest quantity of the same unit, below which a difference of means may be round-off.
constexpr double round_off_of_mean = 1e-7;
} // namespace

template <int dim>
std::vector<std::complex<double>> PeriodicMean<dim>::find(const HarmonicLoad &load,
                                                          const std::vector<double> &ranges,
                                                          const std::vector<bool> &is_compared)
{
  Probes<dim> &probes = run.input.probes;
  const double slowest = longest_relaxation(run.input.problem);
  double s = growth_of_mean * 2. * numbers::PI / run.input.periodic_state.period;
  if (slowest > 0.)
    s = std::min(s, growth_over_rate / slowest);
  const auto at = [&](const double growth)
  {
    SignalWatch::stop_if_asked(run.input.communicator,
                               "in the search for the mean; a periodic response begins anew, with "
                               "--overwrite");
    try
    {
      system.factor(growth);
      return system.solve({load})[0];
    }
    catch (const SingularMatrix &error)
    {
      throw RunError(std::string(error.what()) +
                     " The mean of the loads, which is harmonic 0, is that of loads which grow so "
                     "slowly, and nothing but the inertia resists it there: a part of the body can "
                     "move without a force. Hold that part, give the liquid a way out, or take the "
                     "mean off the loads.");
    }
  };
  // Of two means without their first order the difference is three times the error of the second.
  double least = std::numeric_limits<double>::infinity();
  std::string worst;
  for (unsigned int fall = 0; fall <= most_falls; ++fall, s *= fall_of_growth)
  {
    const HarmonicSolution near_solution = at(s), middle_solution = at(2. * s);
    const std::vector<Complex> near = probe_values(system, probes, near_solution),
                               middle = probe_values(system, probes, middle_solution),
                               far = probe_values(system, probes, at(4. * s));
    std::vector<Complex> result;
    std::map<std::string, double> largest;
    for (unsigned int i = 0; i < near.size(); ++i)
    {
      result.emplace_back(2. * near[i].real() - middle[i].real());
      double &of_unit = largest[probes.unit_of(i)];
      of_unit = std::max({of_unit, std::abs(result[i].real()), ranges[i]});
    }
    double difference = 0.;
    std::string place;
    for (unsigned int i = 0; i < near.size(); ++i)
    {
      const double other = 2. * middle[i].real() - far[i].real();
      const double scale = std::max(
          {std::abs(result[i].real()), ranges[i], round_off_of_mean * largest[probes.unit_of(i)]});
      const double part =
          scale > 0. ? std::abs(result[i].real() - other) / scale
                     : (std::isfinite(other) ? 0. : std::numeric_limits<double>::infinity());
      if (is_compared[i] && !(part <= difference))
      {
        difference = std::isfinite(part) ? part : std::numeric_limits<double>::max();
        place = probes.name_of(i).label();
      }
    }
    if (difference <= run.input.periodic_response.tolerance)
    {
      difference_of_two = difference;
      parts = {{near_solution, 2.}, {middle_solution, -1.}};
      return result;
    }
    if (difference < least)
    {
      least = difference;
      worst = place;
    }
  }
  throw RunError("the mean of '" + worst + "' is not known: it differs by " +
                 shortest_number(least) +
                 " of its range or its mean where the loads grow faster, and Periodic "
                 "response/Tolerance is " +
                 shortest_number(run.input.periodic_response.tolerance) +
                 ". A body that the mean of its loads moves or fills in every period has no "
                 "periodic state: give the liquid a way out and hold the solid, or compare other "
                 "probes.");
}

template class PeriodicMean<2>;
template class PeriodicMean<3>;
} // namespace Continua
