#include <continua/continuum/outlet_coupling.h>

#include <deal.II/base/mpi.h>

#include <algorithm>

namespace Continua
{
using namespace dealii;

OutletCoupling::OutletCoupling(const Problem &problem, Operators &operators)
    : problem(problem), operators(operators)
{
}

void OutletCoupling::initialise()
{
  models.initialise(problem.outlets);
  present_flow_rates_of_mesh.assign(present_flow_rates_of_mesh.size(), 0.);
  system.forget();
}

void OutletCoupling::build()
{
  ports.clear();
  models.reinit(problem.outlets);
  for (unsigned int o = 0; o < problem.outlets.size(); ++o)
    for (const unsigned int condition : problem.outlets[o].conditions)
      ports.emplace_back(problem, operators, o, condition);
  const unsigned int n = ports.size();
  std::vector<bool> holds_flow;
  for (const BodyPort &port : ports)
    holds_flow.push_back(port.holds_flow);
  system.reinit(holds_flow);
  impedances.reinit(n, n);
  outputs.reinit(n);
  predicted.reinit(n);
  sums.resize(2 * ports.size());
  pressures.resize(n);
  flow_rates.resize(n);
  flow_rates_of_mesh.assign(n, 0.);
  present_flow_rates_of_mesh.resize(n, 0.);
  if (!problem.mesh_moves)
    return;
  section = operators.velocity_vector();
  take_sections(*operators.mesh_displacement());
}

void OutletCoupling::respond(StepReport &report)
{
  if (is_empty())
    return;
  DistributedVector momentum = operators.velocity_vector(), prescribed = momentum;
  DistributedVector mass = operators.pressure_vector();
  // Before any solve, see LinearSystem::set_reaction(). The right sides wait where the responses
  // come.
  for (BodyPort &port : ports)
    if (port.holds_flow)
    {
      prescribed = 0.;
      port.velocity.copy_to(prescribed);
      operators.system().set_reaction(prescribed, momentum, mass, port.velocity_response,
                                      port.pressure_response);
      port.momentum_of_velocity = SparseEntries(momentum);
      port.mass_of_velocity = SparseEntries(mass);
    }
  for (BodyPort &port : ports)
  {
    if (port.holds_flow)
    {
      prescribed = 0.;
      port.velocity.copy_to(prescribed);
      momentum.equ(1., port.velocity_response);
      mass.equ(1., port.pressure_response);
    }
    else
    {
      prescribed = momentum = 0.;
      port.flow.copy_to(momentum, -1.);
      mass = 0.;
    }
    operators.system().solve(prescribed, momentum, mass, port.velocity_response,
                             port.pressure_response, report);
  }
  std::vector<double> entries;
  for (const BodyPort &row : ports)
    for (const BodyPort &column : ports)
      entries.push_back(row.output(column.velocity_response, column.pressure_response));
  Utilities::MPI::sum(entries, problem.communicator, entries);
  system.set_responses(entries);
}

void OutletCoupling::leave_out_ports(DistributedVector &prescribed) const
{
  for (const BodyPort &port : ports)
    port.velocity.copy_to(prescribed, 0.);
}

void OutletCoupling::take_forces(const DistributedVector &momentum)
{
  for (BodyPort &port : ports)
    port.force = port.velocity.product(momentum);
}

void OutletCoupling::take_models(const bool changed)
{
  models.set_predicted(predicted);
  if (system.has_inverse() && !changed)
    return;
  models.set_impedances(impedances);
  system.set_impedances(impedances);
}

const Vector<double> &OutletCoupling::solve_ports()
{
  const Vector<double> &inputs = system.solve(outputs, predicted);
  const Vector<double> &completed = system.completed_outputs();
  for (unsigned int i = 0; i < ports.size(); ++i)
  {
    pressures[i] = ports[i].holds_flow ? completed[i] : inputs[i];
    flow_rates[i] = ports[i].holds_flow ? inputs[i] : completed[i];
  }
  return inputs;
}

void OutletCoupling::complete(DistributedVector &velocity, DistributedVector &pressure)
{
  const Vector<double> *inputs = &solve_ports();
  while (models.correct(flow_rates))
  {
    take_models(true);
    inputs = &solve_ports();
  }
  add_responses(*inputs, velocity, pressure);
}

void OutletCoupling::add_responses(const Vector<double> &inputs,
                                   DistributedVector &velocity,
                                   DistributedVector &pressure) const
{
  for (unsigned int i = 0; i < ports.size(); ++i)
  {
    velocity.add(inputs[i], ports[i].velocity_response);
    pressure.add(inputs[i], ports[i].pressure_response);
  }
}

void OutletCoupling::add_pressure_responses(const double factor,
                                            DistributedVector &velocity,
                                            DistributedVector &pressure) const
{
  for (unsigned int i = 0; i < ports.size(); ++i)
    if (!ports[i].holds_flow)
    {
      velocity.add(factor * pressures[i], ports[i].velocity_response);
      pressure.add(factor * pressures[i], ports[i].pressure_response);
    }
}

void OutletCoupling::couple(const Step &step,
                            const DistributedVector &velocity_old,
                            DistributedVector &velocity,
                            DistributedVector &pressure)
{
  if (is_empty())
    return;
  const unsigned int n = ports.size();
  for (unsigned int i = 0; i < n; ++i)
  {
    sums[i] = ports[i].output(velocity, pressure) + ports[i].force;
    sums[n + i] = ports[i].flow.product(velocity_old);
  }
  Utilities::MPI::sum(sums, problem.communicator, sums);
  for (unsigned int i = 0; i < n; ++i)
    outputs[i] = sums[i];
  take_models(models.linearise(step, sums.data() + n));
  complete(velocity, pressure);
}

void OutletCoupling::take_sections(const DistributedVector &mesh_displacement)
{
  for (BodyPort &port : ports)
  {
    operators.ports().set_flow_of_velocities(port.condition, mesh_displacement, section);
    port.flow = SparseEntries(section);
  }
}

std::vector<double> OutletCoupling::present_flow_rates(const DistributedVector &velocity)
{
  std::vector<double> flows;
  for (const BodyPort &port : ports)
    if (problem.mesh_moves)
    {
      // The ports have the sections of the level that the last step balanced.
      operators.ports().set_flow_of_velocities(port.condition, *operators.mesh_displacement(),
                                               section);
      flows.push_back(SparseEntries(section).product(velocity));
    }
    else
      flows.push_back(port.flow.product(velocity));
  Utilities::MPI::sum(flows, problem.communicator, flows);
  for (unsigned int i = 0; i < ports.size(); ++i)
    flows[i] -= present_flow_rates_of_mesh[i];
  return flows;
}

void OutletCoupling::measure(const StepSolution &iterate)
{
  if (is_empty())
    return;
  take_sections(iterate.mesh_displacement);
  const unsigned int n = ports.size();
  std::vector<double> numbers;
  for (const BodyPort &port : ports)
  {
    numbers.push_back(port.flow.product(iterate.velocity));
    numbers.push_back(port.moves_with_mesh ? port.flow.product(iterate.mesh_velocity) : 0.);
    for (const BodyPort &column : ports)
      numbers.push_back(port.holds_flow ? 0. : port.flow.product(column.velocity_response));
  }
  Utilities::MPI::sum(numbers, problem.communicator, numbers);
  auto number = numbers.begin();
  for (unsigned int i = 0; i < n; ++i)
  {
    const double of_matter = *number++;
    flow_rates_of_mesh[i] = *number++;
    flow_rates[i] = of_matter - flow_rates_of_mesh[i];
    for (unsigned int j = 0; j < n; ++j, ++number)
      if (!ports[i].holds_flow)
        system.set_response(i, j, *number);
  }
  models.linearise_about(flow_rates);
  take_models(true);
  for (unsigned int i = 0; i < n; ++i)
  {
    pressures[i] = predicted[i];
    for (unsigned int j = 0; j < n; ++j)
      pressures[i] += impedances(i, j) * flow_rates[j];
  }
}

void OutletCoupling::set_port_velocities(DistributedVector &velocity) const
{
  for (unsigned int i = 0; i < ports.size(); ++i)
    ports[i].velocity.copy_to(velocity, flow_rates[i]);
}

void OutletCoupling::add_to_residual(const double factor, DistributedVector &momentum) const
{
  for (unsigned int i = 0; i < ports.size(); ++i)
    ports[i].flow.add_to(momentum, -factor * pressures[i]);
}

std::vector<double> OutletCoupling::port_rows(const DistributedVector &momentum) const
{
  std::vector<double> rows;
  for (const BodyPort &port : ports)
    rows.push_back(port.velocity.product(momentum));
  if (std::any_of(ports.begin(), ports.end(), [](const BodyPort &port) { return port.holds_flow; }))
    Utilities::MPI::sum(rows, problem.communicator, rows);
  return rows;
}

void OutletCoupling::set_port_rows(const std::vector<double> &rows,
                                   DistributedVector &momentum) const
{
  for (unsigned int i = 0; i < ports.size(); ++i)
    if (ports[i].holds_flow)
      ports[i].velocity.copy_to(momentum, rows[i] / ports[i].square_of_velocity);
}

void OutletCoupling::complete_change(const std::vector<double> &rows,
                                     DistributedVector &velocity_change,
                                     DistributedVector &pressure_change)
{
  if (is_empty())
    return;
  const unsigned int n = ports.size();
  for (unsigned int i = 0; i < n; ++i)
    sums[i] = ports[i].output(velocity_change, pressure_change);
  Utilities::MPI::sum(sums, problem.communicator, sums);
  for (unsigned int i = 0; i < n; ++i)
    outputs[i] = sums[i];
  // A new factor has new responses.
  take_models(false);
  add_responses(system.solve_change(outputs, rows), velocity_change, pressure_change);
}

void OutletCoupling::predict(const Step &step, const DistributedVector &velocity_old)
{
  if (is_empty())
    return;
  flow_rates = present_flow_rates(velocity_old);
  if (models.linearise(step, flow_rates.data()))
    system.forget();
  models.set_pressures(flow_rates, pressures);
}

void OutletCoupling::finish_step(const Step &step)
{
  models.advance(step, flow_rates);
  for (unsigned int i = 0; i < ports.size(); ++i)
    present_flow_rates_of_mesh[i] = step.extrapolate
                                        ? 2. * flow_rates_of_mesh[i] - present_flow_rates_of_mesh[i]
                                        : flow_rates_of_mesh[i];
}

void OutletCoupling::start_steady()
{
  present_flow_rates_of_mesh.assign(ports.size(), 0.);
  models.start_from(flow_rates);
}

void OutletCoupling::couple_steady(const double time,
                                   DistributedVector &velocity,
                                   DistributedVector &pressure)
{
  if (is_empty())
    return;
  const unsigned int n = ports.size();
  for (unsigned int i = 0; i < n; ++i)
    sums[i] = ports[i].output(velocity, pressure) + ports[i].force;
  Utilities::MPI::sum(sums, problem.communicator, sums);
  for (unsigned int i = 0; i < n; ++i)
    outputs[i] = sums[i];
  take_models(models.linearise_steady(time));
  complete(velocity, pressure);
  models.set_steady(flow_rates);
}

void OutletCoupling::add_forces(const double factor, DistributedVector &forces) const
{
  for (unsigned int i = 0; i < ports.size(); ++i)
    if (!ports[i].holds_flow)
      ports[i].flow.add_to(forces, -factor * pressures[i]);
}

void OutletCoupling::add_forces_of(const unsigned int region,
                                   const double factor,
                                   DistributedVector &forces) const
{
  for (unsigned int i = 0; i < ports.size(); ++i)
    if (!ports[i].holds_flow && problem.conditions[ports[i].condition].region_ids.count(region) > 0)
      ports[i].flow.add_to(forces, -factor * pressures[i]);
}

void OutletCoupling::power(std::vector<OutletPower> &of_outlets) const
{
  of_outlets.assign(problem.outlets.size(), OutletPower());
  for (unsigned int i = 0; i < ports.size(); ++i)
    of_outlets[ports[i].outlet].leaving += pressures[i] * (flow_rates[i] + flow_rates_of_mesh[i]);
  for (unsigned int o = 0; o < of_outlets.size(); ++o)
    of_outlets[o].stored = models.stored_power(o);
}

std::vector<double> OutletCoupling::present_pressures(const double time,
                                                      const DistributedVector &velocity)
{
  std::vector<double> of_conditions(problem.conditions.size(), 0.);
  const std::vector<double> of_ports = models.present_pressures(time, present_flow_rates(velocity));
  for (unsigned int i = 0; i < ports.size(); ++i)
    of_conditions[ports[i].condition] += of_ports[i];
  return of_conditions;
}

void OutletCoupling::add_present_forces(const double time,
                                        const DistributedVector &velocity,
                                        DistributedVector &forces)
{
  if (is_empty())
    return;
  const std::vector<double> of_conditions = present_pressures(time, velocity);
  for (const BodyPort &port : ports)
    if (!port.holds_flow)
      port.flow.add_to(forces, -of_conditions[port.condition]);
}

void OutletCoupling::visit(StateVisitor &visitor)
{
  models.visit(visitor);
  for (unsigned int i = 0; i < ports.size(); ++i)
    if (ports[i].moves_with_mesh)
      visitor.value({"flow of the mesh at port", i}, present_flow_rates_of_mesh[i]);
}
} // namespace Continua
