#include <continua/frequency/rational_approximation.h>

#include <continua/frequency/dense_complex_matrix.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace Continua
{
namespace
{
using Complex = std::complex<double>;

bool is_number(const Complex &value)
{
  return std::isfinite(value.real()) && std::isfinite(value.imag());
}

/// Points nearer to each other than this part of the largest one are one point.
constexpr double nearest_points = 1e-14;
} // namespace

RationalApproximation::RationalApproximation(const std::vector<Complex> &points,
                                             const std::vector<std::vector<Complex>> &responses,
                                             const RationalOptions &options)
    : is_real(options.is_real)
{
  if (points.size() < 2 || responses.empty())
    throw std::invalid_argument("a rational approximation needs two points and a response");
  unit = 0.;
  for (const Complex &point : points)
    unit = std::max(unit, std::abs(point));
  if (!(unit > 0.) || !std::isfinite(unit))
    throw std::invalid_argument("points of a rational approximation are different numbers");
  for (const Complex &point : points)
    samples.push_back(point / unit);
  for (const std::vector<Complex> &response : responses)
  {
    if (response.size() != points.size() ||
        !std::all_of(response.begin(), response.end(), is_number))
      throw std::invalid_argument("a response has a number for each point");
    double largest = 0.;
    for (const Complex &value : response)
      largest = std::max(largest, std::abs(value));
    // A response that is zero everywhere remains as it is.
    scales.push_back(largest > 0. ? largest : 1.);
    values.emplace_back();
    for (const Complex &value : response)
      values.back().push_back(value / scales.back());
  }
  const std::size_t n_given = samples.size();
  for (std::size_t j = 0; j < n_given; ++j)
    mirror.push_back(j);
  for (std::size_t j = 0; is_real && j < n_given; ++j)
    if (std::abs(samples[j].imag()) > nearest_points)
    {
      mirror[j] = samples.size();
      mirror.push_back(j);
      samples.push_back(std::conj(samples[j]));
      for (std::vector<Complex> &row : values)
        row.push_back(std::conj(row[j]));
    }
  for (std::size_t j = 0; j < samples.size(); ++j)
    for (std::size_t k = 0; k < j; ++k)
      if (std::abs(samples[j] - samples[k]) <= nearest_points)
        throw std::invalid_argument("two points of a rational approximation are equal");
  is_support.assign(samples.size(), false);
  seek_support(options);
  find_poles();
  if (options.doublet > 0.)
    remove_doublets(options.doublet);
  measure();
  converged = largest_error <= options.tolerance;
}

void RationalApproximation::seek_support(const RationalOptions &options)
{
  // Before there is a support point the approximation is the mean.
  std::vector<std::vector<Complex>> approximate(values.size());
  for (std::size_t r = 0; r < values.size(); ++r)
  {
    Complex mean = 0.;
    for (const Complex &value : values[r])
      mean += value / static_cast<double>(samples.size());
    approximate[r].assign(samples.size(), mean);
  }
  // At least as many equations as unknowns: half of the samples of one response are left.
  const std::size_t n_equations = values.size() * samples.size();
  while (support.size() <= options.most_poles && support.size() < samples.size() &&
         (support.size() + 1) * (values.size() + 1) <= n_equations + values.size())
  {
    double largest = -1.;
    std::size_t worst = 0;
    for (std::size_t j = 0; j < samples.size(); ++j)
      for (std::size_t r = 0; !is_support[j] && r < values.size(); ++r)
        if (const double difference = std::abs(values[r][j] - approximate[r][j]);
            difference > largest)
        {
          largest = difference;
          worst = j;
        }
    if (!support.empty() && largest <= options.tolerance)
      return;
    for (const std::size_t added : {worst, mirror[worst]})
      if (!is_support[added])
      {
        support.push_back(added);
        is_support[added] = true;
      }
    find_weights();
    for (std::size_t j = 0; j < samples.size(); ++j)
      for (std::size_t r = 0; r < values.size(); ++r)
        approximate[r][j] = is_support[j] ? values[r][j] : scaled_value(r, samples[j]);
  }
}

void RationalApproximation::find_weights()
{
  const std::size_t n = samples.size() - support.size(), m = support.size();
  DenseComplexMatrix loewner(values.size() * n, m);
  std::size_t row = 0;
  for (std::size_t j = 0; j < samples.size(); ++j)
    for (std::size_t r = 0; !is_support[j] && r < values.size(); ++r)
    {
      for (std::size_t k = 0; k < m; ++k)
        loewner(row, k) =
            (values[r][j] - values[r][support[k]]) / (samples[j] - samples[support[k]]);
      ++row;
    }
  weights = smallest_singular_vector(std::move(loewner)).vector;
  const bool is_symmetric =
      is_real && std::all_of(support.begin(), support.end(),
                             [this](const std::size_t k) { return is_support[mirror[k]]; });
  if (!is_symmetric)
    return;
  // The vector is free by a factor, and by more where several singular values are equal: of a real
  // system the weights of conjugate points can be conjugate.
  std::vector<std::size_t> place(samples.size());
  for (std::size_t k = 0; k < m; ++k)
    place[support[k]] = k;
  std::vector<Complex> even(m), odd(m);
  double size = 0.;
  for (std::size_t k = 0; k < m; ++k)
  {
    const Complex other = std::conj(weights[place[mirror[support[k]]]]);
    even[k] = 0.5 * (weights[k] + other);
    odd[k] = Complex(0., -0.5) * (weights[k] - other);
    size += std::norm(even[k]);
  }
  // The squares of both parts have the sum one.
  weights = size >= 0.5 ? even : odd;
}

Complex RationalApproximation::scaled_value(const std::size_t response, const Complex s) const
{
  Complex numerator = 0., denominator = 0.;
  for (std::size_t k = 0; k < support.size(); ++k)
  {
    const Complex difference = s - samples[support[k]];
    if (difference == 0.)
      return values[response][support[k]];
    const Complex term = weights[k] / difference;
    numerator += term * values[response][support[k]];
    denominator += term;
  }
  return numerator / denominator;
}

Complex RationalApproximation::scaled_residue(const std::size_t response, const Complex pole) const
{
  Complex numerator = 0., derivative = 0.;
  for (std::size_t k = 0; k < support.size(); ++k)
  {
    const Complex term = weights[k] / (pole - samples[support[k]]);
    numerator += term * values[response][support[k]];
    derivative -= term / (pole - samples[support[k]]);
  }
  return numerator / derivative;
}

void RationalApproximation::find_poles()
{
  pole_places.clear();
  const std::size_t m = support.size();
  if (m < 2)
    return;
  DenseComplexMatrix arrowhead(m + 1, m + 1), diagonal(m + 1, m + 1);
  for (std::size_t k = 0; k < m; ++k)
  {
    arrowhead(0, k + 1) = weights[k];
    arrowhead(k + 1, 0) = 1.;
    arrowhead(k + 1, k + 1) = samples[support[k]];
    diagonal(k + 1, k + 1) = 1.;
  }
  pole_places = generalised_eigenvalues(std::move(arrowhead), std::move(diagonal));
  // Two are infinite, though round-off makes them finite: m - 1 poles remain.
  pole_places.resize(m - 1);
  while (!pole_places.empty() && !std::isfinite(std::abs(pole_places.back())))
    pole_places.pop_back();
}

void RationalApproximation::remove_doublets(const double doublet)
{
  std::vector<double> means;
  for (const std::vector<Complex> &row : values)
  {
    double sum = 0.;
    std::size_t n = 0;
    for (const Complex &value : row)
      if (value != 0.)
      {
        sum += std::log(std::abs(value));
        ++n;
      }
    means.push_back(n > 0 ? std::exp(sum / n) : 1.);
  }
  std::vector<bool> removed(samples.size(), false);
  for (const Complex &pole : pole_places)
  {
    double distance = std::abs(pole - samples[0]);
    for (const Complex &sample : samples)
      distance = std::min(distance, std::abs(pole - sample));
    bool is_doublet = true;
    for (std::size_t r = 0; r < values.size(); ++r)
      is_doublet = is_doublet && std::abs(scaled_residue(r, pole)) < doublet * means[r] * distance;
    if (!is_doublet)
      continue;
    // One support point less for each doublet: of a pair the other one may be needed.
    std::size_t nearest = samples.size();
    for (const std::size_t k : support)
      if (!removed[k] && (nearest == samples.size() ||
                          std::abs(samples[k] - pole) < std::abs(samples[nearest] - pole)))
        nearest = k;
    removed[nearest] = true;
  }
  std::vector<std::size_t> kept;
  for (const std::size_t k : support)
    if (!removed[k])
      kept.push_back(k);
  if (kept.size() == support.size() || kept.empty())
    return;
  support = kept;
  for (std::size_t j = 0; j < samples.size(); ++j)
    is_support[j] = is_support[j] && !removed[j];
  find_weights();
  find_poles();
}

void RationalApproximation::measure()
{
  largest_error = 0.;
  for (std::size_t j = 0; j < samples.size(); ++j)
    for (std::size_t r = 0; r < values.size(); ++r)
      largest_error = std::max(largest_error, std::abs(values[r][j] - scaled_value(r, samples[j])));
  for (Complex &pole : pole_places)
    pole *= unit;
}

Complex RationalApproximation::value(const std::size_t response, const Complex s) const
{
  return scales[response] * scaled_value(response, s / unit);
}

std::vector<Complex> RationalApproximation::residues(const std::size_t response) const
{
  std::vector<Complex> result;
  for (const Complex &pole : pole_places)
    result.push_back(scales[response] * unit * scaled_residue(response, pole / unit));
  return result;
}

double damping_ratio(const Complex s)
{
  return -s.real() / std::abs(s);
}
} // namespace Continua
