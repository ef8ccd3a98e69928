#include <continua/mesh/plane_section.h>

#include <continua/mesh/cell_polynomial.h>
#include <continua/mesh/cells_in_tree_order.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/function.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/non_matching/quadrature_generator.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Continua
{
using namespace dealii;

namespace
{
/// A function on the whole unit cell as one on a face of it.
template <int dim>
class FaceFunction : public Function<dim - 1>
{
public:
  FaceFunction(const Function<dim> &function, const unsigned int face)
      : function(function), direction(face / 2), position(face % 2)
  {
  }
  /// The direction of the cell in which the face's direction i points.
  unsigned int cell_direction(const unsigned int i) const { return i < direction ? i : i + 1; }
  Point<dim> on_cell(const Point<dim - 1> &point) const
  {
    Point<dim> result;
    result[direction] = position;
    for (unsigned int i = 0; i + 1 < dim; ++i)
      result[cell_direction(i)] = point[i];
    return result;
  }
  double value(const Point<dim - 1> &point, const unsigned int = 0) const override
  {
    return function.value(on_cell(point));
  }
  Tensor<1, dim - 1> gradient(const Point<dim - 1> &point, const unsigned int = 0) const override
  {
    const Tensor<1, dim> in_space = function.gradient(on_cell(point));
    Tensor<1, dim - 1> result;
    for (unsigned int i = 0; i + 1 < dim; ++i)
      result[i] = in_space[cell_direction(i)];
    return result;
  }
  SymmetricTensor<2, dim - 1> hessian(const Point<dim - 1> &point,
                                      const unsigned int = 0) const override
  {
    const SymmetricTensor<2, dim> in_space = function.hessian(on_cell(point));
    SymmetricTensor<2, dim - 1> result;
    for (unsigned int i = 0; i + 1 < dim; ++i)
      for (unsigned int j = i; j + 1 < dim; ++j)
        result[i][j] = in_space[cell_direction(i)][cell_direction(j)];
    return result;
  }

private:
  const Function<dim> &function;
  const unsigned int direction;
  const double position;
};
} // namespace

/// The distance to the plane along its normal, over the size of the cell, as a polynomial on the
/// unit cell.
template <int dim>
class PlaneSection<dim>::CellPlane : public Function<dim>
{
public:
  CellPlane(const MappingQ<dim> &mapping, const Point<dim> &point, const Tensor<1, dim> &normal)
      : nodes(mapping,
              nothing,
              QGaussLobatto<dim>(mapping.get_degree() + 1),
              update_quadrature_points),
        point(point),
        normal(normal),
        distance(mapping.get_degree()),
        at_nodes(distance.n_values())
  {
    for (unsigned int d = 0; d < dim; ++d)
      coordinates.emplace_back(mapping.get_degree());
  }

  /// Whether the plane may cut the cell, by its corners.
  bool is_near(const CellIterator &cell) const
  {
    const double reach = 0.5 * cell->diameter();
    // A curved cell may reach beyond its corners.
    double lower = std::numeric_limits<double>::max(), upper = -lower;
    for (const unsigned int v : cell->vertex_indices())
    {
      const double of_vertex = (cell->vertex(v) - point) * normal;
      lower = std::min(lower, of_vertex);
      upper = std::max(upper, of_vertex);
    }
    return lower <= reach && upper >= -reach;
  }
  /// False if the plane misses the cell for certain.
  bool reinit(const CellIterator &cell)
  {
    size = cell->diameter();
    nodes.reinit(cell);
    for (unsigned int i = 0; i < at_nodes.size(); ++i)
      at_nodes[i] = (nodes.quadrature_point(i) - point) * normal / size;
    distance.set(at_nodes);
    if (!distance.may_vanish())
      return false;
    for (unsigned int d = 0; d < dim; ++d)
    {
      for (unsigned int i = 0; i < at_nodes.size(); ++i)
        at_nodes[i] = nodes.quadrature_point(i)[d];
      coordinates[d].set(at_nodes);
    }
    return true;
  }

  double value(const Point<dim> &unit, const unsigned int = 0) const override
  {
    return distance.value(unit);
  }
  Tensor<1, dim> gradient(const Point<dim> &unit, const unsigned int = 0) const override
  {
    return distance.gradient(unit);
  }
  SymmetricTensor<2, dim> hessian(const Point<dim> &unit, const unsigned int = 0) const override
  {
    return distance.hessian(unit);
  }
  /// Length of the gradient of the distance itself [m].
  double slope(const Point<dim> &unit) const { return size * gradient(unit).norm(); }

  /// The point of the body, and the derivative of the mapping [m].
  void map(const Point<dim> &unit, Point<dim> &real, Tensor<2, dim> &jacobian) const
  {
    for (unsigned int d = 0; d < dim; ++d)
    {
      real[d] = coordinates[d].value(unit);
      jacobian[d] = coordinates[d].gradient(unit);
    }
  }

private:
  const FE_Nothing<dim> nothing;
  FEValues<dim> nodes; ///< of the mapping
  const Point<dim> point;
  const Tensor<1, dim> normal;
  CellPolynomial<dim> distance;
  std::vector<CellPolynomial<dim>> coordinates; ///< of a point of the body [m]
  std::vector<double> at_nodes;                 ///< work space
  double size = 1.;
};

template <int dim>
PlaneSection<dim>::PlaneSection(const MappingQ<dim> &mapping,
                                const Triangulation<dim> &triangulation,
                                const Cells cells,
                                const std::set<unsigned int> &regions,
                                const Point<dim> &point,
                                const Tensor<1, dim> &normal,
                                const unsigned int n_points,
                                const VesselAxis<dim> *axis)
    : mapping(mapping),
      triangulation(triangulation),
      cells(cells),
      regions(regions),
      point(point),
      normal(normal / normal.norm()),
      n_points(n_points),
      axis(axis)
{
  if (axis != nullptr)
    position = axis->position(point);
  // Of the coarse mesh, which does not depend on the partition.
  std::vector<Point<dim>> vertices;
  for (const auto &cell : triangulation.cell_iterators_on_level(0))
    for (const unsigned int v : cell->vertex_indices())
      vertices.push_back(cell->vertex(v));
  const auto corners = BoundingBox<dim>(vertices).get_boundary_points();
  const double shift = 1e-9 * corners.first.distance(corners.second);
  for (const double side : {-1., 1.})
  {
    this->point = point + side * shift * this->normal;
    total_area = cut();
    if (total_area > 0.)
      break;
  }
}

template <int dim>
bool PlaneSection<dim>::exists(const MappingQ<dim> &mapping,
                               const Triangulation<dim> &triangulation,
                               const std::set<unsigned int> &regions,
                               const Point<dim> &point,
                               const Tensor<1, dim> &normal,
                               const VesselAxis<dim> *axis)
{
  return PlaneSection(mapping, triangulation, Cells::first_coarse, regions, point, normal, 2, axis)
             .area() > 0.;
}

template <int dim>
bool PlaneSection<dim>::counts(const CellIterator &cell) const
{
  return regions.empty() || regions.count(cell->material_id()) > 0;
}

template <int dim>
bool PlaneSection<dim>::is_on_axis(const CellIterator &cell) const
{
  if (axis == nullptr)
    return true;
  double lower = std::numeric_limits<double>::max(), upper = -lower;
  for (const unsigned int v : cell->vertex_indices())
  {
    // Of another branch it is not a number, and stays out of both.
    const double at_vertex = axis->position(cell->vertex(v));
    lower = std::fmin(lower, at_vertex);
    upper = std::fmax(upper, at_vertex);
  }
  // A curved cell reaches beyond its vertices.
  const double margin = 0.5 * (upper - lower);
  return lower - margin <= position && position <= upper + margin;
}

template <int dim>
double PlaneSection<dim>::cut()
{
  section_parts.clear();
  CellPlane plane(mapping, point, normal);
  const hp::QCollection<1> gauss(QGauss<1>{n_points}); // which the generator refers to
  NonMatching::QuadratureGenerator<dim> generator(gauss);
  const BoundingBox<dim> unit_cell = create_unit_bounding_box<dim>();
  double area = 0.;
  const auto cut_cell = [&](const CellIterator &cell)
  {
    if (!counts(cell) || !plane.is_near(cell) || !is_on_axis(cell) || !plane.reinit(cell))
      return;
    generator.generate(plane, unit_cell);
    const Quadrature<dim> &surface = generator.get_surface_quadrature();
    if (surface.size() == 0)
      return;
    Part part{cell, Quadrature<dim>(), std::vector<Point<dim>>(surface.size()), {}};
    std::vector<double> weights(surface.size());
    for (unsigned int q = 0; q < surface.size(); ++q)
    {
      Tensor<2, dim> jacobian;
      plane.map(surface.point(q), part.points[q], jacobian);
      // Nanson: the area of the image is det J |J^(-T) m| times that in the unit cell, and there
      // the unit normal is m = J^T n / slope.
      weights[q] = surface.weight(q) * determinant(jacobian) / plane.slope(surface.point(q));
      area += weights[q];
    }
    part.quadrature = Quadrature<dim>(surface.get_points(), weights);
    section_parts.push_back(part);
  };
  if (cells != Cells::active)
  {
    for (const auto &cell : triangulation.cell_iterators_on_level(0))
    {
      cut_cell(cell);
      if (cells == Cells::first_coarse && area > 0.)
        break;
    }
    return area;
  }
  for (const auto &cell : cells_in_tree_order(triangulation))
    if (cell->is_locally_owned())
      cut_cell(cell);
  return Utilities::MPI::sum(area, triangulation.get_communicator());
}

template <int dim>
std::vector<typename PlaneSection<dim>::Part> PlaneSection<dim>::outer_rim() const
{
  std::vector<Part> rim;
  CellPlane plane(mapping, point, normal);
  const hp::QCollection<1> gauss(QGauss<1>{n_points}); // which the generator refers to
  NonMatching::QuadratureGenerator<dim - 1> generator(gauss);
  const BoundingBox<dim - 1> unit_face = create_unit_bounding_box<dim - 1>();
  for (const Part &section_part : section_parts)
  {
    const CellIterator &cell = section_part.cell;
    plane.reinit(cell);
    Part part{cell, Quadrature<dim>(), {}, {}};
    std::vector<Point<dim>> unit_points;
    std::vector<double> weights;
    for (const unsigned int f : cell->face_indices())
    {
      if (!cell->at_boundary(f) && counts(cell->neighbor(f)))
        continue;
      const FaceFunction<dim> on_face(plane, f);
      generator.generate(on_face, unit_face);
      const Quadrature<dim - 1> &curve = generator.get_surface_quadrature();
      for (unsigned int q = 0; q < curve.size(); ++q)
      {
        const Point<dim> unit = on_face.on_cell(curve.point(q));
        Point<dim> real;
        Tensor<2, dim> jacobian;
        plane.map(unit, real, jacobian);
        // The face's outward normal, without its part across the plane.
        Tensor<1, dim> outward;
        outward[f / 2] = f % 2 == 0 ? -1. : 1.;
        outward = transpose(invert(jacobian)) * outward;
        outward -= (outward * normal) * normal;
        outward /= outward.norm();
        Tensor<1, dim> radial = real - point;
        radial -= (radial * normal) * normal;
        if (outward * radial <= 0.5 * radial.norm())
          continue;
        double stretch = 1.;
        if (dim == 3)
        {
          const Tensor<1, dim - 1> across = on_face.gradient(curve.point(q));
          Tensor<1, dim> tangent;
          tangent[on_face.cell_direction(0)] = -across[dim - 2];
          tangent[on_face.cell_direction(dim - 2)] = across[0];
          stretch = (jacobian * tangent).norm() / across.norm();
        }
        unit_points.push_back(unit);
        weights.push_back(curve.weight(q) * stretch);
        part.points.push_back(real);
        part.normals.push_back(outward);
      }
    }
    if (weights.empty())
      continue;
    part.quadrature = Quadrature<dim>(unit_points, weights);
    rim.push_back(part);
  }
  return rim;
}

template class PlaneSection<2>;
template class PlaneSection<3>;
} // namespace Continua
