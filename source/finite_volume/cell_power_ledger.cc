#include <continua/finite_volume/cell_power_ledger.h>

#include <continua/linear_algebra/matrix_product.h>

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

/// The same with a weight.
double weighted_product(const DistributedVector &weight,
                        const DistributedVector &a,
                        const DistributedVector &b)
{
  double sum = 0.;
  for (unsigned int i = 0; i < weight.locally_owned_size(); ++i)
    sum += weight.begin()[i] * a.begin()[i] * b.begin()[i];
  return sum;
}
} // namespace

template <int dim>
CellPowerLedger<dim>::CellPowerLedger(const CellSpace<dim> &space,
                                      const Problem &problem,
                                      const CellWiseParameters &parameters,
                                      const FaceConditions<dim> &conditions,
                                      const CellLoads<dim> &loads,
                                      const std::vector<CellOperators> &operators)
    : space(space),
      problem(problem),
      parameters(parameters),
      conditions(conditions),
      loads(loads),
      operators(operators)
{
}

template <int dim>
void CellPowerLedger<dim>::reinit()
{
  forces = space.velocity_vector();
  for (DistributedVector *vector : {&velocity_work, &mixture, &other})
    vector->reinit(forces);
  pressure_work = space.pressure_vector();
  dilatation.reinit(pressure_work);
}

template <int dim>
double CellPowerLedger<dim>::pressure_product(const DistributedVector &p,
                                              const DistributedVector &weight,
                                              const DistributedVector &q) const
{
  // Faces have equations of state, but no volume.
  double sum = 0.;
  for (unsigned int i = 0; i < space.mesh.n_owned_cells(); ++i)
    sum += p.begin()[i] * weight.begin()[i] * q.begin()[i];
  return sum;
}

template <int dim>
void CellPowerLedger<dim>::set_stress_forces(const unsigned int region,
                                             const BalancedCells &step,
                                             const BranchHistory &history)
{
  const CellOperators &of_region = operators[region];
  velocity_work = 0.;
  if (!history.mix_balanced(region, step.step, mixture))
    return;
  if (parameters.power_operator == PowerOperator::wide)
    multiply(of_region.wide_stiffness, velocity_work, mixture);
  else if (parameters.power_operator == PowerOperator::scheme &&
           parameters.accumulated_term == AccumulatedTerm::inconsistent)
  {
    const double own = BranchHistory::step_stiffness(problem.materials[region], step.step);
    mixture.add(-own, step.velocity);
    multiply(of_region.stiffness, velocity_work, step.velocity);
    velocity_work *= own;
    multiply(of_region.wide_stiffness, other, mixture);
    velocity_work.add(1., other);
  }
  else
    multiply(of_region.stiffness, velocity_work, mixture);
}

template <int dim>
double CellPowerLedger<dim>::relaxation_power(const unsigned int region,
                                              const BalancedCells &step,
                                              const BranchHistory &history,
                                              const BulkHistory &bulk_history)
{
  const Material &material = problem.materials[region];
  double sum = 0.;
  for (const Branch &branch : material.shear.branches)
    if (!std::isinf(branch.relaxation_time))
    {
      history.balanced_displacement(branch.relaxation_time, step.step, mixture);
      history.forgotten_velocity(branch.relaxation_time, step.step, step.velocity, other);
      multiply(operators[region].stiffness, velocity_work, mixture);
      sum += branch.shear_modulus * local_product(velocity_work, other);
    }
  for (unsigned int k = 0; k < material.compression.bulk_branches().size(); ++k)
    if (!std::isinf(material.compression.bulk_branches()[k].relaxation_time))
    {
      bulk_history.balanced_dilatation(region, k, step.step, dilatation);
      bulk_history.forgotten_rate(region, k, step.step, pressure_work);
      sum += material.compression.bulk_branches()[k].bulk_modulus *
             pressure_product(dilatation, operators[region].pressure_volume, pressure_work);
    }
  return sum;
}

