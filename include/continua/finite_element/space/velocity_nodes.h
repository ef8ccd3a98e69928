#ifndef continua_finite_element_space_velocity_nodes_h
#define continua_finite_element_space_velocity_nodes_h

#include <deal.II/base/index_set.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/mapping.h>

#include <vector>

namespace Continua
{
/// Local indices of the owned velocities, the components of a node one after the other. The element
/// has dim components of Lagrange type. Not collective.
template <int dim>
std::vector<unsigned int> nodes_in_order(const dealii::DoFHandler<dim> &velocity_dofs);

/// The rigid motions at the owned velocities, by motion and local index: the translations, then the
/// rotations about the middle of all nodes, of size 1 at most [1]. In axisymmetry those of the
/// meridian plane: on the scale of a few cells they take next to no force, too. Collective.
template <int dim>
std::vector<std::vector<double>> rigid_motions(const dealii::Mapping<dim> &mapping,
                                               const dealii::DoFHandler<dim> &velocity_dofs);
} // namespace Continua

#endif
