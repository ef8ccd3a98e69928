// The terms of a solid in finite deformation for several points at a time, with each set of
// instructions, against one point after the other with the functions of the law for one point:
// numbers of points that no set divides, all laws, branches, fibres, a prestretch and an inversion.

#include <continua/finite_element/assembly/solid_at_points.h>
#include <continua/finite_element/terms/solid_terms.h>
#include <continua/materials/holzapfel_gasser_ogden.h>
#include <continua/materials/metric_stress.h>
#include <continua/materials/mooney_rivlin.h>
#include <continua/materials/neo_hookean.h>
#include <continua/materials/saint_venant_kirchhoff.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "../materials/strain_at_point.h"
#include "../unit_test.h"
#include "numbers_of_cell.h"

namespace test_of_solid_at_points
{
using namespace Continua;
using namespace dealii;
using numbers_of_cell::distance;
using numbers_of_cell::Field;
using numbers_of_cell::numbers;
using strain_at_point::unit_tensor;

namespace
{
/// A law for one point alone.
class LawWithoutTemplates : public StrainLaw
{
public:
  void set_stress(const PointStrain &strain, SymmetricTensor<2, 3> &stress) const override
  {
    law.set_stress(strain, stress);
  }
  void set_tangent(const PointStrain &strain,
                   SymmetricTensor<2, 3> &stress,
                   SymmetricTensor<4, 3> &tangent) const override
  {
    law.set_tangent(strain, stress, tangent);
  }
  double energy(const PointStrain &strain) const override { return law.energy(strain); }
  double shear_modulus() const override { return law.shear_modulus(); }
  bool has_own_mean_stress() const override { return true; }
  void set_mean_stress(const PointStrain &strain,
                       double &mean_stress,
                       SymmetricTensor<2, 3> &derivative) const override
  {
    law.set_mean_stress(strain, mean_stress, derivative);
  }

private:
  const SaintVenantKirchhoff law{1.3, 2.1};
};

/// A cell with its numbers.
template <int dim>
struct Cell
{
  static constexpr unsigned int n_numbers = n_numbers_of_direction<dim>;

  Field velocity, displacement, acceleration, pressure, pressure_rate, of_powers;
  std::vector<CellPoint<dim>> geometry;
  std::vector<StressFreeState> stress_free;
  std::vector<SymmetricTensor<2, 3>> branches;
  SolidAtPoints<dim> solid;

  Cell(const StrainLaw &law, const unsigned int n_points, const bool volume_is_rate)
      : velocity(n_points, dim, 0.1),
        displacement(n_points, dim, 0.7),
        acceleration(n_points, dim, 0.9),
        pressure(n_points, 1, 0.4),
        pressure_rate(n_points, 1, 1.3),
        of_powers(n_points, dim, 3.1),
        geometry(n_points)
  {
    for (double &number : displacement.values)
      number *= 0.06;
    const std::vector<double> any = numbers((2 + dim * dim) * n_points, 5.3);
    auto next = any.begin();
    for (CellPoint<dim> &point : geometry)
    {
      point.weight = 1.5 + *next++;
      point.hoop = dim == 2 ? 1.2 + *next++ : 0.;
      for (unsigned int d = 0; d < dim; ++d)
        for (unsigned int e = 0; e < dim; ++e)
          point.inverse_jacobian[d][e] = *next++;
    }
    solid.n_points = n_points;
    solid.geometry = geometry.data();
    solid.scheme = {0.3, 1.4, 2.3, volume_is_rate, 1.7, 0.6, 0.25, law.has_own_mean_stress()};
    solid.law = &law;
    solid.velocity = velocity.view();
    solid.displacement = displacement.view();
    solid.acceleration = acceleration.view();
    solid.pressure = pressure.view();
    solid.pressure_rate = pressure_rate.view();
  }

