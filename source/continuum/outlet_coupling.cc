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
  models.clear();
  for (const Outlet &outlet : problem.outlets)
    models.push_back(make_end_model(outlet));
  present_flow_rates_of_mesh.assign(present_flow_rates_of_mesh.size(), 0.);
  inputs_are_current = false;
}

OutletCoupling::Sparse OutletCoupling::sparse(const DistributedVector &vector)
{
  Sparse entries;
  const double *const values = vector.begin();
  for (unsigned int i = 0; i < vector.locally_owned_size(); ++i)
    if (values[i] != 0.)
      entries.emplace_back(i, values[i]);
  return entries;
}

double OutletCoupling::product(const Sparse &sparse, const DistributedVector &vector)
{
  const double *const values = vector.begin();
  double sum = 0.;
  for (const auto &[index, value] : sparse)
    sum += value * values[index];
  return sum;
}

void OutletCoupling::build()
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
      port.condition = c;
      const DistributedVector flow = operators.ports().flow_of_velocities(c);
      port.flow = sparse(flow);
      port.holds_flow = problem.conditions[c].normal.flow != nullptr;
      // The waves that an absorbing end lets pass are those of matter, also of the wall's.
      port.moves_with_mesh =
          problem.mesh_moves && problem.conditions[c].type != BoundaryType::absorbing;
      if (port.holds_flow)
      {
        // A flow of 1 is wanted, out of the body.
        DistributedVector profile = operators.ports().flow_profile(c);
        profile *= 1. / (flow * profile);
        port.velocity = sparse(profile);
        port.square_of_velocity = profile.norm_sqr();
      }
      port.velocity_response = operators.velocity_vector();
      port.pressure_response = operators.pressure_vector();
    }
  }
  const unsigned int n = ports.size();
  responses.reinit(n, n);
  impedances.reinit(n, n);
  inputs_of_rhs.reinit(n, n);
  for (Vector<double> *vector : {&outputs, &completed, &rhs, &inputs, &predicted})
    vector->reinit(n);
  sums.resize(2 * ports.size());
  pressures.resize(n);
  flow_rates.resize(n);
  flow_rates_of_mesh.assign(n, 0.);
  present_flow_rates_of_mesh.resize(n, 0.);
  if (problem.mesh_moves)
    section = operators.velocity_vector();
  inputs_are_current = false;
  if (problem.mesh_moves)
    take_sections(*operators.mesh_displacement());
}

double OutletCoupling::output(const Port &port,
                              const DistributedVector &velocity,
                              const DistributedVector &pressure) const
{
  return port.holds_flow ? product(port.mass_of_velocity, pressure) -
                               product(port.momentum_of_velocity, velocity)
                         : product(port.flow, velocity);
}

void OutletCoupling::respond(StepReport &report)
{
  if (is_empty())
    return;
  DistributedVector momentum = operators.velocity_vector(), prescribed = momentum;
  DistributedVector mass = operators.pressure_vector();
  const auto set = [](const Sparse &entries, DistributedVector &vector)
  {
    vector = 0.;
    for (const auto &[index, value] : entries)
      vector.begin()[index] = value;
  };
  // Before any solve, see LinearSystem::set_reaction(). The right sides wait where the responses
  // come.
  for (Port &port : ports)
    if (port.holds_flow)
    {
      set(port.velocity, prescribed);
      operators.system().set_reaction(prescribed, momentum, mass, port.velocity_response,
                                      port.pressure_response);
      port.momentum_of_velocity = sparse(momentum);
      port.mass_of_velocity = sparse(mass);
    }
  for (Port &port : ports)
  {
    if (port.holds_flow)
    {
      set(port.velocity, prescribed);
      momentum.equ(1., port.velocity_response);
      mass.equ(1., port.pressure_response);
    }
    else
    {
      set({}, prescribed);
      set(port.flow, momentum);
      momentum *= -1.;
      mass = 0.;
    }
    operators.system().solve(prescribed, momentum, mass, port.velocity_response,
                             port.pressure_response, report);
  }
  std::vector<double> entries;
  for (const Port &row : ports)
    for (const Port &column : ports)
      entries.push_back(output(row, column.velocity_response, column.pressure_response));
  Utilities::MPI::sum(entries, problem.communicator, entries);
  responses.fill(entries.data());
  inputs_are_current = false;
}

