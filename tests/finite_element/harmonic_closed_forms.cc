// Values of motion exp(s t) beside closed forms that the elements represent exactly, on cells some
// of which are divided: a plug of an incompressible liquid before a windkessel, and a bar without
// mass that relaxes, on a spring with a dashpot. At any s, on any number of ranks.

#include <continua/boundary/boundary_conditions.h>
#include <continua/boundary/flow_rates.h>
#include <continua/boundary/outlets.h>
#include <continua/finite_element/taylor_hood.h>

#include "../parameter_text.h"
#include "../unit_test.h"
#include "small_problem.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace test_of_harmonic_closed_forms
{
using namespace Continua;
using namespace dealii;

namespace
{
using Complex = std::complex<double>;

constexpr double length = 3., height = 2.;

/// One region of 3 x 2 cells, two of them divided; it slides along bottom and top.
struct Bar
{
  Bar(const Material &material, const std::string &left, const std::string &right)
      : mesh(MPI_COMM_WORLD), log(MPI_COMM_WORLD)
  {
    static std::vector<ParameterFile> files;
    // One rank after the other: they write a file of the same name.
    for (unsigned int rank = 0; rank < Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD); ++rank)
    {
      if (rank == Utilities::MPI::this_mpi_process(MPI_COMM_WORLD))
        files.push_back(parameters_of("subsection left\n" + left + "\nend\nsubsection right\n" +
                                      right +
                                      "\nend\nsubsection bottom\nset Type = roller\nend\n"
                                      "subsection top\nset Type = roller\nend\n"));
      MPI_Barrier(MPI_COMM_WORLD);
    }
    problem.model = Model::plane_strain;
    problem.regions = {"body"};
    problem.materials = {material};
    small_problem::make_box<2>(mesh, {3, 2});
    problem.conditions =
        read_boundary_conditions(files.back().root(), {"left", "right", "bottom", "top"},
                                 problem.regions, {{0, 0}, {1, 0}, {2, 0}, {3, 0}}, 2, true);
    set_flow_profiles(problem.conditions, files.back().root(), mesh, problem.materials,
                      {true, 0., 0.});
    problem.outlets =
        make_outlets(problem.conditions, files.back().root(), mesh, problem.materials);
    small_problem::refine<2>(mesh, [](const Point<2> &x) { return x[0] > 1. && x[0] < 2.; });
    body = std::make_unique<TaylorHood<2>>(mesh, problem, TaylorHoodParameters(), log);
    body->setup();
    velocity = displacement = body->velocity_vector();
    pressure = body->pressure_vector();
    system = body->harmonic_system({velocity, displacement, pressure, mixtures});
  }

  /// Under all loads of the file.
  HarmonicSolution solution(const Complex s)
  {
    HarmonicLoad load;
    for (const HarmonicLoadSource &source : system->sources())
      load.add(1., system->load_of(source, 0.));
    system->factor(s);
    return system->solve({load})[0];
  }

  /// The largest difference of free displacements from a function of x along x, over its size
  /// there.
  template <typename Function>
  double difference(const HarmonicSolution &solution, const Function &along_x) const
  {
    const std::vector<bool> is_free = system->free_velocities();
    const std::vector<VelocityPlace<2>> places = system->velocity_places();
    double largest = 0., size = 0.;
    for (unsigned int i = 0; i < places.size(); ++i)
    {
      const Complex exact = places[i].component == 0 ? along_x(places[i].point[0]) : Complex(0.);
      size = std::max(size, std::abs(exact));
      if (is_free[i])
        largest = std::max(largest, std::abs(solution.displacement[i] - exact));
    }
    return Utilities::MPI::max(largest, MPI_COMM_WORLD) / Utilities::MPI::max(size, MPI_COMM_WORLD);
  }

  double largest_pressure(const HarmonicSolution &solution) const
  {
    double largest = 0.;
    for (const Complex &value : solution.pressure)
      largest = std::max(largest, std::abs(value));
    return Utilities::MPI::max(largest, MPI_COMM_WORLD);
  }

  parallel::distributed::Triangulation<2> mesh;
  Log log;
  Problem problem;
  std::unique_ptr<TaylorHood<2>> body;
  DistributedVector velocity, displacement, pressure;
  std::vector<DistributedVector> mixtures;
  std::unique_ptr<HarmonicSystem<2>> system;
};

const std::vector<Complex> all_s = {{0., 0.3}, {0., 7.}, {0.4, 2.}, {1.5, 0.}, {-0.3, 4.}};

void plug_before_a_windkessel()
{
  Material liquid;
  liquid.density = 1.3;
  liquid.shear.viscosity = 0.5;
  liquid.compression = Compression::elastic(0.);
  const std::string windkessel = "set Type = windkessel\nset Proximal resistance = 3\n"
                                 "set Distal resistance = 40\nset Compliance = 0.02";
  const auto impedance = [](const Complex s) { return 3. + 40. / (1. + s * 40. * 0.02); };
  // rho L s U = P - Z A U.
  Bar pushed(liquid, "set Type = pressure\nset Pressure = 2", windkessel);
  Bar fed(liquid, "set Type = flow rate\nset Profile = free\nset Flow rate = 5", windkessel);
  for (const Complex s : all_s)
  {
    const Complex velocity = 2. / (1.3 * length * s + impedance(s) * height);
    const HarmonicSolution of_pressure = pushed.solution(s);
    check::absolute("plug: displacement",
                    pushed.difference(of_pressure, [&](double) { return velocity / s; }), 0.,
                    1e-11);
    const Complex outlet = impedance(s) * height * velocity;
    check::absolute("plug: pressure of the port",
                    std::abs(of_pressure.port_pressures[0] / outlet - 1.), 0., 1e-11);
    check::absolute("plug: flow rate of the port",
                    std::abs(of_pressure.port_flow_rates[0] / (height * velocity) - 1.), 0., 1e-11);
    check::relative("plug: largest pressure", pushed.largest_pressure(of_pressure),
                    std::max(2., std::abs(outlet)), 1e-11);

    const HarmonicSolution of_flow = fed.solution(s);
    const Complex given = 5. / height;
    check::absolute("fed plug: displacement",
                    fed.difference(of_flow, [&](double) { return given / s; }), 0., 1e-11);
    const Complex inlet = 1.3 * length * s * given + impedance(s) * 5.;
    check::absolute("fed plug: pressure at the inlet",
                    std::abs(of_flow.port_pressures[1] / inlet - 1.), 0., 1e-11);
  }
}

void bar_on_spring_and_dashpot()
{
  Material solid;
  solid.density = 0.;
  solid.shear.branches = {Branch{5., std::numeric_limits<double>::infinity()}, Branch{3., 0.2}};
  solid.compression = Compression::elastic(0.01);
  Bar bar(solid, "set Type = support\nset Normal stiffness = 2\nset Normal damping = 0.3",
          "set Type = pressure\nset Pressure = 2");
  for (const Complex s : all_s)
  {
    const Complex shear = 5. + 3. * 0.2 * s / (1. + 0.2 * s);
    const Complex modulus = 100. + 4. / 3. * shear;
    const HarmonicSolution solution = bar.solution(s);
    check::absolute("bar: displacement",
                    bar.difference(solution, [&](const double x)
                                   { return -2. / (2. + 0.3 * s) - 2. * x / modulus; }),
                    0., 1e-11);
    // p = -K div u.
    check::relative("bar: pressure", bar.largest_pressure(solution), 100. * std::abs(2. / modulus),
                    1e-11);
  }
}
} // namespace

UNIT_TEST(harmonic_closed_forms)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  small_problem::quiet_other_ranks();
  plug_before_a_windkessel();
  bar_on_spring_and_dashpot();
}
} // namespace test_of_harmonic_closed_forms
