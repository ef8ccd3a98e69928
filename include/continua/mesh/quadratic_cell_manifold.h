#ifndef continua_mesh_quadratic_cell_manifold_h
#define continua_mesh_quadratic_cell_manifold_h

#include <deal.II/base/utilities.h>
#include <deal.II/grid/manifold.h>

#include <array>
#include <vector>

namespace Continua
{
/**
 * A cell of second order with its 3^dim nodes, as a manifold: the chart is the unit cell, and the
 * map to the body is the polynomial of degree 2 in each direction through the nodes. New points lie
 * where the map has the mean of the chart's points. All children of the cell, and a mapping of
 * degree 2 or more on each of them, therefore keep the shape of the cell exactly.
 *
 * A face between two such cells has the same map from both, since its nodes are the same, so that
 * either manifold may stand for it.
 */
template <int dim>
class QuadraticCellManifold : public dealii::ChartManifold<dim, dim, dim>
{
public:
  static constexpr unsigned int n_nodes = dealii::Utilities::pow(3, dim);
  /// Node i + 3 j + 9 k at the chart's point (i/2, j/2, k/2) [m].
  using Nodes = std::array<dealii::Point<dim>, n_nodes>;

  explicit QuadraticCellManifold(const Nodes &nodes);

  /// The corners of the cell, in deal.II's order of vertices, between which a node lies: 2^n of
  /// them, where n is the number of directions in which it is in the middle.
  static std::vector<unsigned int> corners_of_node(unsigned int node);
  /// The cell with the bilinear or trilinear map between these corners.
  static Nodes straight_nodes(const std::vector<dealii::Point<dim>> &corners);

  std::unique_ptr<dealii::Manifold<dim>> clone() const override;
  /// The chart's point of a point of the cell [1], by Newton's method. Throws std::runtime_error
  /// where there is none: outside of the cell, or where the map turns over.
  dealii::Point<dim> pull_back(const dealii::Point<dim> &place) const override;
  dealii::Point<dim> push_forward(const dealii::Point<dim> &chart_point) const override;
  /// The derivatives of the place with respect to the chart's coordinates [m].
  dealii::DerivativeForm<1, dim, dim>
  push_forward_gradient(const dealii::Point<dim> &chart_point) const override;

  /// Whether the nodes lie where straight edges have them, but for round-off.
  bool is_straight() const;
  /// The smallest and the largest determinant of the derivatives [m^dim] at 6 points a direction,
  /// of which the outer ones are on the faces. A cell is valid where both are positive; where both
  /// are negative, its directions stand in the wrong order.
  std::pair<double, double> range_of_determinants() const;
  /// The same cell with other corners: the nodes between move as a bilinear or trilinear field.
  QuadraticCellManifold<dim> with_corners(const std::vector<dealii::Point<dim>> &corners) const;

private:
  /// One Newton iteration from `chart_point`; false if it does not come to `place`.
  bool search(const dealii::Point<dim> &place, dealii::Point<dim> &chart_point) const;
  std::vector<dealii::Point<dim>> corners() const;
  double size() const; ///< [m]

  const Nodes nodes;
};
} // namespace Continua

#endif
