#ifndef continua_tests_analysis_small_harmonic_system_h
#define continua_tests_analysis_small_harmonic_system_h

#include <continua/base/input_error.h>
#include <continua/continuum/harmonic_derivatives.h>
#include <continua/frequency/dense_complex_matrix.h>

#include <cmath>
#include <string>

namespace small_system
{
using namespace Continua;
using Complex = std::complex<double>;

/// Of a solid with a dash pot and a power law beside the spring.
inline Complex modulus(const Complex s)
{
  return 1. + 0.05 * s + 0.2 * std::pow(s, 0.4);
}

/// Four masses of 1 kg on springs: (s^2 + modulus(s) Q diag(stiffness) Q^T) D = f with a reflection
/// Q = 1 - 2 v v^T. Its resonances are those of each stiffness alone.
class SmallHarmonicSystem : public HarmonicSystem<2>
{
public:
  static constexpr unsigned int n = 4;
  std::vector<double> stiffness = {1., 9., 30., 400.};
  std::string failure; ///< of factors at s that decay; empty: none
  unsigned int n_factors = 0;

  unsigned int n_local_velocities() const override { return n; }
  unsigned int n_local_pressures() const override { return 0; }
  unsigned long long n_unknowns() const override { return n; }
  std::vector<std::vector<unsigned int>> velocity_nodes() const override
  {
    return {{0, 1}, {2, 3}};
  }
  std::vector<bool> free_velocities() const override { return std::vector<bool>(n, true); }
  std::vector<VelocityPlace<2>> velocity_places() const override
  {
    return {{{0., 0.}, 0}, {{0., 0.}, 1}, {{1., 0.}, 0}, {{1., 0.}, 1}};
  }

  std::vector<HarmonicLoadSource> sources() const override
  {
    return {{"left", 0, true}, {"right", 1, false}};
  }
  /// Of the left a force that moves from one mass to the next, and a velocity; of the right a
  /// constant.
  HarmonicLoad load_of(const HarmonicLoadSource &source, const double time) const override
  {
    HarmonicLoad load;
    if (source.condition == 0)
    {
      load.forces = {std::cos(time), std::sin(time), 0., 0.};
      load.velocities = {0., 0., 2. * std::cos(time), 0.};
      load.ports = {0.};
    }
    else
      load.forces = {0., 0., 0., 7.};
    return load;
  }
  HarmonicLoad unit_load(unsigned int) const override
  {
    HarmonicLoad load;
    load.forces = {1., 0., 0., 0.};
    return load;
  }
  const std::vector<unsigned int> &ports() const override { return no_ports; }

  void factor(const Complex s) override
  {
    if (!failure.empty() && s.real() < 0.)
      throw RunError(failure);
    factored_at = s;
    ++n_factors;
  }
  std::vector<HarmonicSolution> solve(const std::vector<HarmonicLoad> &loads) override
  {
    std::vector<HarmonicSolution> result;
    for (const HarmonicLoad &load : loads)
    {
      HarmonicSolution solution;
      solution.s = factored_at;
      solution.displacement = least_squares_solution(matrix(factored_at), load.forces);
      result.push_back(solution);
    }
    return result;
  }
  void
  solve_at(const std::vector<Complex> &s,
           const std::function<std::vector<HarmonicLoad>(std::size_t number)> &loads_at,
           const std::function<void(std::size_t number,
                                    const std::vector<HarmonicLoad> &loads,
                                    const std::vector<HarmonicSolution> &solutions)> &sink) override
  {
    for (std::size_t k = 0; k < s.size(); ++k)
    {
      const std::vector<HarmonicLoad> loads = loads_at(k);
      factor(s[k]);
      sink(k, loads, solve(loads));
    }
  }
  std::vector<HarmonicSolution> solve_further(std::size_t,
                                              const std::vector<HarmonicLoad> &loads) override
  {
    return solve(loads);
  }
  HarmonicFunctional functional(const std::vector<std::pair<unsigned int, double>> &,
                                Complex) const override
  {
    throw std::logic_error("it has no probes");
  }
  std::vector<HarmonicLoad> loads_of(const Problem &) override
  {
    throw std::logic_error("it has no problem");
  }
  std::unique_ptr<HarmonicDerivatives> derivatives(const std::vector<ProblemChange> &) override
  {
    throw std::logic_error("it has no problem");
  }
  HarmonicDeterminant determinant() override
  {
    Complex sum = 0.;
    for (const double spring : stiffness)
      sum += std::log(factored_at * factored_at + spring * modulus(factored_at));
    return {sum};
  }
  void multiply(const Complex s,
                const HarmonicSolution &solution,
                std::vector<Complex> &forces,
                std::vector<Complex> &dilatations) override
  {
    const DenseComplexMatrix a = matrix(s);
    forces.assign(n, 0.);
    dilatations.clear();
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        forces[i] += a(i, j) * solution.displacement[j];
  }
  void show_sum(const std::vector<WeightedSolution> &) override {}
  HarmonicPowers powers(const HarmonicSolution &, const HarmonicLoad &) override { return {}; }
  Complex power_of(const HarmonicLoad &, const HarmonicSolution &, const HarmonicLoad &) override
  {
    return 0.;
  }
  Complex flow_rate(unsigned int, const HarmonicSolution &) override { return 0.; }
  double factor_memory() const override { return 0.; }
  std::string solver_name() const override { return "dense"; }
  double largest_residual() const override { return 0.; }

private:
  Complex factored_at;
  std::vector<unsigned int> no_ports;

  DenseComplexMatrix matrix(const Complex s) const
  {
    const double v[n] = {0.5, 0.5, -0.5, 0.5};
    const auto q = [&v](const unsigned int i, const unsigned int j)
    { return (i == j ? 1. : 0.) - 2. * v[i] * v[j]; };
    DenseComplexMatrix a(n, n);
    for (unsigned int i = 0; i < n; ++i)
    {
      a(i, i) += s * s;
      for (unsigned int j = 0; j < n; ++j)
        for (unsigned int k = 0; k < n; ++k)
          a(i, j) += q(i, k) * stiffness[k] * modulus(s) * q(j, k);
    }
    return a;
  }
};
} // namespace small_system

#endif
