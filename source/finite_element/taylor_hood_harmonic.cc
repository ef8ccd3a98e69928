#include <continua/finite_element/taylor_hood_harmonic.h>

#include <continua/base/input_error.h>
#include <continua/linear_algebra/singular_matrix.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace Continua
{
using namespace dealii;

namespace
{
using HarmonicNumbers = std::vector<std::complex<double>>;

/// Sets both parts of complex numbers.
void split(const HarmonicNumbers &values, DistributedVector &real, DistributedVector &imaginary)
{
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    real.begin()[i] = values[i].real();
    imaginary.begin()[i] = values[i].imag();
  }
}

void join(const DistributedVector &real,
          const DistributedVector &imaginary,
          HarmonicNumbers &values)
{
  values.resize(real.locally_owned_size());
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = {real.begin()[i], imaginary.begin()[i]};
}

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

/// Infinite if one of them is no number.
double
largest_magnitude(const HarmonicNumbers &values, const std::size_t begin, const std::size_t end)
{
  double largest = 0.;
  for (std::size_t i = begin; i < end; ++i)
  {
    const double magnitude = std::abs(values[i]);
    largest = std::isfinite(magnitude) ? std::max(largest, magnitude)
                                       : std::numeric_limits<double>::infinity();
    if (std::isinf(largest))
      break;
  }
  return largest;
}

/// Infinite of what is no number, and of a size without a scale.
double relative_size(const double size, const double scale)
{
  if (size == 0.)
    return 0.;
  const double relative = size / scale;
  return std::isfinite(relative) ? relative : std::numeric_limits<double>::infinity();
}

bool is_given(const std::vector<Waveform> &waveforms)
{
  return std::any_of(waveforms.begin(), waveforms.end(),
                     [](const Waveform &waveform) { return !waveform.is_zero(); });
}

bool is_of_time(const std::vector<Waveform> &waveforms)
{
  return std::any_of(waveforms.begin(), waveforms.end(),
                     [](const Waveform &waveform) { return waveform.depends_on_time(); });
}

std::vector<std::pair<unsigned int, double>> entries_not_zero(const DistributedVector &vector)
{
  std::vector<std::pair<unsigned int, double>> entries;
  for (unsigned int i = 0; i < vector.locally_owned_size(); ++i)
    if (vector.begin()[i] != 0.)
      entries.emplace_back(i, vector.begin()[i]);
  return entries;
}

/// Of the values at rest.
HarmonicNumbers real_numbers(const DistributedVector &vector)
{
  return HarmonicNumbers(vector.begin(), vector.end());
}
} // namespace

template <int dim>
TaylorHoodHarmonic<dim>::TaylorHoodHarmonic(const Space<dim> &space,
                                            const Problem &problem,
                                            const std::vector<RegionOperators> &operators,
                                            const BoundaryConstraints<dim> &constraints,
                                            const Loads<dim> &loads,
                                            const LinearProducts<dim> &products,
                                            const HarmonicState &state)
    : space(space),
      problem(problem),
      operators(operators),
      constraints(constraints),
      load_list(loads),
      products(products),
      state(state),
      port_model(problem),
      zero_velocity(space.velocity_vector()),
      velocity_work(space.velocity_vector()),
      pressure_work(space.pressure_vector())
{
  matrix.build(space, operators, constraints);
  std::vector<int> owned;
  for (const auto index : space.velocity_owned)
    owned.push_back(index);
  for (const auto index : space.pressure_owned)
    owned.push_back(space.velocity_dofs.n_dofs() + index);
  factors = std::make_unique<HarmonicFactors>(matrix, owned, space.communicator);
  for (const unsigned int condition : port_model.conditions())
    port_flows.push_back(entries_not_zero(load_list.flow_of_velocities(condition)));
  DistributedVector one = space.pressure_vector();
  one = 1.;
  for (unsigned int region = 0; region < operators.size(); ++region)
  {
    // Within the body a uniform pressure pushes nothing; what is left is at its surface.
    products.multiply_gradient(region, velocity_work, one);
    area_of_node = std::max(area_of_node, velocity_work.linfty_norm());
  }
}

