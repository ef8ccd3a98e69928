#include <continua/finite_element/power_ledger.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <numeric>

namespace Continua
{
using namespace dealii;

namespace
{
/// This rank's part of a scalar product.
double local_product(const DistributedVector &a, const DistributedVector &b)
{
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.);
}
} // namespace

template <int dim>
PowerLedger<dim>::PowerLedger(const Space<dim> &space,
                              const Problem &problem,
                              const std::vector<RegionOperators> &operators,
                              const BoundaryConstraints<dim> &constraints,
                              const Loads<dim> &loads,
                              const OutletCoupling<dim> &outlets)
    : space(space),
      problem(problem),
      operators(operators),
      constraints(constraints),
      loads(loads),
      outlets(outlets)
{
}

template <int dim>
void PowerLedger<dim>::reinit()
{
  nodal_forces = space.velocity_vector();
  for (DistributedVector *vector : {&velocity_work, &mixture, &forgotten})
    vector->reinit(nodal_forces);
  pressure_work = space.pressure_vector();
  for (DistributedVector *vector : {&dilatation, &forgotten_rate})
    vector->reinit(pressure_work);
}

template <int dim>
double PowerLedger<dim>::relaxation_power(const unsigned int region,
                                          const BalancedStep &step,
                                          const BranchHistory &history,
                                          const BulkHistory &bulk_history)
{
  const Material &material = problem.materials[region];
  double sum = 0.;
  for (const Branch &branch : material.shear.branches)
    if (!std::isinf(branch.relaxation_time))
    {
      history.balanced_displacement(branch.relaxation_time, step.step, mixture);
      history.forgotten_velocity(branch.relaxation_time, step.step, step.velocity, forgotten);
      multiply(operators[region].stiffness, velocity_work, mixture);
      sum += branch.shear_modulus * local_product(velocity_work, forgotten);
    }
  for (unsigned int k = 0; k < material.compression.bulk_branches().size(); ++k)
    if (!std::isinf(material.compression.bulk_branches()[k].relaxation_time))
    {
      bulk_history.balanced_dilatation(region, k, step.step, dilatation);
      bulk_history.forgotten_rate(region, k, step.step, forgotten_rate);
      multiply(operators[region].pressure_mass, pressure_work, dilatation);
      sum += material.compression.bulk_branches()[k].bulk_modulus *
             local_product(pressure_work, forgotten_rate);
    }
  return sum;
}

