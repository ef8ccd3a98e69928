#ifndef continua_analysis_free_motions_h
#define continua_analysis_free_motions_h

#include <continua/case/case.h>

#include <set>
#include <string>
#include <vector>

namespace Continua
{
/// A rigid motion of connected solid regions against which nothing pushes back.
struct FreeMotion
{
  std::string motion;             ///< "moving along x", "turning about z through (0, 1) m"
  std::set<unsigned int> regions; ///< the connected regions that move
  /// The numbers of the conditions that hold these regions against other motions.
  std::set<unsigned int> conditions;
};

/**
 * The rigid motions that nothing holds, for each set of solid cells that hang together by faces of
 * the coarse mesh, whose boundaries are curved as the geometry says.
 *
 * What holds a motion m: prescribed velocities by the part of m that they prescribe; supports with
 * a stiffness, likewise, unless the unloaded shape is sought, which they do not act on; and the
 * volume of a cavity, or of a liquid that cannot flow out, by the volume that m displaces. Inertia,
 * dampers and loads do not hold a body at rest. For each condition the mean square of the held part
 * of m over its faces and the mean square of m make two matrices over the motions, summed over the
 * conditions. The least eigenvalue of the one over the other is 0 for a motion that is free and 1
 * for one that is held wherever anything is held; it does not depend on lengths, and its sum over
 * conditions does not let a small boundary disappear beside a large one. A boundary is square to a
 * motion if it is so up to 0.3 percent.
 */
template <int dim>
std::vector<FreeMotion> free_motions(const Case<dim> &input);

/// Throws InputError at `Boundaries` if a motion is free; `what_follows`: a clause of what that
/// means, or empty; `other_remedy`: what one can do besides holding the body, or empty.
template <int dim>
void refuse_free_motions(const Case<dim> &input,
                         ParameterSection root,
                         const std::string &what_follows,
                         const std::string &other_remedy);
} // namespace Continua

#endif