template <int dim>
std::string TaylorHoodHarmonic<dim>::solver_name() const
{
  return "MUMPS, complex L D L^T with pivoting, " + std::to_string(factors->n_side_by_side()) +
         (factors->n_side_by_side() == 1 ? " frequency" : " frequencies") + " at a time";
}

template <int dim>
std::vector<std::vector<unsigned int>> TaylorHoodHarmonic<dim>::velocity_nodes() const
{
  return Continua::velocity_nodes(operators);
}

template <int dim>
std::vector<bool> TaylorHoodHarmonic<dim>::free_velocities() const
{
  std::vector<bool> result;
  for (const auto index : space.velocity_owned)
    result.push_back(!constraints.all().is_constrained(index));
  return result;
}

// Loads.

template <int dim>
std::vector<HarmonicLoadSource> TaylorHoodHarmonic<dim>::sources() const
{
  std::vector<HarmonicLoadSource> result;
  const InteriorData &interior = problem.interior;
  if (is_given(interior.body_force) || is_given(interior.acceleration))
    result.push_back(
        {"body force", -1, is_of_time(interior.body_force) || is_of_time(interior.acceleration)});
  for (unsigned int c = 0; c < problem.conditions.size(); ++c)
  {
    const BoundaryCondition &condition = problem.conditions[c];
    bool is_loaded = !condition.normal.is_zero() || !condition.tangential.is_zero(),
         is_in_time = condition.normal.depends_on_time() || condition.tangential.depends_on_time();
    const auto add = [&](const Waveform &waveform)
    {
      is_loaded = is_loaded || !waveform.is_zero();
      is_in_time = is_in_time || waveform.depends_on_time();
    };
    if (condition.free_flow)
      add(condition.free_flow->rate);
    for (const Outlet &outlet : problem.outlets)
      if (outlet.conditions[0] == c)
        add(outlet.pressure_behind);
    if (is_loaded)
      result.push_back({condition.name, static_cast<int>(c), is_in_time});
  }
  return result;
}

template <int dim>
HarmonicLoad TaylorHoodHarmonic<dim>::load_of(const HarmonicLoadSource &source,
                                              const double time) const
{
  HarmonicLoad load;
  DistributedVector vector = space.velocity_vector();
  load_list.add_of(source.condition, time, vector);
  load.forces = real_numbers(vector);
  if (source.condition < 0)
    return load;
  const BoundaryCondition &condition = problem.conditions[source.condition];
  constraints.evaluate_of(condition, time, vector);
  load.velocities = real_numbers(vector);
  const double origin[3] = {0., 0., 0.};
  load.ports.assign(port_model.size(), 0.);
  for (const Outlet &outlet : problem.outlets)
    for (unsigned int port = 0; port < port_model.size(); ++port)
      if (static_cast<int>(outlet.conditions[0]) == source.condition &&
          port_model.conditions()[port] == outlet.conditions[0])
        load.ports[port] = outlet.pressure_behind(origin, time);
  for (unsigned int port = 0; port < port_model.size(); ++port)
    if (port_model.is_free_flow(port) &&
        static_cast<int>(port_model.conditions()[port]) == source.condition)
      load.ports[port] = condition.free_flow->fraction * condition.free_flow->rate(origin, time);
  return load;
}

template <int dim>
HarmonicLoad TaylorHoodHarmonic<dim>::unit_load(const unsigned int condition) const
{
  HarmonicLoad load;
  load.ports.assign(port_model.size(), 0.);
  for (unsigned int port = 0; port < port_model.size(); ++port)
    if (port_model.conditions()[port] == condition)
    {
      load.ports[port] = 1.;
      return load;
    }
  if (problem.conditions[condition].normal.kind != BoundaryPart::Kind::traction)
    throw RunError("a unit load of the boundary '" + problem.conditions[condition].name +
                   "' needs a pressure there: its velocity is given");
  DistributedVector flow = load_list.flow_of_velocities(condition);
  flow *= -1.;
  load.forces = real_numbers(flow);
  return load;
}

// Products.

template <int dim>
HarmonicCoefficients TaylorHoodHarmonic<dim>::coefficients(const Complex s) const
{
  const Complex omega = Complex(0., -1.) * s;
  HarmonicCoefficients result;
  for (const Material &material : problem.materials)
  {
    result.mass.push_back(s * s * material.density);
    result.stiffness.push_back(material.complex_shear_modulus(omega));
    result.compressibility.push_back(material.complex_inverse_bulk_modulus(omega));
  }
  result.support_damping = s;
  return result;
}

