#ifndef continua_finite_element_looking_field_error_h
#define continua_finite_element_looking_field_error_h

#include <continua/continuum/compared_field.h>
#include <continua/continuum/problem.h>
#include <continua/continuum/state.h>
#include <continua/finite_element/space/space.h>
#include <continua/linear_algebra/distributed_vector.h>
#include <continua/signal/expression.h>

#include <deal.II/base/quadrature.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/hp/fe_values.h>
#include <deal.II/lac/vector.h>

#include <array>
#include <vector>

namespace Continua
{
/// The L2 norm of the difference of a field to functions; see ContinuumSolver::error_norm().
template <int dim>
class FieldError
{
public:
  /// Space, problem and state must outlive it. `vectors`: see vectors_of(). Collective.
  FieldError(const Space<dim> &space,
             const Problem &problem,
             const State &state,
             ComparedField field,
             std::vector<DistributedVector> vectors);

  /// `time` [s]. Collective.
  double norm(const std::vector<Expression> &exact, double time);

private:
  using Cell = typename dealii::DoFHandler<dim>::active_cell_iterator;

  const Space<dim> &space;
  const Problem &problem;
  const bool is_pressure, is_stress;
  /// What a mesh that moves shows is compared where it is; displacements are those of matter.
  const bool moves;
  const DistributedVector pressure, displacement; ///< with ghost entries
  const std::vector<DistributedVector> vectors;
  const dealii::Quadrature<dim> quadrature;
  dealii::FEValues<dim> values;
  dealii::hp::FEValues<dim> hp_pressure_values;
  // Of the present cell, at its points:
  std::vector<dealii::types::global_dof_index> indices;
  std::vector<dealii::Vector<double>> displacements, vector_values, pressures;
  std::vector<std::vector<dealii::Tensor<1, dim>>> gradients;

  void take(const Cell &cell);
  /// Of the field at a point of the present cell.
  std::array<double, 6> components(unsigned int region, unsigned int q) const;
};
} // namespace Continua

#endif
