#include <continua/continuum/probe_weights.h>

namespace Continua
{
using namespace dealii;

ProbeWeights::Collector::Collector(const DistributedVector &velocity,
                                   const DistributedVector &pressure,
                                   const unsigned int n_regions)
    : velocity(velocity),
      displacement(velocity),
      pressure(pressure),
      force(velocity),
      mixtures(n_regions, velocity)
{
  this->velocity = 0.;
  displacement = 0.;
  this->pressure = 0.;
  force = 0.;
  for (DistributedVector &mixture : mixtures)
    mixture = 0.;
}

DistributedVector &ProbeWeights::Collector::weights(const Source source, const unsigned int region)
{
  switch (source)
  {
  case Source::velocity:
    return velocity;
  case Source::displacement:
    return displacement;
  case Source::pressure:
    return pressure;
  case Source::force:
    return force;
  default:
    return mixtures[region];
  }
}

ProbeWeights::ProbeWeights(Collector &collector, const double factor)
{
  keep(Source::velocity, 0, collector.velocity, factor);
  keep(Source::displacement, 0, collector.displacement, factor);
  keep(Source::pressure, 0, collector.pressure, factor);
  keep(Source::force, 0, collector.force, factor);
  for (unsigned int region = 0; region < collector.mixtures.size(); ++region)
    keep(Source::mixture, region, collector.mixtures[region], factor);
}

void ProbeWeights::keep(const Source source,
                        const unsigned int region,
                        DistributedVector &vector,
                        const double factor)
{
  vector.compress(VectorOperation::add);
  Part part{source, region, {}, {}};
  for (unsigned int i = 0; i < vector.locally_owned_size(); ++i)
    if (vector.begin()[i] != 0.)
    {
      part.indices.push_back(i);
      part.values.push_back(factor * vector.begin()[i]);
    }
  if (!part.indices.empty())
    parts.push_back(part);
}

double ProbeWeights::share(const State &state,
                           const DistributedVector *const forces,
                           const std::vector<Material> &materials) const
{
  double result = 0.;
  for (const Part &part : parts)
  {
    const auto add = [&](const double factor, const DistributedVector &vector)
    {
      const double *const entries = vector.begin();
      double sum = 0.;
      for (unsigned int i = 0; i < part.indices.size(); ++i)
        sum += part.values[i] * entries[part.indices[i]];
      result += factor * sum;
    };
    switch (part.source)
    {
    case Source::velocity:
      add(1., state.velocity);
      break;
    case Source::displacement:
      add(1., state.displacement_of_shape());
      break;
    case Source::pressure:
      add(1., state.pressure);
      break;
    case Source::force:
      add(1., *forces);
      break;
    case Source::mixture:
      if (state.mixtures != nullptr)
      {
        add(1., (*state.mixtures)[part.region]);
        break;
      }
      const Material &material = materials[part.region];
      if (material.shear.viscosity != 0.)
        add(material.shear.viscosity, state.velocity);
      for (const Branch &branch : material.shear.branches)
        add(branch.shear_modulus, state.history.internal_displacement(branch.relaxation_time));
      break;
    }
  }
  return result;
}
} // namespace Continua
