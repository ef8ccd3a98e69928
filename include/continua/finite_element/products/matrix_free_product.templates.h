#ifndef continua_finite_element_products_matrix_free_product_templates_h
#define continua_finite_element_products_matrix_free_product_templates_h

#include <continua/finite_element/products/matrix_free_product.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/matrix_free/fe_evaluation.h>
#include <deal.II/matrix_free/matrix_free.h>
#include <deal.II/matrix_free/tools.h>

#include <array>
#include <memory>
#include <utility>
#include <vector>

namespace Continua
{
/// With `width` cells at a time and `n_points` Gauss points in each direction. More points than the
/// degree needs: axisymmetry.
template <int dim, typename Number, std::size_t width, int n_points>
class MatrixFreeProductOfWidth : public MatrixFreeProduct<dim, Number>
{
public:
  using Base = MatrixFreeProduct<dim, Number>;
  using Vector = typename Base::Vector;

  explicit MatrixFreeProductOfWidth(const typename Base::Input &input);

  std::unique_ptr<Base> share() const override;
  void restrict_to(const std::vector<bool> &is_wanted) override;
  void set(const typename Base::Coefficients &coefficients) override;
  void initialise(Vector &vector) const override { cells->initialize_dof_vector(vector, 0); }
  void multiply(Vector &target, const Vector &source) const override;
  void multiply_coupled(Vector &momentum,
                        double *volume,
                        const Vector &velocity,
                        const double *pressure) const override;
  void add_divergence(double *volume, const Vector &velocity) const override;
  void multiply_gradient(Vector &momentum, const double *pressure) const override;
  void find_diagonal(Vector &diagonal) const override;
  void initialise_of_region(Vector &vector) const override
  {
    cells->initialize_dof_vector(vector, 1);
  }
  void multiply_region(Vector &target,
                       const Vector &source,
                       unsigned int region,
                       double mass,
                       double stiffness) const override;
  void find_diagonal(Vector &diagonal,
                     unsigned int region,
                     double mass,
                     double stiffness) const override;
  std::size_t memory() const override
  {
    return cells->memory_consumption() + sizeof(OfBatch) * of_batches.size() +
           sizeof(Materials) * materials.size() + is_left_out.size() / 8 +
           (pressures ? sizeof(PressurePlaces) * pressures->places.size() : 0);
  }

private:
  static constexpr int degree = 2;
  static constexpr bool is_axisymmetric = n_points > degree + 1;
  using Lanes = dealii::VectorizedArray<Number, width>;
  using MatrixFree = dealii::MatrixFree<dim, Number, Lanes>;
  using Evaluation = dealii::FEEvaluation<dim, degree, n_points, dim, Number, Lanes>;

  struct OfBatch
  {
    Lanes mass, stiffness, volumetric;
  };
  using Materials = std::array<dealii::types::material_id, width>;
  static constexpr unsigned int n_pressures = 1U << dim; ///< of a cell
  static constexpr unsigned int n_of_points = Evaluation::static_n_q_points;
  /// Of a batch: the places of its cells' pressures; -1 of lanes without a cell.
  using PressurePlaces = std::array<std::array<int, width>, n_pressures>;
  /// What products with the divergence need.
  struct Pressures
  {
    std::vector<PressurePlaces> places; ///< by batch
    /// The linear shape functions at the points.
    std::array<std::array<Number, n_pressures>, n_of_points> shapes;
  };
  using PressureValues = std::array<Lanes, n_pressures>;

  std::shared_ptr<MatrixFree> cells; ///< of all products that share
  std::vector<Materials> materials;  ///< of the cells of each batch
  dealii::AlignedVector<OfBatch> of_batches;
  std::shared_ptr<const Pressures> pressures; ///< of all products that share; null: none
  std::vector<bool> is_left_out;              ///< by batch; empty: none is

