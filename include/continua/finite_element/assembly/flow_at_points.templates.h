#ifndef continua_finite_element_assembly_flow_at_points_templates_h
#define continua_finite_element_assembly_flow_at_points_templates_h

#include <continua/finite_element/assembly/flow_at_points.h>
#include <continua/finite_element/terms/flow_terms.h>

#include <deal.II/base/vectorization.h>

#include <algorithm>
#include <array>

namespace Continua
{
/// The FlowTerms at `width` points of a cell, one after the other.
template <int dim, std::size_t width>
class FlowOfWidth
{
public:
  /// See FlowTermsAtPoints.
  static double set_all(const FlowAtPoints<dim> &cell,
                        const PowersAtPoints *const asked,
                        const TestedAtPoints &result)
  {
    double least_stiffening = 1.;
    for (unsigned int n_done = 0; n_done < cell.n_points; n_done += width)
    {
      // The last points take some before them along, whose numbers are set once more.
      const unsigned int first = std::min<unsigned int>(n_done, cell.n_points - width);
      const FlowOfWidth points(cell, first);
      points.set(asked, n_done - first, result);
      least_stiffening = std::min(least_stiffening, points.least_stiffening());
    }
    return least_stiffening;
  }
  /// See FlowTermsAtPoints.
  static void set_derivative_of_all(const FlowAtPoints<dim> &cell,
                                    const bool has_pressure_gradient,
                                    double *const result)
  {
    for (unsigned int n_done = 0; n_done < cell.n_points; n_done += width)
    {
      FlowOfWidth points(cell, std::min<unsigned int>(n_done, cell.n_points - width));
      points.set_slopes();
      points.set_derivative(has_pressure_gradient, result);
    }
  }

private:
  using Lanes = dealii::VectorizedArray<double, width>;
  using Vector1 = dealii::Tensor<1, dim, Lanes>;
  using Vector2 = dealii::Tensor<2, dim, Lanes>;

  const FlowAtPoints<dim> &cell;
  const unsigned int first;
  Lanes weight;
  Vector2 inverse_jacobian;
  FlowPoint<dim, Lanes> point;

  FlowOfWidth(const FlowAtPoints<dim> &cell, const unsigned int first) : cell(cell), first(first)
  {
    set_geometry();
    point.scheme = cell.scheme;
    point.velocity = value(cell.velocity);
    point.acceleration = value(cell.acceleration);
    point.carrier = cell.scheme.carries * point.velocity;
    if (cell.mesh_velocity.values != nullptr)
      point.carrier -= value(cell.mesh_velocity);
    for (unsigned int c = 0; c < dim; ++c)
      point.velocity_gradient[c] = gradient(cell.velocity, c);
    point.pressure = number(cell.pressure, 0, 0);
    point.density = cell.density;
    point.viscosity = cell.viscosity;
    point.grad_div_over_speed = cell.grad_div_over_speed;
    point.set_strain_rate();
    if (cell.volume_law.inverse_bulk_modulus != 0.)
      set_compressible();
    if (cell.flow_curve != nullptr)
      set_viscosity();
    point.finish();
  }

