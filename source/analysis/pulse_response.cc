#include <continua/analysis/pulse_response.h>

#include <continua/analysis/harmonic_checks.h>
#include <continua/analysis/harmonic_tables.h>
#include <continua/base/input_error.h>
#include <continua/base/interruption.h>
#include <continua/base/parameter_text.h>
#include <continua/continuum/field_list.h>
#include <continua/linear_algebra/singular_matrix.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

namespace Continua
{
namespace
{
constexpr const char *remedy_of_pulses = "use Analysis = transient";
/// e^(a T) of the duration T: what comes back is that much smaller.
constexpr double growth_of_duration = 1e4;
/// The filter is exp(-strength (part of the last point)^power): 1e-8 at the end.
constexpr double strength_of_filter = 18.4, power_of_filter = 6.;
constexpr std::size_t fewest_points = 8;
/// Of the duration: at its end the filter smooths the jump to the next period of the contour.
constexpr double compared_part = 0.75;
/// A column whose range is below this part of the largest one of its unit is round-off.
constexpr double round_off_of_column = 1e-6;
/// A larger residual of the solver is an error at the end that is named.
constexpr double noted_residual_of_points = 1e-9;
/// A body that vibrates for ever has 1 over the growth; ten times that is worth a warning.
constexpr double noted_difference_by_twice = 10. / growth_of_duration;
} // namespace

template <int dim>
void PulseResponse<dim>::check(const Case<dim> &input, ParameterSection root)
{
  check_harmonic_probes(input, root, remedy_of_pulses);
  check_no_states(input.problem, root, remedy_of_pulses);
  ParameterSection time = root.subsection("Time");
  if (!input.time.changes.empty())
    time.refuse("Time step changes", "the times of a pulse response have equal distances",
                "Remove the entry");
  if (input.time.end_time < 2. * static_cast<double>(fewest_points) * input.time.time_step)
    time.refuse("Time step", "there are fewer than 16 of them until the end",
                "Give a shorter one, which follows the loads");
}

template <int dim>
void PulseResponse<dim>::name_quantities(const Case<dim> &input, QuantityNames &names)
{
  input.probes.name_quantities(field_names<dim>(input.problem), false, names);
  names.add("points of the contour");
  names.add("largest difference of the loads");
  names.add("largest difference by twice the duration");
  names.add("largest residual");
}

template <int dim>
double PulseResponse<dim>::filter(const std::size_t point, const std::size_t last)
{
  if (point > last)
    return 0.;
  const double part = static_cast<double>(point) / static_cast<double>(last);
  return std::exp(-strength_of_filter * std::pow(part, power_of_filter));
}

template <int dim>
double PulseResponse<dim>::difference_of_loads(const std::size_t last) const
{
  double largest_part = 0.;
  for (std::size_t shape = 0; shape < loads->n_shapes(); ++shape)
  {
    const std::vector<double> &load = loads->factors(shape);
    std::vector<Complex> spectrum = contour->transform(load);
    for (std::size_t k = 0; k < spectrum.size(); ++k)
      spectrum[k] *= filter(k, last);
    const std::vector<double> filtered = contour->history(spectrum);
    double largest = 0., difference = 0.;
    for (std::size_t j = 0; j <= n_steps; ++j)
    {
      largest = std::max(largest, std::abs(load[j]));
      difference = std::max(difference, std::abs(filtered[j] - load[j]));
    }
    if (largest > 0.)
      largest_part = std::max(largest_part, difference / largest);
  }
  return largest_part;
}

template <int dim>
void PulseResponse<dim>::take_loads()
{
  const TimeParameters &time = run.input.time;
  n_steps = static_cast<std::size_t>(std::ceil(time.end_time / time.time_step - 1e-9));
  const double duration = static_cast<double>(n_steps) * time.time_step;
  contour = std::make_unique<DampedContour>(2. * duration, 2 * n_steps,
                                            growth_of_duration * growth_of_duration);
  loads = std::make_unique<LoadSamples<dim>>(*system, contour->times(), run.input.communicator);
  // The smallest number that does.
  const double tolerance = run.input.pulse_response.tolerance;
  std::size_t too_few = fewest_points, enough = contour->points().size() - 1;
  while (enough > too_few + 1)
  {
    const std::size_t middle = (too_few + enough) / 2;
    if (difference_of_loads(middle) <= tolerance)
      enough = middle;
    else
      too_few = middle;
  }
  last_point = enough;
  const double difference = difference_of_loads(last_point);
  run.summary.add({"largest difference of the loads", difference, "1", ""});
  if (difference > tolerance)
    run.log.warning("the loads that have the frequencies of the contour alone differ by " +
                    shortest_number(difference) +
                    " of their largest value from those of the file: a load jumps or has a kink. "
                    "Give a shorter Time step, or a load that rises from zero without a jump");
}

template <int dim>
void PulseResponse<dim>::solve()
{
  std::vector<HarmonicLoad> shapes;
  for (std::size_t shape = 0; shape < loads->n_shapes(); ++shape)
  {
    std::vector<Complex> one(loads->n_shapes());
    one[shape] = 1.;
    shapes.push_back(loads->sum(one));
  }
  const std::vector<Complex> points(contour->points().begin(),
                                    contour->points().begin() + last_point + 1);
  try
  {
    system->solve_at(
        points, [&shapes](std::size_t) { return shapes; },
        [&](const std::size_t number, const std::vector<HarmonicLoad> &,
            const std::vector<HarmonicSolution> &solutions)
        {
          responses.emplace_back();
          for (const HarmonicSolution &solution : solutions)
            responses.back().push_back(probe_values(*system, run.input.probes, solution));
          if (number + 1 < points.size())
            SignalWatch::stop_if_asked(run.input.communicator,
                                       "after " + std::to_string(number + 1) + " of " +
                                           std::to_string(points.size()) +
                                           " points; a pulse response begins anew, with "
                                           "--overwrite");
        });
  }
  catch (const SingularMatrix &error)
  {
    throw RunError(std::string(error.what()) +
                   " The body can move without a force there: hold it, or give its liquid a way "
                   "out.");
  }
}

template <int dim>
std::vector<std::vector<double>> PulseResponse<dim>::histories(const DampedContour &at,
                                                               const std::size_t stride) const
{
  std::vector<std::vector<Complex>> spectra;
  for (std::size_t shape = 0; shape < loads->n_shapes(); ++shape)
  {
    const std::vector<double> &load = loads->factors(shape);
    spectra.push_back(at.transform({load.begin(), load.begin() + at.times().size()}));
  }
  std::vector<std::vector<double>> result;
  for (unsigned int column = 0; column < run.input.probes.n_columns(); ++column)
  {
    std::vector<Complex> transformed(at.points().size());
    for (std::size_t k = 0; k * stride <= last_point && k < transformed.size(); ++k)
      for (std::size_t shape = 0; shape < spectra.size(); ++shape)
        transformed[k] += filter(k * stride, last_point) * spectra[shape][k] *
                          responses[k * stride][shape][column];
    result.push_back(at.history(transformed));
  }
  return result;
}

template <int dim>
void PulseResponse<dim>::write(const std::vector<std::vector<double>> &values)
{
  Case<dim> &input = run.input;
  const std::size_t stride = steps_of_a_row();
  input.probes.open(run.directory.file("probes.csv"));
  for (std::size_t j = 0; j <= n_steps; j += stride)
  {
    std::vector<double> row(values.size());
    for (std::size_t i = 0; i < values.size(); ++i)
      row[i] = values[i][j];
    input.probes.record(contour->times()[j], row);
  }
}

template <int dim>
double PulseResponse<dim>::difference(const std::vector<std::vector<double>> &values,
                                      const std::vector<std::vector<double>> &others) const
{
  const Probes<dim> &probes = run.input.probes;
  std::vector<double> ranges;
  std::map<std::string, double> largest;
  for (unsigned int column = 0; column < values.size(); ++column)
  {
    const auto [least, most] =
        std::minmax_element(values[column].begin(), values[column].begin() + n_steps);
    ranges.push_back(*most - *least);
    double &of_unit = largest[probes.unit_of(column)];
    of_unit = std::max(of_unit, ranges[column]);
  }
  double result = 0.;
  for (unsigned int column = 0; column < values.size(); ++column)
  {
    const double scale =
        std::max(ranges[column], round_off_of_column * largest[probes.unit_of(column)]);
    for (std::size_t j = 0; j < compared_part * n_steps && scale > 0.; ++j)
      result = std::max(result, std::abs(values[column][j] - others[column][j]) / scale);
  }
  return result;
}

template <int dim>
std::size_t PulseResponse<dim>::steps_of_a_row() const
{
  const double interval = run.input.output.probe_interval;
  return interval > 0. ? std::max(1., std::round(interval / run.input.time.time_step)) : 1;
}

template <int dim>
void PulseResponse<dim>::warn_of_output() const
{
  const double steps = run.input.output.probe_interval / run.input.time.time_step;
  const std::size_t taken = steps_of_a_row();
  if (steps > 0. && std::abs(steps - static_cast<double>(taken)) > 1e-6 * steps)
    run.log.warning("Output/Probe interval is no multiple of Time/Time step: the rows are " +
                    std::to_string(taken) + (taken == 1 ? " step" : " steps") + " apart");
  if (run.input.output.field_interval > 0.)
    run.log.warning("a pulse response writes no fields: Output/Field interval has no effect");
}

template <int dim>
void PulseResponse<dim>::perform()
{
  this->start();
  warn_of_output();
  {
    SectionTimer::Scope scope(run.log.timer(), "loads");
    take_loads();
  }
  {
    SectionTimer::Scope scope(run.log.timer(), "points");
    solve();
  }
  const double duration = contour->times()[n_steps];
  const std::vector<std::vector<double>> values = histories(*contour, 1);
  const double by_twice =
      difference(values, histories(DampedContour(duration, n_steps, growth_of_duration), 2));
  write(values);
  std::ostringstream text;
  text.precision(3);
  text << responses.size() << " points of the contour: one of half its length differs by "
       << by_twice << " of the range of a probe";
  run.log.line(text.str());
  if (by_twice > std::max(run.input.pulse_response.tolerance, noted_difference_by_twice))
    run.log.warning("the contour of half the length differs by more than Pulse response/Tolerance: "
                    "what comes back from behind the end is not small beside the range of a probe. "
                    "Give a later End time");
  if (system->largest_residual() > noted_residual_of_points)
    run.log.warning("the solver leaves " + shortest_number(system->largest_residual()) +
                    " of the largest force at a node, which the contour multiplies by up to " +
                    shortest_number(growth_of_duration) + " until the end");
  run.summary.set("solver of the frequencies", system->solver_name());
  run.summary.add({"points of the contour", static_cast<double>(responses.size()), "1", ""});
  run.summary.add({"largest difference by twice the duration", by_twice, "1", ""});
  run.summary.add({"largest residual", system->largest_residual(), "1", ""});
  this->finish(duration);
}

template class PulseResponse<2>;
template class PulseResponse<3>;
} // namespace Continua
