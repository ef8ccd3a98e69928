#include <continua/mesh/tube_extents.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace Continua
{
using namespace dealii;

namespace
{
/// What is counted as equal, relative to the tube's length along x and to its radius across.
constexpr double tolerance = 1e-6;
constexpr double roundness = 0.01;

struct AxialRange
{
  double low = std::numeric_limits<double>::max();
  double high = std::numeric_limits<double>::lowest();

  void add(const double value)
  {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  bool empty() const { return low > high; }
};

template <int dim>
double radius_of(const Point<dim> &point)
{
  double sum = 0.;
  for (unsigned int c = 1; c < dim; ++c)
    sum += point[c] * point[c];
  return std::sqrt(sum);
}

template <typename Object>
AxialRange axial_range(const Object &object)
{
  AxialRange range;
  for (unsigned int v = 0; v < object->n_vertices(); ++v)
    range.add(object->vertex(v)[0]);
  return range;
}

/// Collects the measures of one end of the tube, cell by cell.
template <int dim>
class EndFinder
{
public:
  EndFinder(const double x, const double length) : length(length) { end.x = x; }

  void add_cell(const typename Triangulation<dim>::cell_iterator &cell, const bool is_fluid)
  {
    for (const unsigned int f : cell->face_indices())
    {
      const AxialRange range = axial_range(cell->face(f));
      if (!cell->at_boundary(f) || !is_here(range.low) || !is_here(range.high))
        continue;
      if (is_fluid)
      {
        end.fluid_boundary = cell->face(f)->boundary_id();
        end.fluid_region = cell->material_id();
        for (unsigned int v = 0; v < cell->face(f)->n_vertices(); ++v)
          fluid.add(radius_of(cell->face(f)->vertex(v)));
      }
      else
      {
        end.wall_boundary = cell->face(f)->boundary_id();
        const AxialRange cell_range = axial_range(cell);
        end.wall_cell = std::max(end.wall_cell, cell_range.high - cell_range.low);
        for (unsigned int v = 0; v < cell->face(f)->n_vertices(); ++v)
          solids[cell->material_id()].add(radius_of(cell->face(f)->vertex(v)));
      }
    }
  }

  void add_interface(const Point<dim> &vertex)
  {
    if (is_here(vertex[0]))
      interface.add(radius_of(vertex));
  }

  /// Whether it is the end of a tube.
  bool finish()
  {
    if (fluid.empty() || interface.empty() || solids.empty())
      return false;
    end.inner_radius = interface.high;
    const double slack = roundness * end.inner_radius;
    bool is_round = fluid.low <= slack && std::abs(fluid.high - end.inner_radius) <= slack &&
                    interface.high - interface.low <= slack;
    std::vector<std::pair<AxialRange, unsigned int>> layers;
    for (const auto &[region, range] : solids)
      layers.emplace_back(range, region);
    std::sort(layers.begin(), layers.end(),
              [](const auto &a, const auto &b) { return a.first.low < b.first.low; });
    double radius = end.inner_radius;
    for (const auto &[range, region] : layers)
    {
      is_round = is_round && std::abs(range.low - radius) <= slack;
      end.layers.push_back({region, range.high - range.low});
      radius = range.high;
    }
    return is_round;
  }

  TubeExtents::End end;

private:
  const double length;
  AxialRange fluid, interface;
  std::map<unsigned int, AxialRange> solids;

  bool is_here(const double x) const { return std::abs(x - end.x) <= tolerance * length; }
};
} // namespace

template <int dim>
bool find_tube(const Triangulation<dim> &triangulation,
               const std::set<unsigned int> &fluids,
               TubeExtents &extents)
{
  AxialRange body;
  for (const auto &cell : triangulation.cell_iterators_on_level(0))
  {
    const AxialRange range = axial_range(cell);
    body.add(range.low);
    body.add(range.high);
  }
  const double length = body.high - body.low;
  double outermost = 0.;
  EndFinder<dim> begin(body.low, length), end(body.high, length);
  for (const auto &cell : triangulation.cell_iterators_on_level(0))
  {
    const bool is_fluid = fluids.count(cell->material_id()) > 0;
    begin.add_cell(cell, is_fluid);
    end.add_cell(cell, is_fluid);
    if (!is_fluid)
    {
      // The outer surface has the face that is farthest from the axis as a whole.
      for (const unsigned int f : cell->face_indices())
      {
        double distance = std::numeric_limits<double>::max();
        for (unsigned int v = 0; v < cell->face(f)->n_vertices(); ++v)
          distance = std::min(distance, radius_of(cell->face(f)->vertex(v)));
        if (cell->at_boundary(f) && distance > outermost)
        {
          outermost = distance;
          extents.outer_boundary = cell->face(f)->boundary_id();
          extents.outer_region = cell->material_id();
        }
      }
      continue;
    }
    const AxialRange range = axial_range(cell);
    extents.axial_cell = std::max(extents.axial_cell, range.high - range.low);
    for (const unsigned int f : cell->face_indices())
    {
      if (cell->at_boundary(f) || fluids.count(cell->neighbor(f)->material_id()) > 0)
        continue;
      extents.normal_cell =
          std::max(extents.normal_cell, cell->measure() / cell->face(f)->measure());
      for (unsigned int v = 0; v < cell->face(f)->n_vertices(); ++v)
      {
        begin.add_interface(cell->face(f)->vertex(v));
        end.add_interface(cell->face(f)->vertex(v));
      }
    }
  }
  if (!begin.finish() || !end.finish())
    return false;
  extents.ends = {{begin.end, end.end}};
  return true;
}

template bool find_tube<2>(const Triangulation<2> &, const std::set<unsigned int> &, TubeExtents &);
template bool find_tube<3>(const Triangulation<3> &, const std::set<unsigned int> &, TubeExtents &);
} // namespace Continua