template <int dim>
PowerBalance CellPowerLedger<dim>::balance(const BalancedCells &step,
                                           const DistributedVector &start,
                                           const DistributedVector &end,
                                           const BranchHistory &history,
                                           const BulkHistory &bulk_history,
                                           const bool relaxation)
{
  PowerBalance balance;
  balance.time = step.step.balance_time;
  balance.materials.resize(operators.size());
  // Numbers of this rank; all are summed over the ranks at once.
  std::vector<double> sums;
  forces = 0.;
  loads.add(step.step.balance_time, forces);
  sums.push_back(local_product(forces, step.velocity));
  // What the equations leave at faces of prescribed velocity is the force that moves them.
  forces *= -1.;
  for (unsigned int region = 0; region < operators.size(); ++region)
  {
    const Material &material = problem.materials[region];
    const CellOperators &of_region = operators[region];
    if (parameters.power_operator == PowerOperator::scheme)
      sums.push_back(material.density *
                     weighted_product(of_region.volume, step.acceleration, step.velocity));
    else
      sums.push_back(0.5 * material.density / step.step.size() *
                     (weighted_product(of_region.volume, end, end) -
                      weighted_product(of_region.volume, start, start)));
    set_stress_forces(region, step, history);
    sums.push_back(local_product(velocity_work, step.velocity));
    forces.add(1., velocity_work);
    if (material.shear.viscosity != 0.)
    {
      multiply(of_region.stiffness, velocity_work, step.velocity);
      sums.push_back(material.shear.viscosity * local_product(velocity_work, step.velocity));
      forces.add(material.shear.viscosity, velocity_work);
    }
    else
      sums.push_back(0.);
    // In the forms without a pressure the stress has all of it.
    if (parameters.has_pressure())
    {
      multiply(of_region.gradient, velocity_work, step.pressure);
      sums.push_back(local_product(velocity_work, step.velocity));
      forces.add(1., velocity_work);
    }
    else
      sums.push_back(0.);
    sums.push_back(relaxation ? relaxation_power(region, step, history, bulk_history) : 0.);
  }
  sums.push_back(local_product(forces, step.prescribed));
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
    balance.residual -= power.sum();
    for (unsigned int i = 0; i < 4; ++i)
      balance.exchanged += std::abs(of_region[i]);
  }
  return balance;
}

template <int dim>
Energy CellPowerLedger<dim>::energy(const State &state, const BulkHistory &bulk_history)
{
  const unsigned int n_regions = operators.size();
  std::vector<double> sums(1 + 2 * n_regions, 0.);
  for (unsigned int region = 0; region < n_regions; ++region)
  {
    const Material &material = problem.materials[region];
    const CellOperators &of_region = operators[region];
    sums[0] +=
        0.5 * material.density * weighted_product(of_region.volume, state.velocity, state.velocity);
    double &strain = sums[1 + region], &compressive = sums[1 + n_regions + region];
    for (const Branch &branch : material.shear.branches)
    {
      const DistributedVector &internal =
          state.history.internal_displacement(branch.relaxation_time);
      multiply(of_region.stiffness, velocity_work, internal);
      strain += 0.5 * branch.shear_modulus * local_product(velocity_work, internal);
    }
    for (unsigned int k = 0; k < material.compression.bulk_branches().size(); ++k)
    {
      const DistributedVector &internal = bulk_history.internal_dilatation(region, k);
      compressive += 0.5 * material.compression.bulk_branches()[k].bulk_modulus *
                     pressure_product(internal, of_region.pressure_volume, internal);
    }
    if (material.compression.bulk_branches().empty() && parameters.has_pressure())
      compressive += 0.5 * material.inverse_bulk_modulus() *
                     pressure_product(state.pressure, of_region.pressure_volume, state.pressure);
  }
  Utilities::MPI::sum(sums, space.communicator, sums);
  Energy energy;
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

template class CellPowerLedger<2>;
template class CellPowerLedger<3>;
} // namespace Continua
