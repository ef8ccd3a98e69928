#ifndef continua_finite_element_products_matrix_free_mesh_templates_h
#define continua_finite_element_products_matrix_free_mesh_templates_h

#include <continua/finite_element/products/matrix_free_mesh.h>
#include <continua/finite_element/terms/mesh_stress.h>

#include <deal.II/base/aligned_vector.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/matrix_free/fe_evaluation.h>
#include <deal.II/matrix_free/matrix_free.h>

#include <cstddef>
#include <utility>

namespace Continua
{
/// With `width` cells at a time and `n_points` Gauss points in each direction. More points than the
/// degree needs: axisymmetry.
template <int dim, std::size_t width, int n_points>
class MatrixFreeMeshOfWidth : public MatrixFreeMesh<dim>
{
public:
  using Base = MatrixFreeMesh<dim>;
  using typename Base::Input;
  using typename Base::Vector;

  explicit MatrixFreeMeshOfWidth(const Input &input);

  void initialise_free(Vector &vector) const override
  {
    cells.initialize_dof_vector(vector, with_all);
  }
  void initialise_given(Vector &vector) const override
  {
    cells.initialize_dof_vector(vector, with_hanging);
  }
  void set(const Vector &displacement) override;
  void set_residual(Vector &rows, const Vector &displacement) const override;
  void multiply(Vector &target, const Vector &source) const override;
  void multiply_given(Vector &target, const Vector &source) const override;

private:
  static constexpr int degree = 2;
  static constexpr bool is_axisymmetric = n_points > degree + 1;
  /// Numbers of the constraints.
  static constexpr unsigned int with_all = 0, with_hanging = 1;
  using Lanes = dealii::VectorizedArray<double, width>;
  using MatrixFree = dealii::MatrixFree<dim, double, Lanes>;
  using Evaluation = dealii::FEEvaluation<dim, degree, n_points, dim, double, Lanes>;
  using Matrix = dealii::Tensor<2, 3, Lanes>;
  using Range = std::pair<unsigned int, unsigned int>;

  /// What a batch of cells has.
  struct Batch
  {
    Lanes stiffness;
    bool is_of_body = false, has_given = false;
  };

  const bool is_hyperelastic;
  MatrixFree cells;
  dealii::AlignedVector<Batch> batches;
  /// F^-1 at the points of a batch, one batch after the other; empty: d is 0, or its place has no
  /// part in the derivative.
  dealii::AlignedVector<Matrix> inverses;

