#include <continua/laboratory/wave_scheme.h>

#include <map>

namespace Continua
{
const Words<WaveScheme> &wave_scheme_words()
{
  static const Words<WaveScheme> words = {
      {"displacement euler", WaveScheme::displacement_euler},
      {"displacement four levels", WaveScheme::displacement_four_levels},
      {"velocity euler", WaveScheme::velocity_euler},
      {"velocity euler implicit", WaveScheme::velocity_euler_implicit},
      {"velocity backward differencing", WaveScheme::velocity_backward_differencing},
      {"velocity backward differencing trapezoidal",
       WaveScheme::velocity_backward_differencing_trapezoidal},
      {"velocity crank nicolson", WaveScheme::velocity_crank_nicolson}};
  return words;
}

const WaveSchemeData &data_of(const WaveScheme scheme)
{
  static const std::map<WaveScheme, WaveSchemeData> table = {
      {WaveScheme::displacement_euler,
       {Formulation::displacement, Scheme::euler_implicit, {}, 2, 1}},
      {WaveScheme::displacement_four_levels,
       {Formulation::displacement, Scheme::backward_differencing, {}, 3, 4}},
      {WaveScheme::velocity_euler,
       {Formulation::velocity, Scheme::euler_implicit, Update::trapezoidal, 2, 0}},
      {WaveScheme::velocity_euler_implicit,
       {Formulation::velocity, Scheme::euler_implicit, Update::implicit, 2, 0}},
      {WaveScheme::velocity_backward_differencing,
       {Formulation::velocity, Scheme::backward_differencing, Update::implicit, 4, 1}},
      {WaveScheme::velocity_backward_differencing_trapezoidal,
       {Formulation::velocity, Scheme::backward_differencing, Update::trapezoidal, 3, 1}},
      {WaveScheme::velocity_crank_nicolson,
       {Formulation::velocity, Scheme::crank_nicolson, {}, 2, 0}}};
  return table.at(scheme);
}

Amplification amplification_of(const WaveScheme scheme, const double theta)
{
  // Time in units of the step.
  const WaveSchemeData &data = data_of(scheme);
  if (data.formulation == Formulation::displacement)
    return Amplification::of_displacement_form(1., data.scheme == Scheme::backward_differencing,
                                               theta);
  TimeParameters time;
  time.scheme = data.scheme;
  time.update = data.update;
  if (data.scheme == Scheme::crank_nicolson)
    return {crank_nicolson_step(0., 1.), theta};
  if (data.scheme == Scheme::backward_differencing)
    return {backward_differencing_step(0., 1., 1., time.update_type()), theta};
  return {euler_step(0., 1., time.update_type()), theta};
}

std::optional<double> ringing_angle(const WaveScheme scheme)
{
  double below = 0.01, above = below;
  while (!amplification_of(scheme, above).rings())
  {
    below = above;
    above *= 1.01;
    if (above > 1000.)
      return std::nullopt;
  }
  for (unsigned int i = 0; i < 60; ++i)
  {
    const double middle = 0.5 * (below + above);
    (amplification_of(scheme, middle).rings() ? above : below) = middle;
  }
  return above;
}
} // namespace Continua
