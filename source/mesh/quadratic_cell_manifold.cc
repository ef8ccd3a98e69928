#include <continua/mesh/quadratic_cell_manifold.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace Continua
{
using dealii::Point;

namespace
{
/// The three polynomials of degree 2 on [0, 1] that are 1 at 0, 1/2 or 1.
std::array<double, 3> quadratic_values(const double x)
{
  return {{(2. * x - 1.) * (x - 1.), 4. * x * (1. - x), x * (2. * x - 1.)}};
}

std::array<double, 3> quadratic_derivatives(const double x)
{
  return {{4. * x - 3., 4. - 8. * x, 4. * x - 1.}};
}

/// The place of a node along each direction: 0, 1 or 2.
template <int dim>
const std::array<unsigned int, dim> &steps_of_node(const unsigned int node)
{
  constexpr unsigned int n_nodes = QuadraticCellManifold<dim>::n_nodes;
  static const std::array<std::array<unsigned int, dim>, n_nodes> table = []
  {
    std::array<std::array<unsigned int, dim>, n_nodes> all;
    for (unsigned int i = 0; i < n_nodes; ++i)
      for (unsigned int d = 0, rest = i; d < dim; ++d, rest /= 3)
        all[i][d] = rest % 3;
    return all;
  }();
  return table[node];
}
} // namespace

template <int dim>
QuadraticCellManifold<dim>::QuadraticCellManifold(const Nodes &nodes) : nodes(nodes)
{
}

template <int dim>
std::vector<unsigned int> QuadraticCellManifold<dim>::corners_of_node(const unsigned int node)
{
  const auto &steps = steps_of_node<dim>(node);
  std::vector<unsigned int> corners;
  for (unsigned int corner = 0; corner < (1u << dim); ++corner)
  {
    bool counts = true;
    for (unsigned int d = 0; d < dim; ++d)
      counts = counts && (steps[d] == 1 || steps[d] == 2 * ((corner >> d) & 1u));
    if (counts)
      corners.push_back(corner);
  }
  return corners;
}

template <int dim>
typename QuadraticCellManifold<dim>::Nodes
QuadraticCellManifold<dim>::straight_nodes(const std::vector<Point<dim>> &corners)
{
  Nodes result;
  for (unsigned int node = 0; node < n_nodes; ++node)
  {
    const std::vector<unsigned int> between = corners_of_node(node);
    for (const unsigned int corner : between)
      result[node] += corners[corner] / static_cast<double>(between.size());
  }
  return result;
}

template <int dim>
std::unique_ptr<dealii::Manifold<dim>> QuadraticCellManifold<dim>::clone() const
{
  return std::make_unique<QuadraticCellManifold<dim>>(nodes);
}

template <int dim>
Point<dim> QuadraticCellManifold<dim>::push_forward(const Point<dim> &chart_point) const
{
  std::array<std::array<double, 3>, dim> values;
  for (unsigned int d = 0; d < dim; ++d)
    values[d] = quadratic_values(chart_point[d]);
  Point<dim> place;
  for (unsigned int node = 0; node < n_nodes; ++node)
  {
    const auto &steps = steps_of_node<dim>(node);
    double value = 1.;
    for (unsigned int d = 0; d < dim; ++d)
      value *= values[d][steps[d]];
    place += value * nodes[node];
  }
  return place;
}

template <int dim>
dealii::DerivativeForm<1, dim, dim>
QuadraticCellManifold<dim>::push_forward_gradient(const Point<dim> &chart_point) const
{
  std::array<std::array<double, 3>, dim> values, derivatives;
  for (unsigned int d = 0; d < dim; ++d)
  {
    values[d] = quadratic_values(chart_point[d]);
    derivatives[d] = quadratic_derivatives(chart_point[d]);
  }
  dealii::DerivativeForm<1, dim, dim> gradient;
  for (unsigned int node = 0; node < n_nodes; ++node)
  {
    const auto &steps = steps_of_node<dim>(node);
    for (unsigned int along = 0; along < dim; ++along)
    {
      double derivative = 1.;
      for (unsigned int d = 0; d < dim; ++d)
        derivative *= (d == along ? derivatives : values)[d][steps[d]];
      for (unsigned int component = 0; component < dim; ++component)
        gradient[component][along] += derivative * nodes[node][component];
    }
  }
  return gradient;
}

template <int dim>
bool QuadraticCellManifold<dim>::search(const Point<dim> &place, Point<dim> &chart_point) const
{
  constexpr unsigned int most_steps = 50, most_halvings = 10;
  constexpr double round_off = std::numeric_limits<double>::epsilon();
  double distance = push_forward(chart_point).distance(place);
  for (unsigned int step = 0; step < most_steps && distance > 0.; ++step)
  {
    const dealii::Tensor<2, dim> gradient = push_forward_gradient(chart_point);
    if (dealii::determinant(gradient) == 0.)
      return false;
    const dealii::Tensor<1, dim> change =
        dealii::invert(gradient) * (place - push_forward(chart_point));
    if (change.norm() < 2. * round_off * (1. + place.norm() / size()))
      break;
    double factor = 1.;
    bool is_nearer = false;
    for (unsigned int i = 0; i < most_halvings && !is_nearer; ++i, factor *= 0.5)
    {
      const Point<dim> candidate = chart_point + factor * change;
      const double rest = push_forward(candidate).distance(place);
      is_nearer = rest < distance;
      if (is_nearer)
      {
        chart_point = candidate;
        distance = rest;
      }
    }
    // Round-off is left, or a place that no point of the chart has.
    if (!is_nearer)
      break;
  }
  return distance <= 1e-12 * (size() + place.norm());
}

template <int dim>
Point<dim> QuadraticCellManifold<dim>::pull_back(const Point<dim> &place) const
{
  // From the nearest node; from another one if that leads elsewhere.
  std::array<unsigned int, n_nodes> order;
  std::iota(order.begin(), order.end(), 0u);
  std::array<double, n_nodes> distances;
  for (unsigned int node = 0; node < n_nodes; ++node)
    distances[node] = nodes[node].distance_square(place);
  const auto nearest_first = [&distances](const unsigned int a, const unsigned int b)
  { return distances[a] < distances[b]; };
  std::sort(order.begin(), order.end(), nearest_first);
  for (const unsigned int node : order)
  {
    const auto &steps = steps_of_node<dim>(node);
    Point<dim> chart_point;
    for (unsigned int d = 0; d < dim; ++d)
      chart_point[d] = 0.5 * steps[d];
    if (search(place, chart_point) &&
        dealii::GeometryInfo<dim>::is_inside_unit_cell(chart_point, 1e-6))
      return chart_point;
  }
  throw std::runtime_error("a point is in no place of the curved cell of second order that it "
                           "belongs to: the cell is too distorted");
}

template <int dim>
bool QuadraticCellManifold<dim>::is_straight() const
{
  const Nodes straight = straight_nodes(corners());
  const double length = size();
  for (unsigned int node = 0; node < n_nodes; ++node)
    if (nodes[node].distance(straight[node]) >
        1e-13 * length + 4. * std::numeric_limits<double>::epsilon() * nodes[node].norm())
      return false;
  return true;
}

template <int dim>
std::pair<double, double> QuadraticCellManifold<dim>::range_of_determinants() const
{
  // The determinant is a polynomial of degree 3 (in three dimensions 5) in each direction.
  static const dealii::QGaussLobatto<dim> points(6);
  std::pair<double, double> range(std::numeric_limits<double>::max(),
                                  std::numeric_limits<double>::lowest());
  for (const Point<dim> &point : points.get_points())
  {
    const double determinant = push_forward_gradient(point).determinant();
    range.first = std::min(range.first, determinant);
    range.second = std::max(range.second, determinant);
  }
  return range;
}

template <int dim>
QuadraticCellManifold<dim>
QuadraticCellManifold<dim>::with_corners(const std::vector<Point<dim>> &corners) const
{
  const Nodes before = straight_nodes(this->corners()), after = straight_nodes(corners);
  Nodes moved = nodes;
  for (unsigned int node = 0; node < n_nodes; ++node)
    moved[node] += after[node] - before[node];
  return QuadraticCellManifold<dim>(moved);
}

template <int dim>
std::vector<Point<dim>> QuadraticCellManifold<dim>::corners() const
{
  std::vector<Point<dim>> result(1u << dim);
  for (unsigned int node = 0; node < n_nodes; ++node)
    if (const std::vector<unsigned int> corners = corners_of_node(node); corners.size() == 1)
      result[corners.front()] = nodes[node];
  return result;
}

template <int dim>
double QuadraticCellManifold<dim>::size() const
{
  return nodes.front().distance(nodes.back());
}

template class QuadraticCellManifold<2>;
template class QuadraticCellManifold<3>;
} // namespace Continua
