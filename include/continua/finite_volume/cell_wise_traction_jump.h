#ifndef continua_finite_volume_cell_wise_traction_jump_h
#define continua_finite_volume_cell_wise_traction_jump_h

#include <continua/finite_volume/cell_wise_evaluation.h>
#include <continua/finite_volume/face_conditions.h>

#include <deal.II/lac/vector.h>

#include <vector>

namespace Continua
{
/**
 * Refinement indicator: the jump of the traction n.sigma over the faces of a cell, inside a region
 * and across the interface alike, and on a boundary its difference to the prescribed traction:
 * eta^2 = sum_F h_F |F| |jump|^2 (half of it on interior faces), h_F the extent of the face. The
 * tractions are those of the cells' own gradients: what a face's value makes of them balances
 * exactly. `outlet_pressures`: at outlets, by condition [Pa]. Sets `per_cell` of the owned cells to
 * eta [N/m^(1/2) in 2-D, N in 3-D].
 */
template <int dim>
void traction_jump_indicators(const CellWiseSpace<dim> &space,
                              const Problem &problem,
                              const CellWiseEvaluation<dim> &evaluation,
                              const FaceConditions<dim> &conditions,
                              const State &state,
                              const std::vector<double> &outlet_pressures,
                              double time,
                              dealii::Vector<float> &per_cell);
} // namespace Continua

#endif
