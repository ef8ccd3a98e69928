#ifndef continua_finite_element_assembly_solid_at_points_templates_h
#define continua_finite_element_assembly_solid_at_points_templates_h

#include <continua/finite_element/assembly/law_at_points.h>
#include <continua/finite_element/assembly/solid_at_points.h>
#include <continua/finite_element/terms/solid_terms.h>
#include <continua/materials/metric_stress.h>

#include <deal.II/base/vectorization.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace Continua
{
/// The SolidTerms at `width` points of a cell, one after the other.
template <int dim, std::size_t width>
class SolidOfWidth
{
public:
  /// See SolidTermsAtPoints.
  static SolidExtremes set_all(const SolidAtPoints<dim> &cell,
                               const PowersAtPoints *const asked,
                               const TestedAtPoints &result)
  {
    SolidExtremes extremes;
    for_each_group(cell, [&](auto &points, const unsigned int first, const unsigned int n_known)
                   { extremes.add(points.set(first, asked, n_known, result)); });
    return extremes;
  }
  /// See SolidTermsAtPoints.
  static void set_derivative_of_all(const SolidAtPoints<dim> &cell, double *const result)
  {
    for_each_group(cell, [&](auto &points, const unsigned int first, const unsigned int)
                   { points.set_derivative(first, result); });
  }

private:
  template <int, std::size_t>
  friend class SolidOfWidth;

  using Lanes = dealii::VectorizedArray<double, width>;
  using Vector1 = dealii::Tensor<1, dim, Lanes>;
  using Vector2 = dealii::Tensor<2, dim, Lanes>;
  using Symmetric = dealii::SymmetricTensor<2, 3, Lanes>;
  using Point = SolidPoint<dim, Lanes>;

  const SolidAtPoints<dim> &cell;
  const LawAtPoints<dim, Lanes> law;
  unsigned int first = 0; ///< of the present points
  // Of these.
  Lanes weight, undeformed_hoop;
  Vector2 undeformed_jacobian; ///< the inverse one, of the reference mesh
  Vector2 inverse_jacobian;    ///< of the present place
  PointStrainOf<Lanes> strain;

  explicit SolidOfWidth(const SolidAtPoints<dim> &cell)
      : cell(cell), law(LawAtPoints<dim, Lanes>::of(*cell.law))
  {
  }

  /// Calls visit(points, first, n_known) until all points are done, `n_known`: how many of the
  /// first points were done before.
  template <typename Visit>
  static void for_each_group(const SolidAtPoints<dim> &cell, const Visit &visit)
  {
    SolidOfWidth points(cell);
    unsigned int n_done = 0;
    for (; n_done + width <= cell.n_points; n_done += width)
      visit(points, n_done, 0);
    if (n_done == cell.n_points)
      return;
    // A single point is cheaper alone, as in a plane cell of quadratic velocities, which has nine.
    if constexpr (width > 1)
      if (n_done + 1 == cell.n_points)
      {
        SolidOfWidth<dim, 1> last(cell);
        visit(last, n_done, 0);
        return;
      }
    // The last points take some before them along.
    const unsigned int first_of_last = cell.n_points - width;
    visit(points, first_of_last, n_done - first_of_last);
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
  /// With the inverse of a Jacobian.
  Vector2 gradient(const NumbersAtPoints<const double> &from, const Vector2 &inverse) const
  {
    Vector2 result;
    for (unsigned int c = 0; c < dim; ++c)
      for (unsigned int s = 0; s < dim; ++s)
        result[c] += number(from, c, s + 1) * inverse[s];
    return result;
  }
  /// As ValuesAtPoints::space_gradient().
  dealii::Tensor<2, 3, Lanes> space_gradient(const NumbersAtPoints<const double> &from) const
  {
    return whole_gradient<dim, Lanes>(gradient(from, undeformed_jacobian),
                                      undeformed_hoop * number(from, 1, 0));
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
    undeformed_hoop = numbers[1];
    for (unsigned int d = 0; d < dim; ++d)
      for (unsigned int e = 0; e < dim; ++e)
        undeformed_jacobian[d][e] = numbers[2 + d * dim + e];
  }
  Point kinematic_point(const unsigned int first_point)
  {
    first = first_point;
    set_geometry();
    Point point(cell.scheme, KinematicsOf<Lanes>(space_gradient(cell.displacement)));
    const auto &inverse = point.kinematics.inverse();
    Vector2 in_dimension;
    for (unsigned int c = 0; c < dim; ++c)
      for (unsigned int d = 0; d < dim; ++d)
        in_dimension[c][d] = inverse[c][d];
    inverse_jacobian = undeformed_jacobian * in_dimension;
    point.hoop = undeformed_hoop * inverse[2][2];
    point.velocity = value(cell.velocity);
    point.acceleration = value(cell.acceleration);
    point.velocity_gradient = point.kinematics.gradient(space_gradient(cell.velocity));
    point.pressure = number(cell.pressure, 0, 0);
    point.pressure_rate = number(cell.pressure_rate, 0, 0);
    if (cell.stress_free != nullptr)
      for (unsigned int lane = 0; lane < width; ++lane)
        point.stress_free_ratio[lane] = cell.stress_free[first + lane].volume_ratio;
    point.mass_ratio = cell.has_mass_of_mesh ? Lanes(1.) : point.stress_free_ratio;
    return point;
  }
  /// The least of the volume ratios.
  static double least_ratio(const Point &point)
  {
    const Lanes ratio = point.volume_ratio();
    double least = std::numeric_limits<double>::max();
    for (unsigned int lane = 0; lane < width; ++lane)
      for (const double of_point : {ratio[lane], point.stress_free_ratio[lane]})
        least =
            std::min(least, std::isnan(of_point) ? -std::numeric_limits<double>::max() : of_point);
    return least;
  }
  void set_strain(const Point &point)
  {
    strain.gradient = point.kinematics.deformation_gradient();
    strain.determinant = point.volume_ratio();
    if (cell.stress_free == nullptr)
      return;
    dealii::Tensor<2, 3, Lanes> prestretch;
    strain.fibres.resize(cell.stress_free[first].fibres.size());
    for (unsigned int lane = 0; lane < width; ++lane)
    {
      const StressFreeState &stress_free = cell.stress_free[first + lane];
      for (unsigned int i = 0; i < 3; ++i)
      {
        for (unsigned int j = 0; j < 3; ++j)
          prestretch[i][j][lane] = stress_free.prestretch[i][j];
        for (std::size_t k = 0; k < strain.fibres.size(); ++k)
          strain.fibres[k][i][lane] = stress_free.fibres[k][i];
      }
    }
    strain.gradient = strain.gradient * prestretch;
    strain.determinant /= point.stress_free_ratio;
  }
  MetricStressOf<Lanes> branches() const
  {
    Symmetric metric;
    for (unsigned int k = 0; k < Symmetric::n_independent_components; ++k)
      for (unsigned int lane = 0; lane < width; ++lane)
        metric.access_raw_entry(k)[lane] = cell.branches[first + lane].access_raw_entry(k);
    return MetricStressOf<Lanes>(metric);
  }
  void set_stress(Point &point)
  {
    set_strain(point);
    law.set_stress(*cell.law, strain, point);
    if (cell.branches != nullptr)
    {
      Symmetric of_branches;
      branches().set_stress(strain, of_branches);
      point.stress += of_branches;
    }
    point.stress *= point.stress_free_ratio;
  }
  void set_tangent(Point &point)
  {
    set_strain(point);
    law.set_tangent(*cell.law, strain, point);
    if (cell.branches != nullptr)
    {
      Symmetric of_branches;
      dealii::SymmetricTensor<4, 3, Lanes> tangent_of_branches;
      branches().set_tangent(strain, of_branches, tangent_of_branches);
      point.stress += of_branches;
      point.tangent += tangent_of_branches;
    }
    point.stress *= point.stress_free_ratio;
    point.tangent *= point.stress_free_ratio;
  }
  SolidExtremes set(const unsigned int first_point,
                    const PowersAtPoints *const asked,
                    const unsigned int n_known,
                    const TestedAtPoints &result)
  {
    Point point = kinematic_point(first_point);
    SolidExtremes extremes;
    extremes.volume_ratio = least_ratio(point);
    Tested<dim, Lanes> tested;
    if (extremes.volume_ratio > 0.)
    {
      set_stress(point);
      const Lanes size = point.stress.norm() + std::abs(point.volume_ratio() * point.pressure);
      for (unsigned int lane = 0; lane < width; ++lane)
        extremes.stress = std::max(extremes.stress, size[lane]);
      if (asked == nullptr)
        SolidTerms::add(point, tested);
      else
        add_by_kind(point, *asked, n_known, tested);
    }
    else
      inverse_jacobian = Vector2();
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
    return extremes;
  }
  /// Adds what the terms give that are taken, and their powers.
  void add_by_kind(const Point &point,
                   const PowersAtPoints &asked,
                   const unsigned int n_known,
                   Tested<dim, Lanes> &sum) const
  {
    const Vector1 of_velocity = value(asked.velocity);
    const Vector2 of_gradient = gradient(asked.velocity, inverse_jacobian);
    SolidTerms::for_each(
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
  void set_derivative(const unsigned int first_point, double *const result)
  {
    Point point = kinematic_point(first_point);
    constexpr unsigned int n_numbers = n_numbers_of_direction<dim>;
    const bool has_meaning = least_ratio(point) > 0.;
    if (has_meaning)
      set_tangent(point);
    std::array<unsigned int, width> offsets;
    for (unsigned int lane = 0; lane < width; ++lane)
      offsets[lane] = n_numbers * n_numbers * (first + lane);
    double *next = result;
    const auto put = [&](const PointChange<dim, Lanes> &change)
    {
      std::array<Lanes, n_numbers> column;
      if (has_meaning)
        set_column(point, change, column);
      else
        column.fill(Lanes(0.));
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
    PointChange<dim, Lanes> of_pressure;
    of_pressure.pressure = 1.;
    put(of_pressure);
  }
  void set_column(const Point &point,
                  const PointChange<dim, Lanes> &change,
                  std::array<Lanes, n_numbers_of_direction<dim>> &column) const
  {
    Tested<dim, Lanes> tested;
    SolidTerms::add_derivative(point, SolidChange<dim, Lanes>(point, change), tested);
    auto next = column.begin();
    for (unsigned int c = 0; c < dim; ++c)
    {
      *next++ = weight * tested.by_value[c];
      const Vector1 by_slopes = inverse_jacobian * tested.by_gradient[c];
      for (unsigned int s = 0; s < dim; ++s)
        *next++ = weight * by_slopes[s];
    }
    *next = weight * tested.of_volume;
  }
};
} // namespace Continua

// NOLINTBEGIN(bugprone-macro-parentheses): the argument is a name that is declared
/// The functions of one instruction set, with its width.
#define CONTINUA_DEFINE_SOLID_TERMS(name, width)                                                   \
  namespace Continua                                                                               \
  {                                                                                                \
  template <int dim>                                                                               \
  SolidTermsAtPoints<dim> name()                                                                   \
  {                                                                                                \
    return {SolidOfWidth<dim, width>::set_all, SolidOfWidth<dim, width>::set_derivative_of_all};   \
  }                                                                                                \
  template SolidTermsAtPoints<2> name<2>();                                                        \
  template SolidTermsAtPoints<3> name<3>();                                                        \
  }
// NOLINTEND(bugprone-macro-parentheses)

#endif
