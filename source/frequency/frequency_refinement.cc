#include <continua/frequency/frequency_refinement.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace Continua
{
namespace
{
/// Places between two frequencies at which two approximations are compared.
constexpr unsigned int n_between = 8;
/// The approximation is closer to the samples than it has to be between them by this factor.
constexpr double closer_at_samples = 0.01;
} // namespace

FrequencyRefinement::FrequencyRefinement(const double lowest,
                                         const double highest,
                                         const bool is_logarithmic,
                                         const Responses &responses,
                                         const FrequencyRefinementOptions &options)
    : is_logarithmic(is_logarithmic), tilt(options.tilt)
{
  if (!(lowest >= 0.) || !(highest > lowest) || (is_logarithmic && !(lowest > 0.)) ||
      !(options.tolerance > 0.) || options.first_frequencies < 3 || options.checks == 0)
    throw std::invalid_argument("a refinement of frequencies has a band, a tolerance, three first "
                                "frequencies and a check");
  std::vector<double> first;
  for (unsigned int i = 0; i < options.first_frequencies; ++i)
    first.push_back(between(lowest, highest, i / (options.first_frequencies - 1.)));
  compute(first, responses);
  approximate(options.tolerance);
  double before = std::numeric_limits<double>::infinity();
  while (!converged && places.size() < options.most_frequencies)
  {
    const std::vector<double> checks = choose_checks(options.checks);
    const RationalApproximation checked = *present;
    compute(checks, responses);
    double largest = 0.;
    for (const double frequency : checks)
    {
      const std::size_t k =
          std::lower_bound(places.begin(), places.end(), frequency) - places.begin();
      for (std::size_t r = 0; r < checked.n_responses(); ++r)
      {
        double scale = 0.;
        for (const std::vector<Complex> &row : samples)
          scale = std::max(scale, std::abs(row[r]));
        if (scale > 0.)
          largest = std::max(largest,
                             std::abs(checked.value(r, laplace_point(frequency)) - samples[k][r]) /
                                 scale);
      }
    }
    last_difference = std::max(largest, before);
    // A value that is no number is no agreement.
    converged = last_difference <= options.tolerance;
    before = std::isfinite(largest) ? largest : std::numeric_limits<double>::infinity();
    approximate(options.tolerance);
  }
}

std::complex<double> FrequencyRefinement::laplace_point(const double frequency) const
{
  return 2. * M_PI * frequency * Complex(tilt, 1.);
}

double FrequencyRefinement::between(const double from, const double to, const double part) const
{
  if (part == 0. || part == 1.)
    return part == 0. ? from : to;
  return is_logarithmic ? from * std::pow(to / from, part) : from + part * (to - from);
}

void FrequencyRefinement::compute(const std::vector<double> &frequencies,
                                  const Responses &compute_responses)
{
  const std::vector<std::vector<Complex>> found = compute_responses(frequencies);
  if (found.size() != frequencies.size())
    throw std::invalid_argument("there are responses at each frequency");
  for (std::size_t i = 0; i < frequencies.size(); ++i)
  {
    const auto place = std::lower_bound(places.begin(), places.end(), frequencies[i]);
    samples.insert(samples.begin() + (place - places.begin()), found[i]);
    places.insert(place, frequencies[i]);
  }
}

void FrequencyRefinement::approximate(const double tolerance)
{
  std::vector<Complex> points;
  std::vector<std::vector<Complex>> rows(samples.front().size());
  for (std::size_t k = 0; k < places.size(); ++k)
  {
    points.push_back(laplace_point(places[k]));
    for (std::size_t r = 0; r < rows.size(); ++r)
      rows[r].push_back(samples[k][r]);
  }
  RationalOptions options;
  options.tolerance = closer_at_samples * tolerance;
  previous = std::move(present);
  present = std::make_unique<RationalApproximation>(points, rows, options);
  if (!previous)
  {
    // The first comparison is with half of the samples.
    std::vector<Complex> some_points;
    std::vector<std::vector<Complex>> some_rows(rows.size());
    for (std::size_t k = 0; k < points.size(); k += 2)
    {
      some_points.push_back(points[k]);
      for (std::size_t r = 0; r < rows.size(); ++r)
        some_rows[r].push_back(rows[r][k]);
    }
    previous = std::make_unique<RationalApproximation>(some_points, some_rows, options);
  }
}

double FrequencyRefinement::difference(const RationalApproximation &other,
                                       const double frequency) const
{
  double largest = 0.;
  for (std::size_t r = 0; r < present->n_responses(); ++r)
  {
    double scale = 0.;
    for (const std::vector<Complex> &row : samples)
      scale = std::max(scale, std::abs(row[r]));
    const Complex s = laplace_point(frequency);
    const double here = std::abs(present->value(r, s) - other.value(r, s));
    // A pole on the axis: nothing differs more.
    largest = std::max(largest, std::isfinite(here) ? here / std::max(scale, 1e-300) : 1e300);
  }
  return largest;
}

std::vector<double> FrequencyRefinement::choose_checks(const unsigned int n_checks) const
{
  struct Gap
  {
    double difference, width, place, middle;
  };
  std::vector<Gap> gaps;
  for (std::size_t k = 1; k < places.size(); ++k)
  {
    const double from = places[k - 1], to = places[k];
    Gap gap{-1., is_logarithmic ? std::log(to / from) : to - from, from, between(from, to, 0.5)};
    for (unsigned int i = 1; i < n_between; ++i)
    {
      const double place = between(from, to, i / static_cast<double>(n_between));
      if (const double here = difference(*previous, place); here > gap.difference)
      {
        gap.difference = here;
        gap.place = place;
      }
    }
    gaps.push_back(gap);
  }
  std::stable_sort(gaps.begin(), gaps.end(),
                   [](const Gap &a, const Gap &b) { return a.difference > b.difference; });
  std::vector<double> result;
  for (std::size_t i = 0; i < gaps.size() && i < n_checks; ++i)
    result.push_back(gaps[i].place);
  // The widest gap that has no check yet, in its middle.
  const Gap *widest = nullptr;
  for (std::size_t i = n_checks; i < gaps.size(); ++i)
    if (widest == nullptr || gaps[i].width > widest->width)
      widest = &gaps[i];
  if (widest != nullptr)
    result.push_back(widest->middle);
  return result;
}
} // namespace Continua
