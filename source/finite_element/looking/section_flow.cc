#include <continua/finite_element/looking/section_flow.h>
#include <continua/finite_element/motion/kinematics_at.h>
#include <continua/mesh/cells_in_tree_order.h>

#include <deal.II/base/mpi.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/hp/fe_values.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Continua
{
using namespace dealii;

namespace
{
/// Four ramps make the mean exact for cubic polynomials.
constexpr unsigned int most_ramps = 4;
/// What counts as the same place, relative to the length of the liquid.
constexpr double tolerance = 1e-9;
/// Below this part of the largest one a singular value is left out.
constexpr double least_singular_value = 1e-6;

/// The vector of least length with which `matrix` times it comes closest to `right_hand_side`.
std::vector<double> least_squares(const FullMatrix<double> &matrix,
                                  const std::vector<double> &right_hand_side)
{
  LAPACKFullMatrix<double> inverse(matrix.m(), matrix.n());
  inverse = matrix;
  inverse.compute_inverse_svd(least_singular_value);
  Vector<double> known(right_hand_side.begin(), right_hand_side.end()), found(matrix.n());
  inverse.vmult(found, known);
  return std::vector<double>(found.begin(), found.end());
}
} // namespace

template <int dim>
SectionFlow<dim>::SectionFlow(const Space<dim> &space,
                              const std::set<unsigned int> &regions,
                              const Point<dim> &point,
                              const Tensor<1, dim> &normal,
                              const std::shared_ptr<const VesselAxis<dim>> &axis)
    : space(space), regions(regions), point(point), normal(normal / normal.norm()), axis(axis)
{
  if (axis != nullptr)
    position = axis->position(point);
  find_ranges();
}

template <int dim>
double SectionFlow<dim>::distance(const Point<dim> &place) const
{
  return axis == nullptr ? (place - point) * normal : axis->position(place) - position;
}

template <int dim>
Tensor<1, dim> SectionFlow<dim>::direction(const Point<dim> &place) const
{
  return axis == nullptr ? normal : axis->tangent(axis->position(place));
}

template <int dim>
double SectionFlow<dim>::Ramps::value(const unsigned int ramp, const double distance) const
{
  return std::max(0., std::min(1., 0.5 - (distance - centres[ramp]) / width));
}

template <int dim>
void SectionFlow<dim>::find_ranges()
{
  // A distance along an axis is a search: once for each vertex, not for each of its cells.
  const double not_found = std::numeric_limits<double>::infinity();
  std::vector<double> at_vertices(space.triangulation.n_vertices(), not_found);
  const double no_number = std::numeric_limits<double>::quiet_NaN();
  ranges.assign(space.triangulation.n_active_cells(), {{no_number, no_number}});
  for (const auto &cell : space.triangulation.active_cell_iterators())
  {
    if (!cell->is_locally_owned() || !counts(cell))
      continue;
    std::array<double, 2> range = {
        {std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest()}};
    for (const unsigned int v : cell->vertex_indices())
    {
      double &at_vertex = at_vertices[cell->vertex_index(v)];
      if (at_vertex == not_found)
        at_vertex = distance(cell->vertex(v));
      if (std::isnan(at_vertex))
      {
        range = {{no_number, no_number}};
        break;
      }
      range = {{std::min(range[0], at_vertex), std::max(range[1], at_vertex)}};
    }
    ranges[cell->active_cell_index()] = range;
  }
}

template <int dim>
bool SectionFlow<dim>::is_near(const Ramps &ramps, const std::array<double, 2> &range)
{
  const double margin = range[1] - range[0];
  return range[0] <= ramps.end() + margin && range[1] >= ramps.begin() - margin;
}

template <int dim>
bool SectionFlow<dim>::counts(const typename Triangulation<dim>::cell_iterator &cell) const
{
  return regions.empty() || regions.count(cell->material_id()) > 0;
}

template <int dim>
typename SectionFlow<dim>::Ramps SectionFlow<dim>::ramps() const
{
  const auto largest = [this](const double value)
  { return Utilities::MPI::max(value, space.communicator); };
  double begin = std::numeric_limits<double>::max(), end = -begin;
  for (const auto &range : ranges)
    if (!std::isnan(range[0]))
    {
      begin = std::min(begin, range[0]);
      end = std::max(end, range[1]);
    }
  begin = -largest(-begin);
  end = largest(end);
  const double slack = tolerance * (end - begin);
  if (!(begin <= slack && end >= -slack))
    return {};

  // The longest cell that the plane touches, then the longest one that the ramps would.
  Ramps result;
  for (double reach = slack; reach < 2. * result.width || result.width == 0.;)
  {
    double longest = 0.;
    for (const auto &range : ranges)
      if (range[0] <= reach && range[1] >= -reach)
        longest = std::max(longest, range[1] - range[0]);
    longest = largest(longest);
    if (longest == 0.)
      return {};
    const bool is_last = reach > slack;
    result.width = longest;
    reach = 2. * longest;
    if (is_last)
      break;
  }
  const unsigned int n =
      std::max(1., std::min<double>(most_ramps, std::floor((end - begin) / result.width + 1e-6)));
  result.width = std::min(result.width, (end - begin) / n);
  double first = -0.5 * n * result.width;
  first = std::min(std::max(first, begin), end - n * result.width);
  for (unsigned int ramp = 0; ramp < n; ++ramp)
    result.centres.push_back(first + (ramp + 0.5) * result.width);
  return result;
}

template <int dim>
template <typename Add>
void SectionFlow<dim>::for_cells(const Ramps &ramps,
                                 const std::vector<DistributedVector> &nodal_values,
                                 const bool with_gradients,
                                 const Add &add) const
{
  const Quadrature<dim> quadrature = space.quadrature(space.n_quadrature_points());
  FEValues<dim> velocity(space.mapping, space.velocity_element, quadrature,
                         update_values | update_quadrature_points | update_JxW_values |
                             (with_gradients ? update_gradients : update_default));
  hp::FEValues<dim> pressure(space.mappings, space.pressure_elements,
                             hp::QCollection<dim>(quadrature), update_gradients);
  std::vector<std::vector<Tensor<1, dim>>> gradients(
      nodal_values.size(), std::vector<Tensor<1, dim>>(quadrature.size()));
  for (const auto &cell : cells_in_tree_order(space.velocity_dofs))
  {
    if (!is_near(ramps, ranges[cell->active_cell_index()]))
      continue;
    velocity.reinit(cell);
    pressure.reinit(typename DoFHandler<dim>::active_cell_iterator(
        &space.triangulation, cell->level(), cell->index(), &space.pressure_dofs));
    const FEValuesExtractors::Scalar component(space.pressure_component(cell->material_id()));
    for (unsigned int i = 0; i < nodal_values.size(); ++i)
      pressure.get_present_fe_values()[component].get_function_gradients(nodal_values[i],
                                                                         gradients[i]);
    add(cell, velocity, gradients);
  }
}

template <int dim>
std::vector<double>
SectionFlow<dim>::factors(const Ramps &ramps,
                          const std::vector<DistributedVector> &nodal_values) const
{
  const unsigned int n = ramps.centres.size();
  // The mean area over the fall of each ramp, and a line through these areas.
  std::vector<double> own_areas(n), areas(n);
  for_cells(ramps, nodal_values, false,
            [&](const auto &, const FEValues<dim> &values, const auto &gradients)
            {
              for (const unsigned int q : values.quadrature_point_indices())
              {
                const Point<dim> &x = values.quadrature_point(q);
                const Tensor<1, dim> along = direction(x);
                for (unsigned int i = 0; i < n; ++i)
                  own_areas[i] -= gradients[i][q] * along * values.JxW(q) * space.circumference(x);
              }
            });
  Utilities::MPI::sum(own_areas, space.communicator, areas);
  FullMatrix<double> line(n, 2);
  for (unsigned int i = 0; i < n; ++i)
  {
    line(i, 0) = 1.;
    line(i, 1) = ramps.centres[i] / ramps.width;
  }
  const std::vector<double> area = least_squares(line, areas);

  // The means of the powers of the distance, and with them the conditions on the factors.
  const std::size_t n_moments = static_cast<std::size_t>(n) * n;
  std::vector<double> own_moments(n_moments), moments(n_moments);
  for_cells(ramps, nodal_values, false,
            [&](const auto &, const FEValues<dim> &values, const auto &gradients)
            {
              for (const unsigned int q : values.quadrature_point_indices())
              {
                const Point<dim> &x = values.quadrature_point(q);
                const double s = distance(x) / ramps.width;
                const Tensor<1, dim> along = direction(x);
                const double share =
                    values.JxW(q) * space.circumference(x) / (area[0] + area[1] * s);
                for (unsigned int i = 0; i < n; ++i)
                  for (unsigned int k = 1; k < n; ++k)
                    own_moments[k * n + i] -= share * (gradients[i][q] * along) * std::pow(s, k);
              }
            });
  Utilities::MPI::sum(own_moments, space.communicator, moments);
  FullMatrix<double> equations(n, n);
  std::vector<double> right_hand_side(n, 0.);
  right_hand_side[0] = 1.;
  for (unsigned int i = 0; i < n; ++i)
  {
    equations(0, i) = 1.;
    for (unsigned int k = 1; k < n; ++k)
      equations(k, i) = moments[k * n + i];
  }
  std::vector<double> result = least_squares(equations, right_hand_side);
  // To the last digit, so that the function is 1 upstream.
  double sum = 0.;
  for (const double factor : result)
    sum += factor;
  for (double &factor : result)
    factor /= sum;
  return result;
}

template <int dim>
void SectionFlow<dim>::set_function(const Ramps &places)
{
  const unsigned int n_ramps = places.centres.size();
  std::vector<DistributedVector> owned_values(n_ramps, space.pressure_vector());
  std::vector<types::global_dof_index> indices;
  for (const auto &cell : space.pressure_dofs.active_cell_iterators())
  {
    if (!cell->is_locally_owned())
      continue;
    const std::array<double, 2> &range = ranges[cell->active_cell_index()];
    if (std::isnan(range[0]))
      continue;
    // Far from the ramps all nodes of a cell are before them or behind them.
    const bool near = is_near(places, range);
    const FiniteElement<dim> &element = cell->get_fe();
    indices.resize(element.n_dofs_per_cell());
    cell->get_dof_indices(indices);
    for (unsigned int i = 0; i < indices.size(); ++i)
      if (space.pressure_owned.is_element(indices[i]))
      {
        const double at_node = near ? distance(space.mapping.transform_unit_to_real_cell(
                                          cell, element.unit_support_point(i)))
                                    : range[0];
        for (unsigned int ramp = 0; ramp < n_ramps; ++ramp)
          owned_values[ramp](indices[i]) = places.value(ramp, at_node);
      }
  }
  std::vector<DistributedVector> nodal_values;
  for (DistributedVector &values : owned_values)
  {
    values.compress(VectorOperation::insert);
    nodal_values.push_back(space.ghosted_pressure(values));
  }
  const std::vector<double> factor = factors(places, nodal_values);
  DistributedVector sum = space.pressure_vector();
  for (unsigned int ramp = 0; ramp < n_ramps; ++ramp)
    sum.add(factor[ramp], owned_values[ramp]);
  function = space.ghosted_pressure(sum);
}

template <int dim>
bool SectionFlow<dim>::add_weights(DistributedVector &weights,
                                   const DistributedVector *const mesh_displacement)
{
  const Ramps places = ramps();
  if (places.centres.empty())
    return false;
  if (function.size() == 0)
    set_function(places);

  std::vector<types::global_dof_index> indices(space.velocity_element.n_dofs_per_cell());
  for_cells(places, {function}, mesh_displacement != nullptr,
            [&](const auto &cell, const FEValues<dim> &values, const auto &gradients)
            {
              cell->get_dof_indices(indices);
              std::vector<Tensor<1, dim>> slopes = gradients.front();
              for (const unsigned int q : values.quadrature_point_indices())
              {
                slopes[q] *= values.JxW(q) * space.circumference(values.quadrature_point(q));
                if (mesh_displacement == nullptr)
                  continue;
                // grad q dv = J F^-T Grad q dV.
                Tensor<1, 3> slope;
                for (unsigned int c = 0; c < dim; ++c)
                  slope[c] = slopes[q][c];
                slope = kinematics_at(space, values, q, indices, *mesh_displacement).area(slope);
                for (unsigned int c = 0; c < dim; ++c)
                  slopes[q][c] = slope[c];
              }
              for (unsigned int i = 0; i < indices.size(); ++i)
              {
                const unsigned int c = space.velocity_element.system_to_component_index(i).first;
                double weight = 0.;
                for (const unsigned int q : values.quadrature_point_indices())
                  weight -= slopes[q][c] * values.shape_value(i, q);
                if (weight != 0.)
                  space.velocity_hanging.distribute_local_to_global(indices[i], weight, weights);
              }
            });
  return true;
}

template class SectionFlow<2>;
template class SectionFlow<3>;
} // namespace Continua
