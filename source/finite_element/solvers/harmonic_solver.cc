#include <continua/finite_element/solvers/harmonic_solver.h>

#include <continua/base/input_error.h>
#include <continua/linear_algebra/singular_matrix.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Continua
{
using namespace dealii;

namespace
{
/// "at 10 Hz", of a motion that grows or decays by its s.
std::string at_this(const std::complex<double> s)
{
  std::ostringstream text;
  if (s.real() == 0.)
    text << "at " << s.imag() / (2. * numbers::PI) << " Hz";
  else
    text << "at s = " << s.real() << " + " << s.imag() << " i 1/s";
  return text.str();
}

/// Velocities and pressures behind each other.
std::vector<std::complex<double>> packed(const std::vector<std::complex<double>> &velocities,
                                         const std::vector<std::complex<double>> &pressures)
{
  std::vector<std::complex<double>> result = velocities;
  result.insert(result.end(), pressures.begin(), pressures.end());
  return result;
}
} // namespace

template <int dim>
HarmonicSolver<dim>::HarmonicSolver(const Space<dim> &space,
                                    const std::vector<RegionOperators> &operators,
                                    const BoundaryConstraints<dim> &constraints,
                                    HarmonicEquations<dim> &equations,
                                    HarmonicPorts &ports)
    : equations(equations), ports(ports), residual(equations, ports)
{
  if (equations.loaded_body() != nullptr)
    matrix.build(space, operators, constraints, *equations.loaded_body());
  else
    matrix.build(space, operators, constraints);
  std::vector<int> owned;
  for (const auto index : space.velocity_owned)
    owned.push_back(index);
  for (const auto index : space.pressure_owned)
    owned.push_back(space.velocity_dofs.n_dofs() + index);
  factors = std::make_unique<HarmonicFactors>(matrix, owned, space.communicator);
}

template <int dim>
std::string HarmonicSolver<dim>::name() const
{
  return std::string("MUMPS, complex ") + (matrix.is_symmetric() ? "L D L^T" : "L U") +
         " with pivoting, " + std::to_string(factors->n_side_by_side()) +
         (factors->n_side_by_side() == 1 ? " frequency" : " frequencies") + " at a time";
}

template <int dim>
HarmonicFactors::Columns
HarmonicSolver<dim>::right_hand_sides(const Complex s, const std::vector<HarmonicLoad> &loads)
{
  const HarmonicCoefficients at_s = equations.coefficients(s);
  const std::vector<Complex> no_pressure(equations.n_pressures());
  HarmonicFactors::Columns columns;
  for (const HarmonicLoad &load : loads)
  {
    std::vector<Complex> forces = load.forces, dilatations = no_pressure;
    forces.resize(equations.n_velocities());
    std::vector<Complex> given = load.dilatations;
    given.resize(equations.n_pressures());
    if (!load.velocities.empty() && equations.size_of(load.velocities) > 0.)
    {
      // What is prescribed goes to the right-hand side.
      std::vector<Complex> displacement = load.velocities, of_forces;
      for (Complex &value : displacement)
        value /= s;
      equations.apply(at_s, displacement, no_pressure, of_forces, dilatations);
      for (std::size_t i = 0; i < forces.size(); ++i)
        forces[i] -= of_forces[i];
      for (Complex &value : dilatations)
        value *= -1.;
    }
    for (std::size_t i = 0; i < dilatations.size(); ++i)
      dilatations[i] += given[i];
    equations.restrict_rows(forces, dilatations);
    columns.push_back(packed(forces, dilatations));
  }
  for (unsigned int port = 0; port < ports.size(); ++port)
  {
    std::vector<Complex> forces(equations.n_velocities()), dilatations = no_pressure;
    equations.add_port(port, -1., forces);
    equations.restrict_rows(forces, dilatations);
    columns.push_back(packed(forces, dilatations));
  }
  return columns;
}

template <int dim>
bool HarmonicSolver<dim>::is_solved(const std::vector<double> &residuals,
                                    const unsigned int correction)
{
  constexpr unsigned int most_corrections = 2;
  const auto largest = std::max_element(residuals.begin(), residuals.end());
  if (largest == residuals.end())
    return true;
  if (*largest > tolerance && correction < most_corrections)
    return false;
  residual_of_all = std::max(residual_of_all, *largest);
  if (*largest <= largest_accepted_residual)
    return true;
  std::ostringstream text;
  text << at_this(factored[largest - residuals.begin()]) << " the solver leaves "
       << (std::isfinite(*largest) ? std::to_string(*largest) + " of the largest force at a node"
                                   : "values that are no numbers")
       << ": the matrix is nearly singular there, or its entries are too different in size. Give "
          "another frequency, or look for a modulus or a length in a wrong unit.";
  throw RunError(text.str());
}

template <int dim>
void HarmonicSolver<dim>::solve_columns(std::vector<HarmonicFactors::Columns> &columns)
{
  const std::size_t n = equations.n_velocities();
  const std::vector<HarmonicFactors::Columns> right = columns;
  factors->solve(columns);
  for (unsigned int correction = 0;; ++correction)
  {
    std::vector<double> sizes(columns.size(), 0.);
    std::vector<HarmonicFactors::Columns> residuals = right;
    for (std::size_t k = 0; k < columns.size(); ++k)
      for (std::size_t c = 0; c < columns[k].size(); ++c)
      {
        std::vector<Complex> displacement(columns[k][c].begin(), columns[k][c].begin() + n);
        const std::vector<Complex> pressure(columns[k][c].begin() + n, columns[k][c].end());
        equations.expand(displacement);
        sizes[k] = std::max(sizes[k], residual.subtract_left_side(factored[k], displacement,
                                                                  pressure, {}, residuals[k][c]));
      }
    if (is_solved(sizes, correction))
      return;
    factors->solve(residuals);
    for (std::size_t k = 0; k < columns.size(); ++k)
      for (std::size_t c = 0; c < columns[k].size(); ++c)
        for (std::size_t i = 0; i < columns[k][c].size(); ++i)
          columns[k][c][i] += residuals[k][c][i];
  }
}

template <int dim>
void HarmonicSolver<dim>::correct(const std::vector<std::vector<HarmonicLoad>> &loads,
                                  const std::vector<HarmonicFactors::Columns> &columns,
                                  std::vector<std::vector<HarmonicSolution>> &solutions)
{
  for (unsigned int correction = 0;; ++correction)
  {
    std::vector<double> sizes(loads.size(), 0.);
    std::vector<HarmonicFactors::Columns> residuals(loads.size());
    std::vector<std::vector<HarmonicLoad>> of_ports(loads.size());
    for (std::size_t k = 0; k < loads.size(); ++k)
      for (std::size_t l = 0; l < loads[k].size(); ++l)
      {
        const HarmonicSolution &solution = solutions[k][l];
        std::vector<Complex> forces = loads[k][l].forces, dilatations = loads[k][l].dilatations;
        forces.resize(equations.n_velocities());
        dilatations.resize(equations.n_pressures());
        equations.restrict_rows(forces, dilatations);
        residuals[k].push_back(packed(forces, dilatations));
        of_ports[k].emplace_back();
        sizes[k] = std::max(
            {sizes[k],
             residual.subtract_left_side(solution.s, solution.displacement, solution.pressure,
                                         solution.port_pressures, residuals[k].back()),
             residual.of_ports(loads[k][l], solution, of_ports[k].back().ports)});
      }
    if (is_solved(sizes, correction))
      return;
    factors->solve(residuals);
    for (std::size_t k = 0; k < loads.size(); ++k)
    {
      if (loads[k].empty())
        continue;
      residuals[k].insert(residuals[k].end(), columns[k].begin() + loads[k].size(),
                          columns[k].end());
      const std::vector<HarmonicSolution> corrections = complete(k, of_ports[k], residuals[k]);
      for (std::size_t l = 0; l < corrections.size(); ++l)
        solutions[k][l].add(1., corrections[l]);
    }
  }
}

template <int dim>
std::vector<HarmonicSolution> HarmonicSolver<dim>::complete(const std::size_t number,
                                                            const std::vector<HarmonicLoad> &loads,
                                                            const HarmonicFactors::Columns &columns)
{
  const Complex s = factored[number];
  const std::size_t n = equations.n_velocities(), n_ports = ports.size();
  const auto displacement_of = [&](const std::size_t column)
  {
    std::vector<Complex> result(columns[column].begin(), columns[column].begin() + n);
    equations.expand(result);
    return result;
  };
  std::vector<std::vector<Complex>> responses;
  FullMatrix<Complex> flows(n_ports, n_ports);
  for (unsigned int j = 0; j < n_ports; ++j)
  {
    responses.push_back(displacement_of(loads.size() + j));
    for (unsigned int i = 0; i < n_ports; ++i)
      flows(i, j) = equations.flow_of_port(i, responses[j], s);
  }
  try
  {
    ports.set_responses(s, flows);
  }
  catch (const SingularMatrix &error)
  {
    throw SingularMatrix(at_this(s) + ": " + error.what());
  }
  catch (const RunError &error)
  {
    throw RunError(at_this(s) + ": " + error.what());
  }

  std::vector<HarmonicSolution> solutions;
  for (std::size_t l = 0; l < loads.size(); ++l)
  {
    HarmonicSolution solution;
    solution.s = s;
    solution.displacement = displacement_of(l);
    if (!loads[l].velocities.empty())
      for (std::size_t i = 0; i < n; ++i)
        if (loads[l].velocities[i] != 0.)
          solution.displacement[i] += loads[l].velocities[i] / s;
    solution.pressure.assign(columns[l].begin() + n, columns[l].end());
    std::vector<Complex> flow_rates;
    for (unsigned int i = 0; i < n_ports; ++i)
      flow_rates.push_back(equations.flow_of_port(i, solution.displacement, s));
    solution.port_pressures = ports.pressures(flow_rates, loads[l].ports);
    for (unsigned int j = 0; j < n_ports; ++j)
    {
      const Complex pressure = solution.port_pressures[j];
      for (std::size_t i = 0; i < n; ++i)
        solution.displacement[i] += pressure * responses[j][i];
      for (std::size_t i = 0; i < solution.pressure.size(); ++i)
        solution.pressure[i] += pressure * columns[loads.size() + j][n + i];
      for (unsigned int i = 0; i < n_ports; ++i)
        flow_rates[i] += flows(i, j) * pressure;
    }
    solution.port_flow_rates = flow_rates;
    solutions.push_back(std::move(solution));
  }
  return solutions;
}

template <int dim>
std::vector<std::vector<HarmonicSolution>>
HarmonicSolver<dim>::solve_in_use(const std::vector<std::vector<HarmonicLoad>> &loads)
{
  std::vector<HarmonicFactors::Columns> columns;
  for (std::size_t k = 0; k < loads.size(); ++k)
    columns.push_back(right_hand_sides(factored[k], loads[k]));
  solve_columns(columns);
  std::vector<std::vector<HarmonicSolution>> solutions;
  for (std::size_t k = 0; k < loads.size(); ++k)
    solutions.push_back(complete(k, loads[k], columns[k]));
  // The body alone may be near a resonance that it has not with its ports.
  if (ports.size() > 0)
    correct(loads, columns, solutions);
  return solutions;
}

template <int dim>
std::vector<HarmonicSolution>
HarmonicSolver<dim>::solve_further(const std::size_t number, const std::vector<HarmonicLoad> &loads)
{
  AssertThrow(number >= number_of_first && number - number_of_first < factored.size(),
              ExcMessage("The factor of this number is not in use."));
  if (loads.empty())
    return {};
  // Nothing for the other factors in use.
  const std::size_t k = number - number_of_first;
  std::vector<std::vector<HarmonicLoad>> all_loads(factored.size());
  std::vector<HarmonicFactors::Columns> columns(factored.size());
  std::vector<std::vector<HarmonicSolution>> solutions(factored.size());
  all_loads[k] = loads;
  columns[k] = right_hand_sides(factored[k], loads);
  solve_columns(columns);
  solutions[k] = complete(k, loads, columns[k]);
  if (ports.size() > 0)
    correct(all_loads, columns, solutions);
  return solutions[k];
}

template <int dim>
void HarmonicSolver<dim>::make_factors(const std::vector<Complex> &all_s)
{
  std::vector<HarmonicCoefficients> of_batch;
  of_batch.reserve(all_s.size());
  for (const Complex s : all_s)
    of_batch.push_back(equations.coefficients(s));
  factored.clear();
  try
  {
    factors->factorize(of_batch);
  }
  catch (const SingularMatrix &error)
  {
    throw SingularMatrix(at_this(all_s[factors->failed()]) + ": " + error.what());
  }
  catch (const RunError &error)
  {
    throw RunError(at_this(all_s[factors->failed()]) + ": " + error.what());
  }
  factored = all_s;
}

template <int dim>
std::vector<HarmonicSolution> HarmonicSolver<dim>::solve(const std::vector<HarmonicLoad> &loads)
{
  AssertThrow(factored.size() == 1, ExcMessage("factor() comes before solve()."));
  return solve_in_use({loads})[0];
}

template <int dim>
void HarmonicSolver<dim>::solve_at(
    const std::vector<Complex> &s,
    const std::function<std::vector<HarmonicLoad>(std::size_t number)> &loads_at,
    const std::function<void(std::size_t number,
                             const std::vector<HarmonicLoad> &loads,
                             const std::vector<HarmonicSolution> &solutions)> &sink)
{
  const std::size_t n_at_a_time = factors->n_side_by_side();
  for (std::size_t first = 0; first < s.size(); first += n_at_a_time)
  {
    const std::size_t end = std::min(s.size(), first + n_at_a_time);
    std::vector<std::vector<HarmonicLoad>> loads;
    for (std::size_t k = first; k < end; ++k)
      loads.push_back(loads_at(k));
    make_factors({s.begin() + first, s.begin() + end});
    number_of_first = first;
    const std::vector<std::vector<HarmonicSolution>> solutions = solve_in_use(loads);
    for (std::size_t k = first; k < end; ++k)
      sink(k, loads[k - first], solutions[k - first]);
  }
}

template <int dim>
HarmonicDeterminant HarmonicSolver<dim>::determinant()
{
  AssertThrow(factored.size() == 1, ExcMessage("factor() comes before determinant()."));
  HarmonicDeterminant result{factors->log_determinant(0)};
  if (ports.size() == 0)
    return result;
  // By the responses of the ports alone.
  solve({});
  result.logarithm += ports.log_determinant();
  return result;
}

template class HarmonicSolver<2>;
template class HarmonicSolver<3>;
} // namespace Continua
