#ifndef continua_finite_element_assembly_law_at_points_h
#define continua_finite_element_assembly_law_at_points_h

#include <continua/finite_element/terms/solid_point.h>
#include <continua/materials/holzapfel_gasser_ogden.h>
#include <continua/materials/mooney_rivlin.h>
#include <continua/materials/neo_hookean.h>
#include <continua/materials/saint_venant_kirchhoff.h>
#include <continua/materials/strain_law.h>

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/vectorization.h>

namespace Continua
{
/// A law whose text is for one point alone, at several: at one after the other.
class LawOfOnePoint
{
public:
  explicit LawOfOnePoint(const StrainLaw &law) : law(law) {}

  template <std::size_t width>
  void
  set_stress(const PointStrainOf<dealii::VectorizedArray<double, width>> &strain,
             dealii::SymmetricTensor<2, 3, dealii::VectorizedArray<double, width>> &stress) const
  {
    dealii::SymmetricTensor<2, 3> of_lane;
    for (unsigned int lane = 0; lane < width; ++lane)
    {
      law.set_stress(strain_of(strain, lane), of_lane);
      put(of_lane, lane, stress);
    }
  }
  template <std::size_t width>
  void
  set_tangent(const PointStrainOf<dealii::VectorizedArray<double, width>> &strain,
              dealii::SymmetricTensor<2, 3, dealii::VectorizedArray<double, width>> &stress,
              dealii::SymmetricTensor<4, 3, dealii::VectorizedArray<double, width>> &tangent) const
  {
    dealii::SymmetricTensor<2, 3> of_lane;
    dealii::SymmetricTensor<4, 3> tangent_of_lane;
    for (unsigned int lane = 0; lane < width; ++lane)
    {
      law.set_tangent(strain_of(strain, lane), of_lane, tangent_of_lane);
      put(of_lane, lane, stress);
      put(tangent_of_lane, lane, tangent);
    }
  }
  template <std::size_t width>
  void set_mean_stress(
      const PointStrainOf<dealii::VectorizedArray<double, width>> &strain,
      dealii::VectorizedArray<double, width> &mean_stress,
      dealii::SymmetricTensor<2, 3, dealii::VectorizedArray<double, width>> &derivative) const
  {
    dealii::SymmetricTensor<2, 3> of_lane;
    for (unsigned int lane = 0; lane < width; ++lane)
    {
      double mean = 0.;
      law.set_mean_stress(strain_of(strain, lane), mean, of_lane);
      mean_stress[lane] = mean;
      put(of_lane, lane, derivative);
    }
  }
  template <std::size_t width>
  void set_stresses(
      const PointStrainOf<dealii::VectorizedArray<double, width>> &strain,
      dealii::SymmetricTensor<2, 3, dealii::VectorizedArray<double, width>> &stress,
      dealii::VectorizedArray<double, width> &mean_stress,
      dealii::SymmetricTensor<2, 3, dealii::VectorizedArray<double, width>> &derivative) const
  {
    set_stress(strain, stress);
    set_mean_stress(strain, mean_stress, derivative);
  }

private:
  const StrainLaw &law;

  template <typename Lanes>
  static PointStrain strain_of(const PointStrainOf<Lanes> &strain, const unsigned int lane)
  {
    PointStrain result;
    result.determinant = strain.determinant[lane];
    result.fibres.resize(strain.fibres.size());
    for (unsigned int i = 0; i < 3; ++i)
    {
      for (unsigned int j = 0; j < 3; ++j)
        result.gradient[i][j] = strain.gradient[i][j][lane];
      for (std::size_t k = 0; k < strain.fibres.size(); ++k)
        result.fibres[k][i] = strain.fibres[k][i][lane];
    }
    return result;
  }
  template <int rank, typename Lanes>
  static void put(const dealii::SymmetricTensor<rank, 3> &of_lane,
                  const unsigned int lane,
                  dealii::SymmetricTensor<rank, 3, Lanes> &to)
  {
    for (unsigned int k = 0; k < of_lane.n_independent_components; ++k)
      to.access_raw_entry(k)[lane] = of_lane.access_raw_entry(k);
  }
};

/// What a law gives at several points at once: by its own text where it is one of the laws that are
/// named here. To add such a law, add it to of().
template <int dim, typename Lanes>
struct LawAtPoints
{
  using Strain = PointStrainOf<Lanes>;
  using Point = SolidPoint<dim, Lanes>;

  /// Sets the stress of a point, and the mean stress with its slope where the law has one.
  void (*set_stress)(const StrainLaw &law, const Strain &strain, Point &point);
  /// Likewise, and the tangent.
  void (*set_tangent)(const StrainLaw &law, const Strain &strain, Point &point);

  static LawAtPoints of(const StrainLaw &law)
  {
    LawAtPoints result{nullptr, nullptr};
    if (result.take<SaintVenantKirchhoff>(law) || result.take<NeoHookean>(law) ||
        result.take<MooneyRivlin>(law) || result.take<HolzapfelGasserOgden>(law))
      return result;
    return {set_stress_by<LawOfOnePoint, true>, set_tangent_by<LawOfOnePoint, true>};
  }

private:
  template <typename Law>
  bool take(const StrainLaw &law)
  {
    if (dynamic_cast<const Law *>(&law) == nullptr)
      return false;
    constexpr bool has_mean_stress = std::is_same_v<Law, SaintVenantKirchhoff>;
    *this = {set_stress_by<Law, has_mean_stress>, set_tangent_by<Law, has_mean_stress>};
    return true;
  }
  template <typename Law>
  static decltype(auto) as(const StrainLaw &law)
  {
    if constexpr (std::is_same_v<Law, LawOfOnePoint>)
      return LawOfOnePoint(law);
    else
      return static_cast<const Law &>(law);
  }
  template <typename Law, bool has_mean_stress>
  static void set_stress_by(const StrainLaw &law, const Strain &strain, Point &point)
  {
    const auto &of_type = as<Law>(law);
    if constexpr (has_mean_stress)
      if (point.scheme.has_own_mean_stress)
      {
        of_type.set_stresses(strain, point.stress, point.mean_stress, point.mean_stress_slope);
        return;
      }
    of_type.set_stress(strain, point.stress);
  }
  template <typename Law, bool has_mean_stress>
  static void set_tangent_by(const StrainLaw &law, const Strain &strain, Point &point)
  {
    const auto &of_type = as<Law>(law);
    of_type.set_tangent(strain, point.stress, point.tangent);
    if constexpr (has_mean_stress)
      if (point.scheme.has_own_mean_stress)
        of_type.set_mean_stress(strain, point.mean_stress, point.mean_stress_slope);
  }
};
} // namespace Continua

#endif