template <int dim>
void TaylorHoodHarmonic<dim>::apply(const HarmonicCoefficients &at_s,
                                    const std::vector<Complex> &displacement,
                                    const std::vector<Complex> &pressure,
                                    std::vector<Complex> &forces,
                                    std::vector<Complex> &dilatations)
{
  Pair u{space.velocity_vector(), space.velocity_vector()}, f = u;
  Pair p{space.pressure_vector(), space.pressure_vector()}, h = p;
  split(displacement, u.real, u.imaginary);
  split(pressure, p.real, p.imaginary);
  const auto add = [](const Complex factor, const auto &multiply, const Pair &from, Pair &to,
                      DistributedVector &work)
  {
    if (factor == 0.)
      return;
    multiply(work, from.real);
    to.real.add(factor.real(), work);
    to.imaginary.add(factor.imag(), work);
    multiply(work, from.imaginary);
    to.real.add(-factor.imag(), work);
    to.imaginary.add(factor.real(), work);
  };
  using Vector = DistributedVector;
  for (unsigned int r = 0; r < operators.size(); ++r)
  {
    add(
        at_s.mass[r], [&](Vector &y, const Vector &x) { products.multiply_mass(r, y, x); }, u, f,
        velocity_work);
    add(
        at_s.stiffness[r],
        [&](Vector &y, const Vector &x) { products.multiply_stiffness(r, y, x); }, u, f,
        velocity_work);
    add(
        1., [&](Vector &y, const Vector &x) { products.multiply_gradient(r, y, x); }, p, f,
        velocity_work);
    add(
        -1., [&](Vector &y, const Vector &x) { products.multiply_divergence(r, y, x); }, u, h,
        pressure_work);
    add(
        -at_s.compressibility[r],
        [&](Vector &y, const Vector &x) { products.multiply_pressure_mass(r, y, x); }, p, h,
        pressure_work);
    if (!operators[r].is_supported)
      continue;
    add(
        at_s.support_stiffness,
        [&](Vector &y, const Vector &x) { products.multiply_support_stiffness(r, y, x); }, u, f,
        velocity_work);
    add(
        at_s.support_damping,
        [&](Vector &y, const Vector &x) { products.multiply_support_damping(r, y, x); }, u, f,
        velocity_work);
  }
  join(f.real, f.imaginary, forces);
  join(h.real, h.imaginary, dilatations);
}

template <int dim>
void TaylorHoodHarmonic<dim>::restrict_rows(std::vector<Complex> &forces,
                                            std::vector<Complex> &dilatations) const
{
  Pair f{space.velocity_vector(), space.velocity_vector()};
  split(forces, f.real, f.imaginary);
  constraints.restrict_to_free(f.real);
  constraints.restrict_to_free(f.imaginary);
  join(f.real, f.imaginary, forces);
  Pair h{space.pressure_vector(), space.pressure_vector()};
  split(dilatations, h.real, h.imaginary);
  space.set_hanging_pressures_to_zero(h.real);
  space.set_hanging_pressures_to_zero(h.imaginary);
  join(h.real, h.imaginary, dilatations);
}

template <int dim>
void TaylorHoodHarmonic<dim>::expand(std::vector<Complex> &displacement) const
{
  Pair u{space.velocity_vector(), space.velocity_vector()};
  split(displacement, u.real, u.imaginary);
  constraints.expand_free(u.real);
  constraints.expand_free(u.imaginary);
  join(u.real, u.imaginary, displacement);
}

template <int dim>
std::complex<double> TaylorHoodHarmonic<dim>::sum(const Complex of_rank) const
{
  double parts[2] = {of_rank.real(), of_rank.imag()};
  MPI_Allreduce(MPI_IN_PLACE, parts, 2, MPI_DOUBLE, MPI_SUM, space.communicator);
  return {parts[0], parts[1]};
}

template <int dim>
double TaylorHoodHarmonic<dim>::size_of(const std::vector<Complex> &values) const
{
  return Utilities::MPI::max(largest_magnitude(values, 0, values.size()), space.communicator);
}

