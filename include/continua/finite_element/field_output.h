#ifndef continua_finite_element_field_output_h
#define continua_finite_element_field_output_h

#include <continua/finite_element/field_evaluation.h>

#include <deal.II/fe/fe_system.h>
#include <deal.II/numerics/data_out.h>

#include <map>
#include <string>

namespace Continua
{
/// The fields of a picture: velocity and displacement as they are, pressure and stress cell by cell
/// of degree k - 1 (so that they jump where they do), and phase, material id and rank.
template <int dim>
class FieldOutput
{
public:
  FieldOutput(const Space<dim> &space,
              const Problem &problem,
              const FieldEvaluation<dim> &evaluation);

  /// Adds the fields to `data_out`; they live until the next call. Returns name -> unit.
  std::map<std::string, std::string> add(const State &state, dealii::DataOut<dim> &data_out);

private:
  const Space<dim> &space;
  const Problem &problem;
  const FieldEvaluation<dim> &evaluation;
  dealii::FESystem<dim> cell_element;
  dealii::DoFHandler<dim> cell_dofs;
  DistributedVector velocity, displacement, cell_fields;
  dealii::Vector<float> phase, material_id, rank;
};
} // namespace Continua

#endif
