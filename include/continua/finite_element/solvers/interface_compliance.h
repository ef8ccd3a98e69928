#ifndef continua_finite_element_solvers_interface_compliance_h
#define continua_finite_element_solvers_interface_compliance_h

#include <continua/finite_element/space/space.h>

#include <functional>
#include <vector>

namespace Continua
{
/**
 * What a wall yields to a pressure, node by node of its interface with a fluid. `load` is the force
 * f of a unit pressure of the fluid on the velocities of the interface, and `inverse` finds the
 * wall's velocities u under a force: a node's compliance is (u . f)/(f . f), summed over the
 * components of the node [s/kg].
 *
 * A uniform pressure bends a long plate that is held at its ends, which a pressure wave does not.
 * The compliance is therefore reduced by that under waves of pressure along each axis, the length
 * of which is pi times the depth of the fluid: below that a wave does not reach through the fluid.
 * The depth is the fluid's `volume` over the area of the interface. A tube yields to both alike.
 *
 * `nodes`: local indices of owned velocities, the components of a node one after the other.
 * Returns the compliance at these, zero where there is no load. Collective; calls `inverse` 1 + dim
 * times.
 */
template <int dim>
DistributedVector interface_compliance(
    const Space<dim> &space,
    const std::vector<unsigned int> &nodes,
    const DistributedVector &load,
    double volume,
    const std::function<void(DistributedVector &velocity, const DistributedVector &force)>
        &inverse);
} // namespace Continua

#endif
