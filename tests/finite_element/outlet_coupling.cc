// Steps with outlets obey the equations of the body and those of the outlets, which the test writes
// down by itself: whatever holds the ports, with hanging nodes, on any number of ranks, by each
// scheme.

#include <continua/boundary/boundary_conditions.h>
#include <continua/boundary/flow_rates.h>
#include <continua/boundary/outlets.h>
#include <continua/continuum/outlet_coupling.h>
#include <continua/finite_element/taylor_hood.h>

#include "../parameter_text.h"
#include "../unit_test.h"
#include "small_problem.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace test_of_outlet_coupling
{
using namespace Continua;
using namespace dealii;

namespace
{
const std::vector<std::string> names = {"left", "right", "bottom", "top"};
const double resistance = 7., proximal = 3., distal = 40., compliance = 0.02;

const std::string inlet = "set Type = flow rate\nset Flow rate = 2*sin(5*t)";
const std::string windkessel = "set Type = windkessel\nset Proximal resistance = 3\n"
                               "set Distal resistance = 40\nset Compliance = 0.02\n"
                               "set Initial pressure = 4\nset Pressure behind = 1.5\n";
const std::string resistor = "set Type = resistance\nset Resistance = 7\n"
                             "set Pressure behind = 5*cos(t)\n";
const std::string by_flow = "set Coupling = flow\nset Profile = parabolic\n";

/// An axisymmetric tube of radius 3 and length 2 of unit cells, some of them divided, full of a
/// viscous liquid, between two ends.
struct Tube
{
  Tube(const std::string &left, const std::string &right)
      : mesh(MPI_COMM_WORLD),
        log(MPI_COMM_WORLD),
        space(mesh, SpaceParameters(), Model::axisymmetric, 1)
  {
    static std::vector<ParameterFile> files;
    // One rank after the other: they write a file of the same name.
    for (unsigned int rank = 0; rank < Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD); ++rank)
    {
      if (rank == Utilities::MPI::this_mpi_process(MPI_COMM_WORLD))
        files.push_back(parameters_of("subsection left\n" + left + "\nend\nsubsection right\n" +
                                      right + "\nend\nsubsection bottom\nset Type = axis\nend\n" +
                                      "subsection top\nset Type = fixed\nend\n"));
      MPI_Barrier(MPI_COMM_WORLD);
    }
    std::set<std::pair<unsigned int, unsigned int>> pairs;
    for (unsigned int b = 0; b < 4; ++b)
      pairs.insert({b, 0});
    Material liquid;
    liquid.density = 1.3;
    liquid.shear.viscosity = 0.5;
    liquid.compression = Compression::elastic(0.02);
    problem.model = Model::axisymmetric;
    problem.regions = {"body"};
    problem.materials = {liquid};
    problem.conditions =
        read_boundary_conditions(files.back().root(), names, {"body"}, pairs, 2, true);
    small_problem::make_box<2>(mesh, {2, 3});
    set_flow_profiles(problem.conditions, files.back().root(), mesh, problem.materials,
                      {false, 4., 0.01});
    problem.outlets =
        make_outlets(problem.conditions, files.back().root(), mesh, problem.materials);
    small_problem::refine<2>(mesh, [](const Point<2> &x) { return x[1] > 1. && x[1] < 2.; });
    space.distribute();
    loads = std::make_unique<Loads<2>>(space, problem);
    body = std::make_unique<TaylorHood<2>>(mesh, problem, TaylorHoodParameters(), log);
    body->setup();
    coupling = std::make_unique<OutletCoupling>(problem, *body);
    reset();
  }
  /// Begins anew; after a change of the outlets too.
  void reset()
  {
    coupling->initialise();
    coupling->build();
    velocity = space.velocity_vector();
    pressure = space.pressure_vector();
  }
  /// The flow out of an end, by a rule of many points.
  double flow(const unsigned int boundary, const DistributedVector &owned) const
  {
    const DistributedVector u = space.ghosted_velocity(owned);
    FEFaceValues<2> values(space.mapping, space.velocity_element, QGauss<1>(8),
                           update_values | update_quadrature_points | update_JxW_values |
                               update_normal_vectors);
    const FEValuesExtractors::Vector vector(0);
    std::vector<Tensor<1, 2>> at_points(8);
    double sum = 0.;
    for (const auto &cell : space.velocity_dofs.active_cell_iterators())
      if (cell->is_locally_owned())
        for (const unsigned int f : cell->face_indices())
          if (cell->face(f)->at_boundary() && cell->face(f)->boundary_id() == boundary)
          {
            values.reinit(cell, f);
            values[vector].get_function_values(u, at_points);
            for (unsigned int q = 0; q < at_points.size(); ++q)
              sum += at_points[q] * values.normal_vector(q) * values.JxW(q) * 2. * M_PI *
                     values.quadrature_point(q)[1];
          }
    return Utilities::MPI::sum(sum, MPI_COMM_WORLD);
  }
  /// One step with any force in the body; returns the relative residual of the body's equations
  /// with the pressures of the ports as loads, and that of virtual power at ports that hold a flow.
  std::pair<double, double> advance(const Step &step)
  {
    const Material &liquid = problem.materials.front();
    StepReport report;
    if (body->system().prepare({{step.a0 * liquid.density},
                                {liquid.shear.viscosity},
                                {liquid.inverse_bulk_modulus() / step.pressure_time}},
                               step.pressure_time) != SystemChange::none)
      coupling->respond(report);
    const double time = step.balance_time;
    DistributedVector force = small_problem::interpolated<2>(
        space,
        [&](const Point<2> &x) {
          return Tensor<1, 2>({std::sin(x[0] + 2. * time), std::cos(3. * x[1] * time)});
        });
    DistributedVector momentum = force, mass = space.pressure_vector();
    DistributedVector prescribed = space.velocity_vector();
    body->prescribed().evaluate(time, prescribed);
    coupling->leave_out_ports(prescribed);
    coupling->take_forces(momentum);
    body->system().eliminate_prescribed(prescribed, momentum, mass);
    const DistributedVector old = velocity;
    DistributedVector new_pressure = space.pressure_vector();
    DistributedVector new_velocity = space.velocity_vector();
    body->system().solve(prescribed, momentum, mass, new_velocity, new_pressure, report);
    coupling->couple(step, old, new_velocity, new_pressure);
    coupling->finish_step(step);
    velocity = new_velocity;
    if (step.extrapolate)
    {
      velocity *= 2.;
      velocity.add(-1., old);
    }
    at_level = new_velocity;
    pressure = new_pressure;

    // A U + G P - f + q p, at every node; B U + C P.
    DistributedVector residual = space.velocity_vector();
    body->system().add_velocity_product(at_level, residual);
    DistributedVector product = space.velocity_vector();
    body->products().multiply_gradient(0, product, pressure);
    residual.add(1., product);
    const double scale = residual.linfty_norm();
    residual.add(-1., force);
    double virtual_power = 0.;
    for (unsigned int o = 0; o < problem.outlets.size(); ++o)
      for (unsigned int i = 0; i < problem.outlets[o].conditions.size(); ++i)
      {
        const unsigned int c = problem.outlets[o].conditions[i];
        const DistributedVector q = loads->flow_of_velocities(c);
        residual.add(coupling->pressure(o, i), q);
        if (problem.outlets[o].coupling == Outlet::Coupling::flow)
        {
          // The parabola's velocity, 2 (1 - r^2/R^2)/(pi R^2) of a unit flow.
          const double sign = names[problem.conditions[c].boundary_id] == "left" ? -1. : 1.;
          const double end = sign < 0. ? 0. : 2.;
          const DistributedVector parabola = small_problem::interpolated<2>(
              space,
              [&](const Point<2> &x)
              {
                Tensor<1, 2> v;
                v[0] = std::abs(x[0] - end) < 1e-9
                           ? sign * 2. * (1. - x[1] * x[1] / 9.) / (9. * M_PI)
                           : 0.;
                return v;
              });
          virtual_power = std::max(virtual_power, std::abs(parabola * residual) / scale);
        }
      }
    BoundaryConstraints<2> constraints(space, problem.conditions);
    constraints.build();
    constraints.restrict_to_free(residual);
    DistributedVector mass_residual = space.pressure_vector(), compressed = mass_residual;
    body->system().add_divergence(at_level, mass_residual);
    body->products().multiply_pressure_mass(0, compressed, pressure);
    mass_residual.add(liquid.inverse_bulk_modulus() / step.pressure_time, compressed);
    return {(residual.linfty_norm() + mass_residual.linfty_norm()) / scale, virtual_power};
  }

  small_problem::Mesh<2> mesh;
  Log log;
  Space<2> space;
  Problem problem;
  std::unique_ptr<Loads<2>> loads;
  std::unique_ptr<TaylorHood<2>> body;
  std::unique_ptr<OutletCoupling> coupling;
  DistributedVector velocity, pressure, at_level;
};

/// x of the windkessel by the formulas of each scheme, as a person would write them.
struct Compliance
{
  double rate, x, older;

  double step(const Step &step, const bool backward_differencing, const double flow)
  {
    const double h = step.size();
    double at_level = 0., next = 0.;
    if (step.extrapolate)
    {
      // (x_new - x)/h = Q - rate (x_new + x)/2
      next = (x * (1. - 0.5 * h * rate) + h * flow) / (1. + 0.5 * h * rate);
      at_level = 0.5 * (x + next);
    }
    else if (backward_differencing)
      at_level = next = (2. * x - 0.5 * older + h * flow) / (1.5 + h * rate);
    else
      at_level = next = (x + h * flow) / (1. + h * rate);
    older = x;
    x = next;
    return at_level;
  }
};

void take_larger(std::array<double, 2> &largest, const std::pair<double, double> &residuals)
{
  largest[0] = std::max(largest[0], residuals.first);
  largest[1] = std::max(largest[1], residuals.second);
}

/// A windkessel at the right end of a tube with a prescribed inlet.
void windkessel_by_scheme(const std::string &scheme, const std::string &coupling)
{
  Tube tube(inlet, windkessel + coupling);
  const std::string name = scheme + (coupling.empty() ? ": " : ", flow: ");
  Compliance store{1. / (distal * compliance), compliance * (4. - 1.5), compliance * (4. - 1.5)};
  check::relative(name + "energy at the start", tube.coupling->energy(), 0.5 * compliance * 6.25,
                  1e-12);
  std::array<double, 2> residuals{};
  double law = 0., flow_error = 0., energy_error = 0., stored_error = 0., largest_flow = 0.;
  const double h = 0.1;
  for (unsigned int i = 0; i < 6; ++i)
  {
    const double t = i * h;
    const bool second_order = scheme == "backward differencing" && i > 0;
    const Step step = scheme == "crank nicolson" ? crank_nicolson_step(t, h)
                      : second_order ? backward_differencing_step(t, h, h, Update::implicit)
                                     : euler_step(t, h, Update::implicit);
    const double energy_before = tube.coupling->energy();
    take_larger(residuals, tube.advance(step));
    const double flow = tube.flow(1, tube.at_level);
    largest_flow = std::max(largest_flow, std::abs(flow));
    flow_error = std::max(flow_error, std::abs(flow - tube.coupling->flow_rate(0, 0)));
    const double x = store.step(step, second_order, flow);
    const double p = tube.coupling->pressure(0, 0);
    law = std::max(law, std::abs(p - (1.5 + proximal * flow + x / compliance)));
    energy_error = std::max(
        energy_error, std::abs(tube.coupling->energy() - 0.5 * store.x * store.x / compliance));
    std::vector<OutletPower> power;
    tube.coupling->power(power);
    const double loss = proximal * flow * flow + x * x / (compliance * compliance * distal);
    stored_error =
        std::max(stored_error, std::abs(power[0].leaving - power[0].stored - loss - 1.5 * flow));
    if (scheme == "crank nicolson")
      stored_error = std::max(
          stored_error, std::abs(h * power[0].stored - (tube.coupling->energy() - energy_before)));
  }
  check::absolute(name + "the body's equations", residuals[0], 0., 1e-11);
  if (!coupling.empty())
    check::absolute(name + "virtual power", residuals[1], 0., 1e-11);
  check::is_true(name + "something flows", largest_flow > 0.1);
  check::absolute(name + "flow rate", flow_error, 0., 1e-11);
  check::absolute(name + "windkessel's law", law, 0., 1e-10);
  check::absolute(name + "energy", energy_error, 0., 1e-11);
  check::absolute(name + "what is stored, and lost", stored_error, 0., 1e-9);
}

/// A windkessel that drains in a fifth of the step: the exponential update, exact where the flow
/// rate is linear over the step.
void fast_windkessel()
{
  Tube tube(inlet, "set Type = windkessel\nset Proximal resistance = 3\n"
                   "set Distal resistance = 40\nset Compliance = 0.0005\n");
  const double small_compliance = 0.0005, tau = 40. * small_compliance, h = 0.1;
  const double decay = std::exp(-h / tau);
  double x = 0., law = 0., stored = 0.;
  for (unsigned int i = 0; i < 6; ++i)
  {
    const double flow_old = tube.flow(1, tube.velocity);
    const double energy_old = tube.coupling->energy();
    tube.advance(crank_nicolson_step(i * h, h));
    const double flow = tube.flow(1, tube.velocity);
    // Of dx/dt = Q - x/tau.
    const double x_new =
        x * decay + tau * (flow - flow_old * decay - (flow - flow_old) * tau / h * (1. - decay));
    law = std::max(law, std::abs(tube.coupling->pressure(0, 0) - 1.5 * (flow + flow_old) -
                                 0.5 * (x + x_new) / small_compliance));
    x = x_new;
    std::vector<OutletPower> power;
    tube.coupling->power(power);
    stored =
        std::max(stored, std::abs(h * power[0].stored - (tube.coupling->energy() - energy_old)));
  }
  check::absolute("fast windkessel: exponential update", law, 0., 1e-10);
  check::absolute("fast windkessel: what is stored", stored, 0., 1e-11);
}

/// A port that holds a pressure at one end, one that holds a flow at the other.
void two_outlets()
{
  Tube tube(resistor, windkessel + by_flow);
  std::array<double, 2> residuals{};
  Compliance store{1. / (distal * compliance), compliance * 2.5, compliance * 2.5};
  double law = 0.;
  for (unsigned int i = 0; i < 4; ++i)
  {
    const Step step = crank_nicolson_step(0.1 * i, 0.1);
    take_larger(residuals, tube.advance(step));
    const double left = tube.flow(0, tube.at_level), right = tube.flow(1, tube.at_level);
    law = std::max(law, std::abs(tube.coupling->pressure(0, 0) - resistance * left -
                                 5. * std::cos(step.balance_time)));
    law = std::max(law, std::abs(tube.coupling->pressure(1, 0) - 1.5 - proximal * right -
                                 store.step(step, false, right) / compliance));
  }
  check::absolute("two outlets: the body's equations", residuals[0], 0., 1e-11);
  check::absolute("two outlets: virtual power", residuals[1], 0., 1e-11);
  check::absolute("two outlets: their laws", law, 0., 1e-10);
  check::is_true("two outlets: no jump", !tube.coupling->jumps(0.1, 0.2));
  const Tube jump("set Type = resistance\nset Resistance = 7\nset Pressure behind = step(t-1)",
                  "set Type = free");
  check::is_true("a jump of the pressure behind",
                 jump.coupling->jumps(0.95, 1.05) && !jump.coupling->jumps(1.05, 1.15));
}

/// Two ports of one outlet, each with an influence on the other's pressure.
void two_ports()
{
  Tube tube(resistor, "set Type = resistance\nset Resistance = 0");
  Outlet outlet = tube.problem.outlets[0];
  outlet.conditions = {0, 1};
  outlet.pressure_behind = Waveform(20.);
  Impedance::Term term;
  term.rate = 3.;
  for (auto *matrix : {&outlet.impedance.direct, &term.residue})
  {
    matrix->reinit(2, 2);
    (*matrix)(0, 0) = 5.;
    (*matrix)(1, 1) = 4.;
    (*matrix)(0, 1) = (*matrix)(1, 0) = 2.;
  }
  outlet.impedance.terms = {term};
  tube.problem.outlets = {outlet};
  tube.reset();
  std::array<double, 2> residuals{};
  Compliance first{3., 0., 0.}, second{3., 0., 0.};
  double law = 0.;
  for (unsigned int i = 0; i < 4; ++i)
  {
    const Step step = crank_nicolson_step(0.1 * i, 0.1);
    take_larger(residuals, tube.advance(step));
    const double left = tube.flow(0, tube.at_level), right = tube.flow(1, tube.at_level);
    const double x = left + first.step(step, false, left);
    const double y = right + second.step(step, false, right);
    law = std::max(law, std::abs(tube.coupling->pressure(0, 0) - 20. - 5. * x - 2. * y));
    law = std::max(law, std::abs(tube.coupling->pressure(0, 1) - 2. * x - 4. * y));
  }
  check::absolute("two ports: the body's equations", residuals[0], 0., 1e-11);
  check::absolute("two ports: their law", law, 0., 1e-10);
}
} // namespace

UNIT_TEST(outlet_coupling)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  small_problem::quiet_other_ranks();
  for (const std::string scheme : {"euler", "backward differencing", "crank nicolson"})
    for (const std::string &coupling : {std::string(), by_flow})
      windkessel_by_scheme(scheme, coupling);
  fast_windkessel();
  two_outlets();
  two_ports();
}
} // namespace test_of_outlet_coupling