  /// Of one region alone; false if the batch has no cell of it.
  bool find_coefficients(unsigned int batch,
                         unsigned int region,
                         Number mass,
                         Number stiffness,
                         OfBatch &result) const;
  void set_pressures(const std::vector<int> &places_of_cells);
  void read(unsigned int batch, const double *pressure, PressureValues &values) const;
  void add(unsigned int batch, const PressureValues &rows, double *volume) const;
  /// Of the pressure at a point.
  Lanes pressure_at(unsigned int q, const PressureValues &values) const;
  /// From the values at a point to what is integrated there, less the force of a pressure.
  static void
  integrate_at(Evaluation &cell, const OfBatch &coefficients, unsigned int q, Lanes pressure);
  /// From the values of a cell to its integrals.
  static void integrate(Evaluation &cell, const OfBatch &coefficients);
  /// The same less the force of a pressure, and the rows of the divergence.
  void integrate_coupled(Evaluation &cell,
                         const OfBatch &coefficients,
                         const PressureValues &values,
                         PressureValues &rows) const;
  /// Of the velocity at a point; sets the radius in axisymmetry.
  static Lanes divergence_at(const Evaluation &cell, unsigned int q, Lanes &radius);
  /// Adds up the diagonal with the coefficients that a batch has.
  template <typename Coefficients>
  void
  find_diagonal(Vector &diagonal, unsigned int constraints, const Coefficients &coefficients) const;
  void multiply_cells(const MatrixFree &data,
                      Vector &target,
                      const Vector &source,
                      const std::pair<unsigned int, unsigned int> &range) const;
};

template <int dim, typename Number, std::size_t width, int n_points>
MatrixFreeProductOfWidth<dim, Number, width, n_points>::MatrixFreeProductOfWidth(
    const typename Base::Input &input)
    : cells(std::make_shared<MatrixFree>())
{
  typename MatrixFree::AdditionalData data;
  data.tasks_parallel_scheme = MatrixFree::AdditionalData::none;
  data.mapping_update_flags =
      dealii::update_values | dealii::update_gradients | dealii::update_JxW_values;
  if (is_axisymmetric)
    data.mapping_update_flags |= dealii::update_quadrature_points;
  std::vector<const dealii::DoFHandler<dim> *> dof_handlers = {&input.dof_handler};
  std::vector<const dealii::AffineConstraints<double> *> constraints = {&input.constraints};
  if (input.region_constraints != nullptr)
  {
    dof_handlers.push_back(&input.dof_handler);
    constraints.push_back(input.region_constraints);
  }
  cells->reinit(input.mapping, dof_handlers, constraints,
                std::vector<dealii::QGauss<1>>{dealii::QGauss<1>(n_points)}, data);
  materials.resize(cells->n_cell_batches());
  for (unsigned int batch = 0; batch < materials.size(); ++batch)
  {
    materials[batch].fill(dealii::numbers::invalid_material_id);
    for (unsigned int lane = 0; lane < cells->n_active_entries_per_cell_batch(batch); ++lane)
      materials[batch][lane] = cells->get_cell_iterator(batch, lane)->material_id();
  }
  if (!input.pressure_places.empty())
    set_pressures(input.pressure_places);
}

template <int dim, typename Number, std::size_t width, int n_points>
void MatrixFreeProductOfWidth<dim, Number, width, n_points>::set_pressures(
    const std::vector<int> &places_of_cells)
{
  auto result = std::make_shared<Pressures>();
  result->places.resize(materials.size());
  for (unsigned int batch = 0; batch < materials.size(); ++batch)
    for (unsigned int k = 0; k < n_pressures; ++k)
    {
      result->places[batch][k].fill(-1);
      for (unsigned int lane = 0; lane < cells->n_active_entries_per_cell_batch(batch); ++lane)
        result->places[batch][k][lane] = places_of_cells
            [std::size_t(cells->get_cell_iterator(batch, lane)->active_cell_index()) * n_pressures +
             k];
    }
  const dealii::QGauss<dim> points(n_points);
  for (unsigned int q = 0; q < n_of_points; ++q)
    for (unsigned int k = 0; k < n_pressures; ++k)
      result->shapes[q][k] = static_cast<Number>(
          dealii::GeometryInfo<dim>::d_linear_shape_function(points.point(q), k));
  pressures = result;
}

template <int dim, typename Number, std::size_t width, int n_points>
std::unique_ptr<MatrixFreeProduct<dim, Number>>
MatrixFreeProductOfWidth<dim, Number, width, n_points>::share() const
{
  auto result = std::make_unique<MatrixFreeProductOfWidth>(*this);
  result->of_batches.clear();
  result->is_left_out.clear();
  return result;
}

template <int dim, typename Number, std::size_t width, int n_points>
void MatrixFreeProductOfWidth<dim, Number, width, n_points>::restrict_to(
    const std::vector<bool> &is_wanted)
{
  Vector wanted;
  initialise(wanted);
  // A hanging node adds multiples of both signs: the values must not cancel.
  for (unsigned int i = 0; i < is_wanted.size(); ++i)
    if (is_wanted[i])
      wanted.local_element(i) = static_cast<Number>(1. + (i * 37 % 101) / 101.);
  wanted.update_ghost_values();
  is_left_out.assign(materials.size(), true);
  Evaluation cell(*cells, 0);
  for (unsigned int batch = 0; batch < materials.size(); ++batch)
  {
    cell.reinit(batch);
    cell.read_dof_values(wanted);
    for (unsigned int i = 0; i < Evaluation::static_dofs_per_cell && is_left_out[batch]; ++i)
      for (unsigned int lane = 0; lane < width; ++lane)
        if (cell.begin_dof_values()[i][lane] != Number())
          is_left_out[batch] = false;
  }
}

template <int dim, typename Number, std::size_t width, int n_points>
void MatrixFreeProductOfWidth<dim, Number, width, n_points>::set(
    const typename Base::Coefficients &coefficients)
{
  of_batches.resize(materials.size());
  for (unsigned int batch = 0; batch < of_batches.size(); ++batch)
    for (unsigned int lane = 0; lane < width; ++lane)
    {
      const auto material = materials[batch][lane];
      if (material == dealii::numbers::invalid_material_id)
        continue;
      of_batches[batch].mass[lane] = static_cast<Number>(coefficients.mass[material]);
      of_batches[batch].stiffness[lane] = static_cast<Number>(coefficients.stiffness[material]);
      of_batches[batch].volumetric[lane] =
          coefficients.volumetric.empty() ? Number()
                                          : static_cast<Number>(coefficients.volumetric[material]);
      const auto index = cells->get_cell_iterator(batch, lane)->active_cell_index();
      if (!coefficients.volumetric_of_cells.empty())
        of_batches[batch].volumetric[lane] +=
            static_cast<Number>(coefficients.volumetric_of_cells[index]);
      if (!coefficients.stiffness_of_cells.empty())
        of_batches[batch].stiffness[lane] +=
            static_cast<Number>(coefficients.stiffness_of_cells[index]);
    }
}

template <int dim, typename Number, std::size_t width, int n_points>
bool MatrixFreeProductOfWidth<dim, Number, width, n_points>::find_coefficients(
    const unsigned int batch,
    const unsigned int region,
    const Number mass,
    const Number stiffness,
    OfBatch &result) const
{
  result = OfBatch();
  bool is_there = false;
  for (unsigned int lane = 0; lane < width; ++lane)
    if (materials[batch][lane] == region)
    {
      result.mass[lane] = mass;
      result.stiffness[lane] = stiffness;
      is_there = true;
    }
  return is_there;
}

template <int dim, typename Number, std::size_t width, int n_points>
void MatrixFreeProductOfWidth<dim, Number, width, n_points>::multiply(Vector &target,
                                                                      const Vector &source) const
{
  cells->cell_loop(&MatrixFreeProductOfWidth::multiply_cells, this, target, source, true);
}

template <int dim, typename Number, std::size_t width, int n_points>
void MatrixFreeProductOfWidth<dim, Number, width, n_points>::read(const unsigned int batch,
                                                                  const double *const pressure,
                                                                  PressureValues &values) const
{
  for (unsigned int k = 0; k < n_pressures; ++k)
    for (unsigned int lane = 0; lane < width; ++lane)
    {
      const int place = pressures->places[batch][k][lane];
      values[k][lane] = place < 0 ? Number() : static_cast<Number>(pressure[place]);
    }
}

template <int dim, typename Number, std::size_t width, int n_points>
void MatrixFreeProductOfWidth<dim, Number, width, n_points>::add(const unsigned int batch,
                                                                 const PressureValues &rows,
                                                                 double *const volume) const
{
  for (unsigned int k = 0; k < n_pressures; ++k)
    for (unsigned int lane = 0; lane < width; ++lane)
    {
      const int place = pressures->places[batch][k][lane];
      if (place >= 0)
        volume[place] += rows[k][lane];
    }
}

template <int dim, typename Number, std::size_t width, int n_points>
typename MatrixFreeProductOfWidth<dim, Number, width, n_points>::Lanes
MatrixFreeProductOfWidth<dim, Number, width, n_points>::pressure_at(
    const unsigned int q, const PressureValues &values) const
{
  Lanes result = Number();
  for (unsigned int k = 0; k < n_pressures; ++k)
    result += pressures->shapes[q][k] * values[k];
  return result;
}

template <int dim, typename Number, std::size_t width, int n_points>
typename MatrixFreeProductOfWidth<dim, Number, width, n_points>::Lanes
MatrixFreeProductOfWidth<dim, Number, width, n_points>::divergence_at(
    const Evaluation &cell, const unsigned int q, [[maybe_unused]] Lanes &radius)
{
  Lanes result = cell.get_divergence(q);
  if constexpr (is_axisymmetric)
  {
    radius = cell.quadrature_point(q)[1];
    result += cell.get_value(q)[1] / radius;
  }
  return result;
}

template <int dim, typename Number, std::size_t width, int n_points>
void MatrixFreeProductOfWidth<dim, Number, width, n_points>::integrate_coupled(
    Evaluation &cell,
    const OfBatch &coefficients,
    const PressureValues &values,
    PressureValues &rows) const
{
  rows.fill(Number());
  for (unsigned int q = 0; q < cell.n_q_points; ++q)
  {
    Lanes radius = Number();
    // Before the integrals take the place of the values.
    Lanes volume = divergence_at(cell, q, radius) * cell.JxW(q);
    if constexpr (is_axisymmetric)
      volume *= static_cast<Number>(2. * dealii::numbers::PI) * radius;
    for (unsigned int k = 0; k < n_pressures; ++k)
      rows[k] += pressures->shapes[q][k] * volume;
    integrate_at(cell, coefficients, q, pressure_at(q, values));
  }
}

template <int dim, typename Number, std::size_t width, int n_points>
void MatrixFreeProductOfWidth<dim, Number, width, n_points>::multiply_coupled(
    Vector &momentum,
    double *const volume,
    const Vector &velocity,
    const double *const pressure) const
{
  cells->template cell_loop<Vector, Vector>(
      [&](const MatrixFree &data, Vector &to, const Vector &from,
          const std::pair<unsigned int, unsigned int> &range)
      {
        const auto flags = dealii::EvaluationFlags::values | dealii::EvaluationFlags::gradients;
        Evaluation cell(data, 0);
        PressureValues values, rows;
        for (unsigned int batch = range.first; batch < range.second; ++batch)
        {
          cell.reinit(batch);
          cell.gather_evaluate(from, flags);
          read(batch, pressure, values);
          integrate_coupled(cell, of_batches[batch], values, rows);
          add(batch, rows, volume);
          cell.integrate_scatter(flags, to);
        }
      },
      momentum, velocity, true);
}

template <int dim, typename Number, std::size_t width, int n_points>
void MatrixFreeProductOfWidth<dim, Number, width, n_points>::add_divergence(
    double *const volume, const Vector &velocity) const
{
  const auto flags = is_axisymmetric
                         ? dealii::EvaluationFlags::values | dealii::EvaluationFlags::gradients
                         : dealii::EvaluationFlags::gradients;
  Evaluation cell(*cells, 0);
  PressureValues rows;
  velocity.update_ghost_values();
  for (unsigned int batch = 0; batch < materials.size(); ++batch)
  {
    cell.reinit(batch);
    cell.gather_evaluate(velocity, flags);
    rows.fill(Number());
    for (unsigned int q = 0; q < cell.n_q_points; ++q)
    {
      Lanes radius = Number();
      Lanes of_point = divergence_at(cell, q, radius) * cell.JxW(q);
      if constexpr (is_axisymmetric)
        of_point *= static_cast<Number>(2. * dealii::numbers::PI) * radius;
      for (unsigned int k = 0; k < n_pressures; ++k)
        rows[k] += pressures->shapes[q][k] * of_point;
    }
    add(batch, rows, volume);
  }
  velocity.zero_out_ghost_values();
}

template <int dim, typename Number, std::size_t width, int n_points>
void MatrixFreeProductOfWidth<dim, Number, width, n_points>::multiply_gradient(
    Vector &momentum, const double *const pressure) const
{
  // The loop sets a vector to zero only where the source is another one.
  momentum = Number();
  cells->template cell_loop<Vector, Vector>(
      [&](const MatrixFree &data, Vector &to, const Vector & /*from*/,
          const std::pair<unsigned int, unsigned int> &range)
      {
        const auto flags =
            is_axisymmetric ? dealii::EvaluationFlags::values | dealii::EvaluationFlags::gradients
                            : dealii::EvaluationFlags::gradients;
        Evaluation cell(data, 0);
        PressureValues values;
        for (unsigned int batch = range.first; batch < range.second; ++batch)
        {
          cell.reinit(batch);
          read(batch, pressure, values);
          for (unsigned int q = 0; q < cell.n_q_points; ++q)
          {
            Lanes of_point = pressure_at(q, values);
            if constexpr (is_axisymmetric)
            {
              const Lanes radius = cell.quadrature_point(q)[1];
              of_point *= static_cast<Number>(2. * dealii::numbers::PI) * radius;
              dealii::Tensor<1, dim, Lanes> force;
              force[1] = of_point / radius;
              cell.submit_value(force, q);
            }
            cell.submit_divergence(of_point, q);
          }
          cell.integrate_scatter(flags, to);
        }
      },
      momentum, momentum, false);
}

template <int dim, typename Number, std::size_t width, int n_points>
void MatrixFreeProductOfWidth<dim, Number, width, n_points>::multiply_region(
    Vector &target,
    const Vector &source,
    const unsigned int region,
    const double mass,
    const double stiffness) const
{
  cells->template cell_loop<Vector, Vector>(
      [&](const MatrixFree &data, Vector &to, const Vector &from,
          const std::pair<unsigned int, unsigned int> &range)
      {
        const auto flags = dealii::EvaluationFlags::values | dealii::EvaluationFlags::gradients;
        Evaluation cell(data, 1);
        OfBatch coefficients;
        for (unsigned int batch = range.first; batch < range.second; ++batch)
          if (find_coefficients(batch, region, static_cast<Number>(mass),
                                static_cast<Number>(stiffness), coefficients))
          {
            cell.reinit(batch);
            cell.gather_evaluate(from, flags);
            integrate(cell, coefficients);
            cell.integrate_scatter(flags, to);
          }
      },
      target, source, true);
}

template <int dim, typename Number, std::size_t width, int n_points>
template <typename Coefficients>
void MatrixFreeProductOfWidth<dim, Number, width, n_points>::find_diagonal(
    Vector &diagonal, const unsigned int constraints, const Coefficients &coefficients) const
{
  diagonal = Number();
  dealii::MatrixFreeTools::compute_diagonal<dim, degree, n_points, dim, Number, Lanes>(
      *cells, diagonal,
      [&coefficients](Evaluation &cell)
      {
        const auto flags = dealii::EvaluationFlags::values | dealii::EvaluationFlags::gradients;
        cell.evaluate(flags);
        integrate(cell, coefficients(cell.get_current_cell_index()));
        cell.integrate(flags);
      },
      constraints);
}

template <int dim, typename Number, std::size_t width, int n_points>
void MatrixFreeProductOfWidth<dim, Number, width, n_points>::find_diagonal(Vector &diagonal) const
{
  find_diagonal(diagonal, 0, [this](const unsigned int batch) { return of_batches[batch]; });
}

template <int dim, typename Number, std::size_t width, int n_points>
void MatrixFreeProductOfWidth<dim, Number, width, n_points>::find_diagonal(
    Vector &diagonal, const unsigned int region, const double mass, const double stiffness) const
{
  find_diagonal(diagonal, 1,
                [&](const unsigned int batch)
                {
                  OfBatch coefficients;
                  find_coefficients(batch, region, static_cast<Number>(mass),
                                    static_cast<Number>(stiffness), coefficients);
                  return coefficients;
                });
}

template <int dim, typename Number, std::size_t width, int n_points>
void MatrixFreeProductOfWidth<dim, Number, width, n_points>::integrate_at(
    Evaluation &cell, const OfBatch &coefficients, const unsigned int q, const Lanes pressure)
{
  const auto velocity = cell.get_value(q);
  dealii::SymmetricTensor<2, dim, Lanes> rate = cell.get_symmetric_gradient(q);
  Lanes dilatation = trace(rate);
  auto force = coefficients.mass * velocity;
  if constexpr (is_axisymmetric)
  {
    const Lanes radius = cell.quadrature_point(q)[1];
    const Lanes circumference = static_cast<Number>(2. * dealii::numbers::PI) * radius;
    const Lanes hoop = velocity[1] / radius;
    dilatation += hoop;
    const Lanes mean_part =
        (coefficients.volumetric - static_cast<Number>(2. / 3.) * coefficients.stiffness) *
            dilatation -
        pressure;
    force[1] += (static_cast<Number>(2.) * coefficients.stiffness * hoop + mean_part) / radius;
    rate *= static_cast<Number>(2.) * coefficients.stiffness;
    for (int c = 0; c < dim; ++c)
      rate[c][c] += mean_part;
    force *= circumference;
    rate *= circumference;
  }
  else
  {
    const Lanes mean_part =
        (coefficients.volumetric - static_cast<Number>(2. / 3.) * coefficients.stiffness) *
            dilatation -
        pressure;
    rate *= static_cast<Number>(2.) * coefficients.stiffness;
    for (int c = 0; c < dim; ++c)
      rate[c][c] += mean_part;
  }
  cell.submit_value(force, q);
  cell.submit_symmetric_gradient(rate, q);
}

template <int dim, typename Number, std::size_t width, int n_points>
void MatrixFreeProductOfWidth<dim, Number, width, n_points>::integrate(Evaluation &cell,
                                                                       const OfBatch &coefficients)
{
  for (unsigned int q = 0; q < cell.n_q_points; ++q)
    integrate_at(cell, coefficients, q, Number());
}

template <int dim, typename Number, std::size_t width, int n_points>
void MatrixFreeProductOfWidth<dim, Number, width, n_points>::multiply_cells(
    const MatrixFree &data,
    Vector &target,
    const Vector &source,
    const std::pair<unsigned int, unsigned int> &range) const
{
  const auto flags = dealii::EvaluationFlags::values | dealii::EvaluationFlags::gradients;
  Evaluation cell(data, 0);
  for (unsigned int batch = range.first; batch < range.second; ++batch)
  {
    if (!is_left_out.empty() && is_left_out[batch])
      continue;
    cell.reinit(batch);
    cell.gather_evaluate(source, flags);
    integrate(cell, of_batches[batch]);
    cell.integrate_scatter(flags, target);
  }
}

/// `width` is that of double precision.
template <int dim, typename Number, std::size_t width>
std::unique_ptr<MatrixFreeProduct<dim, Number>>
make_product_of_width(const typename MatrixFreeProduct<dim, Number>::Input &input)
{
  constexpr std::size_t lanes = width == 1 ? 1 : width * sizeof(double) / sizeof(Number);
  if constexpr (dim == 2)
    if (input.is_axisymmetric)
      return std::make_unique<MatrixFreeProductOfWidth<dim, Number, lanes, 4>>(input);
  return std::make_unique<MatrixFreeProductOfWidth<dim, Number, lanes, 3>>(input);
}
} // namespace Continua

/// The function of one instruction set, with the width of double precision.
#define CONTINUA_DEFINE_MATRIX_FREE_PRODUCT(name, width)                                           \
  namespace Continua                                                                               \
  {                                                                                                \
  template <int dim, typename Number>                                                              \
  std::unique_ptr<MatrixFreeProduct<dim, Number>>                                                  \
  name(const typename MatrixFreeProduct<dim, Number>::Input &input)                                \
  {                                                                                                \
    return make_product_of_width<dim, Number, width>(input);                                       \
  }                                                                                                \
  }
/// Compiles it for a dimension and a type of numbers.
#define CONTINUA_INSTANTIATE_MATRIX_FREE_PRODUCT(name, dim, Number)                                \
  namespace Continua                                                                               \
  {                                                                                                \
  template std::unique_ptr<MatrixFreeProduct<dim, Number>>                                         \
  name<dim, Number>(const MatrixFreeProduct<dim, Number>::Input &);                                \
  }

#endif
