#ifndef continua_finite_volume_cell_wise_output_h
#define continua_finite_volume_cell_wise_output_h

#include <continua/finite_volume/cell_wise_evaluation.h>

#include <deal.II/fe/fe_system.h>
#include <deal.II/numerics/data_out.h>

#include <map>
#include <string>

namespace Continua
{
/// The fields of a picture, one value in each cell: velocity, displacement, pressure, stress,
/// phase, material id and rank.
template <int dim>
class CellWiseOutput
{
public:
  CellWiseOutput(const CellWiseSpace<dim> &space,
                 const Problem &problem,
                 const CellWiseEvaluation<dim> &evaluation);

  /// Adds the fields to `data_out`; they live until the next call. Returns name -> unit.
  std::map<std::string, std::string> add(const State &state, dealii::DataOut<dim> &data_out);

private:
  const CellWiseSpace<dim> &space;
  const Problem &problem;
  const CellWiseEvaluation<dim> &evaluation;
  dealii::FESystem<dim> element;
  dealii::DoFHandler<dim> dofs;
  DistributedVector fields;
  dealii::Vector<float> phase, material_id, rank;
};
} // namespace Continua

#endif
