#include <continua/finite_element/outlet_coupling.h>

#include <continua/base/input_error.h>
#include <continua/finite_element/flow_shapes.h>
#include <continua/signal/jump.h>

#include <deal.II/base/mpi.h>

#include <limits>

namespace Continua
{
using namespace dealii;

namespace
{
const double origin[3] = {0., 0., 0.};

double relaxation_time(const Impedance::Term &term)
{
  return term.rate > 0. ? 1. / term.rate : std::numeric_limits<double>::infinity();
}
} // namespace

template <int dim>
OutletCoupling<dim>::OutletCoupling(const Space<dim> &space,
                                    const Problem &problem,
                                    const Loads<dim> &loads,
                                    const BoundaryConstraints<dim> &constraints)
    : space(space), problem(problem), loads(loads), constraints(constraints)
{
}

template <int dim>
void OutletCoupling<dim>::initialise()
{
  states.clear();
  for (const Outlet &outlet : problem.outlets)
  {
    const Vector<double> zero(outlet.impedance.n_ports());
    states.emplace_back(outlet.impedance.terms.size(), State{zero, zero, zero, zero});
    for (unsigned int k = 0; k < outlet.initial_states.size(); ++k)
    {
      State &state = states.back()[k];
      state.present[0] = outlet.initial_states[k];
      state.older = state.balanced = state.present;
    }
  }
}

template <int dim>
typename OutletCoupling<dim>::Sparse OutletCoupling<dim>::sparse(const DistributedVector &vector)
{
  Sparse entries;
  const double *const values = vector.begin();
  for (unsigned int i = 0; i < vector.locally_owned_size(); ++i)
    if (values[i] != 0.)
      entries.emplace_back(i, values[i]);
  return entries;
}

template <int dim>
double OutletCoupling<dim>::product(const Sparse &sparse, const DistributedVector &vector)
{
  const double *const values = vector.begin();
  double sum = 0.;
  for (const auto &[index, value] : sparse)
    sum += value * values[index];
  return sum;
}

template <int dim>
void OutletCoupling<dim>::build()
{
  ports.clear();
  first_port.clear();
  for (unsigned int o = 0; o < problem.outlets.size(); ++o)
  {
    first_port.push_back(ports.size());
    for (const unsigned int c : problem.outlets[o].conditions)
    {
      ports.emplace_back();
      Port &port = ports.back();
      port.outlet = o;
      const DistributedVector flow = loads.flow_of_velocities(c);
      port.flow = sparse(flow);
      const BoundaryCondition &condition = problem.conditions[c];
      port.holds_flow = condition.normal.flow != nullptr;
      if (port.holds_flow)
      {
        // The profile has a mean of 1 along x; a flow of 1 is wanted, out of the body.
        DistributedVector profile = space.velocity_vector();
        for (const auto &[dof, shape] : nodal_flow_shapes(space, condition))
          profile[dof] = shape.front();
        profile.compress(VectorOperation::insert);
        profile *= 1. / (flow * profile);
        port.velocity = sparse(profile);
      }
      port.velocity_response = space.velocity_vector();
      port.pressure_response = space.pressure_vector();
    }
  }
  const unsigned int n = ports.size();
  responses.reinit(n, n);
  impedances.reinit(n, n);
  inputs_of_rhs.reinit(n, n);
  for (Vector<double> *vector : {&outputs, &rhs, &inputs, &predicted})
    vector->reinit(n);
  sums.resize(2 * ports.size());
  coefficients.clear();
  for (const Outlet &outlet : problem.outlets)
    coefficients.insert(coefficients.end(), outlet.impedance.terms.size(), 0.);
  impedances_are_set = false;
}

template <int dim>
double OutletCoupling<dim>::output(const Port &port,
                                   const DistributedVector &velocity,
                                   const DistributedVector &pressure) const
{
  return port.holds_flow ? product(port.mass_of_velocity, pressure) -
                               product(port.momentum_of_velocity, velocity)
                         : product(port.flow, velocity);
}

template <int dim>
void OutletCoupling<dim>::respond(StepSystem<dim> &system)
{
  if (is_empty())
    return;
  DistributedVector momentum = space.velocity_vector(), prescribed = momentum;
  DistributedVector mass = space.pressure_vector();
  for (Port &port : ports)
  {
    momentum = 0.;
    mass = 0.;
    prescribed = 0.;
    if (port.holds_flow)
    {
      for (const auto &[index, value] : port.velocity)
        prescribed.begin()[index] = value;
      system.add_velocity_product(prescribed, momentum);
      port.momentum_of_velocity = sparse(momentum);
      momentum *= -1.;
      system.add_divergence(1., prescribed, mass);
      port.mass_of_velocity = sparse(mass);
    }
    else
      for (const auto &[index, value] : port.flow)
        momentum.begin()[index] = -value;
    constraints.restrict_to_free(momentum);
    system.solve(momentum, mass, port.velocity_response, port.pressure_response);
    constraints.set_constrained(port.velocity_response, prescribed);
  }
  std::vector<double> entries;
  for (const Port &row : ports)
    for (const Port &column : ports)
      entries.push_back(output(row, column.velocity_response, column.pressure_response));
  Utilities::MPI::sum(entries, space.communicator, entries);
  responses.fill(entries.data());
  impedances_are_set = false;
}

template <int dim>
void OutletCoupling<dim>::leave_out_ports(DistributedVector &prescribed) const
{
  for (const Port &port : ports)
    for (const auto &entry : port.velocity)
      prescribed.begin()[entry.first] = 0.;
}

template <int dim>
void OutletCoupling<dim>::take_forces(const DistributedVector &momentum)
{
  for (Port &port : ports)
    port.force = product(port.velocity, momentum);
}

template <int dim>
void OutletCoupling<dim>::set_impedances()
{
  if (impedances_are_set && present_coefficients == coefficients)
    return;
  present_coefficients = coefficients;
  impedances_are_set = true;
  impedances = 0.;
  auto coefficient = coefficients.begin();
  for (unsigned int o = 0; o < problem.outlets.size(); ++o)
  {
    const Impedance &impedance = problem.outlets[o].impedance;
    const unsigned int first = first_port[o];
    impedances.add(impedance.direct, 1., first, first);
    for (const Impedance::Term &term : impedance.terms)
      impedances.add(term.residue, *coefficient++, first, first);
  }
  const unsigned int n = ports.size();
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
    {
      double sum = i == j && !ports[i].holds_flow ? 1. : 0.;
      if (ports[i].holds_flow)
        sum += responses(i, j);
      if (ports[j].holds_flow)
        sum -= impedances(i, j);
      for (unsigned int l = 0; l < n; ++l)
        if (!ports[l].holds_flow)
          sum -= impedances(i, l) * responses(l, j);
      inputs_of_rhs(i, j) = sum;
    }
  inputs_of_rhs.gauss_jordan();
}

template <int dim>
void OutletCoupling<dim>::add_responses(DistributedVector &velocity, DistributedVector &pressure)
{
  const unsigned int n = ports.size();
  for (unsigned int i = 0; i < n; ++i)
  {
    rhs[i] = predicted[i] - (ports[i].holds_flow ? outputs[i] : 0.);
    for (unsigned int j = 0; j < n; ++j)
      if (!ports[j].holds_flow)
        rhs[i] += impedances(i, j) * outputs[j];
  }
  inputs_of_rhs.vmult(inputs, rhs);
  responses.vmult_add(outputs, inputs);
  for (unsigned int i = 0; i < n; ++i)
  {
    ports[i].pressure = ports[i].holds_flow ? outputs[i] : inputs[i];
    ports[i].flow_rate = ports[i].holds_flow ? inputs[i] : outputs[i];
    velocity.add(inputs[i], ports[i].velocity_response);
    pressure.add(inputs[i], ports[i].pressure_response);
  }
}

template <int dim>
void OutletCoupling<dim>::couple(const Step &step,
                                 const DistributedVector &velocity_old,
                                 DistributedVector &velocity,
                                 DistributedVector &pressure)
{
  if (is_empty())
    return;
  const unsigned int n = ports.size();
  for (unsigned int i = 0; i < n; ++i)
  {
    sums[i] = output(ports[i], velocity, pressure) + ports[i].force;
    sums[n + i] = product(ports[i].flow, velocity_old);
  }
  Utilities::MPI::sum(sums, space.communicator, sums);
  for (unsigned int i = 0; i < n; ++i)
    outputs[i] = sums[i];

  predicted = 0.;
  auto coefficient = coefficients.begin();
  for (unsigned int o = 0; o < problem.outlets.size(); ++o)
  {
    const Outlet &outlet = problem.outlets[o];
    const unsigned int first = first_port[o];
    predicted[first] += outlet.pressure_behind(origin, step.balance_time);
    for (unsigned int k = 0; k < states[o].size(); ++k)
    {
      const Impedance::Term &term = outlet.impedance.terms[k];
      State &state = states[o][k];
      const BranchCoefficients of_step = step.branch(relaxation_time(term));
      *coefficient++ = of_step.velocity;
      for (unsigned int j = 0; j < state.balanced.size(); ++j)
        state.balanced[j] = of_step.old * state.present[j] + of_step.older * state.older[j] +
                            of_step.velocity_old * sums[n + first + j];
      for (unsigned int i = 0; i < state.balanced.size(); ++i)
        for (unsigned int j = 0; j < state.balanced.size(); ++j)
          predicted[first + i] += term.residue(i, j) * state.balanced[j];
    }
  }
  set_impedances();
  add_responses(velocity, pressure);

  coefficient = coefficients.begin();
  for (unsigned int o = 0; o < states.size(); ++o)
    for (unsigned int k = 0; k < states[o].size(); ++k)
    {
      State &state = states[o][k];
      const Impedance::Term &term = problem.outlets[o].impedance.terms[k];
      for (unsigned int j = 0; j < state.balanced.size(); ++j)
      {
        const double flow_rate = ports[first_port[o] + j].flow_rate;
        state.balanced[j] += *coefficient * flow_rate;
        state.rate[j] = flow_rate - term.rate * state.balanced[j];
      }
      ++coefficient;
      state.older.swap(state.present);
      if (step.extrapolate)
      {
        state.present.equ(2., state.balanced);
        state.present.add(-1., state.older);
      }
      else
        state.present = state.balanced;
      // The exponential update obeys the equation over the step as a whole.
      if (step.branch_is_exponential(relaxation_time(term)))
      {
        state.rate.equ(1. / step.size(), state.present);
        state.rate.add(-1. / step.size(), state.older);
      }
    }
}

template <int dim>
void OutletCoupling<dim>::couple_steady(const double time,
                                        DistributedVector &velocity,
                                        DistributedVector &pressure)
{
  if (is_empty())
    return;
  for (unsigned int i = 0; i < ports.size(); ++i)
    sums[i] = output(ports[i], velocity, pressure) + ports[i].force;
  Utilities::MPI::sum(sums, space.communicator, sums);
  predicted = 0.;
  auto coefficient = coefficients.begin();
  for (unsigned int o = 0; o < problem.outlets.size(); ++o)
  {
    const Outlet &outlet = problem.outlets[o];
    predicted[first_port[o]] += outlet.pressure_behind(origin, time);
    for (const Impedance::Term &term : outlet.impedance.terms)
    {
      if (term.rate == 0.)
        throw RunError("the outlet '" + outlet.name +
                       "' has no pressure that belongs to a steady flow");
      *coefficient++ = 1. / term.rate;
    }
  }
  for (unsigned int i = 0; i < ports.size(); ++i)
    outputs[i] = sums[i];
  set_impedances();
  add_responses(velocity, pressure);
  for (unsigned int o = 0; o < states.size(); ++o)
    for (unsigned int k = 0; k < states[o].size(); ++k)
      for (unsigned int j = 0; j < states[o][k].present.size(); ++j)
        states[o][k].present[j] = states[o][k].balanced[j] =
            ports[first_port[o] + j].flow_rate / problem.outlets[o].impedance.terms[k].rate;
}

template <int dim>
void OutletCoupling<dim>::add_forces(const double factor, DistributedVector &forces) const
{
  for (const Port &port : ports)
    if (!port.holds_flow)
      for (const auto &[index, value] : port.flow)
        forces.begin()[index] -= factor * port.pressure * value;
}

template <int dim>
void OutletCoupling<dim>::power(std::vector<OutletPower> &of_outlets) const
{
  of_outlets.assign(problem.outlets.size(), OutletPower());
  for (const Port &port : ports)
    of_outlets[port.outlet].leaving += port.pressure * port.flow_rate;
  for (unsigned int o = 0; o < states.size(); ++o)
  {
    const Impedance &impedance = problem.outlets[o].impedance;
    if (!impedance.terms_store_energy)
      continue;
    for (unsigned int k = 0; k < states[o].size(); ++k)
    {
      const Impedance::Term &term = impedance.terms[k];
      const Vector<double> &x = states[o][k].balanced;
      for (unsigned int i = 0; i < x.size(); ++i)
        for (unsigned int j = 0; j < x.size(); ++j)
          of_outlets[o].stored += x[i] * term.residue(i, j) * states[o][k].rate[j];
    }
  }
}

template <int dim>
double OutletCoupling<dim>::energy() const
{
  double sum = 0.;
  for (unsigned int o = 0; o < states.size(); ++o)
    if (problem.outlets[o].impedance.terms_store_energy)
      for (unsigned int k = 0; k < states[o].size(); ++k)
        sum += 0.5 * problem.outlets[o].impedance.terms[k].residue.matrix_norm_square(
                         states[o][k].present);
  return sum;
}

template <int dim>
std::vector<double> OutletCoupling<dim>::present_pressures(const double time,
                                                           const DistributedVector &velocity) const
{
  std::vector<double> pressures(problem.conditions.size(), 0.), flow_rates;
  for (const Port &port : ports)
    flow_rates.push_back(product(port.flow, velocity));
  Utilities::MPI::sum(flow_rates, space.communicator, flow_rates);
  for (unsigned int o = 0; o < problem.outlets.size(); ++o)
  {
    const Outlet &outlet = problem.outlets[o];
    for (unsigned int i = 0; i < outlet.conditions.size(); ++i)
    {
      double &pressure = pressures[outlet.conditions[i]];
      if (i == 0)
        pressure += outlet.pressure_behind(origin, time);
      for (unsigned int j = 0; j < outlet.conditions.size(); ++j)
      {
        pressure += outlet.impedance.direct(i, j) * flow_rates[first_port[o] + j];
        for (unsigned int k = 0; k < states[o].size(); ++k)
          pressure += outlet.impedance.terms[k].residue(i, j) * states[o][k].present[j];
      }
    }
  }
  return pressures;
}

template <int dim>
bool OutletCoupling<dim>::jumps(const double begin, const double end) const
{
  for (const Outlet &outlet : problem.outlets)
    if (outlet.pressure_behind.depends_on_time() &&
        jumps_within([&](const double time) { return outlet.pressure_behind(origin, time); }, begin,
                     end))
      return true;
  return false;
}

template <int dim>
void OutletCoupling<dim>::visit(StateVisitor &visitor)
{
  for (unsigned int o = 0; o < states.size(); ++o)
    for (unsigned int k = 0; k < states[o].size(); ++k)
    {
      State &state = states[o][k];
      visitor.levels({"outlet", o, k}, state.present.begin(), state.older.begin(),
                     state.present.size());
    }
}

template class OutletCoupling<2>;
template class OutletCoupling<3>;
} // namespace Continua
