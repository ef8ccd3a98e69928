// Free vibrations on hanging nodes, one of the two materials incompressible, beside an inclined
// roller: what any pair of symmetric matrices K and M has.

#include <continua/boundary/boundary_conditions.h>
#include <continua/finite_element/taylor_hood_vibration.h>
#include <continua/linear_algebra/eigenpairs.h>

#include "../parameter_text.h"
#include "../unit_test.h"
#include "small_problem.h"

namespace test_of_taylor_hood_vibration
{
using namespace Continua;
using namespace dealii;

namespace
{
double product(const std::vector<double> &a, const std::vector<double> &b)
{
  double sum = 0.;
  for (std::size_t i = 0; i < a.size(); ++i)
    sum += a[i] * b[i];
  return Utilities::MPI::sum(sum, MPI_COMM_WORLD);
}
} // namespace

UNIT_TEST(taylor_hood_vibration)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  small_problem::quiet_other_ranks();
  small_problem::Mesh<2> mesh(MPI_COMM_WORLD);
  small_problem::make_box<2>(mesh, {4, 2}, Point<2>(), 2.);
  GridTools::rotate(0.4, mesh);
  small_problem::refine<2>(mesh, [](const Point<2> &x) { return x.norm() > 2.; });
  Space<2> space(mesh, SpaceParameters(), Model::plane_strain, 2);
  space.distribute();
  std::vector<RegionOperators> operators(2);
  assemble_region_operators(space, operators);

  Problem problem;
  problem.communicator = MPI_COMM_WORLD;
  problem.materials.resize(2);
  problem.materials[0].density = 2.;
  problem.materials[0].shear.branches = {{3., std::numeric_limits<double>::infinity()}};
  problem.materials[0].compression = Compression::elastic(0.1);
  problem.materials[1].density = 5.;
  problem.materials[1].shear.branches = {{400., std::numeric_limits<double>::infinity()}};
  problem.materials[1].compression = Compression();
  const double mass = 2. * 4. + 5. * 4.; // of the halves, 2 x 2 each

