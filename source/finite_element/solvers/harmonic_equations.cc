#include <continua/finite_element/solvers/harmonic_equations.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Continua
{
using namespace dealii;

void RealAndImaginary::set(const std::vector<std::complex<double>> &values)
{
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    real.begin()[i] = values[i].real();
    imaginary.begin()[i] = values[i].imag();
  }
}

std::vector<std::complex<double>> RealAndImaginary::values() const
{
  std::vector<std::complex<double>> result(real.locally_owned_size());
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = {real.begin()[i], imaginary.begin()[i]};
  return result;
}

std::vector<std::pair<unsigned int, double>> entries_not_zero(const DistributedVector &vector)
{
  std::vector<std::pair<unsigned int, double>> entries;
  for (unsigned int i = 0; i < vector.locally_owned_size(); ++i)
    if (vector.begin()[i] != 0.)
      entries.emplace_back(i, vector.begin()[i]);
  return entries;
}

namespace
{
/// to += factor A from, with a real A.
template <typename Multiply>
void add_product(const std::complex<double> factor,
                 const Multiply &multiply,
                 const RealAndImaginary &from,
                 RealAndImaginary &to,
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
}
} // namespace

template <int dim>
HarmonicEquations<dim>::HarmonicEquations(const Space<dim> &space,
                                          const Problem &problem,
                                          const std::vector<RegionOperators> &operators,
                                          const BoundaryConstraints<dim> &constraints,
                                          const Loads<dim> &loads,
                                          const LinearProducts<dim> &products,
                                          const HarmonicPorts &ports,
                                          LoadedBody<dim> *const loaded)
    : space(space),
      problem(problem),
      operators(operators),
      constraints(constraints),
      products(products),
      ports(ports),
      load_list(loads),
      loaded(loaded),
      velocity_work(space.velocity_vector()),
      pressure_work(space.pressure_vector())
{
  for (const unsigned int condition : ports.conditions())
    port_flows.push_back(entries_not_zero(flow_of_velocities(condition)));
  DistributedVector one = space.pressure_vector();
  one = 1.;
  for (unsigned int region = 0; region < operators.size(); ++region)
  {
    // Within the body a uniform pressure pushes nothing; what is left is at its surface.
    products.multiply_gradient(region, velocity_work, one);
    largest_area = std::max(largest_area, velocity_work.linfty_norm());
  }
}

template <int dim>
DistributedVector HarmonicEquations<dim>::flow_of_velocities(const unsigned int condition) const
{
  return loaded != nullptr ? loaded->flow_of_velocities(condition)
                           : load_list.flow_of_velocities(condition);
}

template <int dim>
HarmonicCoefficients HarmonicEquations<dim>::coefficients(const Complex s) const
{
  if (loaded != nullptr)
    return loaded->coefficients(s);
  return harmonic_coefficients(problem.materials, s);
}

template <int dim>
void HarmonicEquations<dim>::apply(const HarmonicCoefficients &at_s,
                                   const std::vector<Complex> &displacement,
                                   const std::vector<Complex> &pressure,
                                   std::vector<Complex> &forces,
                                   std::vector<Complex> &dilatations)
{
  RealAndImaginary u(space.velocity_vector()), f = u;
  u.set(displacement);
  if (loaded != nullptr)
  {
    loaded->apply(at_s, displacement, pressure, forces, dilatations);
    f.set(forces);
    add_supports(at_s, u, f);
    forces = f.values();
    return;
  }
  RealAndImaginary p(space.pressure_vector()), h = p;
  p.set(pressure);
  using Vector = DistributedVector;
  for (unsigned int r = 0; r < operators.size(); ++r)
  {
    add_product(
        at_s.mass[r], [&](Vector &y, const Vector &x) { products.multiply_mass(r, y, x); }, u, f,
        velocity_work);
    add_product(
        at_s.stiffness[r],
        [&](Vector &y, const Vector &x) { products.multiply_stiffness(r, y, x); }, u, f,
        velocity_work);
    add_product(
        1., [&](Vector &y, const Vector &x) { products.multiply_gradient(r, y, x); }, p, f,
        velocity_work);
    add_product(
        -1., [&](Vector &y, const Vector &x) { products.multiply_divergence(r, y, x); }, u, h,
        pressure_work);
    add_product(
        -at_s.compressibility[r],
        [&](Vector &y, const Vector &x) { products.multiply_pressure_mass(r, y, x); }, p, h,
        pressure_work);
  }
  add_supports(at_s, u, f);
  forces = f.values();
  dilatations = h.values();
}

