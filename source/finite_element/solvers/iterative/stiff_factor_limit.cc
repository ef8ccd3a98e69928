#include <continua/finite_element/solvers/iterative/stiff_factor_limit.h>

#include <continua/finite_element/solvers/block_factor_estimate.h>
#include <continua/linear_algebra/symmetric_factor.h>

#include <cmath>
#include <limits>

namespace Continua
{
template <int dim>
StiffFactorLimit<dim>::StiffFactorLimit(const Space<dim> &space,
                                        const BoundaryConstraints<dim> &constraints,
                                        const LinearSolverParameters &parameters)
    : space(space), constraints(constraints), parameters(parameters)
{
}

template <int dim>
double StiffFactorLimit<dim>::n_unknowns() const
{
  return static_cast<double>(space.velocity_dofs.n_dofs() + space.pressure_dofs.n_dofs());
}

template <int dim>
double StiffFactorLimit<dim>::most_bytes() const
{
  const double unlimited = std::numeric_limits<double>::infinity();
  if (parameters.stiff_block != StiffBlock::automatic)
    return parameters.stiff_block == StiffBlock::direct ? unlimited : 0.;
  const StiffBlockLimits &limits = parameters.stiff_block_limits;
  if (n_stiff <= (dim == 2 ? limits.small_in_plane : limits.small_in_space))
    return unlimited;
  const auto n_velocity = space.velocity_dofs.n_dofs();
  if (refused_bytes())
    return 0.;
  if (n_stiff > limits.largest || n_stiff > limits.largest_share * static_cast<double>(n_velocity))
    return 0.;
  return limits.bytes_per_unknown * n_unknowns();
}

template <int dim>
void StiffFactorLimit<dim>::refuse_large_factor(const VelocityBlocks &parts)
{
  if (!(parts.most_factor_bytes > 0.) || std::isinf(parts.most_factor_bytes) ||
      n_stiff == n_stiff_with_small_estimate)
    return;
  // An entry has at least the bytes of single precision.
  const double bytes = sizeof(float) * estimate_block_factor<dim>(space, constraints, parts.stiff);
  if (bytes > parts.most_factor_bytes)
    throw FactorTooLarge(bytes);
  n_stiff_with_small_estimate = n_stiff;
}

template <int dim>
void StiffFactorLimit<dim>::refuse(const double bytes)
{
  refused_factor = {n_stiff, bytes};
}

template <int dim>
std::optional<double> StiffFactorLimit<dim>::refused_bytes() const
{
  if (refused_factor && refused_factor->n_stiff == n_stiff)
    return refused_factor->bytes;
  return std::nullopt;
}

template <int dim>
double StiffFactorLimit<dim>::most_linear_bytes() const
{
  const StiffBlockLimits &limits = parameters.stiff_block_limits;
  const bool has_factor =
      n_stiff <= limits.largest_with_linear_factor && n_stiff != n_stiff_without_linear_factor;
  return has_factor ? limits.linear_bytes_per_unknown * n_unknowns() : 0.;
}

template class StiffFactorLimit<2>;
template class StiffFactorLimit<3>;
} // namespace Continua
