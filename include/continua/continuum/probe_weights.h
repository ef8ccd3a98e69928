#ifndef continua_continuum_probe_weights_h
#define continua_continuum_probe_weights_h

#include <continua/continuum/state.h>

#include <vector>

namespace Continua
{
/// A number that is linear in the state, as weights of this rank's entries of its vectors: reading
/// it is a short sum.
class ProbeWeights
{
public:
  /// What a weight multiplies an entry of.
  enum class Source
  {
    velocity,
    displacement,
    mixture, ///< of one region, eta U + sum_k mu_k D_k
    pressure,
    force ///< what the equations leave at the nodes
  };

  /// Weights of entries of any rank, while they are added up.
  class Collector
  {
  public:
    /// The prototypes have the size and the distribution of the state's vectors.
    Collector(const DistributedVector &velocity,
              const DistributedVector &pressure,
              unsigned int n_regions);
    /// Add the weights here, by global index.
    DistributedVector &weights(Source source, unsigned int region = 0);

  private:
    friend class ProbeWeights;
    DistributedVector velocity, displacement, pressure, force;
    std::vector<DistributedVector> mixtures;
  };

  ProbeWeights() = default;
  /// Takes what was collected, times a factor; collective.
  ProbeWeights(Collector &collector, double factor);

  /// This rank's share of the number; the materials by region. `forces` at the nodes: not null if
  /// there are weights of them.
  double share(const State &state,
               const DistributedVector *forces,
               const std::vector<Material> &materials) const;

  /// Weights of one vector.
  struct Part
  {
    Source source;
    unsigned int region;               ///< of a mixture
    std::vector<unsigned int> indices; ///< local
    std::vector<double> values;
  };
  /// This rank's.
  const std::vector<Part> &all_parts() const { return parts; }

private:
  std::vector<Part> parts;

  void keep(Source source, unsigned int region, DistributedVector &vector, double factor);
};
} // namespace Continua

#endif
