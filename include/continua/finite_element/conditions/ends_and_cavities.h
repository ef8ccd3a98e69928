#ifndef continua_finite_element_conditions_ends_and_cavities_h
#define continua_finite_element_conditions_ends_and_cavities_h

#include <continua/continuum/problem.h>
#include <continua/finite_element/conditions/cavity_volumes.h>
#include <continua/finite_element/space/deformed_faces.h>
#include <continua/finite_element/space/space.h>
#include <continua/linear_algebra/distributed_vector.h>

#include <vector>

namespace Continua
{
/// The sections of outlets and of free flow rates, and the cavities of the problem. What a method
/// does is said in Operators under the same name.
template <int dim>
class EndsAndCavities
{
public:
  /// Both must outlive it.
  EndsAndCavities(const Space<dim> &space, const Problem &problem);

  /// The mesh has changed. Collective.
  void reinit();

  void set_flow_of_velocities(unsigned int condition,
                              const DistributedVector &mesh_displacement,
                              DistributedVector &flow);
  DistributedVector flow_profile(unsigned int condition) const;

  std::vector<double> cavity_volumes(const DistributedVector &displacement)
  {
    return cavities.volumes(displacement);
  }
  void linearise_cavity(const unsigned int cavity,
                        const DistributedVector &displacement,
                        DistributedVector &derivative,
                        DistributedVector &force)
  {
    cavities.linearise(cavity, displacement, derivative, force);
  }

private:
  const Space<dim> &space;
  const Problem &problem;
  const std::vector<unsigned int> sections; ///< on a mesh that moves: conditions
  DeformedFaces<dim> section_faces;         ///< of these
  CavityVolumes<dim> cavities;
};
} // namespace Continua

#endif
