#include <continua/mesh/quadratic_cell_manifold.h>

#include "../unit_test.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>

namespace test_of_quadratic_cell_manifold
{
using namespace Continua;
using dealii::Point;

namespace
{
/// A map of the plane that has degree 2 in each direction.
Point<2> map(const Point<2> &x)
{
  return {2. * x[0] + 0.3 * x[1] * x[1] + 0.2 * x[0] * x[0] * x[1] * x[1],
          x[1] - 0.25 * x[0] * x[0] + 0.4 * x[0] * x[1]};
}

/// The same in space.
Point<3> map(const Point<3> &x)
{
  const Point<2> plane = map(Point<2>(x[0], x[1]));
  return {plane[0] + 0.2 * x[2] * x[2], plane[1],
          1.5 * x[2] + 0.2 * x[0] * x[0] - 0.3 * x[1] * x[1] * x[2] * x[2]};
}

/// A cell of that map, with the corner `corner` and edges of the length `side` in the map's chart.
template <int dim>
QuadraticCellManifold<dim> cell_of_map(const Point<dim> &corner = Point<dim>(),
                                       const double side = 1.)
{
  typename QuadraticCellManifold<dim>::Nodes nodes;
  for (unsigned int node = 0; node < nodes.size(); ++node)
  {
    Point<dim> chart = corner;
    for (unsigned int d = 0, rest = node; d < dim; ++d, rest /= 3)
      chart[d] += 0.5 * side * (rest % 3);
    nodes[node] = map(chart);
  }
  return QuadraticCellManifold<dim>(nodes);
}

template <int dim>
std::vector<Point<dim>> some_points()
{
  std::vector<Point<dim>> points;
  for (const double x : {0., 0.3, 1.})
    for (const double y : {0., 0.85, 1.})
      if constexpr (dim == 2)
        points.emplace_back(x, y);
      else
        for (const double z : {0., 0.1, 0.5})
          points.emplace_back(x, y, z);
  return points;
}

template <int dim>
void check_map(const std::string &name)
{
  const QuadraticCellManifold<dim> cell = cell_of_map<dim>();
  double place = 0., back = 0., derivative = 0., new_point = 0.;
  const Point<dim> fixed = some_points<dim>()[4];
  for (const Point<dim> &point : some_points<dim>())
  {
    place = std::max(place, cell.push_forward(point).distance(map(point)));
    back = std::max(back, cell.pull_back(map(point)).distance(point));
    for (unsigned int d = 0; d < dim; ++d)
    {
      Point<dim> before = point, behind = point;
      before[d] -= 0.25;
      behind[d] += 0.25; // exact for degree 2
      const dealii::Tensor<1, dim> difference = 2. * (map(behind) - map(before));
      for (unsigned int c = 0; c < dim; ++c)
        derivative =
            std::max(derivative, std::abs(cell.push_forward_gradient(point)[c][d] - difference[c]));
    }
    new_point = std::max(new_point, cell.clone()
                                        ->get_intermediate_point(map(point), map(fixed), 0.25)
                                        .distance(map(Point<dim>(0.75 * point + 0.25 * fixed))));
  }
  check::absolute(name + ": the polynomial", place, 0., 2e-15);
  check::absolute(name + ": its derivatives", derivative, 0., 2e-14);
  check::absolute(name + ": back to the chart", back, 0., 2e-15);
  check::absolute(name + ": a new point", new_point, 0., 4e-15);
}

/// Two cells of one map beside each other, of which the right one is refined twice, the second time
/// at the common face alone. Every vertex is in the place that the map has.
template <int dim>
void check_refinement(const std::string &name, const double exact_measure)
{
  dealii::Triangulation<dim> mesh;
  std::vector<unsigned int> repetitions(dim, 1);
  repetitions[0] = 2;
  Point<dim> end;
  for (unsigned int d = 0; d < dim; ++d)
    end[d] = d == 0 ? 1. : 0.5;
  dealii::GridGenerator::subdivided_hyper_rectangle(mesh, repetitions, Point<dim>(), end);
  dealii::Triangulation<dim> chart;
  chart.copy_triangulation(mesh);
  dealii::GridTools::transform([](const Point<dim> &x) { return map(x); }, mesh);
  for (const auto &cell : mesh.active_cell_iterators())
  {
    Point<dim> corner;
    corner[0] = 0.5 * cell->index();
    cell->set_all_manifold_ids(cell->index());
    mesh.set_manifold(cell->index(), cell_of_map<dim>(corner, 0.5));
  }
  for (dealii::Triangulation<dim> *one : {&mesh, &chart})
  {
    std::next(one->begin_active())->set_refine_flag();
    one->execute_coarsening_and_refinement();
    for (const auto &cell : one->active_cell_iterators())
      if (cell->level() == 1 && cell->neighbor(0)->level() == 0)
        cell->set_refine_flag();
    one->execute_coarsening_and_refinement();
  }
  double distance = 0.;
  for (unsigned int v = 0; v < mesh.n_vertices(); ++v)
    distance = std::max(distance, mesh.get_vertices()[v].distance(map(chart.get_vertices()[v])));
  check::absolute(name + ": vertices of finer cells", distance, 0., 1e-14);

  for (const unsigned int degree : {2u, 3u})
  {
    const dealii::MappingQ<dim> mapping(degree);
    const dealii::FE_Nothing<dim> element;
    dealii::FEValues<dim> values(mapping, element, dealii::QGauss<dim>(6),
                                 dealii::update_JxW_values);
    double measure = 0.;
    for (const auto &cell : mesh.active_cell_iterators())
    {
      values.reinit(cell);
      for (const unsigned int q : values.quadrature_point_indices())
        measure += values.JxW(q);
    }
    check::relative(name + ": measure with a mapping of degree " + std::to_string(degree), measure,
                    exact_measure, 1e-13);
  }
}

template <int dim>
std::vector<Point<dim>> corners_of(const std::vector<double> &heights)
{
  std::vector<Point<dim>> corners;
  for (unsigned int v = 0; v < (1u << dim); ++v)
  {
    corners.emplace_back();
    for (unsigned int d = 0; d < dim; ++d)
      corners.back()[d] = (v >> d) & 1u;
    corners.back()[dim - 1] += heights[v];
  }
  return corners;
}
} // namespace

UNIT_TEST(quadratic_cell_manifold)
{
  check_map<2>("plane");
  check_map<3>("space");
  // The integral of the map's determinant over 0 <= x <= 1, 0 <= y <= 1/2, that is, of
  // (2 + 0.4 x y^2) (1 + 0.4 x) + (0.6 y + 0.4 x^2 y) (0.5 x - 0.4 y), term by term.
  const double area = 1.2 + 19. / 1800. + 0.01875 - 0.01 + 0.00625 - 1. / 450.;
  check_refinement<2>("plane", area);
  // In space by Gauss points of the map's own determinant.
  double volume = 0.;
  const dealii::QGauss<3> gauss(6);
  for (unsigned int q = 0; q < gauss.size(); ++q)
  {
    const double x = gauss.point(q)[0], y = 0.5 * gauss.point(q)[1], z = 0.5 * gauss.point(q)[2];
    dealii::Tensor<2, 3> gradient;
    gradient[0][0] = 2. + 0.4 * x * y * y;
    gradient[0][1] = 0.6 * y + 0.4 * x * x * y;
    gradient[0][2] = 0.4 * z;
    gradient[1][0] = -0.5 * x + 0.4 * y;
    gradient[1][1] = 1. + 0.4 * x;
    gradient[2][0] = 0.4 * x;
    gradient[2][1] = -0.6 * y * z * z;
    gradient[2][2] = 1.5 - 0.6 * y * y * z;
    volume += 0.25 * gauss.weight(q) * dealii::determinant(gradient);
  }
  check_refinement<3>("space", volume);

  using Plane = QuadraticCellManifold<2>;
  const std::vector<Point<2>> square = corners_of<2>({0., 0., 0., 0.});
  Plane::Nodes nodes = Plane::straight_nodes(square);
  check::is_true("straight", Plane(nodes).is_straight() && !cell_of_map<2>().is_straight());
  check::absolute("determinant of a square", Plane(nodes).range_of_determinants().first, 1., 1e-14);
  nodes[7][1] += 0.2;
  check::is_true("a raised node", !Plane(nodes).is_straight());
  // The top is 1 + 0.8 x (1 - x): its slope at the corner is 0.8.
  check::absolute("slope of the raised side", Plane(nodes).push_forward_gradient({0., 1.})[1][0],
                  0.8, 1e-14);
  nodes[7][1] = -0.2;
  check::is_true("sides that cross", Plane(nodes).range_of_determinants().first < 0. &&
                                         Plane(nodes).range_of_determinants().second > 0.);
  check::is_true("another order of the directions",
                 Plane(Plane::straight_nodes({{0., 0.}, {0., 1.}, {1., 0.}, {1., 1.}}))
                         .range_of_determinants()
                         .second < 0.);
  // The corners move, and what lies between them as far as they do.
  const Plane moved = cell_of_map<2>().with_corners(
      {map(Point<2>(0., 0.)), map(Point<2>(1., 0.)) + dealii::Tensor<1, 2>({0.4, 0.}),
       map(Point<2>(0., 1.)), map(Point<2>(1., 1.))});
  check::absolute(
      "moved corner",
      moved.push_forward({0.5, 0.25})
          .distance(map(Point<2>(0.5, 0.25)) + dealii::Tensor<1, 2>({0.4 * 0.5 * 0.75, 0.})),
      0., 1e-15);
  check::throws<std::runtime_error>(
      "outside",
      [] {
        cell_of_map<2>().pull_back({30., 1.});
      },
      "too distorted");
}
} // namespace test_of_quadratic_cell_manifold
