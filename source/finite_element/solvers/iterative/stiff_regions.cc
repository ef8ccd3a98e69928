#include <continua/finite_element/solvers/iterative/stiff_regions.h>

#include <continua/finite_element/solvers/interface_compliance.h>
#include <continua/finite_element/space/velocity_nodes.h>
#include <continua/linear_algebra/matrix_product.h>

#include <deal.II/base/mpi.h>

#include <algorithm>

namespace Continua
{
using namespace dealii;

template <int dim>
StiffRegions<dim>::StiffRegions(const Space<dim> &space,
                                const std::vector<RegionOperators> &operators,
                                const SystemCoefficients &coefficients)
    : space(space), operators(operators), coefficients(coefficients)
{
  for (const RegionOperators &region : operators)
  {
    mass_diagonals.push_back(region.mass_diagonal());
    stiffness_diagonals.push_back(region.stiffness_diagonal());
  }
  const unsigned int n_regions = operators.size();
  is_of_region.assign(n_regions, std::vector<bool>(space.velocity_owned.n_elements(), false));
  const std::vector<std::vector<unsigned int>> nodes = velocity_nodes(operators);
  for (unsigned int region = 0; region < n_regions; ++region)
    for (const unsigned int i : nodes[region])
      is_of_region[region][i] = true;
  std::vector<double> ratios(n_regions, 0.);
  for (unsigned int region = 0; region < n_regions; ++region)
    for (unsigned int i = 0; i < space.velocity_owned.n_elements(); ++i)
    {
      const auto global = space.velocity_owned.nth_index_in_set(i);
      if (space.velocity_hanging.is_constrained(global) || !is_of_region[region][i])
        continue;
      const double inertia = coefficients.mass[region] * mass_diagonals[region].begin()[i];
      const double stiffness =
          coefficients.stiffness[region] * stiffness_diagonals[region].begin()[i];
      ratios[region] = std::max(ratios[region], inertia > 0. ? stiffness / inertia : 1e300);
    }
  Utilities::MPI::max(ratios, space.communicator, ratios);
  const double largest =
      *std::max_element(coefficients.stiffness.begin(), coefficients.stiffness.end());
  is_stiff_region.resize(n_regions);
  for (unsigned int region = 0; region < n_regions; ++region)
    is_stiff_region[region] =
        ratios[region] > stiff_ratio && coefficients.stiffness[region] >= comparable * largest;
}

template <int dim>
VelocityBlocks StiffRegions<dim>::velocity_blocks(const VelocityOperator &velocity,
                                                  DistributedVector &mobility,
                                                  double &fluid_ratio) const
{
  VelocityBlocks result;
  result.n_components = dim;
  fluid_ratio = 0.;
  for (const unsigned int i : nodes_in_order(space.velocity_dofs))
  {
    const auto global = space.velocity_owned.nth_index_in_set(i);
    double inertia = 0., stiffness = 0.;
    bool is_stiff = false, is_soft = false;
    // A hanging node has no equation of its own.
    const bool is_hanging = space.velocity_hanging.is_constrained(global);
    if (!is_hanging)
      for (unsigned int region = 0; region < operators.size(); ++region)
        if (is_of_region[region][i])
        {
          inertia += coefficients.mass[region] * mass_diagonals[region].begin()[i];
          stiffness += coefficients.stiffness[region] * stiffness_diagonals[region].begin()[i];
          (is_stiff_region[region] ? is_stiff : is_soft) = true;
        }
    if (!is_hanging)
      (is_stiff ? result.stiff : result.fluid).push_back(i);
    if (!is_stiff && inertia > 0.)
      fluid_ratio = std::max(fluid_ratio, stiffness / inertia);
    // What a pressure moves. A soft region feels the interface as stiff as it is.
    const double resistance = is_stiff && is_soft ? velocity.diagonal().begin()[i] : inertia;
    mobility.begin()[i] = resistance > 0. ? 1. / resistance : 0.;
  }
  fluid_ratio = Utilities::MPI::max(fluid_ratio, space.communicator);
  return result;
}

template <int dim>
void StiffRegions<dim>::add_wall_compliance(const BoundaryConstraints<dim> &constraints,
                                            VelocityPreconditioner &velocity_inverse,
                                            DistributedVector &mobility) const
{
  DistributedVector load = space.velocity_vector(), of_region = load, inertia = load;
  DistributedVector one = space.pressure_vector(), volumes = one;
  one = 1.;
  double volume = 0.;
  for (unsigned int region = 0; region < operators.size(); ++region)
    if (!is_stiff_region[region])
    {
      multiply_transposed(operators[region].divergence, of_region, one);
      load.add(1., of_region);
      multiply(operators[region].pressure_mass, volumes, one);
      volume += volumes * one;
    }
  constraints.restrict_to_free(load);
  for (unsigned int i = 0; i < load.locally_owned_size(); ++i)
  {
    if (load.begin()[i] == 0.)
      continue;
    bool is_stiff = false, is_soft = false;
    for (unsigned int region = 0; region < operators.size(); ++region)
      if (is_of_region[region][i])
      {
        inertia.begin()[i] += coefficients.mass[region] * mass_diagonals[region].begin()[i];
        (is_stiff_region[region] ? is_stiff : is_soft) = true;
      }
    if (!is_stiff || !is_soft)
      load.begin()[i] = 0.;
  }
  if (load.linfty_norm() == 0.)
    return;
  const DistributedVector compliance =
      interface_compliance<dim>(space, nodes_in_order(space.velocity_dofs), load, volume,
                                [&](DistributedVector &velocity, const DistributedVector &force)
                                { velocity_inverse.solve_stiff(velocity, force); });
  // A wall that nothing holds moves without bound, or as fast as its inertia lets it.
  for (unsigned int i = 0; i < load.locally_owned_size(); ++i)
    if (compliance.begin()[i] > mobility.begin()[i] && inertia.begin()[i] > 0.)
      mobility.begin()[i] = std::min(compliance.begin()[i], 1. / inertia.begin()[i]);
}

template <int dim>
std::vector<unsigned int> StiffRegions<dim>::pressures() const
{
  std::vector<bool> is_stiff(space.pressure_owned.n_elements(), false);
  const std::vector<std::vector<unsigned int>> nodes = pressure_nodes(operators);
  // The others take back what a continuous pressure shares with them.
  for (const bool of_stiff : {true, false})
    for (unsigned int region = 0; region < operators.size(); ++region)
      if (is_stiff_region[region] == of_stiff)
        for (const unsigned int i : nodes[region])
          is_stiff[i] = of_stiff;
  std::vector<unsigned int> result;
  for (unsigned int i = 0; i < is_stiff.size(); ++i)
    if (is_stiff[i] &&
        !space.pressure_hanging.is_constrained(space.pressure_owned.nth_index_in_set(i)))
      result.push_back(i);
  return result;
}

template class StiffRegions<2>;
template class StiffRegions<3>;
} // namespace Continua
