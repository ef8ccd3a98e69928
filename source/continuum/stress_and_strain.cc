#include <continua/continuum/stress_and_strain.h>

#include <continua/materials/metric_stress.h>

#include <deal.II/base/symmetric_tensor.h>

#include <cmath>

namespace Continua
{
using namespace dealii;

template <int dim>
std::array<double, 6>
stress(const Tensor<2, dim> &gradient, const double hoop, const double pressure, const Model model)
{
  std::array<double, 6> result = {{0., 0., 0., 0., 0., 0.}};
  double diagonal[3] = {0., 0., 0.};
  for (unsigned int c = 0; c < dim; ++c)
    diagonal[c] = gradient[c][c];
  if (model == Model::axisymmetric)
    diagonal[2] = hoop;
  const double mean = (diagonal[0] + diagonal[1] + diagonal[2]) / 3.;
  for (unsigned int c = 0; c < 3; ++c)
    result[c] = 2. * (diagonal[c] - mean) - pressure;
  if (model == Model::plane_stress)
    result[2] = 0.;
  for (unsigned int k = 3; k < n_stresses<dim>(); ++k)
    result[k] = gradient[stress_pairs[k][0]][stress_pairs[k][1]] +
                gradient[stress_pairs[k][1]][stress_pairs[k][0]];
  return result;
}

template <int dim>
double thinning(const FlowCurve &curve,
                const Tensor<2, dim> &gradient,
                const double hoop,
                const Model model)
{
  // Twice the deviator of the strain rate, times eta_0.
  const std::array<double, 6> twice = stress<dim>(gradient, hoop, 0., model);
  double square = 0.;
  for (unsigned int k = 0; k < 6; ++k)
    square += (k < 3 ? 0.5 : 1.) * twice[k] * twice[k];
  return curve.viscosity(std::sqrt(square) / curve.zero_rate_viscosity) / curve.zero_rate_viscosity;
}

template <int dim>
std::array<double, 6> strain(const Tensor<2, dim> &gradient,
                             const double hoop,
                             const Model model,
                             const PlaneStressFactors &plane_stress)
{
  std::array<double, 6> result = {{0., 0., 0., 0., 0., 0.}};
  for (unsigned int c = 0; c < dim; ++c)
    result[c] = gradient[c][c];
  if (model == Model::axisymmetric)
    result[2] = hoop;
  if (model == Model::plane_stress)
    result[2] = plane_stress.thickness_strain_factor * (result[0] + result[1]);
  for (unsigned int k = 3; k < n_stresses<dim>(); ++k)
    result[k] = 0.5 * (gradient[stress_pairs[k][0]][stress_pairs[k][1]] +
                       gradient[stress_pairs[k][1]][stress_pairs[k][0]]);
  return result;
}

template <int dim>
std::array<double, 6> vorticity(const Tensor<2, dim> &gradient)
{
  std::array<double, 6> result = {{0., 0., 0., 0., 0., 0.}};
  if constexpr (dim == 3)
  {
    result[0] = gradient[2][1] - gradient[1][2];
    result[1] = gradient[0][2] - gradient[2][0];
  }
  result[2] = gradient[1][0] - gradient[0][1];
  return result;
}

template <int dim>
double q_criterion(const Tensor<2, dim> &gradient, const double hoop, const Model model)
{
  double sum = model == Model::axisymmetric ? hoop * hoop : 0.;
  for (unsigned int i = 0; i < dim; ++i)
    for (unsigned int j = 0; j < dim; ++j)
      sum += gradient[i][j] * gradient[j][i];
  return -0.5 * sum;
}

namespace
{
std::array<double, 6> components_of(const SymmetricTensor<2, 3> &tensor)
{
  std::array<double, 6> result;
  for (unsigned int k = 0; k < result.size(); ++k)
    result[k] = tensor[stress_pairs[k][0]][stress_pairs[k][1]];
  return result;
}
} // namespace

std::array<double, 6> finite_stress(const Material &material,
                                    const StressFreeState &stress_free,
                                    const Kinematics &kinematics,
                                    const Tensor<2, 3> &velocity_gradient,
                                    const double pressure,
                                    const SymmetricTensor<2, 3> &metric)
{
  const double ratio = kinematics.volume_ratio() / stress_free.volume_ratio;
  const PointStrain strain{kinematics.deformation_gradient() * stress_free.prestretch, ratio,
                           stress_free.fibres};
  SymmetricTensor<2, 3> stress, of_branches;
  if (material.strain_law != nullptr)
  {
    material.strain_law->set_stress(strain, stress);
    MetricStress(metric).set_stress(strain, of_branches);
    stress += of_branches;
    stress /= ratio;
  }
  const SymmetricTensor<2, 3> rate = deviator(symmetrize(kinematics.gradient(velocity_gradient)));
  const Shear &shear = material.shear;
  stress += 2. *
            (shear.flow_curve ? shear.flow_curve->viscosity(std::sqrt(2.) * rate.norm())
                              : shear.viscosity) *
            rate;
  return components_of(stress - pressure * unit_symmetric_tensor<3>());
}

std::array<double, 6> green_strain(const Kinematics &kinematics)
{
  const Tensor<2, 3> &f = kinematics.deformation_gradient();
  return components_of(0.5 * (symmetrize(transpose(f) * f) - unit_symmetric_tensor<3>()));
}

template <int dim>
Tensor<1, dim> traction(const std::array<double, 6> &stress, const Tensor<1, dim> &normal)
{
  Tensor<1, dim> result;
  for (unsigned int k = 0; k < 6; ++k)
  {
    const unsigned int i = stress_pairs[k][0], j = stress_pairs[k][1];
    if (i >= dim || j >= dim)
      continue;
    result[i] += stress[k] * normal[j];
    if (i != j)
      result[j] += stress[k] * normal[i];
  }
  return result;
}

template std::array<double, 6> stress(const Tensor<2, 2> &, double, double, Model);
template std::array<double, 6> stress(const Tensor<2, 3> &, double, double, Model);
template double thinning(const FlowCurve &, const Tensor<2, 2> &, double, Model);
template double thinning(const FlowCurve &, const Tensor<2, 3> &, double, Model);
template std::array<double, 6>
strain(const Tensor<2, 2> &, double, Model, const PlaneStressFactors &);
template std::array<double, 6>
strain(const Tensor<2, 3> &, double, Model, const PlaneStressFactors &);
template std::array<double, 6> vorticity(const Tensor<2, 2> &);
template std::array<double, 6> vorticity(const Tensor<2, 3> &);
template double q_criterion(const Tensor<2, 2> &, double, Model);
template double q_criterion(const Tensor<2, 3> &, double, Model);
template Tensor<1, 2> traction(const std::array<double, 6> &, const Tensor<1, 2> &);
template Tensor<1, 3> traction(const std::array<double, 6> &, const Tensor<1, 3> &);
} // namespace Continua
