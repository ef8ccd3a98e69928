#ifndef continua_finite_element_motion_kinematics_at_h
#define continua_finite_element_motion_kinematics_at_h

#include <continua/continuum/kinematics.h>
#include <continua/finite_element/space/space.h>

#include <deal.II/fe/fe_values.h>

#include <vector>

namespace Continua
{
/// The motion at a quadrature point of a cell, for which values and gradients of the velocity's
/// element were made on the undeformed mesh; `indices`: of the cell's velocities, `displacement`:
/// with ghost entries [m]. The point must not lie on the axis.
template <int dim>
Kinematics kinematics_at(const Space<dim> &space,
                         const dealii::FEValuesBase<dim> &values,
                         unsigned int q,
                         const std::vector<dealii::types::global_dof_index> &indices,
                         const DistributedVector &displacement);
} // namespace Continua

#endif
