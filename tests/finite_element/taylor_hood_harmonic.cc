// Motion exp(s t) obeys the equations of the body with those of its outlets, at hanging nodes, with
// prescribed velocities, for any s and on any number of ranks; the determinant is that of these
// equations. Products and matrix share the coefficients and the impedances of the ports, so that
// their values are not tested here, but by harmonic_closed_forms.cc and tests/tiny_runs/harmonic_*.

#include <continua/base/input_error.h>
#include <continua/base/undefined.h>
#include <continua/boundary/boundary_conditions.h>
#include <continua/boundary/flow_rates.h>
#include <continua/boundary/outlets.h>
#include <continua/finite_element/taylor_hood.h>

#include "../parameter_text.h"
#include "../unit_test.h"
#include "small_problem.h"

#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace test_of_taylor_hood_harmonic
{
using namespace Continua;
using namespace dealii;

namespace
{
using Complex = std::complex<double>;
using Numbers = std::vector<Complex>;

/// An axisymmetric liquid below a solid that relaxes, some cells divided, before a windkessel.
struct Body
{
  explicit Body(const std::string &left) : mesh(MPI_COMM_WORLD), log(MPI_COMM_WORLD)
  {
    static std::vector<ParameterFile> files;
    // One rank after the other: they write a file of the same name.
    for (unsigned int rank = 0; rank < Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD); ++rank)
    {
      if (rank == Utilities::MPI::this_mpi_process(MPI_COMM_WORLD))
        files.push_back(parameters_of(
            "subsection left\n" + left +
            "\nend\nsubsection right\nset Type = windkessel\nset Proximal resistance = 3\n"
            "set Distal resistance = 40\nset Compliance = 0.02\nset Region = liquid\nend\n"
            "subsection right of the wall\nset Boundary = right\nset Region = wall\n"
            "set Type = free\nend\nsubsection bottom\nset Type = axis\nend\n"
            "subsection top\nset Type = support\nset Normal stiffness = 2\n"
            "set Normal damping = 0.3\nend\n"));
      MPI_Barrier(MPI_COMM_WORLD);
    }
    Material liquid, wall;
    liquid.density = 1.3;
    liquid.shear.viscosity = 0.5;
    liquid.compression = Compression::elastic(0.02);
    wall.density = 1.1;
    wall.shear.branches = {Branch{5., std::numeric_limits<double>::infinity()}, Branch{3., 0.2}};
    wall.compression = Compression::elastic(0.01);
    problem.model = Model::axisymmetric;
    problem.regions = {"liquid", "wall"};
    problem.materials = {liquid, wall};
    small_problem::make_box<2>(mesh, {2, 3});
    for (const auto &cell : mesh.active_cell_iterators())
      cell->set_material_id(cell->center()[1] > 2. ? 1 : 0);
    problem.conditions = read_boundary_conditions(
        files.back().root(), {"left", "right", "bottom", "top"}, problem.regions,
        {{0, 0}, {0, 1}, {1, 0}, {1, 1}, {2, 0}, {3, 1}}, 2, true);
    set_flow_profiles(problem.conditions, files.back().root(), mesh, problem.materials,
                      {true, 0., 0.});
    problem.outlets =
        make_outlets(problem.conditions, files.back().root(), mesh, problem.materials);
    small_problem::refine<2>(mesh, [](const Point<2> &x) { return x[1] > 1. && x[1] < 2.; });
    body = std::make_unique<TaylorHood<2>>(mesh, problem, TaylorHoodParameters(), log);
    body->setup();
    velocity = displacement = body->velocity_vector();
    pressure = body->pressure_vector();
    system = body->harmonic_system({velocity, displacement, pressure, mixtures});
  }

  parallel::distributed::Triangulation<2> mesh;
  Log log;
  Problem problem;
  std::unique_ptr<TaylorHood<2>> body;
  DistributedVector velocity, displacement, pressure;
  std::vector<DistributedVector> mixtures;
  std::unique_ptr<HarmonicSystem<2>> system;
};

double size_of(const Numbers &numbers)
{
  double largest = 0.;
  for (const Complex &number : numbers)
    largest = std::max(largest, std::abs(number));
  return Utilities::MPI::max(largest, MPI_COMM_WORLD);
}

/// What the equations leave at free entries, with the loads, relative to the forces.
double
residual(Body &tested, const Complex s, const HarmonicSolution &solution, const HarmonicLoad &load)
{
  Numbers forces, dilatations;
  tested.system->multiply(s, solution, forces, dilatations);
  const double scale = size_of(load.forces) + size_of(solution.pressure);
  const std::vector<bool> is_free = tested.system->free_velocities();
  for (std::size_t i = 0; i < forces.size(); ++i)
    forces[i] -= is_free[i] && !load.forces.empty() ? load.forces[i] : 0.;
  return std::max(size_of(forces) / scale, size_of(dilatations));
}

HarmonicLoad all_loads(Body &tested)
{
  HarmonicLoad total;
  double phase = 0.;
  for (const HarmonicLoadSource &source : tested.system->sources())
    total.add(std::polar(1., phase += 0.7), tested.system->load_of(source, 0.));
  return total;
}

/// The logarithm of the determinant of the equations of the free entries.
Complex log_determinant(Body &tested, const Complex s)
{
  HarmonicSystem<2> &system = *tested.system;
  const std::vector<bool> is_free = system.free_velocities();
  std::vector<unsigned int> rows;
  for (unsigned int i = 0; i < is_free.size(); ++i)
    if (is_free[i])
      rows.push_back(i);
  const unsigned int n_free = rows.size(), n_u = is_free.size();
  HarmonicSolution one;
  one.port_pressures.resize(system.ports().size());
  std::vector<Numbers> columns, flows;
  const auto add = [&]()
  {
    Numbers forces, dilatations, column;
    system.multiply(s, one, forces, dilatations);
    for (const unsigned int row : rows)
      column.push_back(forces[row]);
    column.insert(column.end(), dilatations.begin(), dilatations.end());
    // What moves through a port is the transpose of the force of its pressure.
    for (const Numbers &flow : flows)
    {
      Complex through = 0.;
      for (unsigned int i = 0; i < flow.size() && !one.displacement.empty(); ++i)
        through += flow[i] * one.displacement[i];
      column.push_back(through);
    }
    columns.push_back(column);
  };
  one.displacement.assign(n_u, 0.);
  one.pressure.assign(system.n_local_pressures(), 0.);
  for (unsigned int port = 0; port < system.ports().size(); ++port)
    if (tested.problem.conditions[system.ports()[port]].free_flow)
    {
      Numbers forces, dilatations;
      one.port_pressures[port] = 1.;
      system.multiply(s, one, forces, dilatations);
      one.port_pressures[port] = 0.;
      flows.push_back(forces);
    }
  one.pressure.assign(system.n_local_pressures(), 0.);
  for (const unsigned int row : rows)
  {
    one.displacement.assign(n_u, 0.);
    one.displacement[row] = 1.;
    add();
  }
  one.displacement.assign(n_u, 0.);
  for (unsigned int k = 0; k < system.n_local_pressures(); ++k)
  {
    one.pressure.assign(system.n_local_pressures(), 0.);
    one.pressure[k] = 1.;
    add();
  }
  one.pressure.assign(system.n_local_pressures(), 0.);
  for (unsigned int port = 0; port < system.ports().size(); ++port)
    if (tested.problem.conditions[system.ports()[port]].free_flow)
    {
      one.port_pressures[port] = 1.;
      add();
      one.port_pressures[port] = 0.;
    }
  // Hanging pressures have no equation.
  std::vector<unsigned int> kept;
  for (unsigned int k = 0; k < columns.size(); ++k)
    if (k < n_free || size_of(columns[k]) > 0.)
      kept.push_back(k);
  LAPACKFullMatrix<Complex> matrix(kept.size(), kept.size());
  for (unsigned int i = 0; i < kept.size(); ++i)
    for (unsigned int j = 0; j < kept.size(); ++j)
      matrix.set(i, j, columns[kept[j]][kept[i]]);
  matrix.compute_lu_factorization();
  return std::log(matrix.determinant());
}
} // namespace

