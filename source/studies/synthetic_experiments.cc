#include <continua/studies/synthetic_experiments.h>

#include <continua/base/input_error.h>
#include <continua/base/undefined.h>
#include <continua/inference/interpolated_model.h>
#include <continua/inference/least_squares_fit.h>
#include <continua/inference/whitening.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <random>

namespace Continua
{
namespace
{
/// Half the width of the box in which fits stay, in standard errors.
constexpr double half_width_of_box = 7.;
/// What interpolation may add, over the noise, and at how many places that is looked at.
constexpr double largest_interpolation_error = 0.01;
constexpr unsigned int n_checks = 4, fewest_nodes_of_box = 3, most_nodes_of_box = 5;

std::vector<double>
draw_noise(const Whitening &whitening, const std::size_t n, std::mt19937_64 &generator)
{
  std::normal_distribution<double> normal;
  std::vector<double> white(n);
  for (double &value : white)
    value = normal(generator);
  return whitening.undo(white);
}
} // namespace

SyntheticExperiments::SyntheticExperiments(const std::vector<FitParameter> &of_fit,
                                           const std::vector<double> &truth,
                                           const std::vector<double> &standard_errors,
                                           const std::vector<DataRecord> &records,
                                           const std::vector<NoiseModel> &noise,
                                           const FitOptions &of_user)
    : parameters(of_fit),
      truth(truth),
      standard_errors(standard_errors),
      records(records),
      noise(noise),
      options(of_user)
{
  for (std::size_t j = 0; j < parameters.size(); ++j)
  {
    FitParameter &parameter = parameters[j];
    const bool moves = !parameter.is_held() && std::isfinite(standard_errors[j]);
    double half_width =
        moves ? half_width_of_box * standard_errors[j] / parameter.value_per_coordinate(truth[j])
              : 0.;
    // Within the bounds of the user; a number at its bound stays there.
    const double at = parameter.coordinate(truth[j]);
    for (const double bound : {parameter.lower, parameter.upper})
      if (std::isfinite(parameter.coordinate(bound)))
        half_width = std::min(half_width, std::abs(parameter.coordinate(bound) - at));
    half_widths.push_back(half_width);
    parameter.start = truth[j];
    parameter.lower = parameter.value(at - half_width);
    parameter.upper = parameter.value(at + half_width);
    if (half_width == 0.)
      parameter.lower = parameter.upper = truth[j];
  }
  options.known.clear();
  options.observer = {};
  options.n_starts = 1;
}

double SyntheticExperiments::interpolation_error(FitModel &model,
                                                 FitModel &interpolated,
                                                 const unsigned int seed) const
{
  std::mt19937_64 generator(seed);
  std::uniform_real_distribution<double> uniform(-0.7, 0.7);
  std::vector<std::vector<double>> sets;
  for (unsigned int i = 0; i < n_checks; ++i)
  {
    sets.emplace_back();
    for (std::size_t j = 0; j < parameters.size(); ++j)
      sets.back().push_back(parameters[j].value(parameters[j].coordinate(truth[j]) +
                                                half_widths[j] * uniform(generator)));
  }
  const auto exact = model.predict(sets), found = interpolated.predict(sets);
  double largest = 0.;
  for (std::size_t i = 0; i < sets.size(); ++i)
  {
    if (!exact[i].failure.empty())
      throw RunError("near the estimates the model fails: " + exact[i].failure);
    std::size_t v = 0;
    for (std::size_t r = 0; r < records.size(); ++r)
      for (std::size_t k = 0; k < records[r].size(); ++k, ++v)
        largest = std::max(largest, std::abs(exact[i].values[v] - found[i].values[v]) /
                                        noise[r].standard_deviation);
  }
  return largest;
}

SyntheticExperiments::Outcome SyntheticExperiments::perform(FitModel &model,
                                                            const unsigned int n_experiments,
                                                            const unsigned int seed) const
{
  Outcome outcome;
  std::unique_ptr<InterpolatedModel> interpolated;
  for (unsigned int n_nodes = fewest_nodes_of_box; n_nodes <= most_nodes_of_box; ++n_nodes)
  {
    interpolated =
        std::make_unique<InterpolatedModel>(model, parameters, truth, half_widths, n_nodes);
    outcome.interpolation_error = interpolation_error(model, *interpolated, seed);
    outcome.n_evaluations += interpolated->n_evaluations() + n_checks;
    if (outcome.interpolation_error <= largest_interpolation_error)
      break;
  }
  const std::vector<double> exact = interpolated->predict({truth}).front().values;
  std::vector<Whitening> whitenings;
  for (std::size_t r = 0; r < records.size(); ++r)
    whitenings.emplace_back(noise[r], records[r].interval);
  std::mt19937_64 generator(seed);
  const auto begin = std::chrono::steady_clock::now();
  for (unsigned int i = 0; i < n_experiments; ++i)
  {
    std::vector<DataRecord> drawn = records;
    std::size_t first = 0;
    for (std::size_t r = 0; r < drawn.size(); ++r)
    {
      drawn[r].values = draw_noise(whitenings[r], drawn[r].size(), generator);
      for (double &value : drawn[r].values)
        value += exact[first++];
    }
    try
    {
      outcome.fits.push_back(LeastSquaresFit(parameters, drawn, *interpolated, options).solve());
      outcome.fits.back().records.clear();
      outcome.fits.back().whitened_jacobian.clear();
    }
    catch (const RunError &)
    {
      ++outcome.n_failed;
    }
  }
  outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  summarise(outcome);
  return outcome;
}

void SyntheticExperiments::summarise(Outcome &outcome) const
{
  for (std::size_t j = 0; j < parameters.size(); ++j)
  {
    double sum = 0., squares = 0.;
    unsigned int n = 0, n_covered = 0, n_at_bound = 0;
    for (const FitResult &fit : outcome.fits)
      if (fit.at_bound[j] || !std::isfinite(fit.standard_errors[j]))
        ++n_at_bound;
      else
      {
        const double error = fit.estimates[j] - truth[j];
        sum += error;
        squares += error * error;
        n_covered += fit.intervals[j].lower <= truth[j] && truth[j] <= fit.intervals[j].upper;
        ++n;
      }
    const double mean = n > 0 ? sum / n : undefined, foretold = standard_errors[j];
    const double variance = n > 1 ? (squares - n * mean * mean) / (n - 1) : undefined;
    outcome.parameters.push_back({mean / foretold, std::sqrt(variance) / foretold,
                                  n > 0 ? static_cast<double>(n_covered) / n : undefined,
                                  n_at_bound});
  }
}
} // namespace Continua
