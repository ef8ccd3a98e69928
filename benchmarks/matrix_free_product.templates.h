#ifndef continua_benchmarks_matrix_free_product_templates_h
#define continua_benchmarks_matrix_free_product_templates_h

#include "matrix_free_product.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/matrix_free/fe_evaluation.h>
#include <deal.II/matrix_free/matrix_free.h>

namespace Benchmarks
{
/// With `width` cells at a time.
template <std::size_t width>
class MatrixFreeProductOfWidth : public MatrixFreeProduct
{
public:
  explicit MatrixFreeProductOfWidth(const Input &input);

  void initialise(Vector &vector) const override { matrix_free.initialize_dof_vector(vector); }
  void multiply(Vector &target, const Vector &source) const override;
  std::size_t memory() const override
  {
    return matrix_free.memory_consumption() + 2 * sizeof(Number) * coefficients.size();
  }

private:
  static constexpr int dim = 3, degree = 2;
  using Number = dealii::VectorizedArray<double, width>;
  using MatrixFree = dealii::MatrixFree<dim, double, Number>;
  using Evaluation = dealii::FEEvaluation<dim, degree, degree + 1, dim, double, Number>;

  MatrixFree matrix_free;
  /// Of mass and stiffness, by batch of cells.
  dealii::AlignedVector<std::pair<Number, Number>> coefficients;

  void multiply_cells(const MatrixFree &data,
                      Vector &target,
                      const Vector &source,
                      const std::pair<unsigned int, unsigned int> &range) const;
};

template <std::size_t width>
MatrixFreeProductOfWidth<width>::MatrixFreeProductOfWidth(const Input &input)
{
  typename MatrixFree::AdditionalData data;
  data.tasks_parallel_scheme = MatrixFree::AdditionalData::none;
  data.mapping_update_flags =
      dealii::update_values | dealii::update_gradients | dealii::update_JxW_values;
  matrix_free.reinit(input.mapping, input.dof_handler, input.constraints,
                     dealii::QGauss<1>(degree + 1), data);
  coefficients.resize(matrix_free.n_cell_batches());
  for (unsigned int batch = 0; batch < matrix_free.n_cell_batches(); ++batch)
    for (unsigned int lane = 0; lane < matrix_free.n_active_entries_per_cell_batch(batch); ++lane)
    {
      const auto material = matrix_free.get_cell_iterator(batch, lane)->material_id();
      coefficients[batch].first[lane] = input.mass[material];
      coefficients[batch].second[lane] = input.stiffness[material];
    }
}

template <std::size_t width>
void MatrixFreeProductOfWidth<width>::multiply(Vector &target, const Vector &source) const
{
  matrix_free.cell_loop(&MatrixFreeProductOfWidth::multiply_cells, this, target, source, true);
}

template <std::size_t width>
void MatrixFreeProductOfWidth<width>::multiply_cells(
    const MatrixFree &data,
    Vector &target,
    const Vector &source,
    const std::pair<unsigned int, unsigned int> &range) const
{
  using dealii::EvaluationFlags::gradients;
  using dealii::EvaluationFlags::values;
  Evaluation cell(data);
  for (unsigned int batch = range.first; batch < range.second; ++batch)
  {
    cell.reinit(batch);
    cell.gather_evaluate(source, values | gradients);
    const Number mass = coefficients[batch].first,
                 twice_stiffness = 2. * coefficients[batch].second;
    for (unsigned int q = 0; q < cell.n_q_points; ++q)
    {
      dealii::SymmetricTensor<2, dim, Number> rate = cell.get_symmetric_gradient(q);
      const Number mean = trace(rate) * (1. / 3.);
      for (int c = 0; c < dim; ++c)
        rate[c][c] -= mean;
      cell.submit_value(mass * cell.get_value(q), q);
      cell.submit_symmetric_gradient(twice_stiffness * rate, q);
    }
    cell.integrate_scatter(values | gradients, target);
  }
}
} // namespace Benchmarks

#endif
