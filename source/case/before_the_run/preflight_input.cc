#include <continua/case/before_the_run/preflight_input.h>

#include <continua/case/theory/tube_wave_case.h>
#include <continua/mesh/coordinates.h>
#include <continua/mesh/tube_extents.h>
#include <continua/signal/energy_frequency.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace Continua
{
using namespace dealii;

namespace
{
constexpr double smallest_number_of_samples = 1 << 10;
constexpr double largest_number_of_samples = 1 << 18;

template <int dim>
std::set<unsigned int> fluids_of(const Case<dim> &input)
{
  std::set<unsigned int> fluids;
  for (unsigned int i = 0; i < input.problem.materials.size(); ++i)
    if (!input.problem.materials[i].is_solid())
      fluids.insert(i);
  return fluids;
}

Step regular_step(const TimeParameters &time)
{
  switch (time.scheme)
  {
  case Scheme::crank_nicolson:
    return crank_nicolson_step(0., time.time_step);
  case Scheme::backward_differencing:
    return backward_differencing_step(0., time.time_step, time.time_step, time.update_type());
  default:
    return euler_step(0., time.time_step, time.update_type());
  }
}

template <int dim>
std::vector<PreflightInput::Region> regions_of(const Case<dim> &input, const double refinement)
{
  std::vector<PreflightInput::Region> regions;
  for (unsigned int i = 0; i < input.problem.regions.size(); ++i)
    regions.push_back({input.problem.regions[i], input.problem.materials[i], 0.,
                       std::numeric_limits<double>::max()});
  for (const auto &cell : input.triangulation->cell_iterators_on_level(0))
  {
    PreflightInput::Region &region = regions[cell->material_id()];
    region.smallest_cell =
        std::min(region.smallest_cell, cell->minimum_vertex_distance() / refinement);
    const BoundingBox<dim> box = cell->bounding_box();
    for (unsigned int c = 0; c < dim; ++c)
      region.largest_cell = std::max(region.largest_cell, box.side_length(c) / refinement);
  }
  return regions;
}

/// The centre of that face of the condition's boundary which is closest to the middle of them all.
template <int dim>
std::array<double, 3> middle_of(const Case<dim> &input, const BoundaryCondition &condition)
{
  std::vector<Point<dim>> centers;
  Point<dim> mean;
  for (const auto &cell : input.triangulation->cell_iterators_on_level(0))
    for (const unsigned int f : cell->face_indices())
      if (cell->at_boundary(f) && cell->face(f)->boundary_id() == condition.boundary_id &&
          condition.region_ids.count(cell->material_id()) > 0)
      {
        centers.push_back(cell->face(f)->center());
        mean += centers.back();
      }
  if (centers.empty())
    return {{0., 0., 0.}};
  mean /= centers.size();
  const auto closest = std::min_element(centers.begin(), centers.end(),
                                        [&mean](const Point<dim> &a, const Point<dim> &b) {
                                          return a.distance_square(mean) < b.distance_square(mean);
                                        });
  return coordinates(*closest);
}

bool depends_on_time(const BoundaryCondition &condition)
{
  return condition.normal.depends_on_time() || condition.tangential.depends_on_time() ||
         (condition.free_flow && condition.free_flow->rate.depends_on_time());
}

const BoundaryCondition *load_of(const std::vector<BoundaryCondition> &conditions,
                                 const std::set<unsigned int> &fluids)
{
  const BoundaryCondition *load = nullptr;
  for (const BoundaryCondition &condition : conditions)
  {
    if (!depends_on_time(condition))
      continue;
    if (std::any_of(condition.region_ids.begin(), condition.region_ids.end(),
                    [&fluids](const unsigned int id) { return fluids.count(id) > 0; }))
      return &condition;
    if (load == nullptr)
      load = &condition;
  }
  return load;
}

/// Samples the component of the load that varies most.
void sample_load(const BoundaryCondition &load,
                 const std::array<double, 3> &point,
                 PreflightInput &preflight)
{
  std::vector<Waveform> components;
  if (load.free_flow)
    components.push_back(load.free_flow->rate);
  for (const BoundaryPart *part : {&load.normal, &load.tangential})
  {
    components.push_back(part->along_normal);
    components.insert(components.end(), part->vector.begin(), part->vector.end());
  }
  const double n = std::max(smallest_number_of_samples,
                            std::min(largest_number_of_samples,
                                     std::ceil(4. * preflight.end_time / preflight.step.size())));
  const double interval = preflight.end_time / n;
  std::vector<double> samples;
  double range = 0.;
  for (const Waveform &component : components)
  {
    if (!component.depends_on_time())
      continue;
    const std::vector<double> values =
        samples_of_whole_pulse([&](const double time) { return component(point.data(), time); },
                               preflight.end_time, static_cast<std::size_t>(n));
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    if (*high - *low > range)
    {
      range = *high - *low;
      samples = values;
    }
  }
  preflight.frequency = energy_frequency(samples, interval);
  for (std::size_t i = 1; i < samples.size(); ++i)
    preflight.load_jumps =
        preflight.load_jumps || std::abs(samples[i] - samples[i - 1]) > 0.3 * range;
}

/// The condition on the part of a boundary next to a region; null if there is none.
const BoundaryCondition *condition_on(const std::vector<BoundaryCondition> &conditions,
                                      const unsigned int boundary,
                                      const unsigned int region)
{
  for (const BoundaryCondition &condition : conditions)
    if (condition.boundary_id == boundary && condition.region_ids.count(region) > 0)
      return &condition;
  return nullptr;
}

bool is_fixed(const BoundaryCondition *condition)
{
  return condition != nullptr && condition->normal.kind == BoundaryPart::Kind::velocity &&
         condition->tangential.kind == BoundaryPart::Kind::velocity;
}

PreflightInput::End
end_of(const Problem &problem, const TubeExtents::End &extents, const double refinement)
{
  PreflightInput::End end;
  end.section.inner_radius = extents.inner_radius;
  end.section.fluid = problem.materials[extents.fluid_region];
  for (const TubeExtents::Layer &layer : extents.layers)
  {
    end.section.layer_thicknesses.push_back(layer.thickness);
    end.section.layers.push_back(problem.materials[layer.region]);
  }
  end.boundary = problem.boundaries[extents.fluid_boundary];
  const BoundaryCondition *fluid =
      condition_on(problem.conditions, extents.fluid_boundary, extents.fluid_region);
  end.flow_is_given = fluid != nullptr && (fluid->normal.kind == BoundaryPart::Kind::velocity ||
                                           fluid->free_flow.has_value());
  if (fluid != nullptr)
  {
    end.outlet = fluid->outlet;
    end.rim_is_held = fluid->tangential.kind == BoundaryPart::Kind::velocity;
  }
  end.wall_is_clamped = is_fixed(
      condition_on(problem.conditions, extents.wall_boundary, extents.layers.front().region));
  end.wall_cell = extents.wall_cell / refinement;
  return end;
}
} // namespace

template <int dim>
bool has_fluid_and_solid(const Case<dim> &input)
{
  const std::size_t n_fluids = fluids_of(input).size();
  return n_fluids > 0 && n_fluids < input.problem.materials.size();
}

template <int dim>
PreflightInput preflight_input(const Case<dim> &input)
{
  const std::set<unsigned int> fluids = fluids_of(input);
  const double refinement = std::pow(2., input.mesh.refinements);
  PreflightInput preflight;
  preflight.regions = regions_of(input, refinement);
  preflight.velocities_per_cell = input.discretisation.velocities_per_cell();
  preflight.step = regular_step(input.time);
  preflight.end_time = input.time.end_time;

  const BoundaryCondition *load = load_of(input.problem.conditions, fluids);
  if (load != nullptr)
  {
    preflight.load = input.problem.boundaries[load->boundary_id];
    sample_load(*load, middle_of(input, *load), preflight);
  }

  TubeExtents extents;
  preflight.is_tube = (input.problem.model == Model::axisymmetric ||
                       input.problem.model == Model::three_dimensional) &&
                      find_tube(*input.triangulation, fluids, extents);
  if (!preflight.is_tube)
    return preflight;
  // A wall whose outer surface cannot move across is none that a wave could widen.
  const BoundaryCondition *outside =
      condition_on(input.problem.conditions, extents.outer_boundary, extents.outer_region);
  const bool is_held =
      outside != nullptr && outside->tangential.kind == BoundaryPart::Kind::velocity;
  preflight.is_tube = outside == nullptr || outside->normal.kind == BoundaryPart::Kind::traction;
  if (!preflight.is_tube)
    return preflight;
  preflight.starts_loaded =
      input.problem.finds_unloaded_shape() || (input.problem.deformation == Deformation::finite &&
                                               input.problem.interior.starts_steady_under_loads);
  preflight.length = extents.length();
  preflight.axial_cell = extents.axial_cell / refinement;
  preflight.normal_cell = extents.normal_cell / refinement;
  for (unsigned int i = 0; i < 2; ++i)
  {
    preflight.ends[i] = end_of(input.problem, extents.ends[i], refinement);
    if (outside != nullptr)
      set_hold(*outside, preflight.ends[i].section);
    preflight.ends[i].section.tethered = is_held;
  }
  if (load != nullptr && preflight.ends[1].boundary == preflight.load)
    std::swap(preflight.ends[0], preflight.ends[1]);
  return preflight;
}

template bool has_fluid_and_solid<2>(const Case<2> &);
template bool has_fluid_and_solid<3>(const Case<3> &);
template PreflightInput preflight_input<2>(const Case<2> &);
template PreflightInput preflight_input<3>(const Case<3> &);
} // namespace Continua
