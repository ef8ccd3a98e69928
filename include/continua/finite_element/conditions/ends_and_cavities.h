#ifndef continua_finite_element_conditions_ends_and_cavities_h
#define continua_finite_element_conditions_ends_and_cavities_h

#include <continua/continuum/cavities.h>
#include <continua/continuum/ports.h>
#include <continua/continuum/problem.h>
#include <continua/finite_element/conditions/cavity_volumes.h>
#include <continua/finite_element/conditions/loads.h>
#include <continua/finite_element/space/deformed_faces.h>
#include <continua/finite_element/space/space.h>
#include <continua/linear_algebra/distributed_vector.h>

#include <vector>

namespace Continua
{
/// The sections of outlets and of free flow rates, and the cavities of the problem.
template <int dim>
class EndsAndCavities : public Ports, public Cavities
{
public:
  /// All must outlive it.
  EndsAndCavities(const Space<dim> &space, const Problem &problem, const Loads<dim> &loads);

  /// The mesh has changed. Collective.
  void reinit();

  DistributedVector flow_of_velocities(const unsigned int condition) const override
  {
    return loads.flow_of_velocities(condition);
  }
  void set_flow_of_velocities(unsigned int condition,
                              const DistributedVector &mesh_displacement,
                              DistributedVector &flow) override;
  DistributedVector flow_profile(unsigned int condition) const override;

  std::vector<double> volumes(const DistributedVector &displacement) override
  {
    return cavity_volumes.volumes(displacement);
  }
  void linearise(const unsigned int cavity,
                 const DistributedVector &displacement,
                 DistributedVector &derivative,
                 DistributedVector &force) override
  {
    cavity_volumes.linearise(cavity, displacement, derivative, force);
  }

private:
  const Space<dim> &space;
  const Problem &problem;
  const Loads<dim> &loads;
  const std::vector<unsigned int> sections; ///< on a mesh that moves: conditions
  DeformedFaces<dim> section_faces;         ///< of these
  CavityVolumes<dim> cavity_volumes;
};
} // namespace Continua

#endif
