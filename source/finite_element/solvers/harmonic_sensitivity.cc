#include <continua/finite_element/solvers/harmonic_sensitivity.h>

#include <continua/base/input_error.h>
#include <continua/finite_element/products/supports.h>

#include <algorithm>
#include <cmath>

namespace Continua
{
using namespace dealii;

namespace
{
using Complex = std::complex<double>;

/// Of the impedances of two ports as each answers the other, over the largest impedance [1].
constexpr double largest_asymmetry = 1e-6;

/// a . b, not conjugate, of this rank; an empty vector stands for zeros.
Complex bilinear_product(const std::vector<Complex> &a, const std::vector<Complex> &b)
{
  Complex sum = 0.;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    sum += a[i] * b[i];
  return sum;
}

/// A x of a real A.
template <typename Multiply>
std::vector<Complex>
multiplied(const Multiply &multiply, const std::vector<Complex> &vector, RealAndImaginary &work)
{
  work.set(vector);
  DistributedVector result(work.real);
  multiply(result, work.real);
  work.real = result;
  multiply(result, work.imaginary);
  work.imaginary = result;
  return work.values();
}

double sum_over(const ProblemChange &change, const std::vector<double> &values)
{
  double sum = 0.;
  for (std::size_t k = 0; k < values.size(); ++k)
    sum += change.weights[k] * values[k];
  return sum;
}

const BoundaryPart &part_of(const BoundaryCondition &condition, const bool normal)
{
  return normal ? condition.normal : condition.tangential;
}

/// The derivatives of the coefficients of each region.
HarmonicCoefficients derivative_of(const ProblemChange &change, const Complex s)
{
  const auto add =
      [](const double weight, const std::vector<Complex> &from, std::vector<Complex> &to)
  {
    to.resize(from.size());
    for (std::size_t i = 0; i < from.size(); ++i)
      to[i] += weight * from[i];
  };
  HarmonicCoefficients result;
  for (std::size_t k = 0; k < change.problems.size(); ++k)
  {
    const HarmonicCoefficients at_node = harmonic_coefficients(change.problems[k]->materials, s);
    add(change.weights[k], at_node.mass, result.mass);
    add(change.weights[k], at_node.stiffness, result.stiffness);
    add(change.weights[k], at_node.compressibility, result.compressibility);
  }
  return result;
}
} // namespace

template <int dim>
HarmonicSensitivity<dim>::HarmonicSensitivity(const Space<dim> &space,
                                              const Problem &problem,
                                              const std::vector<RegionOperators> &operators,
                                              const LinearProducts<dim> &products,
                                              HarmonicEquations<dim> &equations,
                                              const HarmonicPorts &ports,
                                              const std::vector<ProblemChange> &changes)
    : space(space),
      problem(problem),
      operators(operators),
      products(products),
      equations(equations),
      ports(ports),
      changes(changes)
{
  for (unsigned int condition = 0; condition < problem.conditions.size(); ++condition)
    for (const bool normal : {true, false})
      add_support(condition, normal);
}

template <int dim>
void HarmonicSensitivity<dim>::add_support(const unsigned int condition, const bool normal)
{
  Support support;
  bool changes_at_all = false;
  for (const ProblemChange &change : changes)
  {
    std::vector<double> stiffness, damping;
    for (const Problem *const changed : change.problems)
    {
      const BoundaryPart &part = part_of(changed->conditions[condition], normal);
      stiffness.push_back(part.stiffness);
      damping.push_back(part.damping);
      const BoundaryPart &own = part_of(problem.conditions[condition], normal);
      changes_at_all =
          changes_at_all || part.stiffness != own.stiffness || part.damping != own.damping;
    }
    support.stiffness.push_back(sum_over(change, stiffness));
    support.damping.push_back(sum_over(change, damping));
  }
  if (!changes_at_all)
    return;
  std::vector<BoundaryCondition> conditions = problem.conditions;
  for (unsigned int c = 0; c < conditions.size(); ++c)
    for (BoundaryPart *const part : {&conditions[c].normal, &conditions[c].tangential})
      part->stiffness = part->damping = 0.;
  (normal ? conditions[condition].normal : conditions[condition].tangential).stiffness = 1.;
  support.unit = std::vector<RegionOperators>(operators.size());
  assemble_supports(space, conditions, support.unit);
  supports.push_back(std::move(support));
}

template <int dim>
typename HarmonicSensitivity<dim>::Products
HarmonicSensitivity<dim>::products_of(const HarmonicSolution &solution,
                                      const std::vector<HarmonicFunctional> &functionals,
                                      const std::vector<HarmonicSolution> &adjoints)
{
  const std::vector<Complex> &displacement = solution.displacement;
  RealAndImaginary of_velocities(space.velocity_vector()), of_pressures(space.pressure_vector());
  using Vector = DistributedVector;
  const auto with_displacements = [&](const std::vector<Complex> &vector)
  {
    std::vector<Complex> result;
    for (const HarmonicSolution &adjoint : adjoints)
      result.push_back(equations.sum(bilinear_product(adjoint.displacement, vector)));
    return result;
  };
  Products result;
  for (unsigned int r = 0; r < operators.size(); ++r)
  {
    result.mass.push_back(with_displacements(multiplied([&](Vector &y, const Vector &x)
                                                        { products.multiply_mass(r, y, x); },
                                                        displacement, of_velocities)));
    result.stiffness.push_back(with_displacements(
        multiplied([&](Vector &y, const Vector &x) { products.multiply_stiffness(r, y, x); },
                   displacement, of_velocities)));
    const std::vector<Complex> of_pressure =
        multiplied([&](Vector &y, const Vector &x) { products.multiply_pressure_mass(r, y, x); },
                   solution.pressure, of_pressures);
    result.pressure_mass.emplace_back();
    result.of_modulus.emplace_back();
    for (std::size_t j = 0; j < adjoints.size(); ++j)
    {
      result.pressure_mass[r].push_back(
          equations.sum(bilinear_product(adjoints[j].pressure, of_pressure)));
      Complex share = 0.;
      for (const auto &[index, weight] : functionals[j].of_modulus[r])
        share += weight * displacement[index];
      result.of_modulus[r].push_back(equations.sum(share));
    }
  }
  for (const Support &support : supports)
  {
    std::vector<Complex> forces(displacement.size());
    for (const RegionOperators &of_region : support.unit)
      if (of_region.is_supported)
      {
        const std::vector<Complex> part =
            multiplied([&](Vector &y, const Vector &x) { of_region.support_stiffness.vmult(y, x); },
                       displacement, of_velocities);
        for (std::size_t i = 0; i < part.size(); ++i)
          forces[i] += part[i];
      }
    result.supports.push_back(with_displacements(forces));
  }
  for (unsigned int port = 0; port < ports.size(); ++port)
  {
    result.port_volumes.emplace_back();
    for (const HarmonicSolution &adjoint : adjoints)
      result.port_volumes.back().push_back(equations.flow_of_port(port, adjoint.displacement, 1.));
  }
  return result;
}

template <int dim>
std::vector<std::complex<double>>
HarmonicSensitivity<dim>::reactions(const HarmonicFunctional &functional,
                                    const HarmonicSolution &adjoint)
{
  std::vector<Complex> forces, dilatations;
  equations.apply(equations.coefficients(adjoint.s), adjoint.displacement, adjoint.pressure, forces,
                  dilatations);
  for (unsigned int port = 0; port < ports.size(); ++port)
    equations.add_port(port, adjoint.port_pressures[port], forces);
  for (std::size_t i = 0; i < forces.size(); ++i)
    forces[i] = functional.weights.forces[i] - forces[i];
  return forces;
}

template <int dim>
FullMatrix<std::complex<double>>
HarmonicSensitivity<dim>::change_of_impedances(const ProblemChange &change, const Complex s) const
{
  FullMatrix<Complex> result(ports.size(), ports.size());
  for (std::size_t k = 0; k < change.problems.size() && ports.size() > 0; ++k)
    result.add(Complex(change.weights[k]), HarmonicPorts(*change.problems[k]).impedances(s));
  return result;
}

template <int dim>
std::complex<double>
HarmonicSensitivity<dim>::share_of_load(const HarmonicLoad &load,
                                        const HarmonicSolution &adjoint,
                                        const std::vector<Complex> &reaction) const
{
  Complex result = bilinear_product(load.forces, adjoint.displacement);
  if (!load.velocities.empty())
    result += bilinear_product(load.velocities, reaction) / adjoint.s;
  return result;
}

template <int dim>
std::vector<std::vector<std::complex<double>>>
HarmonicSensitivity<dim>::evaluate(const HarmonicSolution &solution,
                                   const std::vector<HarmonicFunctional> &functionals,
                                   const std::vector<HarmonicSolution> &adjoints)
{
  const Complex s = solution.s;
  const FullMatrix<Complex> impedances = ports.impedances(s);
  for (unsigned int i = 0; i < ports.size(); ++i)
    for (unsigned int j = 0; j < i; ++j)
      if (std::abs(impedances(i, j) - impedances(j, i)) >
          largest_asymmetry * std::max(std::abs(impedances(i, j)), std::abs(impedances(j, i))))
        throw RunError("the ports of an end answer each other with impedances that are not "
                       "symmetric, so that there is no adjoint solution: remove the section "
                       "Harmonic/Sensitivities, or let the wall's end not absorb");
  const Products all = products_of(solution, functionals, adjoints);
  const bool moves_boundaries =
      std::any_of(changes.begin(), changes.end(),
                  [](const ProblemChange &change) { return !change.load.velocities.empty(); });
  std::vector<std::vector<Complex>> result(functionals.size());
  for (std::size_t j = 0; j < functionals.size(); ++j)
  {
    const std::vector<Complex> reaction =
        moves_boundaries ? reactions(functionals[j], adjoints[j]) : std::vector<Complex>();
    for (const ProblemChange &change : changes)
      result[j].push_back(equations.sum(share_of_load(change.load, adjoints[j], reaction)));
  }
  for (std::size_t m = 0; m < changes.size(); ++m)
  {
    const ProblemChange &change = changes[m];
    const HarmonicCoefficients by_entry = derivative_of(change, s);
    const FullMatrix<Complex> of_impedances = change_of_impedances(change, s);
    for (std::size_t j = 0; j < functionals.size(); ++j)
    {
      Complex &sum = result[j][m];
      for (unsigned int r = 0; r < by_entry.mass.size(); ++r)
        sum += by_entry.compressibility[r] * all.pressure_mass[r][j] +
               by_entry.stiffness[r] * (all.of_modulus[r][j] - all.stiffness[r][j]) -
               by_entry.mass[r] * all.mass[r][j];
      for (std::size_t k = 0; k < supports.size(); ++k)
        sum -= (supports[k].stiffness[m] + s * supports[k].damping[m]) * all.supports[k][j];
      // None has a flow rate without a profile: that needs a section which moves.
      for (unsigned int i = 0; i < ports.size(); ++i)
      {
        Complex pressure = change.load.ports.empty() ? Complex(0.) : change.load.ports[i];
        for (unsigned int k = 0; k < ports.size(); ++k)
          pressure += of_impedances(i, k) * solution.port_flow_rates[k];
        sum -= all.port_volumes[i][j] * pressure;
      }
    }
  }
  return result;
}

template class HarmonicSensitivity<2>;
template class HarmonicSensitivity<3>;
} // namespace Continua
