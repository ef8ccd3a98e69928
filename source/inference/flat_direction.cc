#include <continua/inference/flat_direction.h>

#include <continua/base/quiet_gsl.h>
#include <continua/base/six_digits.h>
#include <continua/signal/gsl_release.h>

#include <gsl/gsl_linalg.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <sstream>

namespace Continua
{
namespace
{
using Direction = std::vector<double>;

/// Below this part of the largest singular value derivatives by differences are not to be trusted.
constexpr double least_singular_ratio = 1e-5;
/// A larger one is as good as infinite, in sizes of coordinates.
constexpr double largest_told_error = 10.;
/// Components below it are not named.
constexpr double least_component = 0.05;

std::string few_digits(const double value)
{
  std::ostringstream text;
  text.precision(3);
  text << value;
  return text.str();
}

double length_of_change(const std::vector<std::vector<double>> &scaled, const Direction &direction)
{
  std::vector<double> change(scaled.front().size(), 0.);
  double square = 0.;
  for (std::size_t i = 0; i < change.size(); ++i)
  {
    for (std::size_t j = 0; j < scaled.size(); ++j)
      change[i] += direction[j] * scaled[j][i];
    square += change[i] * change[i];
  }
  return std::sqrt(square);
}

/// Right singular vectors whose singular values are small.
std::vector<Direction> unseen_directions(const std::vector<std::vector<double>> &scaled,
                                         const double largest_error)
{
  const std::size_t p = scaled.size();
  const std::size_t n = std::max(scaled.front().size(), p);
  const QuietGsl quiet;
  const std::unique_ptr<gsl_matrix, GslRelease<gsl_matrix, gsl_matrix_free>> u(
      gsl_matrix_calloc(n, p)),
      v(gsl_matrix_alloc(p, p));
  const std::unique_ptr<gsl_vector, GslRelease<gsl_vector, gsl_vector_free>> s(gsl_vector_alloc(p));
  for (std::size_t j = 0; j < p; ++j)
    for (std::size_t i = 0; i < scaled[j].size(); ++i)
      gsl_matrix_set(u.get(), i, j, scaled[j][i]);
  gsl_linalg_SV_decomp_jacobi(u.get(), v.get(), s.get());
  std::vector<Direction> result;
  for (std::size_t k = 0; k < p; ++k)
  {
    const double value = gsl_vector_get(s.get(), k);
    Direction direction(p);
    double largest = 0.;
    for (std::size_t j = 0; j < p; ++j)
    {
      direction[j] = gsl_matrix_get(v.get(), j, k);
      largest = std::max(largest, std::abs(direction[j]));
    }
    if (largest <= value * largest_error &&
        value >= least_singular_ratio * gsl_vector_get(s.get(), 0))
      continue;
    result.push_back(direction);
  }
  return result;
}

/// Combines directions so that each has a parameter of its own (Gauss and Jordan, complete
/// pivoting), and divides each by its largest component.
void separate(std::vector<Direction> &directions)
{
  for (std::size_t k = 0; k < directions.size(); ++k)
  {
    std::size_t row = k;
    std::size_t column = 0;
    double largest = 0.;
    for (std::size_t i = k; i < directions.size(); ++i)
      for (std::size_t j = 0; j < directions[i].size(); ++j)
        if (std::abs(directions[i][j]) > largest)
        {
          largest = std::abs(directions[i][j]);
          row = i;
          column = j;
        }
    std::swap(directions[k], directions[row]);
    const double pivot = directions[k][column];
    for (double &component : directions[k])
      component /= pivot;
    for (std::size_t i = 0; i < directions.size(); ++i)
      if (i != k)
      {
        const double factor = directions[i][column];
        for (std::size_t j = 0; j < directions[i].size(); ++j)
          directions[i][j] -= factor * directions[k][j];
      }
  }
  for (Direction &direction : directions)
  {
    double largest = 0.;
    for (const double component : direction)
      if (std::abs(component) > std::abs(largest) * (1. + 1e-6))
        largest = component;
    for (double &component : direction)
      component /= largest;
  }
}

std::string quoted(const FitParameter &parameter)
{
  return "'" + parameter.name + "'";
}

bool is_logarithmic(const FitParameter &parameter)
{
  return parameter.scale == FitParameter::Scale::logarithmic;
}

/// What the data see of two parameters that move together.
std::string
seen_of_two(const FitParameter &a, const double by_a, const FitParameter &b, const double by_b)
{
  std::string text = quoted(a) + " and " + quoted(b) + ": the data see only ";
  if (is_logarithmic(a) && is_logarithmic(b))
  {
    const double exponent = -by_a / by_b;
    if (std::abs(exponent - 1.) < 0.05)
      return text + "their product";
    if (std::abs(exponent + 1.) < 0.05)
      return text + "their ratio";
    return text + "the product of the first and of the second to the power " + few_digits(exponent);
  }
  if (!is_logarithmic(a) && !is_logarithmic(b))
  {
    const double factor = -by_a * a.size() / (by_b * b.size());
    if (a.unit == b.unit && std::abs(factor - 1.) < 0.05)
      return text + "their sum";
    if (a.unit == b.unit && std::abs(factor + 1.) < 0.05)
      return text + "their difference";
    return text + "the sum of the first and of " + few_digits(factor) +
           (a.unit == b.unit ? "" : " " + a.unit + "/(" + b.unit + ")") + " times the second";
  }
  const FitParameter &power = is_logarithmic(a) ? a : b;
  const FitParameter &sum = is_logarithmic(a) ? b : a;
  const double change = is_logarithmic(a) ? by_b / by_a : by_a / by_b;
  return text + "one combination, since " + quoted(power) + " larger by 1 % and " + quoted(sum) +
         " larger by " + few_digits(0.01 * change * sum.size()) + " " + sum.unit +
         " change nothing together";
}

std::string sentence_of(const std::vector<FitParameter> &parameters, const FlatDirection &direction)
{
  std::vector<std::size_t> named;
  for (std::size_t j = 0; j < parameters.size(); ++j)
    if (std::abs(direction.components[j]) >= least_component)
      named.push_back(j);
  const FitParameter &first = parameters[named.front()];
  std::ostringstream text;
  if (named.size() == 1)
    text << quoted(first) << ": the data do not see it";
  else if (named.size() == 2)
    text << seen_of_two(first, direction.components[named[0]], parameters[named[1]],
                        direction.components[named[1]]);
  else
  {
    for (std::size_t k = 0; k < named.size(); ++k)
      text << (k == 0                  ? ""
               : k + 1 == named.size() ? " and "
                                       : ", ")
           << quoted(parameters[named[k]]);
    text << ": the data cannot tell them apart, since nothing changes if";
    for (std::size_t k = 0; k < named.size(); ++k)
    {
      const FitParameter &parameter = parameters[named[k]];
      const double component = direction.components[named[k]];
      text << (k == 0 ? " " : k + 1 == named.size() ? " and " : ", ") << quoted(parameter);
      if (is_logarithmic(parameter))
        text << " grows by " << few_digits(component) << " %";
      else
        text << " grows by " << few_digits(0.01 * component * parameter.size()) << " "
             << parameter.unit;
    }
    text << " together";
  }
  if (direction.standard_error < largest_told_error)
  {
    text << " (one standard error along this direction: ";
    if (is_logarithmic(first))
      text << "'" << first.name << "' by a factor of "
           << few_digits(std::exp(direction.standard_error *
                                  std::abs(direction.components[named.front()])));
    else
      text << few_digits(direction.standard_error * std::abs(direction.components[named.front()]) *
                         first.size())
           << " " << first.unit << " of " << quoted(first);
    text << ")";
  }
  text << (named.size() == 1
               ? ". Give it, or a prior of it, or data that see it."
               : ". Give one of them, or a prior of one, or data that tell them apart.");
  return text.str();
}
} // namespace

std::vector<FlatDirection> flat_directions(const std::vector<FitParameter> &parameters,
                                           const std::vector<std::vector<double>> &columns,
                                           const double flat_factor)
{
  std::vector<std::size_t> moved;
  std::vector<std::vector<double>> scaled;
  for (std::size_t j = 0; j < parameters.size(); ++j)
    if (!columns[j].empty())
    {
      moved.push_back(j);
      scaled.push_back(columns[j]);
      for (double &value : scaled.back())
        value *= parameters[j].size();
    }
  if (scaled.empty())
    return {};
  std::vector<Direction> directions = unseen_directions(scaled, std::log(flat_factor));
  separate(directions);
  std::vector<FlatDirection> result;
  for (const Direction &direction : directions)
  {
    FlatDirection flat{std::vector<double>(parameters.size(), 0.),
                       1. / length_of_change(scaled, direction), ""};
    for (std::size_t k = 0; k < moved.size(); ++k)
      flat.components[moved[k]] = direction[k];
    flat.sentence = sentence_of(parameters, flat);
    result.push_back(flat);
  }
  return result;
}
} // namespace Continua
