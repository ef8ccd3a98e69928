#include <continua/base/difference_formula.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace Continua
{
namespace
{
/// Of the size of the number [1].
constexpr double relative_step = 1e-3;
} // namespace

std::vector<double> derivative_weights(const std::vector<double> &places)
{
  // Of the polynomial of Lagrange that is 1 at the place i and 0 at the others.
  std::vector<double> weights(places.size(), 0.);
  for (std::size_t i = 0; i < places.size(); ++i)
    for (std::size_t k = 0; k < places.size(); ++k)
    {
      if (k == i)
        continue;
      double product = 1. / (places[i] - places[k]);
      for (std::size_t j = 0; j < places.size(); ++j)
        if (j != i && j != k)
          product *= -places[j] / (places[i] - places[j]);
      weights[i] += product;
    }
  return weights;
}

DifferenceFormula DifferenceFormula::at(const double x, const std::function<bool(double)> &accepts)
{
  const double step = relative_step * std::abs(x);
  const std::vector<std::vector<double>> patterns = {
      {-0.5, 0.5, -1., 1.}, {0., -0.25, -0.5, -1.}, {0., 0.25, 0.5, 1.}};
  for (const std::vector<double> &pattern : patterns)
  {
    DifferenceFormula formula;
    for (const double place : pattern)
      formula.nodes.push_back(x + place * step);
    if (!std::all_of(formula.nodes.begin(), formula.nodes.end(), accepts))
      continue;
    // As they are in digits.
    std::vector<double> places;
    for (const double node : formula.nodes)
      places.push_back(node - x);
    formula.weights = derivative_weights(places);
    formula.coarser_weights = derivative_weights({places[0], places[1]});
    formula.coarser_weights.resize(places.size(), 0.);
    return formula;
  }
  throw std::invalid_argument("it may have no value beside its own");
}
} // namespace Continua
