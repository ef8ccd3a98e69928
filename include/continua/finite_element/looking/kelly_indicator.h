#ifndef continua_finite_element_looking_kelly_indicator_h
#define continua_finite_element_looking_kelly_indicator_h

#include <continua/finite_element/space/space.h>

#include <deal.II/lac/vector.h>

namespace Continua
{
/**
 * Refinement indicator: the jump of a field's normal derivative across the faces of a cell inside
 * its region, eta^2 = h/24 sum_F int_F |jump|^2, h the cell's diameter (D. W. Kelly, J. P. Gago, O.
 * C. Zienkiewicz, I. Babuska, Int. J. Numer. Meth. Eng. 19, 1983). Faces between regions and on
 * boundaries have no part. `mesh_displacement`: of a mesh that moves, else null; derivatives,
 * normals, areas and diameters are then the present ones. Sets `per_cell` of the owned cells to
 * eta, in the unit of the field in 2-D, times m^(1/2) in 3-D.
 */
template <int dim>
void kelly_indicators_of_velocity(const Space<dim> &space,
                                  const DistributedVector &velocity,
                                  const DistributedVector *mesh_displacement,
                                  dealii::Vector<float> &per_cell);
template <int dim>
void kelly_indicators_of_pressure(const Space<dim> &space,
                                  const DistributedVector &pressure,
                                  const DistributedVector *mesh_displacement,
                                  dealii::Vector<float> &per_cell);
} // namespace Continua

#endif
