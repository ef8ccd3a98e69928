// The terms of a solid in finite deformation at a point: each derivative against differences, for
// laws with and without a mean stress of their own, at the end of a step, in its middle and where
// the unloaded shape is looked for; the power of the stress against the energy of the law.

#include <continua/continuum/stress_free_state.h>
#include <continua/finite_element/terms/solid_terms.h>
#include <continua/materials/mooney_rivlin.h>
#include <continua/materials/saint_venant_kirchhoff.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "../materials/strain_at_point.h"
#include "../unit_test.h"

namespace test_of_solid_terms
{
using namespace Continua;
using namespace dealii;
using strain_at_point::unit_tensor;

namespace
{
const std::array<const char *, SolidTerms::size> names = {
    {"stress", "viscosity", "pressure", "inertia", "volume"}};

/// A state and the way in which it follows the unknowns, by the reference place.
template <int dim>
struct Solid
{
  SolidScheme scheme;
  const StrainLaw *law = nullptr;
  bool unloads = false;
  double hoop = 0.; ///< 1/R
  Tensor<1, dim> velocity;
  Tensor<2, dim> velocity_gradient;
  double pressure = 0.;
  // Of the displacement the part that does not follow the velocity, and its radial component.
  Tensor<2, dim> displacement_gradient;
  double radial_displacement = 0.;
  Tensor<2, 3> known; ///< of the elastic deformation, where the unloaded shape is looked for
};

template <int dim>
Tensor<2, dim> random_gradient(std::mt19937 &random, const double size)
{
  const Tensor<2, 3> whole = strain_at_point::random_tensor(random, size);
  Tensor<2, dim> result;
  for (unsigned int c = 0; c < dim; ++c)
    for (unsigned int d = 0; d < dim; ++d)
      result[c][d] = whole[c][d];
  return result;
}

template <int dim>
Tensor<2, 3> displacement_gradient(const Solid<dim> &solid)
{
  const double b = solid.scheme.displacement_by_velocity;
  return whole_gradient<dim>(solid.displacement_gradient + b * solid.velocity_gradient,
                             solid.hoop * (solid.radial_displacement + b * solid.velocity[1]));
}

/// The elastic deformation: that of the body, or what the unloaded shape leaves of a known one.
template <int dim>
PointStrain strain_of(const Solid<dim> &solid)
{
  if (!solid.unloads)
    return strain_at_point::strain_of(unit_tensor() + displacement_gradient(solid));
  const RightStretch unloading(unit_tensor() - displacement_gradient(solid));
  return strain_at_point::strain_of(unloading.inverse() * solid.known);
}

template <int dim>
SolidPoint<dim> point_of(const Solid<dim> &solid)
{
  const Tensor<2, 3> gradient = displacement_gradient(solid);
  SolidPoint<dim> point(solid.scheme, Kinematics(solid.unloads ? Tensor<2, 3>() : gradient));
  point.hoop = solid.hoop * point.kinematics.inverse()[2][2];
  point.velocity = solid.velocity;
  point.acceleration = solid.scheme.rate_by_velocity * solid.velocity;
  point.velocity_gradient = point.kinematics.gradient(
      whole_gradient<dim>(solid.velocity_gradient, solid.hoop * solid.velocity[1]));
  point.pressure = solid.pressure;
  point.pressure_rate = 0.2 + solid.scheme.pressure_rate_by_pressure * solid.pressure;
  if (solid.unloads)
    point.stress_free_ratio = determinant(unit_tensor() - gradient);
  const PointStrain strain = strain_of(solid);
  solid.law->set_tangent(strain, point.stress, point.tangent);
  point.stress *= point.stress_free_ratio;
  point.tangent *= point.stress_free_ratio;
  if (solid.law->has_own_mean_stress())
    solid.law->set_mean_stress(strain, point.mean_stress, point.mean_stress_slope);
  return point;
}

/// What is tested by values, by the gradients of test functions on the reference mesh, and of
/// volume.
template <int dim>
std::vector<double> entries(const SolidPoint<dim> &point, const Tested<dim> &tested)
{
  std::vector<double> result;
  for (unsigned int c = 0; c < dim; ++c)
  {
    result.push_back(tested.by_value[c]);
    for (unsigned int d = 0; d < dim; ++d)
    {
      double by_reference = 0.;
      for (unsigned int e = 0; e < dim; ++e)
        by_reference += tested.by_gradient[c][e] * point.kinematics.inverse()[d][e];
      result.push_back(by_reference);
    }
  }
  result.push_back(tested.of_volume);
  return result;
}

template <int dim>
Solid<dim> random_solid(const StrainLaw &law, std::mt19937 &random)
{
  Solid<dim> solid;
  solid.law = &law;
  solid.scheme = {0.3, 1.4, 2.3, false, 1.7, 0.6, 0.25, law.has_own_mean_stress()};
  solid.hoop = dim == 2 ? 0.8 : 0.;
  const Tensor<2, 3> of_values = strain_at_point::random_tensor(random, 1.);
  for (unsigned int c = 0; c < dim; ++c)
    solid.velocity[c] = of_values[0][c];
  solid.velocity_gradient = random_gradient<dim>(random, 0.4);
  solid.pressure = of_values[1][0];
  solid.displacement_gradient = random_gradient<dim>(random, 0.15);
  solid.radial_displacement = 0.1 * of_values[1][1];
  solid.known = unit_tensor() + strain_at_point::random_tensor(random, 0.15);
  return solid;
}

template <int dim>
void check_derivatives(const std::string &name, Solid<dim> solid, std::mt19937 &random)
{
  const Tensor<2, dim> gradient = random_gradient<dim>(random, 1.);
  const Tensor<2, 3> of_values = strain_at_point::random_tensor(random, 1.);
  const auto changed = [&](const double factor)
  {
    Solid<dim> result = solid;
    result.velocity_gradient += factor * gradient;
    for (unsigned int c = 0; c < dim; ++c)
      result.velocity[c] += factor * of_values[0][c];
    result.pressure += factor * of_values[1][0];
    return result;
  };
  SolidPoint<dim> here = point_of(solid);
  std::optional<RightStretch> unloading;
  if (solid.unloads)
  {
    unloading.emplace(unit_tensor() - displacement_gradient(solid));
    here.unloading = &*unloading;
  }
  PointChange<dim> of_unknowns;
  for (unsigned int c = 0; c < dim; ++c)
  {
    of_unknowns.velocity[c] = of_values[0][c];
    for (unsigned int d = 0; d < dim; ++d)
      for (unsigned int e = 0; e < dim; ++e)
        of_unknowns.velocity_gradient[c][d] += gradient[c][e] * here.kinematics.inverse()[e][d];
  }
  of_unknowns.pressure = of_values[1][0];
  const SolidChange<dim> change(here, of_unknowns);
  unsigned int number = 0;
  const double h = 1e-5;
  const SolidPoint<dim> above = point_of(changed(h)), below = point_of(changed(-h));
  SolidTerms::for_each(
      [&](const auto term)
      {
        Tested<dim> derivative, of_above, of_below;
        term.add_derivative(here, change, derivative);
        term.add(above, of_above);
        term.add(below, of_below);
        const std::vector<double> exact = entries(here, derivative), up = entries(above, of_above),
                                  down = entries(below, of_below);
        double largest = 0., difference = 0.;
        for (std::size_t i = 0; i < exact.size(); ++i)
        {
          largest = std::max(largest, std::abs(exact[i]));
          difference = std::max(difference, std::abs(exact[i] - (up[i] - down[i]) / (2. * h)));
        }
        const std::string term_name = name + ", " + names[number++];
        if (solid.scheme.viscosity != 0. || largest > 0.)
          check::is_true(term_name + ": there is a derivative", largest > 1e-3);
        check::absolute(term_name + ": derivative", largest > 0. ? difference / largest : 0., 0.,
                        1e-8);
      });
}

template <int dim>
void check_law(const std::string &name, const StrainLaw &law)
{
  std::mt19937 random(dim);
  check_derivatives(name + ", end of a step", random_solid<dim>(law, random), random);
  Solid<dim> middle = random_solid<dim>(law, random);
  middle.scheme.volume_is_rate = true;
  // The rate of a mean stress leaves out what its slope changes by.
  if (!law.has_own_mean_stress())
    check_derivatives(name + ", middle of a step", middle, random);
  Solid<dim> unloaded = random_solid<dim>(law, random);
  unloaded.unloads = true;
  unloaded.scheme.viscosity = 0.;
  check_derivatives(name + ", unloaded shape", unloaded, random);

  // The power of the stress, and of the law's mean stress, is the rate of the energy.
  const Solid<dim> moving = random_solid<dim>(law, random);
  const SolidPoint<dim> here = point_of(moving);
  Tested<dim> tested;
  SolidStress::add(here, tested);
  double power = tested.by_value * here.velocity;
  for (unsigned int c = 0; c < dim; ++c)
    for (unsigned int d = 0; d < dim; ++d)
      power += tested.by_gradient[c][d] * here.velocity_gradient[c][d];
  power += here.volume_ratio() * here.mean_stress * trace(here.velocity_gradient);
  const double h = 1e-5;
  const auto energy_at = [&](const double time)
  {
    Solid<dim> then = moving;
    then.displacement_gradient += time * moving.velocity_gradient;
    then.radial_displacement += time * moving.velocity[1];
    return law.energy(strain_of(then));
  };
  check::relative(name + ": power of the stress", power, (energy_at(h) - energy_at(-h)) / (2. * h),
                  1e-7);
}
} // namespace

UNIT_TEST(solid_terms)
{
  const MooneyRivlin rubber(1.3, 0.4);
  const SaintVenantKirchhoff stiff(1.3, 2.1);
  check_law<2>("rubber in axisymmetry", rubber);
  check_law<3>("rubber in space", rubber);
  check_law<2>("St. Venant-Kirchhoff in axisymmetry", stiff);
  check_law<3>("St. Venant-Kirchhoff in space", stiff);
}
} // namespace test_of_solid_terms