template <int dim>
std::complex<double> TaylorHoodHarmonic<dim>::flow_of_port(const unsigned int port,
                                                           const std::vector<Complex> &displacement,
                                                           const Complex s) const
{
  Complex of_rank = 0.;
  for (const auto &[index, value] : port_flows[port])
    of_rank += value * displacement[index];
  return s * sum(of_rank);
}

// Solving.

template <int dim>
std::vector<std::complex<double>>
TaylorHoodHarmonic<dim>::packed(const std::vector<Complex> &velocities,
                                const std::vector<Complex> &pressures) const
{
  std::vector<Complex> result = velocities;
  result.insert(result.end(), pressures.begin(), pressures.end());
  return result;
}

template <int dim>
HarmonicFactors::Columns
TaylorHoodHarmonic<dim>::right_hand_sides(const Complex s, const std::vector<HarmonicLoad> &loads)
{
  const HarmonicCoefficients at_s = coefficients(s);
  const std::vector<Complex> no_pressure(n_local_pressures());
  HarmonicFactors::Columns columns;
  for (const HarmonicLoad &load : loads)
  {
    std::vector<Complex> forces = load.forces, dilatations = no_pressure;
    forces.resize(n_local_velocities());
    if (!load.velocities.empty() && size_of(load.velocities) > 0.)
    {
      // What is prescribed goes to the right-hand side.
      std::vector<Complex> displacement = load.velocities, of_forces;
      for (Complex &value : displacement)
        value /= s;
      apply(at_s, displacement, no_pressure, of_forces, dilatations);
      for (std::size_t i = 0; i < forces.size(); ++i)
        forces[i] -= of_forces[i];
      for (Complex &value : dilatations)
        value *= -1.;
    }
    restrict_rows(forces, dilatations);
    columns.push_back(packed(forces, dilatations));
  }
  for (const Sparse &flow : port_flows)
  {
    std::vector<Complex> forces(n_local_velocities()), dilatations = no_pressure;
    for (const auto &[index, value] : flow)
      forces[index] = -value;
    restrict_rows(forces, dilatations);
    columns.push_back(packed(forces, dilatations));
  }
  return columns;
}

template <int dim>
double TaylorHoodHarmonic<dim>::subtract_left_side(const Complex s,
                                                   const std::vector<Complex> &displacement,
                                                   const std::vector<Complex> &pressure,
                                                   const std::vector<Complex> &port_pressures,
                                                   std::vector<Complex> &right)
{
  const std::size_t n = n_local_velocities();
  const auto size_of_part =
      [this](const std::vector<Complex> &values, const std::size_t begin, const std::size_t end)
  { return Utilities::MPI::max(largest_magnitude(values, begin, end), space.communicator); };
  std::vector<Complex> forces, dilatations;
  apply(coefficients(s), displacement, pressure, forces, dilatations);
  for (std::size_t port = 0; port < port_pressures.size(); ++port)
    for (const auto &[index, value] : port_flows[port])
      forces[index] += value * port_pressures[port];
  // Before they cancel, the rows of what is held among them. Of a liquid without compression the
  // dilatations of a node cancel in its row.
  const double scale = std::max(size_of(forces), size_of_part(right, 0, n));
  const double scale_of_dilatations =
      std::max({area_of_node * size_of(displacement), size_of(dilatations),
                size_of_part(right, n, right.size())});
  restrict_rows(forces, dilatations);
  for (std::size_t i = 0; i < right.size(); ++i)
    right[i] -= i < n ? forces[i] : dilatations[i - n];
  return std::max(relative_size(size_of_part(right, 0, n), scale),
                  relative_size(size_of_part(right, n, right.size()), scale_of_dilatations));
}