void OutletCoupling::leave_out_ports(DistributedVector &prescribed) const
{
  for (const Port &port : ports)
    for (const auto &entry : port.velocity)
      prescribed.begin()[entry.first] = 0.;
}

void OutletCoupling::take_forces(const DistributedVector &momentum)
{
  for (Port &port : ports)
    port.force = product(port.velocity, momentum);
}

void OutletCoupling::take_models(const bool changed)
{
  for (unsigned int o = 0; o < models.size(); ++o)
    for (unsigned int i = 0; i < models[o]->n_ports(); ++i)
      predicted[first_port[o] + i] = models[o]->predicted_pressures()[i];
  if (inputs_are_current && !changed)
    return;
  inputs_are_current = true;
  impedances = 0.;
  for (unsigned int o = 0; o < models.size(); ++o)
    impedances.add(models[o]->impedance(), 1., first_port[o], first_port[o]);
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

void OutletCoupling::solve_ports()
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
  completed = outputs;
  responses.vmult_add(completed, inputs);
  for (unsigned int i = 0; i < n; ++i)
  {
    pressures[i] = ports[i].holds_flow ? completed[i] : inputs[i];
    flow_rates[i] = ports[i].holds_flow ? inputs[i] : completed[i];
  }
}

bool OutletCoupling::correct_models()
{
  bool changed = false;
  for (unsigned int o = 0; o < models.size(); ++o)
    changed = models[o]->correct(&flow_rates[first_port[o]]) || changed;
  return changed;
}

void OutletCoupling::add_responses(DistributedVector &velocity, DistributedVector &pressure)
{
  solve_ports();
  while (correct_models())
  {
    take_models(true);
    solve_ports();
  }
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
    sums[i] = output(ports[i], velocity, pressure) + ports[i].force;
    sums[n + i] = product(ports[i].flow, velocity_old);
  }
  Utilities::MPI::sum(sums, problem.communicator, sums);
  for (unsigned int i = 0; i < n; ++i)
    outputs[i] = sums[i];
  bool changed = false;
  for (unsigned int o = 0; o < models.size(); ++o)
    changed = models[o]->linearise(step, &sums[n + first_port[o]]) || changed;
  take_models(changed);
  add_responses(velocity, pressure);
}

void OutletCoupling::take_sections(const DistributedVector &mesh_displacement)
{
  for (Port &port : ports)
  {
    operators.ports().set_flow_of_velocities(port.condition, mesh_displacement, section);
    port.flow = sparse(section);
  }
}

std::vector<double> OutletCoupling::present_flow_rates(const DistributedVector &velocity)
{
  std::vector<double> flows;
  for (const Port &port : ports)
    if (problem.mesh_moves)
    {
      // The ports have the sections of the level that the last step balanced.
      operators.ports().set_flow_of_velocities(port.condition, *operators.mesh_displacement(),
                                               section);
      flows.push_back(product(sparse(section), velocity));
    }
    else
      flows.push_back(product(port.flow, velocity));
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
  for (const Port &port : ports)
  {
    numbers.push_back(product(port.flow, iterate.velocity));
    numbers.push_back(port.moves_with_mesh ? product(port.flow, iterate.mesh_velocity) : 0.);
    for (const Port &column : ports)
      numbers.push_back(port.holds_flow ? 0. : product(port.flow, column.velocity_response));
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
        responses(i, j) = *number;
  }
  for (unsigned int o = 0; o < models.size(); ++o)
    models[o]->linearise_about(&flow_rates[first_port[o]]);
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
    for (const auto &[index, value] : ports[i].velocity)
      velocity.begin()[index] = flow_rates[i] * value;
}

