#ifndef continua_finite_element_solvers_block_factor_estimate_h
#define continua_finite_element_solvers_block_factor_estimate_h

#include <continua/finite_element/conditions/boundary_constraints.h>
#include <continua/finite_element/space/space.h>

#include <vector>

namespace Continua
{
/**
 * About how many entries the factor of a block of velocities has, on all ranks [1]: by MUMPS's
 * analysis of the graph of the block's nodes, in which an entry stands for dim x dim ones. It takes
 * a small part of the time and of the memory of an analysis of the velocities. Pressures of the
 * block would add to the entries. `velocities`: local indices, those of one node after one another
 * (nodes_in_order()), all components of a node or none. Collective.
 */
template <int dim>
double estimate_block_factor(const Space<dim> &space,
                             const BoundaryConstraints<dim> &constraints,
                             const std::vector<unsigned int> &velocities);
} // namespace Continua

#endif
