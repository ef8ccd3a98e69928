#include <continua/network/vessel.h>

#include <continua/base/six_digits.h>
#include <continua/network/limited_slopes.h>
#include <continua/network/neo_hookean_wall.h>
#include <continua/network/square_root_wall.h>
#include <continua/network/steady_profile.h>
#include <continua/network/tabulated_wall.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace Continua
{
namespace
{
double square(const double x)
{
  return x * x;
}

constexpr const char *remedy_of_load =
    "Lower the flow rates or the pressures at the terminals, or give a stiffer wall";

VesselProblem as_fast_as_the_wave(const double position)
{
  return {position, "the liquid is as fast as the wave there", remedy_of_load};
}

template <typename Wall>
class VesselWithWall : public Vessel
{
public:
  VesselWithWall(const VesselDescription &description,
                 const FlowLaw &liquid,
                 const std::function<Wall(double)> &wall);

  double steady_end_pressure(const double of_flow, const double start_pressure) const override
  {
    return steady_profile(of_flow, start_pressure).end_pressure;
  }
  void start_steady(double of_flow, double start_pressure) override;
  double largest_step() const override;
  bool reconstruct() override;
  void advance(double step, double share) override;
  VesselProblem problem() const override;
  double pressure(const End end, const double area) const override
  {
    return wall_at(end).pressure(area) + memory_pressure(end);
  }
  double stiffness(const End end, const double area) const override
  {
    return wall_at(end).stiffness(area);
  }
  double largest_pressure(const End end) const override
  {
    return wall_at(end).largest_pressure() + memory_pressure(end);
  }
  double area_at(const End end, const double pressure, const double start) const override
  {
    return wall_at(end).area(pressure - memory_pressure(end), start);
  }
  LinearEnd linear_end(End end) const override;
  const FlowLaw &flow_law() const override { return liquid; }

private:
  /// The state on one side of a face.
  struct FaceState
  {
    double area, flow, pressure;
    double stiffness; ///< dp/dA [Pa/m^2], for the speeds of waves
  };
  FlowLaw liquid;
  std::vector<Wall> centres, faces;                              ///< by cell; by face
  std::vector<double> weights;                                   ///< rho g height of the faces [Pa]
  std::vector<double> heads, head_differences, flow_differences; ///< by cell
  std::vector<FaceState> before, behind; ///< of each face, towards the start and the end
  /// What crosses a face [m^3/s], and what its jump gives to the flow rates on its two sides.
  struct Jump
  {
    double mass_flux, before, behind;
  };
  std::vector<Jump> jumps;
  VesselProblem of_faces; ///< of the last reconstruct()

  const Wall &wall_at(const End end) const
  {
    return end == End::start ? faces.front() : faces.back();
  }
  double pressure_at_centre(const unsigned int cell, const double of_area) const override
  {
    return centres[cell].pressure(of_area);
  }
  double wall_energy(const unsigned int cell, const double of_area) const override
  {
    // Gauss's rule with four points.
    constexpr double places[] = {0.339981043584856, 0.861136311594053},
                     weights[] = {0.652145154862546, 0.347854845137454};
    const Wall &wall = centres[cell];
    const double start = wall.reference_area(), half = 0.5 * (of_area - start),
                 middle = start + half;
    double sum = 0.;
    for (unsigned int i = 0; i < 2; ++i)
      sum += weights[i] *
             (wall.pressure(middle - places[i] * half) + wall.pressure(middle + places[i] * half));
    return half * sum;
  }
  double stiffness_at_face(const unsigned int face, const double of_area) const override
  {
    return faces[face].stiffness(of_area);
  }
  double head_of(const unsigned int cell) const
  {
    return centres[cell].pressure(area[cell]) + 0.5 * (weights[cell] + weights[cell + 1]) +
           dynamic_pressure(area[cell], flow[cell]);
  }
  /// rho alpha U^2/2 [Pa].
  double dynamic_pressure(const double of_area, const double of_flow) const
  {
    return 0.5 * liquid.density * liquid.momentum_correction * square(of_flow / of_area);
  }
  SteadyProfile<Wall> steady_profile(const double of_flow, const double start_pressure) const
  {
    return {name(), liquid, centres, faces, weights, cell_length(), of_flow, start_pressure};
  }
  /// With numbers that are none if there is no such state.
  FaceState face_state(const Wall &wall, double head, double of_flow, double near_area) const;
  /// Whether the liquid is slower than the wave.
  bool is_slow(const double of_area, const double of_flow, const double stiffness) const
  {
    return of_area > 0. && 2. * dynamic_pressure(of_area, of_flow) < of_area * stiffness;
  }
  /// Sets the states on the two faces of a cell with these differences over it.
  bool set_faces_of(unsigned int cell, double head_difference, double flow_difference);
  /// The change of alpha Q^2/A + integral of A dp/rho from one state to another one.
  double flux_change(const Wall &wall, const FaceState &from, const FaceState &to) const;
  Jump jump_between(const Wall &wall, const FaceState &left, const FaceState &right) const;
  /// Between the state inside an end and that on it.
  Jump jump_at(End end) const;
};

template <typename Wall>
VesselWithWall<Wall>::VesselWithWall(const VesselDescription &description,
                                     const FlowLaw &liquid,
                                     const std::function<Wall(double)> &wall)
    : Vessel(description),
      liquid(liquid),
      weights(description.n_cells + 1),
      heads(description.n_cells),
      head_differences(description.n_cells),
      flow_differences(description.n_cells),
      before(description.n_cells + 1),
      behind(description.n_cells + 1),
      jumps(description.n_cells + 1)
{
  const double cell = cell_length();
  for (unsigned int i = 0; i < description.n_cells; ++i)
    centres.push_back(wall((i + 0.5) * cell));
  for (unsigned int f = 0; f <= description.n_cells; ++f)
  {
    faces.push_back(wall(std::min(f * cell, description.length)));
    weights[f] = liquid.density * liquid.gravity * height(f * cell);
  }
}

template <typename Wall>
void VesselWithWall<Wall>::start_steady(const double of_flow, const double start_pressure)
{
  const SteadyProfile<Wall> profile = steady_profile(of_flow, start_pressure);
  area = profile.areas;
  std::fill(flow.begin(), flow.end(), of_flow);
  of_end(End::start).state = of_end(End::start).trace = {profile.start_area, of_flow};
  of_end(End::end).state = of_end(End::end).trace = {profile.end_area, of_flow};
  if (past)
    past->start_at_rest(flow);
}

template <typename Wall>
Vessel::LinearEnd VesselWithWall<Wall>::linear_end(const End end) const
{
  const unsigned int face = end == End::start ? 0 : n_cells(),
                     cell = end == End::start ? 0 : n_cells() - 1,
                     next = n_cells() == 1      ? cell
                            : end == End::start ? 1
                                                : cell - 1;
  const State &state = of_end(end).state;
  const double dynamic = dynamic_pressure(state.area, state.flow),
               speed = liquid.relative_speed(state.area * faces[face].stiffness(state.area),
                                             state.flow / state.area);
  return {1.5 * head_of(cell) - 0.5 * head_of(next) - weights[face] - dynamic,
          liquid.density * speed / state.area, dynamic};
}

template <typename Wall>
double VesselWithWall<Wall>::largest_step() const
{
  const double friction = liquid.friction();
  const bool relaxes = wall_relaxes();
  double largest = std::numeric_limits<double>::infinity();
  for (unsigned int i = 0; i < n_cells(); ++i)
  {
    double stiffness = centres[i].stiffness(area[i]);
    if (relaxes)
      stiffness *=
          1. + past->fast_share(cell_length() * std::sqrt(liquid.density / (area[i] * stiffness)));
    const double velocity = flow[i] / area[i],
                 fastest = std::abs(liquid.momentum_correction * velocity) +
                           liquid.relative_speed(area[i] * stiffness, velocity);
    largest = std::min(largest, std::min(cell_length() / fastest, area[i] / friction));
  }
  return largest;
}

template <typename Wall>
typename VesselWithWall<Wall>::FaceState VesselWithWall<Wall>::face_state(
    const Wall &wall, const double head, const double of_flow, const double near_area) const
{
  constexpr unsigned int most_iterations = 20;
  constexpr double tolerance = 1e-9; // the error after the last correction is its square
  const double factor = liquid.density * liquid.momentum_correction * square(of_flow);
  double of_area = wall.area(head - 0.5 * factor / square(near_area), near_area);
  for (unsigned int i = 0; i < most_iterations; ++i)
  {
    const PressureAndStiffness values = wall.both(of_area);
    const double inverse = 1. / of_area, dynamic = 0.5 * factor * inverse * inverse,
                 change = (head - values.pressure - dynamic) /
                          (values.stiffness - 2. * dynamic * inverse);
    of_area += change;
    if (std::abs(change) < tolerance * of_area)
      return {of_area, of_flow, head - 0.5 * factor / square(of_area), values.stiffness};
  }
  return {std::nan(""), of_flow, std::nan(""), std::nan("")};
}

template <typename Wall>
bool VesselWithWall<Wall>::set_faces_of(const unsigned int cell,
                                        const double head_difference,
                                        const double flow_difference)
{
  head_differences[cell] = head_difference;
  flow_differences[cell] = flow_difference;
  const auto at_face = [&](const unsigned int face, const double side)
  {
    return face_state(faces[face], heads[cell] + side * head_difference - weights[face],
                      flow[cell] + side * flow_difference, area[cell]);
  };
  behind[cell] = at_face(cell, -0.5);
  before[cell + 1] = at_face(cell + 1, 0.5);
  for (const FaceState *const state : {&behind[cell], &before[cell + 1]})
    if (!is_slow(state->area, state->flow, state->stiffness))
      return false;
  return true;
}

template <typename Wall>
bool VesselWithWall<Wall>::reconstruct()
{
  const unsigned int n = n_cells();
  for (unsigned int i = 0; i < n; ++i)
    heads[i] = head_of(i);
  set_limited_differences(heads, head_differences);
  set_limited_differences(flow, flow_differences);
  of_faces = {};
  for (unsigned int i = 0; i < n; ++i)
    // At a jump the slopes, each limited for itself, may together be beyond the speed of the wave.
    if (!set_faces_of(i, head_differences[i], flow_differences[i]) && !set_faces_of(i, 0., 0.))
    {
      const bool at_start = !is_slow(behind[i].area, behind[i].flow, behind[i].stiffness);
      const unsigned int face = at_start ? i : i + 1;
      of_faces = faces[face].largest_pressure() > heads[i] - weights[face]
                     ? as_fast_as_the_wave(face * cell_length())
                     : VesselProblem{face * cell_length(),
                                     "the head is above the largest pressure of the wall, " +
                                         six_digits(faces[face].largest_pressure()) + " Pa",
                                     remedy_of_load};
      return false;
    }
  of_end(End::start).trace = {behind.front().area, behind.front().flow};
  of_end(End::end).trace = {before.back().area, before.back().flow};
  return true;
}

template <typename Wall>
double VesselWithWall<Wall>::flux_change(const Wall &wall,
                                         const FaceState &from,
                                         const FaceState &to) const
{
  // Simpson over the pressure.
  const double middle = wall.area(0.5 * (from.pressure + to.pressure), 0.5 * (from.area + to.area));
  return liquid.momentum_correction * (square(to.flow) / to.area - square(from.flow) / from.area) +
         (from.area + 4. * middle + to.area) * (to.pressure - from.pressure) /
             (6. * liquid.density);
}

template <typename Wall>
typename VesselWithWall<Wall>::Jump VesselWithWall<Wall>::jump_between(const Wall &wall,
                                                                       const FaceState &left,
                                                                       const FaceState &right) const
{
  const auto speeds = [&](const FaceState &state)
  {
    const double velocity = state.flow / state.area, middle = liquid.momentum_correction * velocity,
                 relative = liquid.relative_speed(state.area * state.stiffness, velocity);
    return std::make_pair(middle - relative, middle + relative);
  };
  const auto [left_slow, left_fast] = speeds(left);
  const auto [right_slow, right_fast] = speeds(right);
  const double slow = std::min(std::min(left_slow, right_slow), 0.),
               fast = std::max(std::max(left_fast, right_fast), 0.), width = fast - slow;
  const double of_area = right.area - left.area, of_flow = right.flow - left.flow,
               of_flux = flux_change(wall, left, right), diffusion = slow * fast / width;
  return {left.flow - slow / width * of_flow + diffusion * of_area,
          -slow / width * of_flux + diffusion * of_flow,
          fast / width * of_flux - diffusion * of_flow};
}

template <typename Wall>
typename VesselWithWall<Wall>::Jump VesselWithWall<Wall>::jump_at(const End end) const
{
  const State &state = of_end(end).state;
  const Wall &wall = wall_at(end);
  const FaceState on = {state.area, state.flow, wall.pressure(state.area), 0.};
  if (end == End::start)
    return {on.flow, 0., flux_change(wall, on, behind.front())};
  return {on.flow, flux_change(wall, before.back(), on), 0.};
}

template <typename Wall>
void VesselWithWall<Wall>::advance(const double step, const double share)
{
  const unsigned int n = n_cells();
  const double ratio = step / cell_length(), friction = liquid.friction();
  jumps.front() = jump_at(End::start);
  jumps.back() = jump_at(End::end);
  for (unsigned int f = 1; f < n; ++f)
    jumps[f] = jump_between(faces[f], before[f], behind[f]);
  for (unsigned int i = 0; i < n; ++i)
  {
    const FaceState &left = behind[i], &right = before[i + 1];
    // Of alpha U dQ + A dH/rho over the cell, by Simpson.
    const double inside =
        liquid.momentum_correction * (right.flow - left.flow) *
            (left.flow / left.area + 4. * flow[i] / area[i] + right.flow / right.area) / 6. +
        (left.area + 4. * area[i] + right.area) * head_differences[i] / (6. * liquid.density);
    const double new_area = area[i] - ratio * (jumps[i + 1].mass_flux - jumps[i].mass_flux),
                 new_flow = flow[i] - ratio * (jumps[i + 1].before + jumps[i].behind + inside) -
                            step * friction * flow[i] / area[i];
    area[i] = share * old_area[i] + (1. - share) * new_area;
    flow[i] = share * old_flow[i] + (1. - share) * new_flow;
  }
}

template <typename Wall>
VesselProblem VesselWithWall<Wall>::problem() const
{
  for (unsigned int i = 0; i < n_cells(); ++i)
  {
    const double z = (i + 0.5) * cell_length();
    if (area[i] <= 0.)
      return {
          z, "the tube is closed there",
          "Lower the flow rate that is drawn off, raise the initial pressure, or give a stiffer "
          "wall"};
    if (std::isfinite(area[i]) && !std::isfinite(centres[i].stiffness(area[i])))
      return {z, "the wall law has no state at the area there, " + six_digits(area[i]) + " m^2",
              remedy_of_load};
    if (!is_slow(area[i], flow[i], centres[i].stiffness(area[i])))
      return as_fast_as_the_wave(z);
  }
  return of_faces;
}
} // namespace

template <typename Wall>
std::unique_ptr<Vessel> make_vessel(const VesselDescription &description,
                                    const FlowLaw &flow_law,
                                    const std::function<Wall(double)> &wall)
{
  return std::make_unique<VesselWithWall<Wall>>(description, flow_law, wall);
}

template std::unique_ptr<Vessel> make_vessel(const VesselDescription &,
                                             const FlowLaw &,
                                             const std::function<SquareRootWall(double)> &);
template std::unique_ptr<Vessel> make_vessel(const VesselDescription &,
                                             const FlowLaw &,
                                             const std::function<NeoHookeanWall(double)> &);
template std::unique_ptr<Vessel> make_vessel(const VesselDescription &,
                                             const FlowLaw &,
                                             const std::function<TabulatedWall(double)> &);
} // namespace Continua
