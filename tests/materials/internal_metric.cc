// The relaxing branch at finite strain: weights, the update against a fine integration and its
// order, what it keeps, the balance of its energy, the linear branch as its limit, and closed forms
// of simple shear.

#include <continua/materials/internal_metric.h>
#include <continua/materials/metric_stress.h>
#include <continua/materials/neo_hookean.h>

#include <deal.II/base/symmetric_tensor.h>

#include <algorithm>
#include <limits>

#include "../unit_test.h"
#include "strain_at_point.h"

namespace test_of_internal_metric
{
using namespace Continua;
using namespace strain_at_point;

namespace
{
constexpr double branch_modulus = 1.7, branch_time = 0.8;

const Symmetric2 unit_metric = dealii::unit_symmetric_tensor<3>();

void check_weights()
{
  for (const double x : {1e-12, 1e-6, 1e-3, 0.05, 0.0999, 0.1001, 1., 7., 50., 800.})
  {
    const MetricWeights weights(x);
    const long double e = std::exp(-static_cast<long double>(x)),
                      g = -std::expm1(-static_cast<long double>(x)) / x;
    const bool is_small = x < 1e-5;
    check::relative("weight of the old metric", weights.old_metric, static_cast<double>(e), 1e-15);
    check::relative("weight of the old inverse", weights.old_inverse,
                    is_small ? x / 2. - x * x / 3. : static_cast<double>(g - e), 1e-12);
    check::relative("weight of the new inverse", weights.new_inverse,
                    is_small ? x / 2. - x * x / 6. : static_cast<double>(1.L - g), 1e-12);
    check::relative("their sum", weights.old_metric + weights.old_inverse + weights.new_inverse, 1.,
                    1e-15);
  }
  const MetricWeights spring(0.), fluid(std::numeric_limits<double>::infinity());
  check::is_true("an infinite time keeps the metric",
                 spring.old_metric == 1. && spring.old_inverse == 0. && spring.new_inverse == 0.);
  check::is_true("a time of 0 keeps nothing",
                 fluid.old_metric == 0. && fluid.old_inverse == 0. && fluid.new_inverse == 1.);
}

/// A motion with stretch, shear, rotation and a change of volume.
PointStrain moved(const double time, const double amplitude = 1.)
{
  Tensor2 f = unit_tensor();
  f[0][0] += amplitude * 0.5 * std::sin(time);
  f[0][1] += amplitude * 0.7 * std::sin(2. * time);
  f[1][0] += amplitude * 0.2 * time;
  f[1][1] += amplitude * 0.1 * time;
  f[2][2] -= amplitude * 0.3 * std::sin(1.5 * time);
  f[1][2] += amplitude * 0.4 * (1. - std::cos(time));
  return strain_of(f);
}

/// A after `n` steps to time 2.
Symmetric2 updated(const unsigned int n)
{
  const double step = 2. / n;
  const MetricWeights weights(step / branch_time);
  Symmetric2 metric = unit_metric;
  for (unsigned int i = 0; i < n; ++i)
    metric =
        new_metric(weights, kept_metric(weights, metric, inverse_isochoric_metric(moved(i * step))),
                   inverse_isochoric_metric(moved((i + 1) * step)));
  return metric;
}

/// The same by the classical Runge-Kutta scheme.
Symmetric2 integrated(const unsigned int n)
{
  const double step = 2. / n;
  const auto rate = [](const double time, const Symmetric2 &metric)
  { return (inverse_isochoric_metric(moved(time)) - metric) / branch_time; };
  Symmetric2 metric = unit_metric;
  for (unsigned int i = 0; i < n; ++i)
  {
    const double time = i * step;
    const Symmetric2 k1 = rate(time, metric), k2 = rate(time + step / 2., metric + step / 2. * k1),
                     k3 = rate(time + step / 2., metric + step / 2. * k2),
                     k4 = rate(time + step, metric + step * k3);
    metric += step / 6. * (k1 + 2. * k2 + 2. * k3 + k4);
  }
  return metric;
}

void check_order()
{
  const Symmetric2 exact = integrated(2000);
  double before = (updated(10) - exact).norm();
  for (const unsigned int n : {20u, 40u, 80u, 160u})
  {
    const double error = (updated(n) - exact).norm();
    check::absolute("a quarter of the error in half of the step", before / error, 4., 0.15);
    before = error;
  }
  check::absolute("160 steps", before, 0., 1e-4);
}

/// Energy at the end, heat and work of the motion by the trapezoidal and the midpoint rule:
/// E - E0 + heat - work.
double imbalance(const unsigned int n)
{
  const double step = 2. / n;
  const MetricWeights weights(step / branch_time);
  Symmetric2 metric = unit_metric;
  double heat = 0., work = 0.;
  const auto stress = [](const PointStrain &strain, const Symmetric2 &a)
  {
    Symmetric2 tau;
    MetricStress(branch_modulus * a).set_stress(strain, tau);
    return tau;
  };
  for (unsigned int i = 0; i < n; ++i)
  {
    const PointStrain start = moved(i * step), end = moved((i + 1) * step);
    const double heat_at_start = metric_dissipation(branch_modulus, branch_time, start, metric);
    const Symmetric2 stress_at_start = stress(start, metric);
    metric = new_metric(weights, kept_metric(weights, metric, inverse_isochoric_metric(start)),
                        inverse_isochoric_metric(end));
    heat +=
        0.5 * step * (heat_at_start + metric_dissipation(branch_modulus, branch_time, end, metric));
    const Tensor2 change =
        (end.gradient - start.gradient) * invert(0.5 * (end.gradient + start.gradient));
    work += 0.5 * (stress_at_start + stress(end, metric)) * symmetrize(change);
  }
  return metric_energy(branch_modulus, moved(2.), metric) + heat - work;
}

void check_energy()
{
  const double coarse = imbalance(200), fine = imbalance(400);
  check::absolute("work is energy and heat", fine, 0., 1e-4);
  check::absolute("but for the second order of the step", coarse / fine, 4., 0.1);
  std::mt19937 random(3);
  bool positive = true, dissipates = true, has_energy = true;
  double at_rest = 0., heat_at_rest = 0.;
  for (unsigned int trial = 0; trial < 200; ++trial)
  {
    Symmetric2 metric = unit_metric;
    PointStrain strain = strain_of(unit_tensor());
    for (const double x : {1e-9, 0.3, 30., 1e6, 1e-3})
    {
      const PointStrain old_strain = strain;
      strain = strain_of(unit_tensor() + random_tensor(random, 0.45));
      if (strain.determinant < 0.05)
        strain = old_strain;
      const MetricWeights weights(x);
      metric =
          new_metric(weights, kept_metric(weights, metric, inverse_isochoric_metric(old_strain)),
                     inverse_isochoric_metric(strain));
      positive = positive && eigenvalues(metric)[2] > 0.;
      dissipates = dissipates && metric_dissipation(1., 1., strain, metric) >= 0.;
      has_energy = has_energy && metric_energy(1., strain, metric) >= -1e-13;
    }
    const Symmetric2 rest = inverse_isochoric_metric(strain);
    at_rest = std::max(at_rest, std::abs(metric_energy(1., strain, rest)));
    heat_at_rest = std::max(heat_at_rest, std::abs(metric_dissipation(1., 1., strain, rest)));
  }
  check::is_true("A is positive definite after steps of any length", positive);
  check::is_true("no motion makes work from heat", dissipates);
  check::is_true("energy is not negative", has_energy);
  check::absolute("energy of the branch at rest", at_rest, 0., 1e-13);
  check::absolute("heat of the branch at rest", heat_at_rest, 0., 1e-13);
}

/// Both by the formulas of the header, which divide by what is 0 at rest.
void check_formulas()
{
  const PointStrain strain = moved(1.3);
  const Symmetric2 metric = updated(50), inverse = inverse_isochoric_metric(strain),
                   cb = invert(inverse);
  check::relative("energy", metric_energy(branch_modulus, strain, metric),
                  0.5 * branch_modulus * (cb * metric - 3. - std::log(determinant(metric))), 1e-12);
  check::relative(
      "heat", metric_dissipation(branch_modulus, branch_time, strain, metric),
      0.5 * branch_modulus / branch_time * (invert(metric) * inverse + cb * metric - 6.), 1e-12);
  // 4 mu times the strain energy of the linear branch, half of it each.
  const double tiny = 1e-7;
  const Symmetric2 e = symmetrize(moved(1.3, tiny).gradient - unit_tensor());
  check::relative("energy of a tiny strain",
                  metric_energy(branch_modulus, moved(1.3, tiny), unit_metric),
                  branch_modulus * (deviator(e) * deviator(e)), 1e-5);
}

void check_stress()
{
  const PointStrain strain = moved(1.3), later = moved(1.5);
  const Symmetric2 metric = updated(50);
  const MetricWeights weights(0.2 / branch_time);
  const Symmetric2 kept = kept_metric(weights, metric, inverse_isochoric_metric(strain)),
                   metric_later = new_metric(weights, kept, inverse_isochoric_metric(later));
  Symmetric2 by_kept, by_new;
  MetricStress(branch_modulus * kept).set_stress(later, by_kept);
  MetricStress(branch_modulus * metric_later).set_stress(later, by_new);
  check::absolute("the metric that is kept gives the stress", (by_kept - by_new).norm(), 0., 1e-14);

  std::mt19937 random(8);
  const MetricStress law(branch_modulus * kept);
  double of_stress = 0.;
  for (unsigned int trial = 0; trial < 10; ++trial)
  {
    const Tensor2 g = random_tensor(random, 1.);
    Symmetric2 stress;
    dealii::SymmetricTensor<4, 3> tangent;
    law.set_tangent(later, stress, tangent);
    const Symmetric2 rate = derivative<Symmetric2>(
        [&](const double h)
        {
          Symmetric2 result;
          law.set_stress(strain_of(later.gradient + h * g * later.gradient), result);
          return result;
        });
    of_stress = std::max(of_stress, (stress_change(tangent, stress, g) - rate).norm());
  }
  check::absolute("tangent", of_stress, 0., 1e-9);
  Symmetric2 of_spring, of_rubber;
  MetricStress(branch_modulus * unit_metric).set_stress(later, of_spring);
  NeoHookean(branch_modulus).set_stress(later, of_rubber);
  check::absolute("a spring is neo-Hookean", (of_spring - of_rubber).norm(), 0., 1e-14);
}

/// dD/dt = de/dt - D/tau, exact where e is linear within the step; stress 2 mu dev D.
void check_linear_limit()
{
  const double amplitude = 1e-6, step = 0.1, x = step / branch_time;
  const MetricWeights weights(x);
  Symmetric2 metric = unit_metric, d, stress;
  for (unsigned int i = 0; i < 20; ++i)
  {
    const PointStrain start = moved(i * step, amplitude), end = moved((i + 1) * step, amplitude);
    const Symmetric2 kept = kept_metric(weights, metric, inverse_isochoric_metric(start));
    metric = new_metric(weights, kept, inverse_isochoric_metric(end));
    MetricStress(branch_modulus * kept).set_stress(end, stress);
    d = std::exp(-x) * d - std::expm1(-x) / x * symmetrize(end.gradient - start.gradient);
  }
  check::absolute("a small strain: the linear branch",
                  (stress - 2. * branch_modulus * deviator(d)).norm() / amplitude, 0., 2e-5);
}

void check_rest()
{
  const PointStrain strain = moved(1.3);
  const Symmetric2 inverse = inverse_isochoric_metric(strain);
  const MetricWeights weights(0.5);
  Symmetric2 metric = unit_metric, stress;
  for (unsigned int i = 0; i < 100; ++i)
    metric = new_metric(weights, kept_metric(weights, metric, inverse), inverse);
  MetricStress(metric).set_stress(strain, stress);
  check::absolute("a strain that is held: A is 1/Cb", (metric - inverse).norm(), 0., 1e-14);
  check::absolute("a strain that is held: no stress", stress.norm(), 0., 1e-14);
}

void check_simple_shear()
{
  const auto sheared = [](const double gamma)
  {
    Tensor2 f = unit_tensor();
    f[0][1] = gamma;
    return strain_of(f);
  };
  Symmetric2 stress;
  {
    // A sudden shear relaxes as the linear branch, by steps of any length.
    const PointStrain strain = sheared(1.4);
    const Symmetric2 inverse = inverse_isochoric_metric(strain);
    Symmetric2 metric = unit_metric;
    double time = 0.;
    for (const double step : {0.01, 0.5, 2.})
    {
      const MetricWeights weights(step / branch_time);
      time += step;
      metric = new_metric(weights, kept_metric(weights, metric, inverse), inverse);
      MetricStress(branch_modulus * metric).set_stress(strain, stress);
      check::relative("a sudden shear", stress[0][1],
                      branch_modulus * 1.4 * std::exp(-time / branch_time), 1e-13);
    }
  }
  {
    // A steady shear is that of the upper-convected Maxwell liquid.
    const double rate = 1.1, step = 0.002;
    const MetricWeights weights(step / branch_time);
    Symmetric2 metric = unit_metric;
    const unsigned int n_steps = 10000;
    for (unsigned int i = 0; i < n_steps; ++i)
      metric = new_metric(
          weights, kept_metric(weights, metric, inverse_isochoric_metric(sheared(rate * step * i))),
          inverse_isochoric_metric(sheared(rate * step * (i + 1))));
    MetricStress(branch_modulus * metric).set_stress(sheared(rate * step * n_steps), stress);
    check::relative("a steady shear: shear stress", stress[0][1],
                    branch_modulus * branch_time * rate, 1e-5);
    check::relative("a steady shear: difference of normal stresses", stress[0][0] - stress[1][1],
                    2. * branch_modulus * branch_time * branch_time * rate * rate, 1e-5);
  }
}
} // namespace

UNIT_TEST(internal_metric)
{
  check_weights();
  check_order();
  check_energy();
  check_formulas();
  check_stress();
  check_linear_limit();
  check_rest();
  check_simple_shear();
}
} // namespace test_of_internal_metric
