#ifndef continua_finite_element_conditions_following_loads_h
#define continua_finite_element_conditions_following_loads_h

#include <continua/continuum/problem.h>
#include <continua/time_integration/step.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

namespace Continua
{
bool body_force_depends_on_space(const InteriorData &interior);
/// Whether the present shape of a region changes the body forces on it. They are a term of its
/// equations then (BodyForce), else a linear load (Loads).
bool body_force_follows(const Problem &problem, unsigned int region);
/// The body force at a place, rho b + f with the density of the stress-free material, at the
/// balanced time of a step and with its load factor [N/m^3].
template <int dim>
dealii::Tensor<1, dim> body_force_at(const Problem &problem,
                                     unsigned int region,
                                     const dealii::Point<dim> &place,
                                     const Step &step);
/// Whether the present shape changes the traction that a half of a condition gives on a region: its
/// value along the normal, or its vector. It is a term on faces then (FollowerPressure,
/// GivenTraction), else a linear load.
bool traction_follows(const Problem &problem,
                      unsigned int region,
                      const BoundaryPart &part,
                      bool along_normal);
/// Whether a condition gives a traction that is such a term.
bool has_following_traction(const Problem &problem,
                            unsigned int region,
                            const BoundaryCondition &condition);
} // namespace Continua

#endif