template <int dim>
void HarmonicEquations<dim>::add_supports(const HarmonicCoefficients &at_s,
                                          const RealAndImaginary &u,
                                          RealAndImaginary &f)
{
  using Vector = DistributedVector;
  for (unsigned int r = 0; r < operators.size(); ++r)
  {
    if (!operators[r].is_supported)
      continue;
    add_product(
        at_s.support_stiffness,
        [&](Vector &y, const Vector &x) { products.multiply_support_stiffness(r, y, x); }, u, f,
        velocity_work);
    add_product(
        at_s.support_damping,
        [&](Vector &y, const Vector &x) { products.multiply_support_damping(r, y, x); }, u, f,
        velocity_work);
  }
}

template <int dim>
void HarmonicEquations<dim>::multiply(const Complex s,
                                      const HarmonicSolution &solution,
                                      std::vector<Complex> &forces,
                                      std::vector<Complex> &dilatations)
{
  apply(coefficients(s), solution.displacement, solution.pressure, forces, dilatations);
  const FullMatrix<Complex> impedance = ports.impedances(s);
  for (unsigned int i = 0; i < ports.size(); ++i)
  {
    Complex pressure = ports.is_free_flow(i) ? solution.port_pressures[i] : Complex(0.);
    for (unsigned int j = 0; j < ports.size(); ++j)
      if (impedance(i, j) != 0.)
        pressure += impedance(i, j) * flow_of_port(j, solution.displacement, s);
    add_port(i, pressure, forces);
  }
  restrict_rows(forces, dilatations);
}

template <int dim>
void HarmonicEquations<dim>::restrict_rows(std::vector<Complex> &forces,
                                           std::vector<Complex> &dilatations) const
{
  RealAndImaginary f(space.velocity_vector());
  f.set(forces);
  constraints.restrict_to_free(f.real);
  constraints.restrict_to_free(f.imaginary);
  forces = f.values();
  RealAndImaginary h(space.pressure_vector());
  h.set(dilatations);
  space.set_hanging_pressures_to_zero(h.real);
  space.set_hanging_pressures_to_zero(h.imaginary);
  dilatations = h.values();
}

template <int dim>
void HarmonicEquations<dim>::expand(std::vector<Complex> &displacement) const
{
  RealAndImaginary u(space.velocity_vector());
  u.set(displacement);
  constraints.expand_free(u.real);
  constraints.expand_free(u.imaginary);
  displacement = u.values();
}

template <int dim>
void HarmonicEquations<dim>::add_port(const unsigned int port,
                                      const Complex pressure,
                                      std::vector<Complex> &forces) const
{
  for (const auto &[index, value] : port_flows[port])
    forces[index] += value * pressure;
}

template <int dim>
std::complex<double> HarmonicEquations<dim>::flow_of_port(const unsigned int port,
                                                          const std::vector<Complex> &displacement,
                                                          const Complex s) const
{
  Complex of_rank = 0.;
  for (const auto &[index, value] : port_flows[port])
    of_rank += value * displacement[index];
  return s * sum(of_rank);
}

template <int dim>
double HarmonicEquations<dim>::size_of_flow(const unsigned int port,
                                            const std::vector<Complex> &displacement,
                                            const Complex s) const
{
  double size = 0.;
  for (const auto &[index, value] : port_flows[port])
    size += std::abs(value * displacement[index]);
  return std::abs(s) * sum(size).real();
}

template <int dim>
std::complex<double> HarmonicEquations<dim>::sum(const Complex of_rank) const
{
  double parts[2] = {of_rank.real(), of_rank.imag()};
  MPI_Allreduce(MPI_IN_PLACE, parts, 2, MPI_DOUBLE, MPI_SUM, space.communicator);
  return {parts[0], parts[1]};
}

template <int dim>
double HarmonicEquations<dim>::size_of(const std::vector<Complex> &values) const
{
  return size_of(values, 0, values.size());
}

template <int dim>
double HarmonicEquations<dim>::size_of(const std::vector<Complex> &values,
                                       const std::size_t begin,
                                       const std::size_t end) const
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
  return Utilities::MPI::max(largest, space.communicator);
}

template class HarmonicEquations<2>;
template class HarmonicEquations<3>;
} // namespace Continua
