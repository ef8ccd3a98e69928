#include <continua/case/before_the_run/flow_numbers_input.h>

#include <continua/mesh/coordinates.h>
#include <continua/theory/korteweg.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/manifold.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace Continua
{
using namespace dealii;

namespace
{
constexpr unsigned int n_times_of_flow = 257, n_radii_of_flow = 65;
/// Of the mean speed, below which nothing flows through a boundary.
constexpr double tangential = 1e-6;

/// One place of a boundary.
template <int dim>
struct FlowPoint
{
  std::array<double, 3> place;
  Tensor<1, dim> normal;
  double area; ///< [m^2], in the plane [m]
};

/// The liquid's part of a boundary.
template <int dim>
struct FlowSection
{
  std::vector<FlowPoint<dim>> points;
  double area = 0.;
  double perimeter = 0.; ///< of the edges at walls [m]; in the plane their number
  double extent = 0.;    ///< [m], largest along an axis
  unsigned int liquid = 0;
};

template <int dim>
bool is_liquid(const Case<dim> &input, const unsigned int region)
{
  return !input.problem.materials[region].is_solid();
}

/// Of a coarse face: what a point of a revolved face stands for, else 1.
template <int dim>
double circumference(const Case<dim> &input, const Point<dim> &point)
{
  return input.problem.model == Model::axisymmetric ? 2. * numbers::PI * point[1] : 1.;
}

/// The edges of faces at which the liquid sticks, by the index of a line, or in 2-D of a vertex.
template <int dim>
std::set<unsigned int> edges_of_walls(const Case<dim> &input)
{
  std::set<unsigned int> walls;
  std::set<std::pair<unsigned int, unsigned int>> fixed; ///< boundary, region
  for (const BoundaryCondition &condition : input.problem.conditions)
    if (condition.normal.is_fixed() && condition.tangential.is_fixed() && !condition.normal.flow)
      for (const unsigned int region : condition.region_ids)
        fixed.insert({condition.boundary_id, region});
  for (const auto &cell : input.triangulation->cell_iterators_on_level(0))
  {
    if (!is_liquid(input, cell->material_id()))
      continue;
    for (const unsigned int f : cell->face_indices())
    {
      const bool is_wall =
          cell->at_boundary(f)
              ? fixed.count({cell->face(f)->boundary_id(), cell->material_id()}) > 0
              : !is_liquid(input, cell->neighbor(f)->material_id());
      if (!is_wall)
        continue;
      if constexpr (dim == 2)
        for (const unsigned int v : cell->face(f)->vertex_indices())
          walls.insert(cell->face(f)->vertex_index(v));
      else
        for (unsigned int l = 0; l < cell->face(f)->n_lines(); ++l)
          walls.insert(cell->face(f)->line_index(l));
    }
  }
  return walls;
}

/// Of a line that may be curved.
template <typename Line>
double length_of(const Line &line)
{
  constexpr unsigned int n_chords = 8;
  const auto &manifold = line->get_manifold();
  double length = 0.;
  auto last = line->vertex(0);
  for (unsigned int i = 1; i <= n_chords; ++i)
  {
    const auto next = i == n_chords
                          ? line->vertex(1)
                          : manifold.get_intermediate_point(line->vertex(0), line->vertex(1),
                                                            static_cast<double>(i) / n_chords);
    length += next.distance(last);
    last = next;
  }
  return length;
}

template <int dim>
FlowSection<dim> section_of(const Case<dim> &input,
                            const BoundaryCondition &condition,
                            const std::set<unsigned int> &walls)
{
  // Curved as the finer meshes will be.
  const MappingQ<dim> mapping(4);
  const FE_Nothing<dim> element;
  FEFaceValues<dim> values(mapping, element, QGauss<dim - 1>(dim == 2 ? 8 : 4),
                           update_JxW_values | update_quadrature_points | update_normal_vectors);
  FlowSection<dim> section;
  std::set<unsigned int> counted;
  Point<dim> low, high;
  for (const auto &cell : input.triangulation->cell_iterators_on_level(0))
    for (const unsigned int f : cell->face_indices())
    {
      const auto face = cell->face(f);
      if (!cell->at_boundary(f) || face->boundary_id() != condition.boundary_id ||
          condition.region_ids.count(cell->material_id()) == 0 ||
          !is_liquid(input, cell->material_id()))
        continue;
      if (section.points.empty())
        low = high = face->vertex(0);
      section.liquid = cell->material_id();
      values.reinit(cell, f);
      for (const unsigned int q : values.quadrature_point_indices())
      {
        const Point<dim> &point = values.quadrature_point(q);
        const double area = values.JxW(q) * circumference(input, point);
        section.points.push_back({coordinates(point), values.normal_vector(q), area});
        section.area += area;
      }
      for (const unsigned int v : face->vertex_indices())
      {
        for (unsigned int d = 0; d < dim; ++d)
        {
          low[d] = std::min(low[d], face->vertex(v)[d]);
          high[d] = std::max(high[d], face->vertex(v)[d]);
        }
        if constexpr (dim == 2)
          if (walls.count(face->vertex_index(v)) > 0 &&
              counted.insert(face->vertex_index(v)).second)
            section.perimeter += circumference(input, face->vertex(v));
      }
      if constexpr (dim == 3)
        for (unsigned int l = 0; l < face->n_lines(); ++l)
          if (walls.count(face->line_index(l)) > 0 && counted.insert(face->line_index(l)).second)
            section.perimeter += length_of(face->line(l));
    }
  for (unsigned int d = 0; d < dim; ++d)
    section.extent = std::max(section.extent, high[d] - low[d]);
  return section;
}

template <int dim>
void set_width(const Case<dim> &input, const FlowSection<dim> &section, FlowNumbersInput &flow)
{
  const bool is_plane = dim == 2 && input.problem.model != Model::axisymmetric;
  if (section.perimeter > 0.)
  {
    flow.duct = is_plane ? FlowNumbersInput::Duct::channel : FlowNumbersInput::Duct::pipe;
    flow.width = (is_plane ? 2. : 4.) * section.area / section.perimeter;
  }
  else
  {
    flow.duct = FlowNumbersInput::Duct::none;
    flow.width = section.extent;
  }
}

/// Mean and largest speed [m/s] at a time; the mean of what flows through, or if nothing does of
/// what moves along.
struct Speeds
{
  double mean = 0., largest = 0.;
  bool flows_in = true;
};

template <int dim>
Speeds
speeds_at(const BoundaryCondition &condition, const FlowSection<dim> &section, const double time)
{
  Speeds speeds;
  if (const FlowProfile *const profile = condition.normal.flow.get())
  {
    const std::vector<double> &amplitudes = profile->amplitudes(time);
    speeds.mean = std::abs(amplitudes.front());
    for (unsigned int i = 0; i < n_radii_of_flow; ++i)
    {
      const std::vector<double> shapes =
          profile->shapes(static_cast<double>(i) / (n_radii_of_flow - 1));
      double speed = 0.;
      for (std::size_t m = 0; m < shapes.size(); ++m)
        speed += shapes[m] * amplitudes[m];
      speeds.largest = std::max(speeds.largest, std::abs(speed));
    }
    return speeds;
  }
  if (condition.free_flow)
  {
    const double origin[3] = {0., 0., 0.};
    speeds.mean = speeds.largest =
        std::abs(condition.free_flow->fraction * condition.free_flow->rate(origin, time)) /
        section.area;
    return speeds;
  }
  const auto value_of = [&](const BoundaryPart &part, const FlowPoint<dim> &point)
  {
    Tensor<1, dim> value;
    for (unsigned int c = 0; c < part.vector.size(); ++c)
      value[c] = part.vector[c](point.place.data(), time);
    return value + part.along_normal(point.place.data(), time) * point.normal;
  };
  double flow = 0., speed_mean = 0.;
  for (const FlowPoint<dim> &point : section.points)
  {
    Tensor<1, dim> velocity;
    if (condition.normal.kind == BoundaryPart::Kind::velocity)
      velocity += (value_of(condition.normal, point) * point.normal) * point.normal;
    if (condition.tangential.kind == BoundaryPart::Kind::velocity)
    {
      const Tensor<1, dim> value = value_of(condition.tangential, point);
      velocity += value - (value * point.normal) * point.normal;
    }
    flow += velocity * point.normal * point.area;
    speed_mean += velocity.norm() * point.area;
    speeds.largest = std::max(speeds.largest, velocity.norm());
  }
  flow = std::abs(flow) / section.area;
  speed_mean /= section.area;
  speeds.flows_in = flow > tangential * speed_mean;
  speeds.mean = speeds.flows_in ? flow : speed_mean;
  return speeds;
}

/// Whether the condition gives a velocity to a liquid.
bool drives(const BoundaryCondition &condition)
{
  if (condition.free_flow)
    return true;
  for (const BoundaryPart *part : {&condition.normal, &condition.tangential})
    if (part->kind == BoundaryPart::Kind::velocity && (!part->is_zero() || part->flow))
      return condition.outlet == nullptr;
  return false;
}

template <int dim>
void set_cells(const Case<dim> &input, FlowNumbersInput &flow)
{
  flow.shortest_cell = std::numeric_limits<double>::max();
  // A cell of a higher degree counts as several of degree 2.
  const double parts =
      std::pow(2., input.mesh.refinements) * 0.5 * input.discretisation.velocities_per_cell();
  for (const auto &cell : input.triangulation->cell_iterators_on_level(0))
    if (is_liquid(input, cell->material_id()))
    {
      const BoundingBox<dim> box = cell->bounding_box();
      double longest = 0.;
      for (unsigned int c = 0; c < dim; ++c)
        longest = std::max(longest, box.side_length(c) / parts);
      flow.largest_cell = std::max(flow.largest_cell, longest);
      flow.shortest_cell = std::min(flow.shortest_cell, longest);
    }
}

/// The axis that the liquid flows along if its region is a straight duct with rigid walls, whose
/// volume is that section times its length; else `dim`.
template <int dim>
unsigned int axis_of_straight_duct(const Case<dim> &input, const FlowSection<dim> &section)
{
  for (const Material &material : input.problem.materials)
    if (material.is_solid())
      return dim;
  unsigned int axis = dim;
  for (unsigned int d = 0; d < dim; ++d)
    if (std::abs(section.points.front().normal[d]) > 1. - 1e-9)
      axis = d;
  if (axis == dim)
    return dim;
  const MappingQ<dim> mapping(4);
  const FE_Nothing<dim> element;
  FEValues<dim> values(mapping, element, QGauss<dim>(4),
                       update_JxW_values | update_quadrature_points);
  double volume = 0., low = std::numeric_limits<double>::max(), high = -low;
  for (const auto &cell : input.triangulation->cell_iterators_on_level(0))
  {
    values.reinit(cell);
    for (const unsigned int q : values.quadrature_point_indices())
      volume += values.JxW(q) * circumference(input, values.quadrature_point(q));
    for (const unsigned int v : cell->vertex_indices())
    {
      low = std::min(low, cell->vertex(v)[axis]);
      high = std::max(high, cell->vertex(v)[axis]);
    }
  }
  const double straight = section.area * (high - low);
  // The curved faces are known to this share.
  return std::abs(volume - straight) < 1e-4 * straight ? axis : dim;
}

/// A profile that stays as it is on its way through a straight duct: the cells along it do not
/// matter.
template <int dim>
void set_developed(const Case<dim> &input,
                   const BoundaryCondition &condition,
                   const FlowSection<dim> &section,
                   FlowNumbersInput &flow)
{
  using Shape = FlowProfile::Shape;
  if (!condition.profile ||
      (*condition.profile != Shape::parabolic && *condition.profile != Shape::womersley))
    return;
  const unsigned int axis = axis_of_straight_duct(input, section);
  if (axis == dim)
    return;
  flow.is_developed = true;
  flow.largest_cell = 0.;
  const double parts =
      std::pow(2., input.mesh.refinements) * 0.5 * input.discretisation.velocities_per_cell();
  for (const auto &cell : input.triangulation->cell_iterators_on_level(0))
    for (unsigned int c = 0; c < dim; ++c)
      if (c != axis)
        flow.largest_cell =
            std::max(flow.largest_cell, cell->bounding_box().side_length(c) / parts);
}

template <int dim>
void set_liquid(const Case<dim> &input, const unsigned int region, FlowNumbersInput &flow)
{
  const Material &liquid = input.problem.materials[region];
  flow.density = liquid.density;
  flow.viscosity = liquid.shear.viscosity;
  flow.has_flow_curve = liquid.shear.flow_curve.has_value();
  flow.wave_speed = 0.;
  if (!liquid.is_incompressible())
  {
    flow.wave_speed = acoustic_speed(liquid.density, liquid.inverse_bulk_modulus());
    flow.wave = "sound";
  }
}
} // namespace

template <int dim>
FlowNumbersInput flow_numbers_input(const Case<dim> &input)
{
  FlowNumbersInput flow;
  set_cells(input, flow);
  if (input.analysis.is_transient())
    flow.time_step = input.time.time_step;
  flow.convects_explicitly = input.problem.convection.is_explicit();
  const std::set<unsigned int> walls = edges_of_walls(input);
  double largest = 0.;
  bool has_section = false;
  for (const BoundaryCondition &condition : input.problem.conditions)
  {
    const FlowSection<dim> section = section_of(input, condition, walls);
    if (section.points.empty())
      continue;
    if (condition.type == BoundaryType::absorbing)
      flow.has_absorbing_end = true;
    FlowNumbersInput candidate = flow;
    set_width(input, section, candidate);
    set_liquid(input, section.liquid, candidate);
    set_developed(input, condition, section, candidate);
    if (!drives(condition))
    {
      // What flows in by a pressure has its section at least.
      if (condition.normal.kind == BoundaryPart::Kind::traction && !has_section &&
          flow.boundary.empty())
      {
        has_section = true;
        flow = candidate;
      }
      continue;
    }
    const bool varies = condition.normal.depends_on_time() ||
                        condition.tangential.depends_on_time() ||
                        (condition.free_flow && condition.free_flow->rate.depends_on_time());
    const unsigned int n_times = varies && input.analysis.is_transient() ? n_times_of_flow : 1;
    Speeds speeds;
    double largest_speed = 0.;
    for (unsigned int i = 0; i < n_times; ++i)
    {
      const double time = n_times == 1 ? 0. : input.time.end_time * i / (n_times - 1);
      const Speeds present = speeds_at(condition, section, time);
      largest_speed = std::max(largest_speed, present.largest);
      if (present.mean > speeds.mean)
        speeds = present;
    }
    if (speeds.mean * candidate.width <= largest)
      continue;
    largest = speeds.mean * candidate.width;
    flow = candidate;
    flow.boundary = condition.name;
    flow.flows_in = speeds.flows_in;
    flow.mean_speed = speeds.mean;
    flow.largest_speed = largest_speed;
    if (!flow.flows_in)
    {
      flow.duct = FlowNumbersInput::Duct::none;
      flow.width = section.extent;
    }
  }
  if (flow.density == 0.)
    for (unsigned int region = 0; region < input.problem.materials.size(); ++region)
      if (is_liquid(input, region))
        set_liquid(input, region, flow);
  return flow;
}

template FlowNumbersInput flow_numbers_input<2>(const Case<2> &);
template FlowNumbersInput flow_numbers_input<3>(const Case<3> &);
} // namespace Continua
