#include <continua/finite_element/solvers/harmonic_ports.h>

#include <continua/linear_algebra/singular_matrix.h>

#include <deal.II/lac/lapack_full_matrix.h>

#include <cmath>

namespace Continua
{
using namespace dealii;

namespace
{
/// Overwrites a small matrix by its inverse; returns the logarithm of its determinant.
std::complex<double> invert(FullMatrix<std::complex<double>> &matrix)
{
  const unsigned int n = matrix.m();
  if (n == 0)
    return 0.;
  LAPACKFullMatrix<std::complex<double>> factor(n, n);
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
      factor.set(i, j, matrix(i, j));
  try
  {
    factor.compute_lu_factorization();
    const std::complex<double> logarithm = std::log(factor.determinant());
    factor.invert();
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        matrix(i, j) = factor(i, j);
    return logarithm;
  }
  catch (const LACExceptions::ExcSingular &)
  {
    throw SingularMatrix("the ends of the body determine no pressure at this frequency.");
  }
}
} // namespace

HarmonicPorts::HarmonicPorts(const Problem &problem) : problem(problem)
{
  for (const Outlet &outlet : problem.outlets)
    of_ports.insert(of_ports.end(), outlet.conditions.begin(), outlet.conditions.end());
  n_of_outlets = of_ports.size();
  for (unsigned int c = 0; c < problem.conditions.size(); ++c)
    if (problem.conditions[c].free_flow)
      of_ports.push_back(c);
}

FullMatrix<std::complex<double>> HarmonicPorts::impedances(const Complex s) const
{
  FullMatrix<Complex> result(size(), size());
  unsigned int first = 0;
  for (const Outlet &outlet : problem.outlets)
  {
    const FullMatrix<Complex> of_outlet = outlet.impedance_at(s);
    for (unsigned int i = 0; i < of_outlet.m(); ++i)
      for (unsigned int j = 0; j < of_outlet.n(); ++j)
        result(first + i, first + j) = of_outlet(i, j);
    first += of_outlet.m();
  }
  return result;
}

void HarmonicPorts::set_responses(const Complex s, const FullMatrix<Complex> &responses)
{
  const unsigned int n = size();
  impedance = impedances(s);
  inverse.reinit(n, n);
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
    {
      inverse(i, j) = i == j ? 1. : 0.;
      for (unsigned int k = 0; k < n; ++k)
        inverse(i, j) -= impedance(i, k) * responses(k, j);
      if (is_free_flow(i))
        inverse(i, j) = responses(i, j);
    }
  logarithm = invert(inverse);
  // A row of a free flow rate is that of the displacements, whose response is H over s.
  for (unsigned int i = 0; i < n; ++i)
    if (is_free_flow(i))
      logarithm -= std::log(s);
}

std::vector<std::complex<double>> HarmonicPorts::pressures(const std::vector<Complex> &flow_rates,
                                                           const std::vector<Complex> &given) const
{
  const unsigned int n = size();
  std::vector<Complex> right(n), result(n);
  for (unsigned int i = 0; i < n; ++i)
  {
    const Complex of_load = given.empty() ? 0. : given[i];
    right[i] = is_free_flow(i) ? -of_load - flow_rates[i] : of_load;
    for (unsigned int j = 0; j < n && !is_free_flow(i); ++j)
      right[i] += impedance(i, j) * flow_rates[j];
  }
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
      result[i] += inverse(i, j) * right[j];
  return result;
}
} // namespace Continua