  /// Of a component: number 0 is its value, those behind it are its derivatives.
  Lanes number(const NumbersAtPoints<const double> &from,
               const unsigned int component,
               const unsigned int number) const
  {
    Lanes result;
    result.load(from.values + component * from.component_size + number * cell.n_points + first);
    return result;
  }
  Vector1 value(const NumbersAtPoints<const double> &from) const
  {
    Vector1 result;
    for (unsigned int c = 0; c < dim; ++c)
      result[c] = number(from, c, 0);
    return result;
  }
  Vector1 gradient(const NumbersAtPoints<const double> &from, const unsigned int component) const
  {
    Vector1 result;
    for (unsigned int s = 0; s < dim; ++s)
      result += number(from, component, s + 1) * inverse_jacobian[s];
    return result;
  }
  void set_geometry()
  {
    constexpr unsigned int n_numbers = 2 + dim * dim;
    static_assert(sizeof(CellPoint<dim>) == n_numbers * sizeof(double));
    std::array<unsigned int, width> offsets;
    for (unsigned int lane = 0; lane < width; ++lane)
      offsets[lane] = n_numbers * lane;
    std::array<Lanes, n_numbers> numbers;
    dealii::vectorized_load_and_transpose(n_numbers, &cell.geometry[first].weight, offsets.data(),
                                          numbers.data());
    weight = numbers[0];
    point.hoop = numbers[1];
    for (unsigned int d = 0; d < dim; ++d)
      for (unsigned int e = 0; e < dim; ++e)
        inverse_jacobian[d][e] = numbers[2 + d * dim + e];
  }
  void set_compressible()
  {
    point.pressure_rate = number(cell.pressure_rate, 0, 0);
    point.pressure_gradient = gradient(cell.pressure, 0);
    for (unsigned int lane = 0; lane < width; ++lane)
    {
      point.density[lane] *= cell.volume_law.density_ratio(point.pressure[lane]);
      point.compressibility[lane] = cell.volume_law.compressibility(point.pressure[lane]);
    }
  }
  void set_viscosity()
  {
    const Lanes rate = point.shear_rate();
    for (unsigned int lane = 0; lane < width; ++lane)
      point.viscosity[lane] = cell.flow_curve->viscosity(rate[lane]);
  }
  /// Of density and viscosity.
  void set_slopes()
  {
    if (cell.volume_law.inverse_bulk_modulus != 0.)
      for (unsigned int lane = 0; lane < width; ++lane)
        point.compressibility_slope[lane] =
            cell.volume_law.compressibility_slope(point.pressure[lane]);
    if (cell.flow_curve == nullptr)
      return;
    const Lanes rate = point.shear_rate();
    for (unsigned int lane = 0; lane < width; ++lane)
      point.viscosity_slope[lane] = cell.flow_curve->slope_over_rate(rate[lane]);
  }
  double least_stiffening() const
  {
    double least = cell.volume_law.stiffening(point.pressure[0]);
    for (unsigned int lane = 1; lane < width; ++lane)
      least = std::min(least, cell.volume_law.stiffening(point.pressure[lane]));
    return least;
  }
  /// `n_known`: at how many of the first points the powers were added before.
  void set(const PowersAtPoints *const asked,
           const unsigned int n_known,
           const TestedAtPoints &result) const
  {
    Tested<dim, Lanes> tested;
    if (asked == nullptr)
      FlowTerms::add(point, tested);
    else
      add_by_kind(*asked, n_known, tested);
    for (unsigned int c = 0; c < dim; ++c)
    {
      double *const of_component =
          result.momentum.values + c * result.momentum.component_size + first;
      (weight * tested.by_value[c]).store(of_component);
      const Vector1 by_slopes = inverse_jacobian * tested.by_gradient[c];
      for (unsigned int s = 0; s < dim; ++s)
        (weight * by_slopes[s]).store(of_component + (s + 1) * cell.n_points);
    }
    (weight * tested.of_volume).store(result.volume + first);
  }
  void set_derivative(const bool has_pressure_gradient, double *const result) const
  {
    constexpr unsigned int n_numbers = n_numbers_of_direction<dim>;
    std::array<unsigned int, width> offsets;
    for (unsigned int lane = 0; lane < width; ++lane)
      offsets[lane] = n_directions<dim>(has_pressure_gradient) * n_numbers * (first + lane);
    double *next = result;
    const auto put = [&](const PointChange<dim, Lanes> &change)
    {
      const std::array<Lanes, n_numbers> column = column_of(change);
      dealii::vectorized_transpose_and_store(false, n_numbers, column.data(), offsets.data(), next);
      next += n_numbers;
    };
    for (unsigned int d = 0; d < dim; ++d)
      for (unsigned int k = 0; k <= dim; ++k)
      {
        PointChange<dim, Lanes> change;
        if (k == 0)
          change.velocity[d] = 1.;
        else
          change.velocity_gradient[d] = inverse_jacobian[k - 1];
        put(change);
      }
    for (unsigned int k = 0; k <= (has_pressure_gradient ? dim : 0); ++k)
    {
      PointChange<dim, Lanes> change;
      if (k == 0)
        change.pressure = 1.;
      else
        change.pressure_gradient = inverse_jacobian[k - 1];
      put(change);
    }
  }
  std::array<Lanes, n_numbers_of_direction<dim>>
  column_of(const PointChange<dim, Lanes> &change) const
  {
    Tested<dim, Lanes> tested;
    FlowTerms::add_derivative(point, FlowChange<dim, Lanes>(point, change), tested);
    std::array<Lanes, n_numbers_of_direction<dim>> column;
    auto next = column.begin();
    for (unsigned int c = 0; c < dim; ++c)
    {
      *next++ = weight * tested.by_value[c];
      const Vector1 by_slopes = inverse_jacobian * tested.by_gradient[c];
      for (unsigned int s = 0; s < dim; ++s)
        *next++ = weight * by_slopes[s];
    }
    *next = weight * tested.of_volume;
    return column;
  }
  /// Adds what the terms give that are taken, and their powers.
  void add_by_kind(const PowersAtPoints &asked,
                   const unsigned int n_known,
                   Tested<dim, Lanes> &sum) const
  {
    const Vector1 of_velocity = value(asked.velocity);
    Vector2 of_gradient;
    for (unsigned int c = 0; c < dim; ++c)
      of_gradient[c] = gradient(asked.velocity, c);
    FlowTerms::for_each(
        [&](const auto term)
        {
          const PowerKind kind = decltype(term)::power;
          if (kind == nullptr || !takes_terms_of(asked.taken, kind))
            return;
          Tested<dim, Lanes> tested;
          term.add(point, tested);
          const Lanes power = weight * (tested.by_value * of_velocity +
                                        scalar_product(tested.by_gradient, of_gradient));
          for (unsigned int lane = n_known; lane < width; ++lane)
            asked.powers.*kind += power[lane];
          sum += tested;
        });
  }
};
} // namespace Continua

// NOLINTBEGIN(bugprone-macro-parentheses): the argument is a name that is declared
/// The functions of one instruction set, with its width.
#define CONTINUA_DEFINE_FLOW_TERMS(name, width)                                                    \
  namespace Continua                                                                               \
  {                                                                                                \
  template <int dim>                                                                               \
  FlowTermsAtPoints<dim> name()                                                                    \
  {                                                                                                \
    return {FlowOfWidth<dim, width>::set_all, FlowOfWidth<dim, width>::set_derivative_of_all};     \
  }                                                                                                \
  template FlowTermsAtPoints<2> name<2>();                                                         \
  template FlowTermsAtPoints<3> name<3>();                                                         \
  }
// NOLINTEND(bugprone-macro-parentheses)

#endif
