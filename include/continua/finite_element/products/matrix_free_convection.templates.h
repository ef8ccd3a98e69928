#ifndef continua_finite_element_products_matrix_free_convection_templates_h
#define continua_finite_element_products_matrix_free_convection_templates_h

#include <continua/finite_element/products/matrix_free_convection.h>
#include <continua/finite_element/terms/flow_terms.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_dgq.h>
#include <deal.II/matrix_free/fe_evaluation.h>
#include <deal.II/matrix_free/matrix_free.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace Continua
{
/// With `width` cells at a time.
template <int dim, std::size_t width, bool is_axisymmetric>
class MatrixFreeConvectionOfWidth : public MatrixFreeConvection<dim>
{
public:
  using Base = MatrixFreeConvection<dim>;
  using typename Base::Input;
  using typename Base::Liquid;
  using typename Base::State;
  using typename Base::Vector;

  explicit MatrixFreeConvectionOfWidth(const Input &input);

  void initialise(Vector &vector) const override
  {
    matrix_free.initialize_dof_vector(vector, of_velocity);
  }
  void set(const State *state_of_products) override { state = state_of_products; }
  void multiply(Vector &momentum,
                std::vector<double> &volume,
                const Vector &velocity,
                const double *pressure) const override;

private:
  // The same as in ConvectiveTerms.
  static constexpr int degree = 2, n_points = 4;
  static constexpr unsigned int of_velocity = 0, of_pressure = 1;
  using Lanes = dealii::VectorizedArray<double, width>;
  using MatrixFree = dealii::MatrixFree<dim, double, Lanes>;
  using VelocityCell = dealii::FEEvaluation<dim, degree, n_points, dim, double, Lanes>;
  using PressureCell = dealii::FEEvaluation<dim, degree - 1, n_points, 1, double, Lanes>;
  using Vector1 = dealii::Tensor<1, dim, Lanes>;
  using Vector2 = dealii::Tensor<2, dim, Lanes>;

  static constexpr unsigned int no_cell = static_cast<unsigned int>(-1);

  /// Of the cells of a batch; lanes without a cell that counts have zeros.
  struct Batch
  {
    std::array<unsigned int, width> cells; ///< active_cell_index(), or no_cell
    std::array<const Liquid *, width> liquids;
    Lanes share; ///< 1, of lanes without a cell 0
    Lanes density, viscosity, viscosity_over_speed;
    bool is_liquid = false, is_compressible = false, has_flow_curve = false;
  };

  using Point = FlowPoint<dim, Lanes>;

  /// What the motion of the mesh makes of integrals over the undeformed mesh, at a point.
  struct Motion
  {
    Vector2 inverse;         ///< F^-1 in the plane or in space [1]
    Lanes volume_ratio = 1.; ///< without that of the circumferences [1]
    Lanes stretch = 1.;      ///< of the circumferences, in axisymmetry [1]
    Vector1 mesh_velocity;   ///< W [m/s]
  };

  /// Pressures are read by the places that are given: this is for their shape functions alone.
  dealii::DoFHandler<dim> shapes_of_pressure;
  MatrixFree matrix_free;
  const std::vector<Liquid> liquids;
  const bool mesh_moves;
  FlowScheme scheme;
  const std::vector<int> pressure_places;
  dealii::AlignedVector<Batch> batches;
  const State *state = nullptr;

  void make_batches(const Input &input);
  /// The values of a cell's pressures.
  void read(const Batch &batch, const double *entries, PressureCell &cell) const;
  /// Sets what the liquids of a batch are at a point.
  void set_materials(const Batch &batch, Point &point) const;
  static Motion motion_at(const VelocityCell &of_displacement,
                          const VelocityCell &of_mesh_velocity,
                          unsigned int q);
};

template <int dim, std::size_t width, bool is_axisymmetric>
MatrixFreeConvectionOfWidth<dim, width, is_axisymmetric>::MatrixFreeConvectionOfWidth(
    const Input &input)
    : shapes_of_pressure(input.dof_handler.get_triangulation()),
      liquids(input.liquids),
      mesh_moves(input.mesh_moves),
      pressure_places(input.pressure_places)
{
  scheme.carries = input.carries;
  scheme.skew = input.is_skew ? 0.5 : 0.;
  scheme.grad_div_viscosity = input.constant_viscosity;
  typename MatrixFree::AdditionalData data;
  data.tasks_parallel_scheme = MatrixFree::AdditionalData::none;
  data.mapping_update_flags =
      dealii::update_values | dealii::update_gradients | dealii::update_JxW_values;
  if (is_axisymmetric)
    data.mapping_update_flags |= dealii::update_quadrature_points;
  // Cells that count are not mixed with others.
  data.cell_vectorization_category.resize(input.has_cell.size());
  std::copy(input.has_cell.begin(), input.has_cell.end(), data.cell_vectorization_category.begin());
  data.cell_vectorization_categories_strict = true;
  shapes_of_pressure.distribute_dofs(dealii::FE_DGQ<dim>(degree - 1));
  const dealii::AffineConstraints<double> none;
  matrix_free.reinit(
      input.mapping,
      std::vector<const dealii::DoFHandler<dim> *>{&input.dof_handler, &shapes_of_pressure},
      std::vector<const dealii::AffineConstraints<double> *>{&input.hanging, &none},
      std::vector<dealii::QGauss<1>>{dealii::QGauss<1>(n_points)}, data);
  make_batches(input);
}

template <int dim, std::size_t width, bool is_axisymmetric>
void MatrixFreeConvectionOfWidth<dim, width, is_axisymmetric>::make_batches(const Input &input)
{
  batches.resize(matrix_free.n_cell_batches());
  for (unsigned int number = 0; number < batches.size(); ++number)
  {
    Batch &batch = batches[number];
    batch.cells.fill(no_cell);
    batch.liquids.fill(nullptr);
    for (unsigned int lane = 0; lane < matrix_free.n_active_entries_per_cell_batch(number); ++lane)
    {
      const auto cell = matrix_free.get_cell_iterator(number, lane, of_velocity);
      const unsigned int index = cell->active_cell_index();
      if (!input.has_cell[index])
        continue;
      const Liquid &liquid = liquids[cell->material_id()];
      batch.cells[lane] = index;
      batch.liquids[lane] = &liquid;
      batch.share[lane] = 1.;
      batch.density[lane] = liquid.density;
      batch.viscosity[lane] = liquid.viscosity;
      batch.viscosity_over_speed[lane] = input.viscosity_over_speed[index];
      batch.is_liquid = true;
      if (liquid.volume_law.inverse_bulk_modulus != 0.)
        batch.is_compressible = true;
      if (liquid.flow_curve)
        batch.has_flow_curve = true;
    }
  }
}

template <int dim, std::size_t width, bool is_axisymmetric>
void MatrixFreeConvectionOfWidth<dim, width, is_axisymmetric>::read(const Batch &batch,
                                                                    const double *const entries,
                                                                    PressureCell &cell) const
{
  for (unsigned int k = 0; k < Base::n_pressures; ++k)
  {
    Lanes value = 0.;
    for (unsigned int lane = 0; lane < width; ++lane)
      if (batch.cells[lane] != no_cell)
        value[lane] = entries[pressure_places[batch.cells[lane] * Base::n_pressures + k]];
    cell.submit_dof_value(value, k);
  }
}

template <int dim, std::size_t width, bool is_axisymmetric>
void MatrixFreeConvectionOfWidth<dim, width, is_axisymmetric>::set_materials(const Batch &batch,
                                                                             Point &point) const
{
  point.density = batch.density;
  point.viscosity = batch.viscosity;
  point.grad_div_over_speed = batch.viscosity_over_speed;
  if (batch.is_compressible)
    for (unsigned int lane = 0; lane < width; ++lane)
      if (batch.liquids[lane] != nullptr)
      {
        const VolumeLaw &law = batch.liquids[lane]->volume_law;
        point.density[lane] *= law.density_ratio(point.pressure[lane]);
        point.compressibility[lane] = law.compressibility(point.pressure[lane]);
        point.compressibility_slope[lane] = law.compressibility_slope(point.pressure[lane]);
      }
  if (!batch.has_flow_curve)
    return;
  const Lanes shear_rate = point.shear_rate();
  for (unsigned int lane = 0; lane < width; ++lane)
    if (batch.liquids[lane] != nullptr && batch.liquids[lane]->flow_curve)
    {
      const FlowCurve &curve = *batch.liquids[lane]->flow_curve;
      point.viscosity[lane] = curve.viscosity(shear_rate[lane]);
      point.viscosity_slope[lane] = curve.slope_over_rate(shear_rate[lane]);
    }
}

template <int dim, std::size_t width, bool is_axisymmetric>
typename MatrixFreeConvectionOfWidth<dim, width, is_axisymmetric>::Motion
MatrixFreeConvectionOfWidth<dim, width, is_axisymmetric>::motion_at(
    const VelocityCell &of_displacement, const VelocityCell &of_mesh_velocity, const unsigned int q)
{
  Motion motion;
  Vector2 gradient = of_displacement.get_gradient(q);
  for (unsigned int c = 0; c < dim; ++c)
    gradient[c][c] += Lanes(1.);
  motion.inverse = invert(gradient);
  motion.volume_ratio = determinant(gradient);
  if constexpr (is_axisymmetric)
    motion.stretch = 1. + of_displacement.get_value(q)[1] / of_displacement.quadrature_point(q)[1];
  motion.mesh_velocity = of_mesh_velocity.get_value(q);
  return motion;
}

template <int dim, std::size_t width, bool is_axisymmetric>
void MatrixFreeConvectionOfWidth<dim, width, is_axisymmetric>::multiply(
    Vector &momentum,
    std::vector<double> &volume,
    const Vector &velocity,
    const double *const pressure) const
{
  const auto values = dealii::EvaluationFlags::values;
  const auto gradients = dealii::EvaluationFlags::gradients;
  const auto both = dealii::EvaluationFlags::values | dealii::EvaluationFlags::gradients;
  matrix_free.template cell_loop<Vector, Vector>(
      [&](const MatrixFree &data, Vector &target, const Vector &source,
          const std::pair<unsigned int, unsigned int> &range)
      {
        VelocityCell of_state(data, of_velocity), of_acceleration(data, of_velocity),
            of_change(data, of_velocity), of_displacement(data, of_velocity),
            of_mesh_velocity(data, of_velocity);
        PressureCell pressure_of_state(data, of_pressure), rate_of_state(data, of_pressure),
            pressure_of_change(data, of_pressure);
        for (unsigned int number = range.first; number < range.second; ++number)
        {
          const Batch &batch = batches[number];
          if (!batch.is_liquid)
            continue;
          for (VelocityCell *const cell : {&of_state, &of_acceleration, &of_change})
            cell->reinit(number);
          of_state.gather_evaluate(state->velocity, both);
          of_change.gather_evaluate(source, both);
          pressure_of_change.reinit(number);
          read(batch, pressure, pressure_of_change);
          pressure_of_change.evaluate(batch.is_compressible ? both : values);
          // Only changes of the density multiply the acceleration.
          if (batch.is_compressible)
          {
            of_acceleration.gather_evaluate(state->acceleration, values);
            for (PressureCell *const cell : {&pressure_of_state, &rate_of_state})
              cell->reinit(number);
            read(batch, state->pressure.data(), pressure_of_state);
            read(batch, state->pressure_rate.data(), rate_of_state);
            pressure_of_state.evaluate(both);
            rate_of_state.evaluate(values);
          }
          if (mesh_moves)
          {
            for (VelocityCell *const cell : {&of_displacement, &of_mesh_velocity})
              cell->reinit(number);
            of_displacement.gather_evaluate(state->mesh_displacement,
                                            is_axisymmetric ? both : gradients);
            of_mesh_velocity.gather_evaluate(state->mesh_velocity, values);
          }
          for (unsigned int q = 0; q < of_change.n_q_points; ++q)
          {
            Point point;
            Motion motion;
            PointChange<dim, Lanes> of_unknowns;
            point.scheme = scheme;
            point.scheme.rate_by_velocity = state->acceleration_by_velocity;
            point.scheme.pressure_rate_by_pressure = state->pressure_rate_by_pressure;
            Lanes factor = batch.share;
            if (mesh_moves)
            {
              motion = motion_at(of_displacement, of_mesh_velocity, q);
              factor *= motion.volume_ratio * motion.stretch;
            }
            if constexpr (is_axisymmetric)
            {
              const Lanes radius = of_change.quadrature_point(q)[1];
              point.hoop = 1. / (radius * motion.stretch);
              factor *= 2. * dealii::numbers::PI * radius;
            }
            point.velocity = of_state.get_value(q);
            point.carrier = scheme.carries * point.velocity;
            point.velocity_gradient = of_state.get_gradient(q);
            of_unknowns.velocity = of_change.get_value(q);
            of_unknowns.velocity_gradient = of_change.get_gradient(q);
            of_unknowns.pressure = pressure_of_change.get_value(q);
            if (batch.is_compressible)
            {
              point.acceleration = of_acceleration.get_value(q);
              point.pressure = pressure_of_state.get_value(q);
              point.pressure_gradient = pressure_of_state.get_gradient(q);
              point.pressure_rate = rate_of_state.get_value(q);
              of_unknowns.pressure_gradient = pressure_of_change.get_gradient(q);
            }
            if (mesh_moves)
            {
              point.carrier -= motion.mesh_velocity;
              point.velocity_gradient = point.velocity_gradient * motion.inverse;
              point.pressure_gradient = point.pressure_gradient * motion.inverse;
              of_unknowns.velocity_gradient = of_unknowns.velocity_gradient * motion.inverse;
              of_unknowns.pressure_gradient = of_unknowns.pressure_gradient * motion.inverse;
            }
            point.set_strain_rate();
            set_materials(batch, point);
            point.finish();
            Tested<dim, Lanes> tested;
            FlowTerms::add_derivative(point, FlowChange<dim, Lanes>(point, of_unknowns), tested);
            if (mesh_moves)
              tested.by_gradient = tested.by_gradient * transpose(motion.inverse);
            of_change.submit_value(factor * tested.by_value, q);
            of_change.submit_gradient(factor * tested.by_gradient, q);
            pressure_of_change.submit_value(factor * tested.of_volume, q);
          }
          of_change.integrate_scatter(both, target);
          pressure_of_change.integrate(values);
          for (unsigned int lane = 0; lane < width; ++lane)
            if (batch.cells[lane] != no_cell)
              for (unsigned int k = 0; k < Base::n_pressures; ++k)
                volume[batch.cells[lane] * Base::n_pressures + k] =
                    pressure_of_change.get_dof_value(k)[lane];
        }
      },
      momentum, velocity, true);
}

/// `width` is that of double precision.
template <int dim, std::size_t width>
std::unique_ptr<MatrixFreeConvection<dim>>
make_convection_of_width(const typename MatrixFreeConvection<dim>::Input &input)
{
  if constexpr (dim == 2)
    if (input.is_axisymmetric)
      return std::make_unique<MatrixFreeConvectionOfWidth<dim, width, true>>(input);
  return std::make_unique<MatrixFreeConvectionOfWidth<dim, width, false>>(input);
}
} // namespace Continua

/// The function of one instruction set, with the width of double precision.
#define CONTINUA_DEFINE_MATRIX_FREE_CONVECTION(name, width)                                        \
  namespace Continua                                                                               \
  {                                                                                                \
  template <int dim>                                                                               \
  std::unique_ptr<MatrixFreeConvection<dim>>                                                       \
  name(const typename MatrixFreeConvection<dim>::Input &input)                                     \
  {                                                                                                \
    return make_convection_of_width<dim, width>(input);                                            \
  }                                                                                                \
  }
/// Compiles it for a dimension.
#define CONTINUA_INSTANTIATE_MATRIX_FREE_CONVECTION(name, dim)                                     \
  namespace Continua                                                                               \
  {                                                                                                \
  template std::unique_ptr<MatrixFreeConvection<dim>>                                              \
  name<dim>(const MatrixFreeConvection<dim>::Input &);                                             \
  }

#endif
