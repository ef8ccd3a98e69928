#include <continua/theory/loaded_tube.h>

#include <continua/materials/strain_law.h>

#include <deal.II/base/quadrature_lib.h>

#include <boost/math/tools/toms748_solve.hpp>

#include <gsl/gsl_integration.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <type_traits>

namespace Continua
{
using namespace dealii;

namespace
{
const Tensor<1, 3> tube_axis({1., 0., 0.}), tube_circumference({0., 1., 0.});

double square_of(const double x)
{
  return x * x;
}

/// Of a stress over a layer. It has a bend where fibres begin to bear.
const auto integrate_stress = [](const auto &integrand, const double begin, const double end)
{
  static const QIterated<1> quadrature(QGauss<1>(8), 32);
  std::decay_t<decltype(integrand(begin))> sum{};
  for (unsigned int q = 0; q < quadrature.size(); ++q)
    sum += quadrature.weight(q) * integrand(begin + quadrature.point(q)[0] * (end - begin));
  return sum * (end - begin);
};

/// Of a tangent, which has a jump there: adaptive.
const auto integrate_tangent = [](const auto &integrand, const double begin, const double end)
{
  using Integrand = std::decay_t<decltype(integrand)>;
  const gsl_function function = {[](const double place, void *const data)
                                 { return (*static_cast<const Integrand *>(data))(place); },
                                 const_cast<void *>(static_cast<const void *>(&integrand))};
  constexpr std::size_t n_intervals = 200;
  const std::unique_ptr<gsl_integration_cquad_workspace,
                        decltype(&gsl_integration_cquad_workspace_free)>
      workspace(gsl_integration_cquad_workspace_alloc(n_intervals),
                &gsl_integration_cquad_workspace_free);
  double result = 0.;
  gsl_integration_cquad(&function, begin, end, 0., 1e-9, workspace.get(), &result, nullptr,
                        nullptr);
  return result;
};
} // namespace

LoadedTube::LoadedTube(const TubeSection &section) : mesh(section)
{
  if (mesh.layers.empty())
    throw std::invalid_argument("The tube has no wall.");
  for (const Material &layer : mesh.layers)
  {
    if (layer.strain_law == nullptr || !layer.is_incompressible() ||
        layer.strain_law->has_own_mean_stress())
      throw std::invalid_argument(
          "A layer of the wall has no strain law, or is not incompressible.");
    fibres.push_back(layer.strain_law_parameters.fibres(tube_axis, tube_circumference));
  }
}

LoadedTube LoadedTube::of_image(const TubeSection &section, const double wanted)
{
  // The radius without load, or of the opened ring, gives the thicknesses by the volumes.
  const auto of_radius = [&](const double radius)
  {
    LoadedTube tube(section);
    tube.mesh.inner_radius = radius;
    double image = section.inner_radius, inner = radius;
    for (unsigned int i = 0; i < section.layers.size(); ++i)
    {
      const double thickness = section.layer_thicknesses[i],
                   outer = std::sqrt(square_of(inner) +
                                     thickness * (2. * image + thickness) /
                                         section.layers[i].prestretch.volume_ratio(1.));
      tube.mesh.layer_thicknesses[i] = outer - inner;
      image += thickness;
      inner = outer;
    }
    return tube;
  };
  const auto surplus = [&](const double radius)
  { return of_radius(radius).pressure(section.inner_radius) - wanted; };
  constexpr double step = 1.05, farthest = 50.;
  double high = section.inner_radius;
  for (; surplus(high) > 0.; high *= step)
    if (high > farthest * section.inner_radius)
      throw std::domain_error("no tube without load was found that widens less under it.");
  double low = high;
  for (; surplus(low) < 0.; low /= step)
    if (low < section.inner_radius / farthest)
      throw std::domain_error("no tube without load bears so much at this radius.");
  if (low == high)
    return of_radius(low);
  std::uintmax_t n_iterations = 100;
  const auto bracket = boost::math::tools::toms748_solve(
      surplus, low, high,
      boost::math::tools::eps_tolerance<double>(std::numeric_limits<double>::digits - 4),
      n_iterations);
  return of_radius(0.5 * (bracket.first + bracket.second));
}

template <typename Value, typename Rule, typename Function>
Value LoadedTube::integral(const double inner_radius,
                           const Rule &rule,
                           const Function &function) const
{
  Value sum{};
  double inner = mesh.inner_radius, present_inner = inner_radius;
  for (unsigned int i = 0; i < mesh.layers.size(); ++i)
  {
    const Material &layer = mesh.layers[i];
    const double thickness = mesh.layer_thicknesses[i];
    const double volume_ratio = layer.prestretch.volume_ratio(1.);
    const Tensor<2, 3> inverse = layer.prestretch.inverse(tube_axis, tube_circumference, 1.);
    const auto present = [&](const double radius)
    {
      return std::sqrt(square_of(present_inner) +
                       volume_ratio * (radius - inner) * (radius + inner));
    };
    WallPoint point;
    point.strain.fibres = fibres[i];
    const auto integrand = [&](const double radius) -> Value
    {
      point.radius = present(radius);
      const double across = volume_ratio * radius / point.radius; // dr/dR
      Tensor<2, 3> gradient;
      gradient[0][0] = 1.;
      gradient[1][1] = point.radius / radius;
      gradient[2][2] = across;
      point.strain.gradient = gradient * inverse;
      return function(layer, point) * across / point.radius;
    };
    sum += rule(integrand, inner, inner + thickness);
    present_inner = present(inner + thickness);
    inner += thickness;
  }
  return sum;
}

double LoadedTube::pressure(const double inner_radius) const
{
  return integral(inner_radius, integrate_stress,
                  [](const Material &layer, const WallPoint &point)
                  {
                    SymmetricTensor<2, 3> stress;
                    layer.strain_law->set_stress(point.strain, stress);
                    return stress[1][1] - stress[2][2];
                  });
}

LoadedTube::Loads LoadedTube::loads(const double inner_radius) const
{
  const auto both = integral<Tensor<1, 2>>(
      inner_radius, integrate_stress,
      [](const Material &layer, const WallPoint &point)
      {
        SymmetricTensor<2, 3> stress;
        layer.strain_law->set_stress(point.strain, stress);
        // The stress is a deviator: 2 along - around - across = 3 along.
        return Tensor<1, 2>({stress[1][1] - stress[2][2],
                             3. * numbers::PI * stress[0][0] * square_of(point.radius)});
      });
  return {both[0], both[1]};
}

double LoadedTube::stiffness(const double inner_radius) const
{
  return integral(inner_radius, integrate_tangent,
                  [&](const Material &layer, const WallPoint &point)
                  {
                    SymmetricTensor<2, 3> stress;
                    SymmetricTensor<4, 3> tangent;
                    layer.strain_law->set_tangent(point.strain, stress, tangent);
                    // dr = a da/r: the strain is around, minus the same across, and dr/r itself
                    // changes.
                    const double strain = inner_radius / square_of(point.radius);
                    const double of_law = tangent[1][1][1][1] - tangent[1][1][2][2] -
                                          tangent[2][2][1][1] + tangent[2][2][2][2];
                    return strain * (of_law + 4. * stress[2][2]);
                  });
}

double LoadedTube::inner_radius(const double wanted) const
{
  return inner_radius(wanted, mesh.inner_radius);
}

double LoadedTube::inner_radius(const double wanted, const double start) const
{
  constexpr double down = 0.9, up = 1.02, farthest = 50.;
  // A ring that was opened has a much smaller radius when it is closed.
  double volume_ratio = 1.;
  for (const Material &layer : mesh.layers)
    volume_ratio = std::min(volume_ratio, layer.prestretch.volume_ratio(1.));
  const double smallest = mesh.inner_radius * volume_ratio / farthest;
  double low = start;
  while (!(pressure(low) < wanted))
  {
    low *= down;
    if (low < smallest)
      throw std::domain_error("no radius was found at which the wall balances a pressure.");
  }
  double high = low, reached = pressure(low);
  while (reached < wanted)
  {
    low = high;
    high *= up;
    const double next = pressure(high);
    if (!(next > reached) || high > farthest * mesh.inner_radius)
    {
      std::ostringstream text;
      text << "its pressure rises no further than " << reached << " Pa, at the inner radius of "
           << low << " m.";
      throw std::domain_error(text.str());
    }
    reached = next;
  }
  std::uintmax_t n_iterations = 100;
  const auto bracket = boost::math::tools::toms748_solve(
      [&](const double radius) { return pressure(radius) - wanted; }, low, high,
      boost::math::tools::eps_tolerance<double>(std::numeric_limits<double>::digits - 4),
      n_iterations);
  return 0.5 * (bracket.first + bracket.second);
}

double LoadedTube::outer_radius(const double inner_radius) const
{
  double squared = square_of(inner_radius), inner = mesh.inner_radius;
  for (unsigned int i = 0; i < mesh.layers.size(); ++i)
  {
    const double thickness = mesh.layer_thicknesses[i];
    squared += mesh.layers[i].prestretch.volume_ratio(1.) * thickness * (2. * inner + thickness);
    inner += thickness;
  }
  return std::sqrt(squared);
}

double LoadedTube::distensibility(const double inner_radius) const
{
  return 2. / (inner_radius * stiffness(inner_radius));
}

TubeSection LoadedTube::section_about(const double pressure, const WallTheory wall_theory) const
{
  const double a = inner_radius(pressure), b = outer_radius(a), thickness = b - a;
  // A thin layer of shear modulus mu, held along its axis, has dp/da = 4 mu h/a^2, a thick one
  // 2 mu a (1/a^2 - 1/b^2).
  const double of_stiffness = wall_theory == WallTheory::thin
                                  ? a * a / (4. * thickness)
                                  : 0.5 / (a * (1. / (a * a) - 1. / (b * b)));
  Material wall;
  wall.type = "prony";
  wall.shear.branches.push_back({stiffness(a) * of_stiffness});
  double squared = a * a, inner = mesh.inner_radius, mass = 0.;
  for (unsigned int i = 0; i < mesh.layers.size(); ++i)
  {
    const Material &layer = mesh.layers[i];
    const double of_mesh = mesh.layer_thicknesses[i] * (2. * inner + mesh.layer_thicknesses[i]),
                 area = layer.prestretch.volume_ratio(1.) * of_mesh, outer = squared + area;
    inner += mesh.layer_thicknesses[i];
    mass += layer.density * area;
    // A layer without stress, of shear modulus mu: dp/da = 2 mu a (1/r_i^2 - 1/r_o^2). A branch is
    // such a layer about a state at which it is relaxed.
    const double share = 2. * a * (1. / squared - 1. / outer) * of_stiffness;
    for (const Branch &branch : layer.shear.branches)
      if (std::isfinite(branch.relaxation_time))
        wall.shear.branches.push_back({branch.shear_modulus * share, branch.relaxation_time});
    wall.shear.viscosity += layer.shear.viscosity * share;
    squared = outer;
  }
  wall.density = mass / (squared - a * a);

  TubeSection section = mesh;
  section.inner_radius = a;
  section.mean_pressure = pressure;
  section.layer_thicknesses = {thickness};
  section.layers = {wall};
  section.tethered = true;
  return section;
}
} // namespace Continua