void OutletCoupling::add_to_residual(const double factor, DistributedVector &momentum) const
{
  for (unsigned int i = 0; i < ports.size(); ++i)
    for (const auto &[index, value] : ports[i].flow)
      momentum.begin()[index] -= factor * pressures[i] * value;
}

std::vector<double> OutletCoupling::port_rows(const DistributedVector &momentum) const
{
  std::vector<double> rows;
  for (const Port &port : ports)
    rows.push_back(product(port.velocity, momentum));
  if (std::any_of(ports.begin(), ports.end(), [](const Port &port) { return port.holds_flow; }))
    Utilities::MPI::sum(rows, problem.communicator, rows);
  return rows;
}

void OutletCoupling::set_port_rows(const std::vector<double> &rows,
                                   DistributedVector &momentum) const
{
  for (unsigned int i = 0; i < ports.size(); ++i)
    for (const auto &[index, value] : ports[i].velocity)
      momentum.begin()[index] = rows[i] / ports[i].square_of_velocity * value;
}

void OutletCoupling::complete_change(const std::vector<double> &rows,
                                     DistributedVector &velocity_change,
                                     DistributedVector &pressure_change)
{
  if (is_empty())
    return;
  const unsigned int n = ports.size();
  for (unsigned int i = 0; i < n; ++i)
    sums[i] = output(ports[i], velocity_change, pressure_change);
  Utilities::MPI::sum(sums, problem.communicator, sums);
  for (unsigned int i = 0; i < n; ++i)
    outputs[i] = sums[i];
  // A new factor has new responses.
  take_models(false);
  for (unsigned int i = 0; i < n; ++i)
  {
    rhs[i] = ports[i].holds_flow ? -rows[i] - outputs[i] : 0.;
    for (unsigned int j = 0; j < n; ++j)
      if (!ports[j].holds_flow)
        rhs[i] += impedances(i, j) * outputs[j];
  }
  inputs_of_rhs.vmult(inputs, rhs);
  for (unsigned int i = 0; i < n; ++i)
  {
    velocity_change.add(inputs[i], ports[i].velocity_response);
    pressure_change.add(inputs[i], ports[i].pressure_response);
  }
}

void OutletCoupling::predict(const Step &step, const DistributedVector &velocity_old)
{
  if (is_empty())
    return;
  const std::vector<double> flows = present_flow_rates(velocity_old);
  for (unsigned int o = 0; o < models.size(); ++o)
  {
    EndModel &model = *models[o];
    const unsigned int first = first_port[o];
    std::copy_n(&flows[first], model.n_ports(), &flow_rates[first]);
    if (model.linearise(step, &flows[first]))
      inputs_are_current = false;
    const FullMatrix<double> impedance = model.impedance();
    for (unsigned int i = 0; i < model.n_ports(); ++i)
    {
      pressures[first + i] = model.predicted_pressures()[i];
      for (unsigned int j = 0; j < model.n_ports(); ++j)
        pressures[first + i] += impedance(i, j) * flows[first + j];
    }
  }
}

void OutletCoupling::finish_step(const Step &step)
{
  for (unsigned int o = 0; o < models.size(); ++o)
    models[o]->advance(step, &flow_rates[first_port[o]]);
  for (unsigned int i = 0; i < ports.size(); ++i)
    present_flow_rates_of_mesh[i] = step.extrapolate
                                        ? 2. * flow_rates_of_mesh[i] - present_flow_rates_of_mesh[i]
                                        : flow_rates_of_mesh[i];
}

void OutletCoupling::start_steady()
{
  present_flow_rates_of_mesh.assign(ports.size(), 0.);
  for (unsigned int o = 0; o < models.size(); ++o)
    models[o]->start_from(&flow_rates[first_port[o]]);
}

