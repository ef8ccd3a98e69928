#include <continua/laboratory/homogeneous_test.h>

#include <continua/base/input_error.h>
#include <continua/base/units.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace Continua
{
using namespace dealii;

namespace
{
/// The principal stresses and the volume with their derivatives, by logarithms of the stretches and
/// by p; stresses over the shear modulus.
struct PrincipalSystem
{
  std::array<double, 3> stress = {};
  double volume = 0.; ///< is 0 in equilibrium
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
  const double scale = law.shear_modulus(), jp = strain.determinant * pressure;
  PrincipalSystem system;
  for (unsigned int i = 0; i < 3; ++i)
  {
    system.stress[i] = stress[i][i] / scale - jp;
    for (unsigned int j = 0; j < 3; ++j)
      system.stress_slope[i][j] =
          (tangent[i][i][j][j] + (i == j ? 2. * stress[i][i] : 0.)) / scale - jp;
    system.stress_slope[i][3] = -strain.determinant;
  }
  if (law.has_own_mean_stress())
  {
    double mean = 0.;
    SymmetricTensor<2, 3> slope;
    law.set_mean_stress(strain, mean, slope);
    system.volume = pressure + mean / scale;
    for (unsigned int j = 0; j < 3; ++j)
      system.volume_slope[j] = slope[j][j] / scale;
    system.volume_slope[3] = 1.;
  }
  else
  {
    system.volume = std::log(strain.determinant) + pressure * scale * inverse_bulk_modulus;
    system.volume_slope = {{1., 1., 1., scale * inverse_bulk_modulus}};
  }
  return system;
}
using FourEquations = std::array<std::array<double, 4>, 4>;

/// Gauss's elimination with pivots; `values` becomes the solution. Returns false, instead of what
/// deal.II asserts, for a matrix that is singular or has no numbers: a stretch without equilibrium
/// is no mistake of the program.
bool solve_four(FourEquations matrix, std::array<double, 4> &values)
{
  for (unsigned int column = 0; column < 4; ++column)
  {
    unsigned int pivot = column;
    for (unsigned int row = column; row < 4; ++row)
      if (std::abs(matrix[row][column]) > std::abs(matrix[pivot][column]))
        pivot = row;
    // Written so that NaN is refused too.
    if (!(std::abs(matrix[pivot][column]) > 0.))
      return false;
    std::swap(matrix[pivot], matrix[column]);
    std::swap(values[pivot], values[column]);
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
      return false;
  }
  return true;
}
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
  const double n_free = std::count(given.begin(), given.end(), false);
  // The start keeps the volume, as rubber nearly does.
  std::array<double, 3> logarithms = {};
  for (unsigned int i = 0; i < 3; ++i)
    if (given[i])
      logarithms[i] = std::log(stretches[i]);
  const double given_volume = logarithms[0] + logarithms[1] + logarithms[2];
  for (unsigned int i = 0; i < 3; ++i)
    if (!given[i])
      logarithms[i] = -given_volume / n_free;
  double pressure = 0.;
  PrincipalState state;
  state.strain.fibres = fibres;
  FourEquations matrix = {};
  std::array<double, 4> change = {};
  PrincipalSystem system;
  constexpr unsigned int most_iterations = 100;
  for (unsigned int iteration = 0; iteration < most_iterations; ++iteration)
  {
    state.strain.determinant = 1.;
    for (unsigned int i = 0; i < 3; ++i)
    {
      state.strain.gradient[i][i] = std::exp(logarithms[i]);
      state.strain.determinant *= state.strain.gradient[i][i];
    }
    system = principal_system(law, state.strain, pressure, inverse_bulk_modulus);
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 4; ++j)
        matrix[i][j] = given[i] ? (i == j ? 1. : 0.) : system.stress_slope[i][j];
    for (unsigned int j = 0; j < 4; ++j)
      matrix[3][j] = system.volume_slope[j];
    for (unsigned int i = 0; i < 3; ++i)
      change[i] = given[i] ? 0. : -system.stress[i];
    change[3] = -system.volume;
    if (!solve_four(matrix, change))
      break;
    double largest = 0.;
    for (unsigned int i = 0; i < 3; ++i)
      largest = std::max(largest, std::abs(change[i]));
    // A fibre that stiffens sends the first steps far away.
    const double factor = largest > 0.3 ? 0.3 / largest : 1.;
    for (unsigned int i = 0; i < 3; ++i)
      logarithms[i] += factor * change[i];
    pressure += factor * change[3];
    if (largest > 1e-12 || std::abs(change[3]) > 1e-11 * (1. + std::abs(pressure)))
      continue;
    // The matrix is that of equilibrium but for round-off.
    for (unsigned int i = 0; i < 3; ++i)
      change[i] = given[i] ? logarithmic_rates[i] : 0.;
    change[3] = 0.;
    if (!solve_four(matrix, change))
      break;
    const double modulus = law.shear_modulus();
    state.pressure = modulus * pressure;
    for (unsigned int i = 0; i < 3; ++i)
    {
      state.stress[i] = given[i] ? modulus * system.stress[i] : 0.;
      state.stress_rate[i] = 0.;
      for (unsigned int j = 0; given[i] && j < 4; ++j)
        state.stress_rate[i] += modulus * system.stress_slope[i][j] * change[j];
    }
    return state;
  }
  std::string text;
  for (unsigned int i = 0; i < 3; ++i)
    if (given[i])
      text += (text.empty() ? "" : ", ") + shortest_number(stretches[i]);
  throw RunError("no equilibrium was found at the stretch " + text +
                 ": the law is unstable there; ask for smaller strains");
}

HomogeneousTestPoint HomogeneousTest::at(const HomogeneousTestType type, const double measure) const
{
  if (type == HomogeneousTestType::shear)
    return sheared(measure);
  const bool is_uniaxial = type == HomogeneousTestType::uniaxial,
             is_planar = type == HomogeneousTestType::planar;
  const double rate = 1. / measure;
  const PrincipalState state =
      equilibrium({{measure, is_planar ? 1. : measure, 1.}}, {{true, !is_uniaxial, false}},
                  {{rate, is_planar ? 0. : rate, 0.}});
  HomogeneousTestPoint point;
  point.measure = measure;
  point.volume_ratio = state.strain.determinant;
  point.nominal_stress = state.stress[0] / measure;
  point.cauchy_stress = state.stress[0] / point.volume_ratio;
  point.tangent_modulus = (state.stress_rate[0] - point.nominal_stress) / measure;
  point.normal_difference = (state.stress[0] - state.stress[1]) / point.volume_ratio;
  point.energy = law.energy(state.strain);
  point.strain = state.strain;
  return point;
}

HomogeneousTestPoint HomogeneousTest::sheared(const double amount) const
{
  HomogeneousTestPoint point;
  point.measure = amount;
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
  return point;
}
} // namespace Continua