  const std::set<std::pair<unsigned int, unsigned int>> pairs = {{0, 0}, {1, 1}, {2, 0},
                                                                 {2, 1}, {3, 0}, {3, 1}};
  const auto conditions = [&pairs](const std::string &left, const std::string &bottom)
  {
    // One rank after the other, since they write the file in the same folder.
    std::vector<ParameterFile> files;
    for (unsigned int rank = 0; rank < Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD); ++rank)
    {
      if (rank == Utilities::MPI::this_mpi_process(MPI_COMM_WORLD))
        files.push_back(parameters_of(
            "subsection Boundaries\nsubsection left\nset Type = " + left +
            "\nend\nsubsection right\nset Type = free\nend\nsubsection bottom\nset Type = " +
            bottom + "\nend\nsubsection top\nset Type = free\nend\nend\n"));
      MPI_Barrier(MPI_COMM_WORLD);
    }
    return read_boundary_conditions(files.front().root().subsection("Boundaries"),
                                    {"left", "right", "bottom", "top"}, {"one", "two"}, pairs, 2,
                                    false);
  };
  DistributedVector velocity = space.velocity_vector(), displacement = velocity,
                    pressure = space.pressure_vector();
  const VibratingState state{velocity, displacement, pressure};

  {
    const std::vector<BoundaryCondition> free = conditions("free", "free");
    BoundaryConstraints<2> constraints(space, free);
    constraints.build();
    StepSystem<2> system(space, operators, constraints, LinearSolverParameters());
    system.reinit();
    TaylorHoodVibration<2> vibration(space, problem, operators, constraints, system, state);
    const std::vector<unsigned int> directions = vibration.directions();
    const std::vector<double> momentum = vibration.momentum(
        [](const Point<2> &) {
          return Tensor<1, 2>({1., 10.});
        });
    double sums[2] = {0., 0.};
    for (unsigned int i = 0; i < momentum.size(); ++i)
      sums[directions[i]] += momentum[i];
    check::relative("mass along x", Utilities::MPI::sum(sums[0], MPI_COMM_WORLD), mass, 1e-12);
    check::relative("mass along y", Utilities::MPI::sum(sums[1], MPI_COMM_WORLD), 10. * mass,
                    1e-12);
  }

  const std::vector<BoundaryCondition> held = conditions("roller", "fixed");
  BoundaryConstraints<2> constraints(space, held);
  constraints.build();
  StepSystem<2> system(space, operators, constraints, LinearSolverParameters());
  system.reinit();
  TaylorHoodVibration<2> vibration(space, problem, operators, constraints, system, state);
  const unsigned int n = vibration.n_local_unknowns();
  const auto solved = [&](std::vector<double> x)
  {
    vibration.solve(x);
    return x;
  };
  const auto weighed = [&](const std::vector<double> &x)
  {
    std::vector<double> y(n);
    vibration.multiply_mass(x, y);
    return y;
  };
  const std::vector<double> a = vibration.momentum(
      [](const Point<2> &x) {
        return Tensor<1, 2>({std::sin(x[0] + 2. * x[1]), std::cos(3. * x[0] * x[1])});
      });
  const std::vector<double> b = vibration.momentum([](const Point<2> &x) { return x * x[1]; });

  vibration.set_shift(0.);
  const std::vector<double> at_zero = solved(a);
  check::relative("the inverse is symmetric", product(b, at_zero), product(a, solved(b)), 1e-10);
  check::is_true("and positive", product(a, at_zero) > 0.);
  // (K - s M)^-1 - K^-1 = s K^-1 M (K - s M)^-1.
  const double shift = 7.;
  vibration.set_shift(shift);
  std::vector<double> shifted = solved(a);
  vibration.set_shift(0.);
  const std::vector<double> right = solved(weighed(shifted));
  double largest = 0., scale = 0.;
  for (unsigned int i = 0; i < n; ++i)
  {
    largest = std::max(largest, std::abs(shifted[i] - at_zero[i] - shift * right[i]));
    scale = std::max(scale, std::abs(shift * right[i]));
  }
  check::absolute("the resolvents agree",
                  Utilities::MPI::max(largest, MPI_COMM_WORLD) /
                      Utilities::MPI::max(scale, MPI_COMM_WORLD),
                  0., 1e-9);

  const std::vector<Eigenpair> modes = dominant_eigenpairs(
      [&](const std::vector<double> &x, std::vector<double> &y) { y = solved(x); },
      [&](const std::vector<double> &x, std::vector<double> &y) { y = weighed(x); }, n, 2,
      MPI_COMM_WORLD);
  for (const Eigenpair &mode : modes)
  {
    vibration.set_shape(mode.real, 1. / mode.value.real());
    // B u + C p = 0, and twice the elastic energy is omega^2 times the modal mass.
    DistributedVector divergence = space.pressure_vector(), compression = divergence;
    system.add_divergence(1., displacement, divergence);
    const double size = std::max(1e-3, divergence.linfty_norm());
    system.add_compression(pressure, compression);
    const double volume_energy = pressure * compression;
    compression.add(1., divergence);
    space.set_hanging_pressures_to_zero(compression);
    check::absolute("the pressure belongs to the shape", compression.linfty_norm() / size, 0.,
                    1e-8);
    double shear_energy = 0.;
    DistributedVector work = displacement;
    for (unsigned int region = 0; region < 2; ++region)
    {
      multiply(operators[region].stiffness, work, displacement);
      shear_energy += problem.materials[region].long_term_shear_modulus() * (work * displacement);
    }
    check::relative("energy of the shape", shear_energy + volume_energy,
                    product(mode.real, weighed(mode.real)) / mode.value.real(), 1e-9);
    check::absolute("no velocity", velocity.linfty_norm(), 0., 0.);
  }
}
} // namespace test_of_taylor_hood_vibration
