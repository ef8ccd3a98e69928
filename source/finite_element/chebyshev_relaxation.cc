#include <continua/finite_element/chebyshev_relaxation.h>

#include <algorithm>
#include <cmath>

namespace Continua
{
using namespace dealii;

namespace
{
constexpr unsigned int polynomial_degree = 2;
/// Of the largest to the smallest eigenvalue that are damped.
constexpr double eigenvalue_ratio = 8.;
constexpr unsigned int n_power_steps = 25;
/// Power steps approach the largest eigenvalue from below.
constexpr double eigenvalue_margin = 1.15;
} // namespace

template <int dim>
ChebyshevRelaxation<dim>::ChebyshevRelaxation(const Space<dim> &space,
                                              const BoundaryConstraints<dim> &constraints,
                                              const typename Product::Coefficients &coefficients,
                                              const std::vector<unsigned int> &fluid,
                                              const InstructionSet instruction_set)
    : a(make_matrix_free_product<dim, float>(
            instruction_set,
            {space.mapping, space.velocity_dofs, constraints.all(), space.is_axisymmetric()}),
        space.velocity_dofs.n_dofs())
{
  a.product->set(coefficients);
  a.product->initialise(source_entries);
  a.product->initialise(target_entries);
  a.product->find_diagonal(target_entries);
  auto diagonal = std::make_shared<DiagonalMatrix<Vector>>();
  Vector &inverse_diagonal = diagonal->get_vector();
  inverse_diagonal.reinit(target_entries);
  for (const unsigned int i : fluid)
    if (target_entries.local_element(i) > 0.f) // else constrained
      inverse_diagonal.local_element(i) = 1.f / target_entries.local_element(i);
  find_largest_eigenvalue(inverse_diagonal);

  typename Polynomial::AdditionalData data;
  data.degree = polynomial_degree;
  data.smoothing_range = eigenvalue_ratio;
  data.eig_cg_n_iterations = 0; // the eigenvalue is given
  data.max_eigenvalue = eigenvalue;
  data.preconditioner = diagonal;
  polynomial.initialize(a, data);
}

template <int dim>
void ChebyshevRelaxation<dim>::find_largest_eigenvalue(const Vector &inverse_diagonal)
{
  // Any start that is no eigenvector.
  const auto first = source_entries.locally_owned_elements().n_elements() > 0
                         ? source_entries.locally_owned_elements().nth_index_in_set(0)
                         : 0;
  for (unsigned int i = 0; i < source_entries.locally_owned_size(); ++i)
    source_entries.local_element(i) =
        inverse_diagonal.local_element(i) > 0.f ? std::sin(1.f + 2.f * ((first + i) % 1009)) : 0.f;
  float norm = source_entries.l2_norm();
  for (unsigned int step = 0; step < n_power_steps && norm > 0.f; ++step)
  {
    source_entries *= 1.f / norm;
    a.vmult(target_entries, source_entries);
    source_entries = target_entries;
    source_entries.scale(inverse_diagonal);
    norm = source_entries.l2_norm();
    eigenvalue = eigenvalue_margin * norm;
  }
  // Without a velocity to relax the polynomial is never used on anything but zeros.
  if (!(eigenvalue > 0.))
    eigenvalue = 1.;
}

template <int dim>
void ChebyshevRelaxation<dim>::add_relaxed(DistributedVector &velocity,
                                           const DistributedVector &residual)
{
  for (unsigned int i = 0; i < residual.locally_owned_size(); ++i)
    source_entries.local_element(i) = static_cast<float>(residual.begin()[i]);
  polynomial.vmult(target_entries, source_entries);
  for (unsigned int i = 0; i < residual.locally_owned_size(); ++i)
    velocity.begin()[i] += target_entries.local_element(i);
}

template <int dim>
void ChebyshevRelaxation<dim>::leave_residual(DistributedVector &residual,
                                              const DistributedVector &velocity,
                                              const DistributedVector &source)
{
  for (unsigned int i = 0; i < velocity.locally_owned_size(); ++i)
    source_entries.local_element(i) = static_cast<float>(velocity.begin()[i]);
  a.vmult(target_entries, source_entries);
  for (unsigned int i = 0; i < residual.locally_owned_size(); ++i)
    residual.begin()[i] = source.begin()[i] - target_entries.local_element(i);
}

template class ChebyshevRelaxation<2>;
template class ChebyshevRelaxation<3>;
} // namespace Continua