  static dealii::EvaluationFlags::EvaluationFlags needed()
  {
    return is_axisymmetric ? dealii::EvaluationFlags::values | dealii::EvaluationFlags::gradients
                           : dealii::EvaluationFlags::gradients;
  }
  /// 1/R in axisymmetry.
  static Lanes hoop(const Evaluation &cell, unsigned int q);
  static Matrix displacement_gradient(const Evaluation &cell, unsigned int q);
  static Matrix inverse_of(Matrix displacement_gradient);
  /// Hands over what a term has given at a point.
  static void submit(Evaluation &cell, const Tested<dim, Lanes> &tested, Lanes factor, unsigned q);
  /// The product of the cells of which `counts` is true.
  template <typename Counts>
  void multiply(Vector &target,
                const Vector &source,
                unsigned int constraints,
                const Counts &counts) const;
};

template <int dim, std::size_t width, int n_points>
MatrixFreeMeshOfWidth<dim, width, n_points>::MatrixFreeMeshOfWidth(const Input &input)
    : is_hyperelastic(input.is_hyperelastic)
{
  typename MatrixFree::AdditionalData data;
  data.tasks_parallel_scheme = MatrixFree::AdditionalData::none;
  data.mapping_update_flags =
      dealii::update_values | dealii::update_gradients | dealii::update_JxW_values;
  if (is_axisymmetric)
    data.mapping_update_flags |= dealii::update_quadrature_points;
  // Cells that count are not mixed with others.
  for (std::size_t i = 0; i < input.stiffness.size(); ++i)
    data.cell_vectorization_category.push_back(input.stiffness[i] == 0. ? 0
                                               : input.has_given[i]     ? 1
                                                                        : 2);
  data.cell_vectorization_categories_strict = true;
  cells.reinit(
      input.mapping,
      std::vector<const dealii::DoFHandler<dim> *>{&input.dof_handler, &input.dof_handler},
      std::vector<const dealii::AffineConstraints<double> *>{&input.constraints, &input.hanging},
      std::vector<dealii::QGauss<1>>{dealii::QGauss<1>(n_points)}, data);
  batches.resize(cells.n_cell_batches());
  for (unsigned int number = 0; number < batches.size(); ++number)
  {
    Batch &batch = batches[number];
    batch.stiffness = 0.;
    for (unsigned int lane = 0; lane < cells.n_active_entries_per_cell_batch(number); ++lane)
    {
      const unsigned int i = cells.get_cell_iterator(number, lane)->active_cell_index();
      batch.stiffness[lane] = input.stiffness[i];
      batch.is_of_body = input.stiffness[i] != 0.;
      batch.has_given = input.has_given[i];
    }
  }
}

template <int dim, std::size_t width, int n_points>
typename MatrixFreeMeshOfWidth<dim, width, n_points>::Lanes
MatrixFreeMeshOfWidth<dim, width, n_points>::hoop([[maybe_unused]] const Evaluation &cell,
                                                  [[maybe_unused]] const unsigned int q)
{
  if constexpr (is_axisymmetric)
    return 1. / cell.quadrature_point(q)[1];
  else
    return 0.;
}

template <int dim, std::size_t width, int n_points>
typename MatrixFreeMeshOfWidth<dim, width, n_points>::Matrix
MatrixFreeMeshOfWidth<dim, width, n_points>::displacement_gradient(const Evaluation &cell,
                                                                   const unsigned int q)
{
  Lanes of_circle = 0.;
  if constexpr (is_axisymmetric)
    of_circle = cell.get_value(q)[1] * hoop(cell, q);
  return MeshStress::whole_gradient(dealii::Tensor<2, dim, Lanes>(cell.get_gradient(q)), of_circle);
}

template <int dim, std::size_t width, int n_points>
typename MatrixFreeMeshOfWidth<dim, width, n_points>::Matrix
MatrixFreeMeshOfWidth<dim, width, n_points>::inverse_of(Matrix displacement_gradient)
{
  for (unsigned int c = 0; c < 3; ++c)
    displacement_gradient[c][c] += Lanes(1.);
  return invert(displacement_gradient);
}

template <int dim, std::size_t width, int n_points>
void MatrixFreeMeshOfWidth<dim, width, n_points>::submit(Evaluation &cell,
                                                         const Tested<dim, Lanes> &tested,
                                                         Lanes factor,
                                                         const unsigned int q)
{
  if constexpr (is_axisymmetric)
  {
    factor *= 2. * dealii::numbers::PI * cell.quadrature_point(q)[1];
    cell.submit_value(factor * tested.by_value, q);
  }
  cell.submit_gradient(factor * tested.by_gradient, q);
}

template <int dim, std::size_t width, int n_points>
void MatrixFreeMeshOfWidth<dim, width, n_points>::set(const Vector &displacement)
{
  if (!is_hyperelastic)
    return;
  Evaluation cell(cells, with_hanging);
  inverses.resize(std::size_t(batches.size()) * Evaluation::static_n_q_points);
  displacement.update_ghost_values();
  for (unsigned int number = 0; number < batches.size(); ++number)
  {
    if (!batches[number].is_of_body)
      continue;
    cell.reinit(number);
    cell.gather_evaluate(displacement, needed());
    for (unsigned int q = 0; q < cell.n_q_points; ++q)
      inverses[std::size_t(number) * Evaluation::static_n_q_points + q] =
          inverse_of(displacement_gradient(cell, q));
  }
  displacement.zero_out_ghost_values();
}

template <int dim, std::size_t width, int n_points>
void MatrixFreeMeshOfWidth<dim, width, n_points>::set_residual(Vector &rows,
                                                               const Vector &displacement) const
{
  cells.template cell_loop<Vector, Vector>(
      [&](const MatrixFree &data, Vector &target, const Vector &source, const Range &range)
      {
        Evaluation cell(data, with_hanging);
        for (unsigned int number = range.first; number < range.second; ++number)
        {
          if (!batches[number].is_of_body)
            continue;
          cell.reinit(number);
          cell.gather_evaluate(source, needed());
          for (unsigned int q = 0; q < cell.n_q_points; ++q)
          {
            MeshPoint<Lanes> point;
            point.is_hyperelastic = is_hyperelastic;
            point.hoop = hoop(cell, q);
            point.displacement_gradient = displacement_gradient(cell, q);
            point.inverse = inverse_of(point.displacement_gradient);
            Tested<dim, Lanes> tested;
            MeshStress::add(point, tested);
            submit(cell, tested, batches[number].stiffness, q);
          }
          cell.integrate_scatter(needed(), target);
        }
      },
      rows, displacement, true);
}

template <int dim, std::size_t width, int n_points>
template <typename Counts>
void MatrixFreeMeshOfWidth<dim, width, n_points>::multiply(Vector &target,
                                                           const Vector &source,
                                                           const unsigned int constraints,
                                                           const Counts &counts) const
{
  cells.template cell_loop<Vector, Vector>(
      [&](const MatrixFree &data, Vector &to, const Vector &from, const Range &range)
      {
        Evaluation cell(data, constraints);
        MeshPoint<Lanes> point;
        point.is_hyperelastic = is_hyperelastic;
        point.inverse = dealii::unit_symmetric_tensor<3, Lanes>();
        for (unsigned int number = range.first; number < range.second; ++number)
        {
          if (!counts(batches[number]))
            continue;
          cell.reinit(number);
          cell.gather_evaluate(from, needed());
          for (unsigned int q = 0; q < cell.n_q_points; ++q)
          {
            if (!inverses.empty())
              point.inverse = inverses[std::size_t(number) * Evaluation::static_n_q_points + q];
            PointChange<dim, Lanes> change;
            change.velocity_gradient = cell.get_gradient(q);
            if constexpr (is_axisymmetric)
            {
              point.hoop = hoop(cell, q);
              change.velocity = cell.get_value(q);
            }
            Tested<dim, Lanes> tested;
            MeshStress::add_derivative(point, change, tested);
            submit(cell, tested, batches[number].stiffness, q);
          }
          cell.integrate_scatter(needed(), to);
        }
      },
      target, source, true);
}

template <int dim, std::size_t width, int n_points>
void MatrixFreeMeshOfWidth<dim, width, n_points>::multiply(Vector &target,
                                                           const Vector &source) const
{
  multiply(target, source, with_all, [](const Batch &batch) { return batch.is_of_body; });
}

template <int dim, std::size_t width, int n_points>
void MatrixFreeMeshOfWidth<dim, width, n_points>::multiply_given(Vector &target,
                                                                 const Vector &source) const
{
  multiply(target, source, with_hanging,
           [](const Batch &batch) { return batch.is_of_body && batch.has_given; });
}

/// `width` is that of double precision.
template <int dim, std::size_t width>
std::unique_ptr<MatrixFreeMesh<dim>>
make_mesh_of_width(const typename MatrixFreeMesh<dim>::Input &input)
{
  if constexpr (dim == 2)
    if (input.is_axisymmetric)
      return std::make_unique<MatrixFreeMeshOfWidth<dim, width, 4>>(input);
  return std::make_unique<MatrixFreeMeshOfWidth<dim, width, 3>>(input);
}
} // namespace Continua

/// The function of one instruction set, with the width of double precision.
#define CONTINUA_DEFINE_MATRIX_FREE_MESH(name, width)                                              \
  namespace Continua                                                                               \
  {                                                                                                \
  template <int dim>                                                                               \
  std::unique_ptr<MatrixFreeMesh<dim>> name(const typename MatrixFreeMesh<dim>::Input &input)      \
  {                                                                                                \
    return make_mesh_of_width<dim, width>(input);                                                  \
  }                                                                                                \
  }
/// Compiles it for a dimension.
#define CONTINUA_INSTANTIATE_MATRIX_FREE_MESH(name, dim)                                           \
  namespace Continua                                                                               \
  {                                                                                                \
  template std::unique_ptr<MatrixFreeMesh<dim>> name<dim>(const MatrixFreeMesh<dim>::Input &);     \
  }

#endif
