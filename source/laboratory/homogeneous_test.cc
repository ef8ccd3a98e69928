#include <continua/laboratory/homogeneous_test.h>

#include <continua/base/input_error.h>
#include <continua/base/six_digits.h>
#include <continua/base/units.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace Continua
{
using namespace dealii;

namespace
{
/// The principal Kirchhoff stresses and the volume with their derivatives, by logarithms of the
/// stretches and by p; stresses over the shear modulus.
struct PrincipalSystem
{
  std::array<double, 3> stress = {};
  double volume = 0.;    ///< is 0 in equilibrium
  double magnitude = 0.; ///< of the terms whose sums the stresses are
  std::array<std::array<double, 4>, 3> stress_slope = {};
  std::array<double, 4> volume_slope = {};
};

PrincipalSystem principal_system(const StrainLaw &law,
                                 const PointStrain &strain,
                                 const double pressure,
                                 const double inverse_bulk_modulus)
{
  SymmetricTensor<2, 3> stress;
  SymmetricTensor<4, 3> tangent;
  law.set_tangent(strain, stress, tangent);
  const double scale = law.shear_modulus(), j = strain.determinant;
  const bool has_own_mean_stress = law.has_own_mean_stress();
  double mean = 0.;
  SymmetricTensor<2, 3> mean_slope;
  PrincipalSystem system;
  if (has_own_mean_stress)
  {
    // The stretches alone give the mean stress. With p as an unknown beside them Newton's method
    // would seek both at a time, and fail where either is far from its place.
    law.set_mean_stress(strain, mean, mean_slope);
    system.volume = pressure + mean / scale;
    for (unsigned int i = 0; i < 3; ++i)
      system.volume_slope[i] = mean_slope[i][i] / scale;
    system.volume_slope[3] = 1.;
  }
  else
  {
    mean = -scale * pressure;
    system.volume = std::log(j) + pressure * scale * inverse_bulk_modulus;
    system.volume_slope = {{1., 1., 1., scale * inverse_bulk_modulus}};
  }
  for (unsigned int i = 0; i < 3; ++i)
  {
    system.stress[i] = (stress[i][i] + j * mean) / scale;
    system.magnitude =
        std::max(system.magnitude, (std::abs(stress[i][i]) + std::abs(j * mean)) / scale);
    for (unsigned int k = 0; k < 3; ++k)
      system.stress_slope[i][k] = (tangent[i][i][k][k] + (i == k ? 2. * stress[i][i] : 0.) +
                                   j * (mean + mean_slope[k][k])) /
                                  scale;
    system.stress_slope[i][3] = has_own_mean_stress ? 0. : -j;
  }
  return system;
}
using FourEquations = std::array<std::array<double, 4>, 4>;

/// Gauss's elimination with pivots; `values` becomes the solution. Returns the sign of the
/// determinant, and 0, instead of what deal.II asserts, for a matrix that is singular or has no
/// numbers: a stretch without equilibrium is no mistake of the program.
int solve_four(FourEquations matrix, std::array<double, 4> &values)
{
  int sign = 1;
  for (unsigned int column = 0; column < 4; ++column)
  {
    unsigned int pivot = column;
    for (unsigned int row = column; row < 4; ++row)
      if (std::abs(matrix[row][column]) > std::abs(matrix[pivot][column]))
        pivot = row;
    // Written so that NaN is refused too.
    if (!(std::abs(matrix[pivot][column]) > 0.))
      return 0;
    if (pivot != column)
      sign = -sign;
    std::swap(matrix[pivot], matrix[column]);
    std::swap(values[pivot], values[column]);
    if (matrix[column][column] < 0.)
      sign = -sign;
    for (unsigned int row = column + 1; row < 4; ++row)
    {
      const double factor = matrix[row][column] / matrix[column][column];
      for (unsigned int j = column; j < 4; ++j)
        matrix[row][j] -= factor * matrix[column][j];
      values[row] -= factor * values[column];
    }
  }
  for (unsigned int row = 4; row-- > 0;)
  {
    for (unsigned int j = row + 1; j < 4; ++j)
      values[row] -= matrix[row][j] * values[j];
    values[row] /= matrix[row][row];
    if (!std::isfinite(values[row]))
      return 0;
  }
  return sign;
}

/// The logarithms of the stretches and p over the shear modulus.
using Unknowns = std::array<double, 4>;

/// The states of equilibrium between no strain and given stretches. At the part s of the path the
/// given logarithms are s times those at its end, and the free directions bear 1 - s of what they
/// bear at no strain: nothing, but for a law that remembers an earlier strain.
class EquilibriumPath
{
public:
  EquilibriumPath(const StrainLaw &law,
                  const double inverse_bulk_modulus,
                  const std::vector<Tensor<1, 3>> &fibres,
                  const std::array<double, 3> &end,
                  const std::array<bool, 3> &given)
      : law(law), inverse_bulk_modulus(inverse_bulk_modulus), end(end), given(given)
  {
    strain.fibres = fibres;
    evaluate({});
    for (unsigned int i = 0; i < 3; ++i)
    {
      if (given[i])
        length = std::max(length, std::abs(end[i]));
      else
        start_stress[i] = system.stress[i];
      length = std::max(length, std::abs(start_stress[i]));
    }
    Unknowns ignored = {};
    start_sign = solve_four(matrix, ignored);
  }

  /// Goes to the end, or as far as there is equilibrium.
  void follow()
  {
    double step = std::min(1., largest_step / length);
    while (part < 1.)
    {
      const double next = step >= 1. - part ? 1. : part + step;
      if (go_to(next))
        step = std::min(2. * step, largest_step / length);
      else if (step * length > smallest_step)
        step *= 0.5;
      else
        return;
    }
  }

  bool at_end() const { return part >= 1.; }
  /// The part of the path up to the last state of equilibrium [1].
  double last_part() const { return part; }

  /// Why there is none beyond it.
  std::string reason()
  {
    if (!is_finite)
      return "There its stress is larger than a number can hold";
    evaluate(unknowns);
    // Round-off of the stresses over the shear modulus, which is what holds the free sides.
    if (std::numeric_limits<double>::epsilon() * system.magnitude > 1e-3)
      return "There its stress is " + six_digits(system.magnitude) +
             " times the shear modulus, and the numbers of a computer no longer hold the balance "
             "of "
             "the free sides";
    for (unsigned int i = 0; i < 3; ++i)
      if (!given[i] && unknowns[i] < std::log(0.01))
        return "There the free sides shrink to nothing";
    return "There the free sides lose their stability, a limit point of the law";
  }

  /// The system at the last state.
  PrincipalState state(const std::array<double, 3> &logarithmic_rates)
  {
    evaluate(unknowns);
    Unknowns rates = {};
    for (unsigned int i = 0; i < 3; ++i)
      rates[i] = given[i] ? logarithmic_rates[i] : 0.;
    solve_four(matrix, rates);
    const double modulus = law.shear_modulus();
    PrincipalState result;
    result.strain = strain;
    result.pressure = modulus * unknowns[3];
    for (unsigned int i = 0; i < 3; ++i)
    {
      result.stress[i] = given[i] ? modulus * system.stress[i] : 0.;
      for (unsigned int j = 0; given[i] && j < 4; ++j)
        result.stress_rate[i] += modulus * system.stress_slope[i][j] * rates[j];
    }
    return result;
  }

private:
  // Changes of the logarithm of a stretch. With steps of this length Newton's method stays on the
  // path; the smallest step is the accuracy of the place where the path ends.
  static constexpr double largest_step = 0.2, smallest_step = 1e-10;
  static constexpr unsigned int most_iterations = 20;

  const StrainLaw &law;
  const double inverse_bulk_modulus;
  const std::array<double, 3> end;
  const std::array<bool, 3> given;
  double length = 0.;
  std::array<double, 3> start_stress = {};
  int start_sign = 0;
  double part = 0.;
  Unknowns unknowns = {}; ///< of the last state
  bool is_finite = true;  ///< whether the last attempt met numbers alone
  PointStrain strain;
  PrincipalSystem system;
  FourEquations matrix = {};

  void evaluate(const Unknowns &at)
  {
    strain.determinant = 1.;
    for (unsigned int i = 0; i < 3; ++i)
    {
      strain.gradient[i][i] = std::exp(at[i]);
      strain.determinant *= strain.gradient[i][i];
    }
    system = principal_system(law, strain, at[3], inverse_bulk_modulus);
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 4; ++j)
        matrix[i][j] = given[i] ? (i == j ? 1. : 0.) : system.stress_slope[i][j];
    matrix[3] = system.volume_slope;
  }

  /// Newton's method from the tangent of the path. False if it does not converge, goes far from the
  /// tangent or arrives where the free directions are not as stable as at no strain.
  bool go_to(const double next)
  {
    is_finite = true;
    evaluate(unknowns);
    Unknowns change = {};
    for (unsigned int i = 0; i < 3; ++i)
      change[i] = (next - part) * (given[i] ? end[i] : -start_stress[i]);
    if (solve_four(matrix, change) == 0)
      return fail();
    Unknowns at = unknowns;
    for (unsigned int i = 0; i < 4; ++i)
      at[i] += change[i];
    for (unsigned int i = 0; i < 3; ++i)
      if (given[i])
        at[i] = next * end[i];
    const Unknowns start = at;
    for (unsigned int iteration = 0; iteration < most_iterations; ++iteration)
    {
      evaluate(at);
      const double round_off =
          8. * std::numeric_limits<double>::epsilon() * (1. + system.magnitude);
      bool is_exact = std::abs(system.volume) <= round_off;
      for (unsigned int i = 0; i < 3; ++i)
      {
        change[i] = given[i] ? 0. : (1. - next) * start_stress[i] - system.stress[i];
        is_exact = is_exact && std::abs(change[i]) <= round_off;
      }
      change[3] = -system.volume;
      const int sign = solve_four(matrix, change);
      if (sign == 0)
        return fail();
      double largest = 0., largest_change = 0.;
      for (unsigned int i = 0; i < 4; ++i)
      {
        at[i] += change[i];
        if (i < 3)
        {
          largest = std::max(largest, std::abs(change[i]));
          largest_change = std::max(largest_change, std::abs(at[i] - start[i]));
        }
      }
      if (largest_change > largest_step)
        return fail();
      // Where large stresses cancel in the free directions the changes do not fall as far.
      if (is_exact || (largest <= 1e-12 && std::abs(change[3]) <= 1e-11 * (1. + std::abs(at[3]))))
      {
        if (sign != start_sign)
          return false;
        part = next;
        unknowns = at;
        return true;
      }
    }
    return false;
  }

  bool fail()
  {
    is_finite = std::isfinite(system.magnitude);
    for (const auto &row : matrix)
      for (const double value : row)
        is_finite = is_finite && std::isfinite(value);
    return false;
  }
};
} // namespace