template <int dim>
PowerBalance PowerLedger<dim>::balance(const BalancedStep &step,
                                       const BranchHistory &history,
                                       const BulkHistory &bulk_history,
                                       const bool relaxation)
{
  PowerBalance balance;
  balance.time = step.step.balance_time;
  balance.materials.resize(operators.size());
  // Numbers of this rank; all are summed over the ranks at once.
  std::vector<double> sums;
  sums.reserve(2 + 5 * operators.size());

  // What the equations leave at the nodes - inertia + inner forces - loads - is the force that
  // moves those of prescribed velocity; without such nodes nobody asks for it.
  const bool reactions = !constraints.is_homogeneous();
  nodal_forces = 0.;
  loads.add(step.step.balance_time, nodal_forces);
  sums.push_back(local_product(nodal_forces, step.velocity));
  if (reactions)
  {
    outlets.add_forces(1., nodal_forces);
    nodal_forces *= -1.;
  }
  for (unsigned int region = 0; region < operators.size(); ++region)
  {
    const Material &material = problem.materials[region];
    // The power of the nodal forces in velocity_work.
    const auto add_power = [&](const double factor)
    {
      sums.push_back(factor * local_product(velocity_work, step.velocity));
      if (reactions)
        nodal_forces.add(factor, velocity_work);
    };
    multiply(operators[region].mass, velocity_work, step.acceleration);
    add_power(material.density);
    if (history.mix_balanced(region, step.step, mixture))
    {
      multiply(operators[region].stiffness, velocity_work, mixture);
      add_power(1.);
    }
    else
      sums.push_back(0.);
    if (material.shear.viscosity != 0.)
    {
      multiply(operators[region].stiffness, velocity_work, step.velocity);
      add_power(material.shear.viscosity);
    }
    else
      sums.push_back(0.);
    if (reactions)
    {
      multiply_transposed(operators[region].divergence, velocity_work, step.pressure);
      add_power(-1.);
    }
    else
    {
      multiply(operators[region].divergence, pressure_work, step.velocity);
      sums.push_back(-local_product(pressure_work, step.pressure));
    }
    sums.push_back(relaxation ? relaxation_power(region, step, history, bulk_history) : 0.);
  }
  sums.push_back(reactions ? local_product(nodal_forces, step.prescribed) : 0.);
  Utilities::MPI::sum(sums, space.communicator, sums);

  balance.external = sums.front() + sums.back();
  balance.residual = balance.external;
  balance.exchanged = std::abs(balance.external);
  for (unsigned int region = 0; region < operators.size(); ++region)
  {
    const double *const of_region = &sums[1 + 5 * region];
    Power &power = balance.materials[region];
    power.kinetic = of_region[0];
    power.strain = of_region[1];
    power.viscous = of_region[2];
    power.compressive = of_region[3];
    power.relaxation = of_region[4];
    balance.residual -= balance.materials[region].sum();
    for (unsigned int i = 0; i < 4; ++i)
      balance.exchanged += std::abs(of_region[i]);
  }
  outlets.power(balance.outlets);
  for (const OutletPower &power : balance.outlets)
  {
    balance.residual -= power.leaving;
    balance.exchanged += std::abs(power.leaving);
  }
  return balance;
}

template <int dim>
Energy PowerLedger<dim>::energy(const State &state, const BulkHistory &bulk_history)
{
  const unsigned int n_regions = operators.size();
  std::vector<double> sums(1 + 2 * n_regions, 0.);
  for (unsigned int region = 0; region < n_regions; ++region)
  {
    const Material &material = problem.materials[region];
    multiply(operators[region].mass, velocity_work, state.velocity);
    sums[0] += 0.5 * material.density * local_product(velocity_work, state.velocity);
    double &strain = sums[1 + region], &compressive = sums[1 + n_regions + region];
    for (const Branch &branch : material.shear.branches)
    {
      const DistributedVector &internal =
          state.history.internal_displacement(branch.relaxation_time);
      multiply(operators[region].stiffness, velocity_work, internal);
      strain += 0.5 * branch.shear_modulus * local_product(velocity_work, internal);
    }
    for (unsigned int k = 0; k < material.compression.bulk_branches().size(); ++k)
    {
      const DistributedVector &internal = bulk_history.internal_dilatation(region, k);
      multiply(operators[region].pressure_mass, pressure_work, internal);
      compressive += 0.5 * material.compression.bulk_branches()[k].bulk_modulus *
                     local_product(pressure_work, internal);
    }
    if (material.compression.bulk_branches().empty())
    {
      multiply(operators[region].pressure_mass, pressure_work, state.pressure);
      compressive +=
          0.5 * material.inverse_bulk_modulus() * local_product(pressure_work, state.pressure);
    }
  }
  Utilities::MPI::sum(sums, space.communicator, sums);
  Energy energy;
  energy.outlets = outlets.energy();
  energy.kinetic = sums[0];
  energy.strain_of_materials.assign(sums.begin() + 1, sums.begin() + 1 + n_regions);
  energy.compressive_of_materials.assign(sums.begin() + 1 + n_regions, sums.end());
  for (unsigned int region = 0; region < n_regions; ++region)
  {
    energy.strain += energy.strain_of_materials[region];
    energy.compressive += energy.compressive_of_materials[region];
  }
  return energy;
}

template class PowerLedger<2>;
template class PowerLedger<3>;
} // namespace Continua