template <int dim>
bool TaylorHoodHarmonic<dim>::is_solved(const std::vector<double> &residuals,
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
void TaylorHoodHarmonic<dim>::solve_columns(std::vector<HarmonicFactors::Columns> &columns)
{
  const std::size_t n = n_local_velocities();
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
        expand(displacement);
        sizes[k] = std::max(
            sizes[k], subtract_left_side(factored[k], displacement, pressure, {}, residuals[k][c]));
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
double TaylorHoodHarmonic<dim>::residual_of_ports(const HarmonicLoad &load,
                                                  const HarmonicSolution &solution,
                                                  std::vector<Complex> &residuals) const
{
  const unsigned int n_ports = port_model.size();
  const FullMatrix<Complex> impedance = port_model.impedances(solution.s);
  std::vector<Complex> flows;
  std::vector<double> sizes; // of the flows, before they cancel
  for (unsigned int port = 0; port < n_ports; ++port)
  {
    flows.push_back(flow_of_port(port, solution.displacement, solution.s));
    double size = 0.;
    for (const auto &[index, value] : port_flows[port])
      size += std::abs(value * solution.displacement[index]);
    sizes.push_back(std::abs(solution.s) * sum(size).real());
  }
  residuals.assign(n_ports, 0.);
  double largest = 0.;
  for (unsigned int port = 0; port < n_ports; ++port)
  {
    const Complex given = load.ports.empty() ? 0. : load.ports[port];
    double scale = std::abs(given);
    if (port_model.is_free_flow(port))
    {
      residuals[port] = given + flows[port];
      scale += sizes[port];
    }
    else
    {
      residuals[port] = given - solution.port_pressures[port];
      scale += std::abs(solution.port_pressures[port]);
      for (unsigned int other = 0; other < n_ports; ++other)
      {
        residuals[port] += impedance(port, other) * flows[other];
        scale += std::abs(impedance(port, other)) * sizes[other];
      }
    }
    largest = std::max(largest, relative_size(std::abs(residuals[port]), scale));
  }
  return largest;
}

template <int dim>
void TaylorHoodHarmonic<dim>::correct(const std::vector<std::vector<HarmonicLoad>> &loads,
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
        std::vector<Complex> forces = loads[k][l].forces, dilatations(n_local_pressures());
        forces.resize(n_local_velocities());
        restrict_rows(forces, dilatations);
        residuals[k].push_back(packed(forces, dilatations));
        of_ports[k].emplace_back();
        sizes[k] =
            std::max({sizes[k],
                      subtract_left_side(solution.s, solution.displacement, solution.pressure,
                                         solution.port_pressures, residuals[k].back()),
                      residual_of_ports(loads[k][l], solution, of_ports[k].back().ports)});
      }
    if (is_solved(sizes, correction))
      return;
    factors->solve(residuals);
    for (std::size_t k = 0; k < loads.size(); ++k)
    {
      residuals[k].insert(residuals[k].end(), columns[k].begin() + loads[k].size(),
                          columns[k].end());
      const std::vector<HarmonicSolution> corrections = complete(k, of_ports[k], residuals[k]);
      for (std::size_t l = 0; l < corrections.size(); ++l)
        solutions[k][l].add(1., corrections[l]);
    }
  }
}