const Words<HomogeneousTestType> &homogeneous_test_words()
{
  static const Words<HomogeneousTestType> words = {
      {"uniaxial", HomogeneousTestType::uniaxial},
      {"equibiaxial", HomogeneousTestType::equibiaxial},
      {"planar", HomogeneousTestType::planar},
      {"shear", HomogeneousTestType::shear}};
  return words;
}

HomogeneousTest::HomogeneousTest(const StrainLaw &law,
                                 const double inverse_bulk_modulus,
                                 const std::vector<Tensor<1, 3>> &fibres)
    : law(law), inverse_bulk_modulus(inverse_bulk_modulus), fibres(fibres)
{
}

PrincipalState HomogeneousTest::equilibrium(const std::array<double, 3> &stretches,
                                            const std::array<bool, 3> &given,
                                            const std::array<double, 3> &logarithmic_rates) const
{
  std::array<double, 3> logarithms = {};
  for (unsigned int i = 0; i < 3; ++i)
    if (given[i])
      logarithms[i] = std::log(stretches[i]);
  EquilibriumPath path(law, inverse_bulk_modulus, fibres, logarithms, given);
  path.follow();
  if (path.at_end())
    return path.state(logarithmic_rates);
  std::string asked, last;
  for (unsigned int i = 0; i < 3; ++i)
    if (given[i])
    {
      const std::string comma = asked.empty() ? "" : ", ";
      asked += comma + shortest_number(stretches[i]);
      last += comma + six_digits(std::exp(path.last_part() * logarithms[i]));
    }
  throw RunError("there is no equilibrium at the stretch " + asked + ": the law has none beyond " +
                 last + ". " + path.reason() + ". Ask for a range that ends before");
}