  void relax()
  {
    const std::vector<double> any = numbers(6 * solid.n_points, 2.4);
    branches.resize(solid.n_points);
    for (unsigned int q = 0; q < solid.n_points; ++q)
    {
      branches[q] = 1.9 * unit_symmetric_tensor<3>();
      for (unsigned int k = 0; k < 6; ++k)
        branches[q].access_raw_entry(k) += 0.5 * any[6 * q + k];
    }
    solid.branches = branches.data();
  }
  /// Two families of fibres and a prestretch at each point.
  void relieve()
  {
    const std::vector<double> any = numbers(10 * solid.n_points, 4.2);
    auto next = any.begin();
    stress_free.resize(solid.n_points);
    for (StressFreeState &state : stress_free)
    {
      const double angle = *next++;
      state.fibres = {Tensor<1, 3>({std::cos(angle), std::sin(angle), 0.}),
                      Tensor<1, 3>({0., std::cos(angle), -std::sin(angle)})};
      state.prestretch = unit_tensor();
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          state.prestretch[i][j] += 0.1 * *next++;
      state.volume_ratio = 1. / determinant(state.prestretch);
    }
    solid.stress_free = stress_free.data();
  }

  Tensor<2, 3> space_gradient(const Field &field, const unsigned int q) const
  {
    Tensor<2, dim> gradient;
    for (unsigned int c = 0; c < dim; ++c)
      gradient[c] = field.gradient<dim>(c, q, geometry[q].inverse_jacobian);
    return whole_gradient<dim>(gradient, geometry[q].hoop * field.at(1, 0, q));
  }
  SolidPoint<dim> point(const unsigned int q) const
  {
    SolidPoint<dim> result(solid.scheme, Kinematics(space_gradient(displacement, q)));
    result.hoop = geometry[q].hoop * result.kinematics.inverse()[2][2];
    result.velocity = velocity.value<dim>(q);
    result.acceleration = acceleration.value<dim>(q);
    result.velocity_gradient = result.kinematics.gradient(space_gradient(velocity, q));
    result.pressure = pressure.at(0, 0, q);
    result.pressure_rate = pressure_rate.at(0, 0, q);
    PointStrain strain = {result.kinematics.deformation_gradient(), result.volume_ratio()};
    if (solid.stress_free != nullptr)
    {
      result.stress_free_ratio = stress_free[q].volume_ratio;
      strain.gradient = strain.gradient * stress_free[q].prestretch;
      strain.determinant /= stress_free[q].volume_ratio;
      strain.fibres = stress_free[q].fibres;
    }
    result.mass_ratio = solid.has_mass_of_mesh ? 1. : result.stress_free_ratio;
    solid.law->set_tangent(strain, result.stress, result.tangent);
    if (solid.law->has_own_mean_stress())
      solid.law->set_mean_stress(strain, result.mean_stress, result.mean_stress_slope);
    if (solid.branches != nullptr)
    {
      SymmetricTensor<2, 3> stress;
      SymmetricTensor<4, 3> tangent;
      MetricStress(branches[q]).set_tangent(strain, stress, tangent);
      result.stress += stress;
      result.tangent += tangent;
    }
    result.stress *= result.stress_free_ratio;
    result.tangent *= result.stress_free_ratio;
    return result;
  }
};

/// Rows that terms have set, and what stands beside them.
template <int dim>
struct Result
{
  std::size_t component_size;
  std::vector<double> momentum, volume, derivative;
  NonlinearPowers powers;
  SolidExtremes extremes;

