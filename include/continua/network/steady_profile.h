#ifndef continua_network_steady_profile_h
#define continua_network_steady_profile_h

#include <continua/network/flow_law.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace Continua
{
/**
 * A steady flow along a vessel: one flow rate, and a head p + rho g height + rho alpha U^2/2 that
 * the friction takes away, -dH/dz = rho friction Q/A^2. Marched from the start, each half of a cell
 * with the friction of the cell's centre: that is where the finite volumes of the vessel stay, up
 * to an error of second order in the cells.
 */
template <typename Wall>
struct SteadyProfile
{
  std::vector<double> areas;             ///< of the cells [m^2]
  double start_area = 0., end_area = 0.; ///< [m^2]
  double end_pressure = 0.;              ///< [Pa]

  /// `weights`: rho g height of the faces [Pa]; a cell is `cell` [m] long; the flow rate [m^3/s]
  /// and the pressure at the start [Pa]. Throws std::domain_error where the wall has no such state.
  SteadyProfile(const std::string &name,
                const FlowLaw &liquid,
                const std::vector<Wall> &centres,
                const std::vector<Wall> &faces,
                const std::vector<double> &weights,
                const double cell,
                const double flow,
                const double start_pressure)
      : name(name), liquid(liquid), flow(flow)
  {
    start_area = faces.front().area(start_pressure, faces.front().reference_area());
    if (!(start_area > 0.))
      fail("has no state under this pressure");
    double head = start_pressure + weights.front() + dynamic_pressure(start_area),
           near = start_area;
    for (std::size_t i = 0; i < centres.size(); ++i)
    {
      const double height = 0.5 * (weights[i] + weights[i + 1]);
      double loss = half_loss(cell, near);
      for (unsigned int k = 0; k < n_corrections_of_loss; ++k)
      {
        near = area_under(centres[i], head - loss - height, near);
        loss = half_loss(cell, near);
      }
      areas.push_back(near);
      head -= 2. * loss;
    }
    end_area = area_under(faces.back(), head - weights.back(), near);
    end_pressure = head - weights.back() - dynamic_pressure(end_area);
  }

private:
  /// The loss of a cell is small beside what changes its area: each correction is a small part of
  /// the one before.
  static constexpr unsigned int n_corrections_of_loss = 4;
  const std::string &name; ///< of the vessel
  const FlowLaw &liquid;
  double flow;

  [[noreturn]] void fail(const std::string &problem) const
  {
    throw std::domain_error("the wall of the vessel '" + name + "' " + problem);
  }

  double dynamic_pressure(const double area) const
  {
    return 0.5 * liquid.density * liquid.momentum_correction * flow * flow / (area * area);
  }
  /// Of the head over half a cell [Pa].
  double half_loss(const double cell, const double area) const
  {
    return 0.5 * cell * liquid.density * liquid.friction() * flow / (area * area);
  }
  /// Where the pressure and the dynamic one are `head` [Pa].
  double area_under(const Wall &wall, const double head, const double near) const
  {
    constexpr unsigned int most_iterations = 50;
    constexpr double tolerance = 1e-9; // the error after the last correction is its square
    double area = wall.area(head - dynamic_pressure(near), near);
    for (unsigned int i = 0; i < most_iterations && area > 0.; ++i)
    {
      const double dynamic = dynamic_pressure(area),
                   slope = wall.stiffness(area) - 2. * dynamic / area,
                   change = (head - wall.pressure(area) - dynamic) / slope;
      if (!(slope > 0.))
        fail("has a steady flow that is as fast as the wave");
      area += change;
      if (std::abs(change) < tolerance * area)
        return area;
    }
    fail("has no state under this pressure");
  }
};
} // namespace Continua

#endif