namespace
{
std::array<bool, 3> given_in(const HomogeneousTestType type)
{
  return {{true, type != HomogeneousTestType::uniaxial, false}};
}

std::array<double, 3> stretches_in(const HomogeneousTestType type, const double strain_measure)
{
  return {{strain_measure, type == HomogeneousTestType::planar ? 1. : strain_measure, 1.}};
}
} // namespace

HomogeneousTestEnd HomogeneousTest::end(const HomogeneousTestType type,
                                        const double strain_measure) const
{
  if (type == HomogeneousTestType::shear)
    return {strain_measure, ""};
  std::array<double, 3> logarithms = stretches_in(type, strain_measure);
  for (double &value : logarithms)
    value = std::log(value);
  EquilibriumPath path(law, inverse_bulk_modulus, fibres, logarithms, given_in(type));
  path.follow();
  return path.at_end()
             ? HomogeneousTestEnd{strain_measure, ""}
             : HomogeneousTestEnd{std::exp(path.last_part() * logarithms[0]), path.reason()};
}

HomogeneousTestPoint HomogeneousTest::at(const HomogeneousTestType type,
                                         const double strain_measure) const
{
  if (type == HomogeneousTestType::shear)
    return sheared(strain_measure);
  const double rate = 1. / strain_measure;
  const PrincipalState state =
      equilibrium(stretches_in(type, strain_measure), given_in(type),
                  {{rate, type == HomogeneousTestType::equibiaxial ? rate : 0., 0.}});
  HomogeneousTestPoint point;
  point.strain_measure = strain_measure;
  point.volume_ratio = state.strain.determinant;
  point.nominal_stress = state.stress[0] / strain_measure;
  point.cauchy_stress = state.stress[0] / point.volume_ratio;
  point.tangent_modulus = (state.stress_rate[0] - point.nominal_stress) / strain_measure;
  point.normal_difference = (state.stress[0] - state.stress[1]) / point.volume_ratio;
  point.energy = law.energy(state.strain);
  point.strain = state.strain;
  return point;
}

HomogeneousTestPoint HomogeneousTest::sheared(const double amount) const
{
  HomogeneousTestPoint point;
  point.strain_measure = amount;
  point.strain.gradient = Tensor<2, 3>(unit_symmetric_tensor<3>());
  point.strain.gradient[0][1] = amount;
  point.strain.fibres = fibres;
  SymmetricTensor<2, 3> stress;
  SymmetricTensor<4, 3> tangent;
  law.set_tangent(point.strain, stress, tangent);
  // The volume stays, so that Kirchhoff's stress is Cauchy's, and its shear is the nominal one. The
  // rate of shear is the gradient itself: g tau + tau g^T adds tau_11 to the slope.
  point.nominal_stress = point.cauchy_stress = stress[0][1];
  point.tangent_modulus = tangent[0][1][0][1] + stress[1][1];
  point.normal_difference = stress[0][0] - stress[1][1];
  point.energy = law.energy(point.strain);
  if (!std::isfinite(point.nominal_stress) || !std::isfinite(point.tangent_modulus))
    throw RunError("there is no stress at the shear " + shortest_number(amount) +
                   ": it is larger than a number can hold. Ask for a smaller shear");
  return point;
}
} // namespace Continua