UNIT_TEST(taylor_hood_harmonic)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) > 0)
    std::cout.setstate(std::ios::failbit); // rank 0 alone prints
  const std::vector<Complex> all_s = {{0., 0.3}, {0., 7.}, {0.4, 2.}, {1.5, 0.}};

  const std::string free_flow_rate =
      "set Region = liquid\nset Type = flow rate\nset Profile = free\nset Flow rate = 2\nend\n"
      "subsection left of the wall\nset Boundary = left\nset Region = wall\nset Type = fixed";
  for (const std::string &left :
       {std::string("set Type = pressure\nset Pressure = 2\nset Tangential = fixed"),
        std::string("set Type = velocity\nset Velocity = 0.5, 0"), free_flow_rate})
  {
    const std::string name = left == free_flow_rate                       ? "flow rate"
                             : left.find("pressure") != std::string::npos ? "pressure"
                                                                          : "velocity";
    Body tested(left);
    // The mesh is as far on one side of x = 1 as on the other.
    double moment = 0., n_beyond = 0.;
    for (const VelocityPlace<2> &place : tested.system->velocity_places())
    {
      moment += place.point[0] - 1.;
      n_beyond += place.point[0] > 1. + 1e-9 && place.component == 1 ? 1. : 0.;
    }
    check::absolute(name + ": places", Utilities::MPI::sum(moment, MPI_COMM_WORLD), 0., 1e-12);
    check::is_true(name + ": places beyond the middle",
                   Utilities::MPI::sum(n_beyond, MPI_COMM_WORLD) > 10.);
    const HarmonicLoad load = all_loads(tested);
    HarmonicLoad twice;
    twice.add({0., 2.}, load);
    double largest = 0., difference = 0., imbalance = 0.;
    std::vector<HarmonicSolution> one_by_one;
    for (const Complex s : all_s)
    {
      tested.system->factor(s);
      const std::vector<HarmonicSolution> solutions = tested.system->solve({load, twice});
      largest = std::max(largest, residual(tested, s, solutions[0], load));
      HarmonicSolution rest = solutions[1];
      rest.add({0., -2.}, solutions[0]);
      difference =
          std::max(difference, size_of(rest.displacement) / size_of(solutions[0].displacement));
      if (s.real() == 0.)
      {
        const HarmonicPowers powers = tested.system->powers(solutions[0], load);
        imbalance = std::max(imbalance, std::abs(powers.given() - powers.taken()) / powers.taken());
      }
      one_by_one.push_back(solutions[0]);
    }
    check::is_true(name + ": something moves", size_of(one_by_one[0].displacement) > 1e-3);
    check::absolute(name + ": the equations", largest, 0., 1e-12);
    check::absolute(name + ": twice the load, a quarter of a period ahead", difference, 0., 1e-13);
    check::absolute(name + ": mean powers", imbalance, 0., 1e-12);

    HarmonicLoad no_number = load;
    no_number.forces.assign(tested.system->n_local_velocities(), undefined);
    check::throws<RunError>(
        name + ": what is no number is no solution", [&] { tested.system->solve({no_number}); },
        "at s = 1.5 \\+ 0 i 1/s the solver leaves values that are no numbers");

    double side_by_side = 0.;
    std::size_t n_seen = 0;
    tested.system->solve_at(
        all_s, [&](std::size_t) { return std::vector<HarmonicLoad>{load}; },
        [&](const std::size_t number, const std::vector<HarmonicLoad> &,
            const std::vector<HarmonicSolution> &solutions)
        {
          HarmonicSolution rest = solutions[0];
          rest.add(-1., one_by_one[number]);
          side_by_side = std::max(side_by_side, size_of(rest.displacement) /
                                                    size_of(one_by_one[number].displacement));
          n_seen += number == n_seen ? 1 : 0;
        });
    check::is_true(name + ": side by side, all in their order", n_seen == all_s.size());
    check::absolute(name + ": side by side, the same", side_by_side, 0., 1e-12);

    // What is shown at a phase, and the mixture of which the stress is made.
    const HarmonicSolution &shown = one_by_one[1];
    tested.system->show(shown, std::polar(1., 0.8));
    double misfit = 0.;
    const Complex modulus = tested.problem.materials[1].complex_shear_modulus({shown.s.imag(), 0.});
    for (unsigned int i = 0; i < shown.displacement.size(); ++i)
    {
      const Complex turned = std::polar(1., 0.8) * shown.displacement[i];
      misfit = std::max({misfit, std::abs(tested.displacement.begin()[i] - turned.real()),
                         std::abs(tested.velocity.begin()[i] - (shown.s * turned).real()),
                         std::abs(tested.mixtures[1].begin()[i] - (modulus * turned).real())});
    }
    check::absolute(name + ": what is shown", Utilities::MPI::max(misfit, MPI_COMM_WORLD), 0.,
                    1e-14);

    if (Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) > 1)
      continue;
    std::vector<Complex> ratios;
    for (const Complex s : all_s)
    {
      tested.system->factor(s);
      ratios.push_back(
          std::exp(tested.system->determinant().logarithm - log_determinant(tested, s)));
    }
    double spread = 0.;
    for (const Complex &ratio : ratios)
      spread = std::max(spread, std::abs(ratio / ratios[0] - 1.));
    check::absolute(name + ": determinant", spread, 0., 1e-9);
  }
}
} // namespace test_of_taylor_hood_harmonic
