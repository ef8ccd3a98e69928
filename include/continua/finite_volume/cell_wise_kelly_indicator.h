#ifndef continua_finite_volume_cell_wise_kelly_indicator_h
#define continua_finite_volume_cell_wise_kelly_indicator_h

#include <continua/finite_volume/linear_reconstruction.h>

#include <deal.II/lac/vector.h>

namespace Continua
{
/**
 * Refinement indicator: the jump of a field's normal derivative across the faces of a cell inside
 * its region, from the gradients of the two cells, eta^2 = h/24 sum_F |F| |jump|^2, h the cell's
 * diameter. Faces between regions and on boundaries have no part. Sets `per_cell` of the owned
 * cells to eta, in the unit of the field in 2-D, times m^(1/2) in 3-D.
 */
template <int dim>
void kelly_indicators_of_velocity(const CellWiseSpace<dim> &space,
                                  const LinearReconstruction<dim> &reconstruction,
                                  const DistributedVector &velocity,
                                  dealii::Vector<float> &per_cell);
template <int dim>
void kelly_indicators_of_pressure(const CellWiseSpace<dim> &space,
                                  const LinearReconstruction<dim> &reconstruction,
                                  const DistributedVector &pressure,
                                  dealii::Vector<float> &per_cell);
} // namespace Continua

#endif