void OutletCoupling::couple_steady(const double time,
                                   DistributedVector &velocity,
                                   DistributedVector &pressure)
{
  if (is_empty())
    return;
  const unsigned int n = ports.size();
  for (unsigned int i = 0; i < n; ++i)
    sums[i] = output(ports[i], velocity, pressure) + ports[i].force;
  Utilities::MPI::sum(sums, problem.communicator, sums);
  for (unsigned int i = 0; i < n; ++i)
    outputs[i] = sums[i];
  bool changed = false;
  for (const std::unique_ptr<EndModel> &model : models)
    changed = model->linearise_steady(time) || changed;
  take_models(changed);
  add_responses(velocity, pressure);
  for (unsigned int o = 0; o < models.size(); ++o)
    models[o]->set_steady(&flow_rates[first_port[o]]);
}

void OutletCoupling::add_forces(const double factor, DistributedVector &forces) const
{
  for (unsigned int i = 0; i < ports.size(); ++i)
    if (!ports[i].holds_flow)
      for (const auto &[index, value] : ports[i].flow)
        forces.begin()[index] -= factor * pressures[i] * value;
}

void OutletCoupling::add_forces_of(const unsigned int region,
                                   const double factor,
                                   DistributedVector &forces) const
{
  for (unsigned int i = 0; i < ports.size(); ++i)
    if (!ports[i].holds_flow && problem.conditions[ports[i].condition].region_ids.count(region) > 0)
      for (const auto &[index, value] : ports[i].flow)
        forces.begin()[index] -= factor * pressures[i] * value;
}

void OutletCoupling::power(std::vector<OutletPower> &of_outlets) const
{
  of_outlets.assign(problem.outlets.size(), OutletPower());
  for (unsigned int i = 0; i < ports.size(); ++i)
    of_outlets[ports[i].outlet].leaving += pressures[i] * (flow_rates[i] + flow_rates_of_mesh[i]);
  for (unsigned int o = 0; o < models.size(); ++o)
    of_outlets[o].stored = models[o]->stored_power();
}

double OutletCoupling::energy() const
{
  double sum = 0.;
  for (const std::unique_ptr<EndModel> &model : models)
    sum += model->energy();
  return sum;
}

std::vector<double> OutletCoupling::present_pressures(const double time,
                                                      const DistributedVector &velocity)
{
  std::vector<double> of_conditions(problem.conditions.size(), 0.);
  const std::vector<double> flows = present_flow_rates(velocity);
  for (unsigned int o = 0; o < models.size(); ++o)
  {
    const std::vector<double> of_ports = models[o]->present_pressures(time, &flows[first_port[o]]);
    for (unsigned int i = 0; i < of_ports.size(); ++i)
      of_conditions[problem.outlets[o].conditions[i]] += of_ports[i];
  }
  return of_conditions;
}

void OutletCoupling::add_present_forces(const double time,
                                        const DistributedVector &velocity,
                                        DistributedVector &forces)
{
  if (is_empty())
    return;
  const std::vector<double> of_conditions = present_pressures(time, velocity);
  for (const Port &port : ports)
  {
    const unsigned int in_outlet = &port - &ports[first_port[port.outlet]];
    const double pressure = of_conditions[problem.outlets[port.outlet].conditions[in_outlet]];
    if (!port.holds_flow)
      for (const auto &[index, value] : port.flow)
        forces.begin()[index] -= pressure * value;
  }
}

const Network *OutletCoupling::network()
{
  for (const std::unique_ptr<EndModel> &model : models)
    if (const Network *const found = model->network())
      return found;
  return nullptr;
}

bool OutletCoupling::jumps(const double begin, const double end) const
{
  for (const std::unique_ptr<EndModel> &model : models)
    if (model->jumps(begin, end))
      return true;
  return false;
}

void OutletCoupling::visit(StateVisitor &visitor)
{
  for (unsigned int o = 0; o < models.size(); ++o)
    models[o]->visit(visitor, o);
  for (unsigned int i = 0; i < ports.size(); ++i)
    if (ports[i].moves_with_mesh)
      visitor.value({"flow of the mesh at port", i}, present_flow_rates_of_mesh[i]);
}
} // namespace Continua
