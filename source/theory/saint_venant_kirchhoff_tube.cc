#include <continua/theory/saint_venant_kirchhoff_tube.h>

#include <continua/materials/saint_venant_kirchhoff.h>

#include <cmath>
#include <stdexcept>

namespace Continua
{
namespace
{
constexpr unsigned int n_steps = 16; ///< of a layer

double strain_of(const double stretch)
{
  return 0.5 * (stretch * stretch - 1.);
}
} // namespace

SaintVenantKirchhoffTube::SaintVenantKirchhoffTube(const TubeSection &section)
{
  double inner = section.inner_radius;
  for (std::size_t i = 0; i < section.layers.size(); ++i)
  {
    const Material &material = section.layers[i];
    if (dynamic_cast<const SaintVenantKirchhoff *>(material.strain_law.get()) == nullptr ||
        material.inverse_bulk_modulus() == 0. || material.prestretch.exists())
      throw std::invalid_argument("A layer of the tube has another law.");
    const double modulus = material.long_term_shear_modulus(),
                 outer = inner + section.layer_thicknesses[i];
    layers.push_back(
        {inner, outer, 1. / material.inverse_bulk_modulus() - 2. / 3. * modulus, modulus});
    inner = outer;
  }
}

SaintVenantKirchhoffTube::State
SaintVenantKirchhoffTube::rates(const Layer &layer, const double place, const State &state) const
{
  const double around = state.radius / place, strain_around = strain_of(around);
  // The stretch across the wall that has this stress, by Newton's method from that of no stress.
  const double stiffness = layer.lambda + 2. * layer.modulus,
               start = 1. - 2. * layer.lambda / stiffness * strain_around;
  double across = start > 0. ? std::sqrt(start) : 1.;
  constexpr unsigned int most_iterations = 30;
  constexpr double tolerance = 1e-14;
  for (unsigned int i = 0; i < most_iterations; ++i)
  {
    const double second = stiffness * strain_of(across) + layer.lambda * strain_around,
                 change = (state.stress - across * second) / (second + stiffness * across * across);
    across += change;
    if (std::abs(change) < tolerance)
      break;
  }
  const double stress_around = around * (layer.lambda * strain_of(across) +
                                         (layer.lambda + 2. * layer.modulus) * strain_around);
  return {across, (stress_around - state.stress) / place};
}

SaintVenantKirchhoffTube::State SaintVenantKirchhoffTube::inside(const double outer_radius) const
{
  State state{outer_radius, 0.};
  for (std::size_t l = layers.size(); l-- > 0;)
  {
    const Layer &layer = layers[l];
    const double step = (layer.inner - layer.outer) / n_steps;
    const auto moved = [&state](const State &rate, const double by) {
      return State{state.radius + by * rate.radius, state.stress + by * rate.stress};
    };
    for (unsigned int i = 0; i < n_steps; ++i)
    {
      const double place = layer.outer + i * step;
      const State first = rates(layer, place, state),
                  second = rates(layer, place + 0.5 * step, moved(first, 0.5 * step)),
                  third = rates(layer, place + 0.5 * step, moved(second, 0.5 * step)),
                  fourth = rates(layer, place + step, moved(third, step));
      state = {state.radius +
                   step / 6. * (first.radius + 2. * (second.radius + third.radius) + fourth.radius),
               state.stress +
                   step / 6. *
                       (first.stress + 2. * (second.stress + third.stress) + fourth.stress)};
    }
  }
  return state;
}

double SaintVenantKirchhoffTube::pressure(const double inner_radius) const
{
  // The secant method for the outer radius that gives this inner one.
  double last = layers.back().outer + (inner_radius - layers.front().inner), outer = last * 0.999;
  State of_last = inside(last);
  constexpr unsigned int most_iterations = 40;
  constexpr double tolerance = 1e-13;
  for (unsigned int i = 0; i < most_iterations; ++i)
  {
    const State state = inside(outer);
    const double surplus = state.radius - inner_radius, before = of_last.radius - inner_radius;
    if (std::abs(surplus) < tolerance * inner_radius)
      // Of Cauchy, on the present surface.
      return -state.stress * layers.front().inner / state.radius;
    if (!std::isfinite(surplus) || surplus == before)
      break;
    const double next = outer - surplus * (outer - last) / (surplus - before);
    last = outer;
    of_last = state;
    outer = next;
  }
  return std::nan("");
}
} // namespace Continua
