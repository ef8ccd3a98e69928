// A step of the cell-wise path with outlets obeys the equations of the body, with the pressures of
// the ports as loads, and those of the outlets, which the test writes down by itself: whether they
// hold the section by a pressure or by the flow rate, with hanging nodes, on any number of ranks.

#include <continua/boundary/boundary_conditions.h>
#include <continua/boundary/flow_rates.h>
#include <continua/boundary/outlets.h>
#include <continua/continuum/outlet_coupling.h>
#include <continua/finite_volume/cell_wise.h>

#include "../parameter_text.h"
#include "../unit_test.h"
#include "cell_wise_meshes.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace test_of_cell_wise_outlets
{
namespace
{
using namespace cell_wise_meshes;
const std::vector<std::string> ends = {"left", "right", "bottom", "top"};
const std::string resistor = "set Type = resistance\nset Resistance = 7\nset Pressure behind = 5\n";
const std::string windkessel = "set Type = windkessel\nset Proximal resistance = 3\n"
                               "set Distal resistance = 40\nset Compliance = 0.02\n"
                               "set Initial pressure = 4\nset Pressure behind = 1.5\n";
const std::string by_flow = "set Coupling = flow\nset Profile = parabolic\n";

/// An axisymmetric tube of radius 1 and length 1, some of its cells divided, full of a viscous
/// liquid.
struct CellTube
{
  CellTube(const std::string &left, const std::string &right)
      : mesh(MPI_COMM_WORLD), log(MPI_COMM_WORLD)
  {
    static std::vector<ParameterFile> files;
    // One rank after the other: they write a file of the same name.
    for (unsigned int rank = 0; rank < dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
         ++rank)
    {
      if (rank == dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD))
        files.push_back(parameters_of("subsection left\n" + left + "\nend\nsubsection right\n" +
                                      right + "\nend\nsubsection bottom\nset Type = axis\nend\n" +
                                      "subsection top\nset Type = fixed\nend\n"));
      MPI_Barrier(MPI_COMM_WORLD);
    }
    Material liquid;
    liquid.density = 1.3;
    liquid.shear.viscosity = 0.5;
    liquid.compression = Compression::elastic(0.02);
    problem.model = Model::axisymmetric;
    problem.regions = {"body"};
    problem.materials = {liquid};
    std::set<std::pair<unsigned int, unsigned int>> pairs;
    for (unsigned int b = 0; b < 4; ++b)
      pairs.insert({b, 0});
    problem.conditions =
        read_boundary_conditions(files.back().root(), ends, {"body"}, pairs, 2, true);
    make_uniform<2>(mesh);
    set_flow_profiles(problem.conditions, files.back().root(), mesh, problem.materials,
                      {false, 4., 0.01});
    problem.outlets =
        make_outlets(problem.conditions, files.back().root(), mesh, problem.materials);
    refine<2>(mesh, [](const dealii::Point<2> &x) { return x[1] > 0.3 && x[1] < 0.6; });
    body = std::make_unique<CellWise<2>>(mesh, problem, parameters, log);
    body->setup();
    coupling = std::make_unique<OutletCoupling>(problem, *body);
    coupling->initialise();
    coupling->build();
  }
  template <int dim>
  static void make_uniform(Triangulation<dim> &mesh)
  {
    make_box(mesh, 4);
    for (const auto &cell : mesh.active_cell_iterators())
      cell->set_material_id(0);
  }
  /// The flow out of a condition.
  double flow(const unsigned int condition, const DistributedVector &velocity) const
  {
    return body->ports().flow_of_velocities(condition) * velocity;
  }

  Triangulation<2> mesh;
  Log log;
  Problem problem;
  CellWiseParameters parameters;
  std::unique_ptr<CellWise<2>> body;
  std::unique_ptr<OutletCoupling> coupling;
};

/// One step from rest with a force in the body; `law` of the outlet's pressure and its flow rate is
/// what is left of it.
void check_step(const std::string &name,
                const std::string &left,
                const std::string &right,
                const std::function<double(double, double, const Step &)> &law)
{
  CellTube tube(left, right);
  CellWise<2> &body = *tube.body;
  const Material &liquid = tube.problem.materials.front();
  const Step step = body.variant().adapted(euler_step(0., 0.1, Update::implicit));
  StepReport report;
  const double compressibility = liquid.inverse_bulk_modulus() / step.pressure_time;
  body.system().prepare({{step.a0 * liquid.density}, {liquid.shear.viscosity}, {compressibility}},
                        step.pressure_time);
  tube.coupling->respond(report);
  DistributedVector force = body.velocity_vector(), velocity = force, prescribed = force;
  DistributedVector pressure = body.pressure_vector(), mass = pressure;
  force = 0.;
  DistributedVector ones = force;
  ones = 0.7;
  body.products().multiply_mass(0, force, ones);
  DistributedVector momentum = force;
  body.prescribed().evaluate(step.balance_time, prescribed);
  tube.coupling->leave_out_ports(prescribed);
  tube.coupling->take_forces(momentum);
  const DistributedVector start = body.velocity_vector();
  body.system().solve(prescribed, momentum, mass, velocity, pressure, report);
  tube.coupling->couple(step, start, velocity, pressure);

  // A U + G p - f + q P, and B U + C p.
  DistributedVector residual = body.velocity_vector(), product = residual;
  body.system().add_velocity_product(velocity, residual);
  body.products().multiply_gradient(0, product, pressure);
  residual.add(1., product);
  const double scale = residual.linfty_norm();
  residual.add(-1., force);
  double worst = 0., reaction = 0.;
  for (unsigned int o = 0; o < tube.problem.outlets.size(); ++o)
  {
    const unsigned int condition = tube.problem.outlets[o].conditions.front();
    const double p = tube.coupling->pressure(o, 0);
    const double q = tube.flow(condition, velocity);
    worst = std::max(worst, std::abs(q - tube.coupling->flow_rate(o, 0)));
    worst = std::max(worst, std::abs(law(p, q, step)) / std::abs(p));
    residual.add(p, body.ports().flow_of_velocities(condition));
    if (tube.problem.outlets[o].coupling == Outlet::Coupling::flow)
    {
      // Of a unit flow with the profile of the section.
      DistributedVector profile = body.ports().flow_profile(condition);
      profile *= 1. / tube.flow(condition, profile);
      reaction = std::abs(profile * residual);
      check::is_true(name + "the profile moves the end alone",
                     std::abs(tube.flow(1 - condition, profile)) < 1e-14);
    }
    check::is_true(name + "something flows", std::abs(q) > 1e-3);
  }
  DistributedVector mass_residual = body.pressure_vector(), compressed = mass_residual;
  body.system().add_divergence(velocity, mass_residual);
  body.system().add_flux_correction(pressure, mass_residual);
  body.products().multiply_pressure_mass(0, compressed, pressure);
  mass_residual.add(compressibility, compressed);
  body.system().restrict_residuals(residual, mass_residual);
  check::absolute(name + "the body's equations", residual.linfty_norm() / scale, 0., 1e-11);
  check::absolute(name + "the body's volume", mass_residual.linfty_norm(), 0., 1e-11);
  check::absolute(name + "virtual power of the profile", reaction / scale, 0., 1e-11);
  check::absolute(name + "the outlet's law", worst, 0., 1e-11);
}
} // namespace

UNIT_TEST(cell_wise_outlets)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  quiet_other_ranks();
  const std::string inlet = "set Type = free";
  const auto resistance = [](const double p, const double q, const Step &)
  { return p - 5. - 7. * q; };
  // x = C (4 - 1.5) at the start; dx/dt = Q - x/(R_d C) by Euler.
  const auto store = [](const double p, const double q, const Step &step)
  {
    const double h = step.size(), x = (0.02 * 2.5 + h * q) / (1. + h / (40. * 0.02));
    return p - 1.5 - 3. * q - x / 0.02;
  };
  check_step("resistance: ", inlet, resistor, resistance);
  check_step("resistance, flow: ", inlet, resistor + by_flow, resistance);
  check_step("windkessel: ", inlet, windkessel, store);
  check_step("windkessel, flow: ", inlet, windkessel + by_flow, store);
}
} // namespace test_of_cell_wise_outlets