  explicit Result(const unsigned int n_points)
      : component_size((dim + 1) * n_points + 2),
        momentum(dim * component_size, 0.),
        volume(n_points, 0.)
  {
  }
};

/// By the value and the derivatives of test functions for each component of momentum, and of
/// volume.
template <int dim>
std::vector<double>
numbers_of(const SolidPoint<dim> &point, const CellPoint<dim> &geometry, const Tested<dim> &tested)
{
  std::vector<double> result;
  for (unsigned int c = 0; c < dim; ++c)
  {
    result.push_back(geometry.weight * tested.by_value[c]);
    for (unsigned int s = 0; s < dim; ++s)
    {
      double sum = 0.;
      for (unsigned int d = 0; d < dim; ++d)
        for (unsigned int e = 0; e < dim; ++e)
          sum += geometry.inverse_jacobian[s][e] * point.kinematics.inverse()[e][d] *
                 tested.by_gradient[c][d];
      result.push_back(geometry.weight * sum);
    }
  }
  result.push_back(geometry.weight * tested.of_volume);
  return result;
}

/// The gradient by the present place of a vector with that gradient on the reference cell.
template <int dim>
Tensor<1, dim> present_gradient(const SolidPoint<dim> &point, const Tensor<1, dim> &by_reference)
{
  Tensor<1, dim> result;
  for (unsigned int d = 0; d < dim; ++d)
    for (unsigned int e = 0; e < dim; ++e)
      result[d] += by_reference[e] * point.kinematics.inverse()[e][d];
  return result;
}

template <int dim>
void add_derivative(const SolidPoint<dim> &point,
                    const CellPoint<dim> &geometry,
                    std::vector<double> &derivative)
{
  const auto add = [&](const PointChange<dim> &change)
  {
    Tested<dim> tested;
    SolidTerms::add_derivative(point, SolidChange<dim>(point, change), tested);
    const std::vector<double> column = numbers_of(point, geometry, tested);
    derivative.insert(derivative.end(), column.begin(), column.end());
  };
  for (unsigned int d = 0; d < dim; ++d)
    for (unsigned int k = 0; k <= dim; ++k)
    {
      PointChange<dim> change;
      if (k == 0)
        change.velocity[d] = 1.;
      else
        change.velocity_gradient[d] = present_gradient(point, geometry.inverse_jacobian[k - 1]);
      add(change);
    }
  PointChange<dim> of_pressure;
  of_pressure.pressure = 1.;
  add(of_pressure);
}

/// One point after the other.
template <int dim>
Result<dim> expected_of(const Cell<dim> &cell, const TermsTaken *const taken)
{
  const unsigned int n_points = cell.solid.n_points;
  Result<dim> result(n_points);
  for (unsigned int q = 0; q < n_points; ++q)
  {
    const CellPoint<dim> &geometry = cell.geometry[q];
    const SolidPoint<dim> point = cell.point(q);
    result.extremes.add({std::min(point.volume_ratio(), point.stress_free_ratio),
                         point.stress.norm() + std::abs(point.volume_ratio() * point.pressure)});
    Tested<dim> sum;
    if (taken == nullptr)
      SolidTerms::add(point, sum);
    else
      SolidTerms::for_each(
          [&](const auto term)
          {
            const PowerKind kind = decltype(term)::power;
            if (kind == nullptr || !takes_terms_of(*taken, kind))
              return;
            Tested<dim> tested;
            term.add(point, tested);
            double power = tested.by_value * cell.of_powers.template value<dim>(q);
            for (unsigned int c = 0; c < dim; ++c)
              power += tested.by_gradient[c] *
                       present_gradient(point, cell.of_powers.template gradient<dim>(
                                                   c, q, geometry.inverse_jacobian));
            result.powers.*kind += geometry.weight * power;
            sum += tested;
          });
    const std::vector<double> numbers = numbers_of(point, geometry, sum);
    for (unsigned int c = 0; c < dim; ++c)
      for (unsigned int s = 0; s <= dim; ++s)
        result.momentum[c * result.component_size + s * n_points + q] = numbers[c * (dim + 1) + s];
    result.volume[q] = numbers.back();
    add_derivative(point, geometry, result.derivative);
  }
  return result;
}

template <int dim>
Result<dim>
result_of(const Cell<dim> &cell, const InstructionSet wanted, const TermsTaken *const taken)
{
  // What this processor lacks is as good as what it has: the answer must not depend on it.
  const SolidTermsAtPoints<dim> terms =
      solid_terms_of<dim>(can_run(wanted) ? wanted : InstructionSet::baseline);
  Result<dim> result(cell.solid.n_points);
  const PowersAtPoints asked{cell.of_powers.view(), taken != nullptr ? *taken : TermsTaken::all,
                             result.powers};
  result.extremes =
      terms.set(cell.solid, taken != nullptr ? &asked : nullptr,
                {{result.momentum.data(), result.component_size}, result.volume.data()});
  result.derivative.assign(cell.n_numbers * cell.n_numbers * cell.solid.n_points, 0.);
  terms.set_derivative(cell.solid, result.derivative.data());
  return result;
}

template <int dim>
void compare(const std::string &name,
             const Cell<dim> &cell,
             const TermsTaken *const taken = nullptr)
{
  const Result<dim> expected = expected_of(cell, taken);
  double largest = 0.;
  for (const double number : expected.derivative)
    largest = std::max(largest, std::abs(number));
  for (const InstructionSet wanted :
       {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512})
  {
    const Result<dim> result = result_of(cell, wanted, taken);
    double of_powers = 0.;
    for (const PowerKind kind : {&NonlinearPowers::inertia, &NonlinearPowers::strain,
                                 &NonlinearPowers::viscosity, &NonlinearPowers::compression})
      of_powers = std::max(of_powers, std::abs(result.powers.*kind - expected.powers.*kind));
    const std::string of_set = name + ", " + word_of(instruction_set_words(), wanted);
    check::absolute(of_set + ": momentum", distance(result.momentum, expected.momentum), 0., 1e-11);
    check::absolute(of_set + ": volume", distance(result.volume, expected.volume), 0., 1e-11);
    check::absolute(of_set + ": derivative",
                    distance(result.derivative, expected.derivative) / largest, 0., 1e-13);
    check::absolute(of_set + ": powers", of_powers, 0., 1e-11);
    check::absolute(of_set + ": volume ratio", result.extremes.volume_ratio,
                    expected.extremes.volume_ratio, 1e-14);
    check::absolute(of_set + ": stress", result.extremes.stress, expected.extremes.stress, 1e-12);
  }
}

template <int dim>
void check_laws(const std::string &name)
{
  const TermsTaken all = TermsTaken::all;
  const NeoHookean neo_hookean(1.3);
  compare(name + ", neo-Hookean", Cell<dim>(neo_hookean, 16, false));
  const MooneyRivlin mooney_rivlin(0.9, 0.4);
  Cell<dim> relaxing(mooney_rivlin, 11, true);
  relaxing.relax();
  compare(name + ", Mooney-Rivlin with branches", relaxing);
  compare(name + ", its powers", relaxing, &all);
  const HolzapfelGasserOgden holzapfel(1.3, 0.8, 0.5, 0.1);
  Cell<dim> artery(holzapfel, 9, false);
  artery.relieve();
  artery.relax();
  compare(name + ", fibres and prestretch", artery);
  artery.solid.has_mass_of_mesh = true;
  compare(name + ", mass of the mesh", artery, &all);
  const SaintVenantKirchhoff saint_venant(1.3, 2.1);
  compare(name + ", St. Venant-Kirchhoff", Cell<dim>(saint_venant, 9, true));
  compare(name + ", the same at the end of a step", Cell<dim>(saint_venant, 17, false));
  const LawWithoutTemplates one_point;
  compare(name + ", for one point alone", Cell<dim>(one_point, 13, true));
}

void check_inversion()
{
  const NeoHookean law(1.3);
  Cell<2> cell(law, 16, false);
  cell.geometry[3].inverse_jacobian = Tensor<2, 2>({{1., 0.}, {0., 1.}});
  for (unsigned int s = 1; s <= 2; ++s)
    for (unsigned int c = 0; c < 2; ++c)
      cell.displacement.values[c * cell.displacement.component_size + s * 16 + 3] =
          s == c + 1 && c == 0 ? -1.5 : 0.;
  for (const InstructionSet wanted : {InstructionSet::baseline, InstructionSet::avx512})
  {
    const Result<2> result = result_of(cell, wanted, nullptr);
    const std::string of_set =
        "inside out, " + std::string(word_of(instruction_set_words(), wanted));
    check::is_true(of_set + ": seen", result.extremes.volume_ratio < 0.);
    check::is_true(of_set + ": a number",
                   std::all_of(result.momentum.begin(), result.momentum.end(),
                               [](const double number) { return std::isfinite(number); }));
  }
}
} // namespace

UNIT_TEST(solid_at_points)
{
  check_laws<2>("plane");
  check_laws<3>("in space");
  check_inversion();
}
} // namespace test_of_solid_at_points
