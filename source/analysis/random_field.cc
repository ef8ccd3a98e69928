#include <continua/analysis/random_field.h>

#include <cmath>

namespace Continua
{
using namespace dealii;

namespace
{
constexpr unsigned int n_random_waves = 24;
/// The size of the body over the shortest wave.
constexpr double most_waves_in_body = 100.;
} // namespace

template <int dim>
RandomField<dim>::RandomField(std::mt19937_64 &generator, const double size)
{
  // The standard fixes the generator's numbers, but not those of its distributions.
  const auto uniform = [&generator]() { return (generator() >> 11) * 0x1p-53; };
  for (std::vector<Wave> &of_component : waves)
    for (unsigned int k = 0; k < n_random_waves; ++k)
    {
      Wave wave;
      // A direction is a point of the cube that lies in the ball; the number of steps is fixed.
      double length = 0.;
      for (unsigned int attempt = 0; attempt < 8; ++attempt)
      {
        Tensor<1, dim> direction;
        for (unsigned int d = 0; d < dim; ++d)
          direction[d] = 2. * uniform() - 1.;
        if (const double norm = direction.norm(); length == 0. && norm > 0.1 && norm <= 1.)
        {
          wave.wave_vector = direction / norm;
          length = norm;
        }
      }
      wave.wave_vector *= 2. * M_PI / size * std::pow(most_waves_in_body, uniform());
      wave.phase = 2. * M_PI * uniform();
      of_component.push_back(wave);
    }
}

template <int dim>
double RandomField<dim>::value(const Point<dim> &place, const unsigned int component) const
{
  double sum = 0.;
  for (const Wave &wave : waves[component])
    sum += std::cos(wave.wave_vector * place + wave.phase);
  return sum / std::sqrt(0.5 * n_random_waves);
}

template class RandomField<2>;
template class RandomField<3>;
} // namespace Continua