template <int dim>
std::vector<HarmonicSolution>
TaylorHoodHarmonic<dim>::complete(const std::size_t number,
                                  const std::vector<HarmonicLoad> &loads,
                                  const HarmonicFactors::Columns &columns)
{
  const Complex s = factored[number];
  const std::size_t n = n_local_velocities(), n_ports = port_model.size();
  const auto displacement_of = [&](const std::size_t column)
  {
    std::vector<Complex> result(columns[column].begin(), columns[column].begin() + n);
    expand(result);
    return result;
  };
  std::vector<std::vector<Complex>> responses;
  FullMatrix<Complex> flows(n_ports, n_ports);
  for (unsigned int j = 0; j < n_ports; ++j)
  {
    responses.push_back(displacement_of(loads.size() + j));
    for (unsigned int i = 0; i < n_ports; ++i)
      flows(i, j) = flow_of_port(i, responses[j], s);
  }
  try
  {
    port_model.set_responses(s, flows);
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
      flow_rates.push_back(flow_of_port(i, solution.displacement, s));
    solution.port_pressures = port_model.pressures(flow_rates, loads[l].ports);
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
TaylorHoodHarmonic<dim>::solve_in_use(const std::vector<std::vector<HarmonicLoad>> &loads)
{
  std::vector<HarmonicFactors::Columns> columns;
  for (std::size_t k = 0; k < loads.size(); ++k)
    columns.push_back(right_hand_sides(factored[k], loads[k]));
  solve_columns(columns);
  std::vector<std::vector<HarmonicSolution>> solutions;
  for (std::size_t k = 0; k < loads.size(); ++k)
    solutions.push_back(complete(k, loads[k], columns[k]));
  // The body alone may be near a resonance that it has not with its ports.
  if (port_model.size() > 0)
    correct(loads, columns, solutions);
  return solutions;
}

template <int dim>
void TaylorHoodHarmonic<dim>::make_factors(const std::vector<Complex> &all_s)
{
  std::vector<HarmonicCoefficients> of_batch;
  of_batch.reserve(all_s.size());
  for (const Complex s : all_s)
    of_batch.push_back(coefficients(s));
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
void TaylorHoodHarmonic<dim>::factor(const Complex s)
{
  make_factors({s});
}

template <int dim>
std::vector<HarmonicSolution> TaylorHoodHarmonic<dim>::solve(const std::vector<HarmonicLoad> &loads)
{
  AssertThrow(factored.size() == 1, ExcMessage("factor() comes before solve()."));
  return solve_in_use({loads})[0];
}

template <int dim>
void TaylorHoodHarmonic<dim>::solve_at(
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
    const std::vector<std::vector<HarmonicSolution>> solutions = solve_in_use(loads);
    for (std::size_t k = first; k < end; ++k)
      sink(k, loads[k - first], solutions[k - first]);
  }
}

template <int dim>
HarmonicDeterminant TaylorHoodHarmonic<dim>::determinant()
{
  AssertThrow(factored.size() == 1, ExcMessage("factor() comes before determinant()."));
  HarmonicDeterminant result{factors->log_determinant(0)};
  if (port_model.size() == 0)
    return result;
  // By the responses of the ports alone.
  solve({});
  result.logarithm += port_model.log_determinant();
  return result;
}

template <int dim>
void TaylorHoodHarmonic<dim>::multiply(const Complex s,
                                       const HarmonicSolution &solution,
                                       std::vector<Complex> &forces,
                                       std::vector<Complex> &dilatations)
{
  apply(coefficients(s), solution.displacement, solution.pressure, forces, dilatations);
  const FullMatrix<Complex> impedance = port_model.impedances(s);
  for (unsigned int i = 0; i < port_model.size(); ++i)
  {
    Complex pressure = port_model.is_free_flow(i) ? solution.port_pressures[i] : Complex(0.);
    for (unsigned int j = 0; j < port_model.size(); ++j)
      if (impedance(i, j) != 0.)
        pressure += impedance(i, j) * flow_of_port(j, solution.displacement, s);
    for (const auto &[index, value] : port_flows[i])
      forces[index] += value * pressure;
  }
  restrict_rows(forces, dilatations);
}

// Results.

template <int dim>
void TaylorHoodHarmonic<dim>::show(const HarmonicSolution &solution, const Complex factor)
{
  const auto set =
      [](const Complex of_all, const std::vector<Complex> &values, DistributedVector &vector)
  {
    for (std::size_t i = 0; i < values.size(); ++i)
      vector.begin()[i] = (of_all * values[i]).real();
  };
  set(factor, solution.displacement, state.displacement);
  set(factor * solution.s, solution.displacement, state.velocity);
  set(factor, solution.pressure, state.pressure);
  const HarmonicCoefficients at_s = coefficients(solution.s);
  state.mixtures.resize(operators.size());
  for (unsigned int region = 0; region < operators.size(); ++region)
  {
    if (state.mixtures[region].size() != zero_velocity.size())
      state.mixtures[region].reinit(zero_velocity);
    set(factor * at_s.stiffness[region], solution.displacement, state.mixtures[region]);
  }
}

template <int dim>
std::vector<std::complex<double>>
TaylorHoodHarmonic<dim>::reactions(const HarmonicSolution &solution, const HarmonicLoad &load)
{
  std::vector<Complex> forces, dilatations;
  apply(coefficients(solution.s), solution.displacement, solution.pressure, forces, dilatations);
  for (std::size_t i = 0; i < load.forces.size(); ++i)
    forces[i] -= load.forces[i];
  for (unsigned int port = 0; port < port_model.size(); ++port)
    for (const auto &[index, value] : port_flows[port])
      forces[index] += value * solution.port_pressures[port];
  return forces;
}

template <int dim>
std::complex<double> TaylorHoodHarmonic<dim>::power_of(const HarmonicLoad &part,
                                                       const HarmonicSolution &solution,
                                                       const HarmonicLoad &load)
{
  Complex of_rank = 0.;
  const Complex s = solution.s;
  for (std::size_t i = 0; i < part.forces.size(); ++i)
    of_rank += part.forces[i] * std::conj(s * solution.displacement[i]);
  if (!part.velocities.empty() && size_of(part.velocities) > 0.)
  {
    const std::vector<Complex> of_supports = reactions(solution, load);
    for (std::size_t i = 0; i < of_supports.size(); ++i)
      of_rank += of_supports[i] * std::conj(part.velocities[i]);
  }
  Complex power = 0.5 * sum(of_rank);
  for (unsigned int port = 0; port < part.ports.size(); ++port)
    power += port_model.is_free_flow(port)
                 ? 0.5 * solution.port_pressures[port] * std::conj(part.ports[port])
                 : -0.5 * part.ports[port] * std::conj(solution.port_flow_rates[port]);
  return power;
}

template <int dim>
HarmonicPowers TaylorHoodHarmonic<dim>::powers(const HarmonicSolution &solution,
                                               const HarmonicLoad &load)
{
  const double omega = solution.s.imag();
  const HarmonicCoefficients at_s = coefficients(solution.s);
  Pair u{space.velocity_vector(), space.velocity_vector()};
  Pair p{space.pressure_vector(), space.pressure_vector()};
  split(solution.displacement, u.real, u.imaginary);
  split(solution.pressure, p.real, p.imaginary);
  // x* A x of a symmetric A.
  const auto square = [](const Pair &x, const auto &multiply, DistributedVector &work)
  {
    multiply(work, x.real);
    double result = work * x.real;
    multiply(work, x.imaginary);
    return result + work * x.imaginary;
  };
  using Vector = DistributedVector;
  HarmonicPowers powers;
  for (unsigned int r = 0; r < operators.size(); ++r)
  {
    HarmonicPower power;
    const double strain = square(
        u, [&](Vector &y, const Vector &x) { products.multiply_stiffness(r, y, x); },
        velocity_work);
    power.viscosity = 0.5 * omega * omega * problem.materials[r].shear.viscosity * strain;
    power.relaxation = 0.5 * omega * at_s.stiffness[r].imag() * strain - power.viscosity;
    if (at_s.compressibility[r].imag() != 0.)
      power.relaxation -=
          0.5 * omega * at_s.compressibility[r].imag() *
          square(
              p, [&](Vector &y, const Vector &x) { products.multiply_pressure_mass(r, y, x); },
              pressure_work);
    if (operators[r].is_supported)
      power.supports =
          0.5 * omega * omega *
          square(
              u, [&](Vector &y, const Vector &x) { products.multiply_support_damping(r, y, x); },
              velocity_work);
    powers.regions.push_back(power);
  }
  HarmonicLoad forces, velocities, ports;
  forces.forces = load.forces;
  velocities.velocities = load.velocities;
  ports.ports = load.ports;
  powers.forces = power_of(forces, solution, load).real();
  powers.velocities = power_of(velocities, solution, load).real();
  powers.behind_ports = power_of(ports, solution, load).real();
  for (unsigned int port = 0; port < port_model.size(); ++port)
  {
    const Complex behind = load.ports.empty() ? 0. : load.ports[port];
    powers.ports.push_back(port_model.is_free_flow(port)
                               ? 0.
                               : 0.5 * ((solution.port_pressures[port] - behind) *
                                        std::conj(solution.port_flow_rates[port]))
                                           .real());
  }
  return powers;
}

template <int dim>
std::complex<double> TaylorHoodHarmonic<dim>::flow_rate(const unsigned int condition,
                                                        const HarmonicSolution &solution)
{
  constexpr double round_off = 1e-12;
  Complex of_rank = 0.;
  double size = 0.;
  for (const auto &[index, value] : entries_not_zero(load_list.flow_of_velocities(condition)))
  {
    of_rank += value * solution.displacement[index];
    size += std::abs(value * solution.displacement[index]);
  }
  const Complex flow = sum(of_rank);
  return std::abs(flow) > round_off * sum(size).real() ? solution.s * flow : 0.;
}

template class TaylorHoodHarmonic<2>;
template class TaylorHoodHarmonic<3>;
} // namespace Continua
