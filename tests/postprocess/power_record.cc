#include "../unit_test.h"
#include "fake_solver.h"
#include "text_file.h"

#include <continua/base/input_error.h>
#include <continua/postprocess/power_record.h>

namespace test_of_power_record
{
using namespace Continua;

namespace
{
/// A step of 0.5 s from `time`, balanced in its middle.
Step step_from(const double time)
{
  Step step;
  step.time_old = time;
  step.time = time + 0.5;
  step.duration = 0.5;
  step.balance_time = time + 0.25;
  return step;
}

/// Of two materials, the first of which is at rest but for its motion [J].
Energy energy(const double kinetic, const double strain, const double compressive)
{
  return {{{kinetic, 0.}, {0., strain}, {0., 0.}, {0., compressive}}, 0.};
}

/// Sets what the solver says of the n-th step, n = 1, 2, 3, 4, and records it.
void take_step(FakeSolver<2> &solver, PowerRecord<2> &record, const unsigned int n)
{
  const double residuals[] = {0.25, -0.5, 0.25, 0.125};
  const Step step = step_from(0.5 * (n - 1));
  solver.balance = {
      step.balance_time, 8., {{{1., 2., 3., 0.5}}, {{0.25, 0.5, 0.125, 0.5}}}, {}, 0., 0.};
  solver.balance.residual = residuals[n - 1];
  solver.balance.exchanged = 4. * n;
  // The energy is 10 J at the start, then 11, 12, 13, 14 J.
  solver.present_energy = energy(7. + n, 2., 1.);
  record.record(solver, step, n != 3);
}

PowerRecord<2> new_record(FakeSolver<2> &solver)
{
  PowerRecord<2> record(MPI_COMM_WORLD, {"fluid", "wall"});
  solver.present_energy = energy(7., 2., 1.);
  record.start(solver);
  return record;
}
} // namespace

UNIT_TEST(power_record)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    std::cout.setstate(std::ios::failbit); // one rank speaks

  const std::string expected =
      "time [s],balance time [s],external [W],kinetic [W],strain [W],viscous [W],compressive [W],"
      "fluid: kinetic [W],fluid: strain [W],fluid: viscous [W],fluid: compressive [W],"
      "wall: kinetic [W],wall: strain [W],wall: viscous [W],wall: compressive [W],"
      "residual [W],share [1],kinetic energy [J],strain energy [J],compressive energy [J],"
      "work of loads [J],loss of the scheme [J]\n"
      // Of 4.75 W in steps of 0.5 s the energy has risen by 1, 2 and 4 J.
      "0.5,0.25,8,1.25,2.5,3.125,1,1,2,3,0.5,0.25,0.5,0.125,0.5,0.25,0.0625,8,2,1,4,1.375\n"
      "1,0.75,8,1.25,2.5,3.125,1,1,2,3,0.5,0.25,0.5,0.125,0.5,-0.5,-0.0625,9,2,1,8,2.75\n"
      "2,1.75,8,1.25,2.5,3.125,1,1,2,3,0.5,0.25,0.5,0.125,0.5,0.125,0.0078125,11,2,1,16,5.5\n";
  {
    FakeSolver<2> solver;
    PowerRecord<2> record = new_record(solver);
    record.open("power.csv");
    for (unsigned int n = 1; n <= 4; ++n)
      take_step(solver, record, n);
    Summary summary;
    record.finish(solver, summary);
    check::equal("file", read_text("power.csv"), expected);
    // 0.5 W of at most 16 W; the residuals' sum 0.125 W over 0.5 s of at most 14 J; 4 of 10 J.
    check::relative("power residual", quantity(summary, "power residual"), 1. / 32., 1e-14);
    check::relative("energy residual", quantity(summary, "energy residual"), 0.0625 / 14., 1e-14);
    check::relative("energy change", quantity(summary, "total energy change"), 0.4, 1e-14);
    check::relative("work of the loads", quantity(summary, "work of the loads"), 16., 1e-14);
    // What comes last is the wall's: 0.25 W and 0.125 W for 2 s.
    check::relative("wall: kinetic", quantity(summary, "kinetic energy taken", "wall"), 0.5, 1e-14);
    check::relative("wall: dissipated", quantity(summary, "energy dissipated", "wall"), 0.25,
                    1e-14);
    check::relative("fluid: strain", quantity(summary, "strain energy taken", "fluid"), 4., 1e-14);
  }

  // Saved after two steps, run on for a third that is lost, and continued.
  {
    FakeSolver<2> solver;
    PowerRecord<2> record = new_record(solver);
    record.open("restarted.csv");
    take_step(solver, record, 1);
    take_step(solver, record, 2);
    if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    {
      ArchiveWriter archive;
      record.save(archive);
      archive.write("power.archive");
    }
    take_step(solver, record, 4);
    Summary summary;
    record.finish(solver, summary);
  }
  {
    FakeSolver<2> solver;
    PowerRecord<2> record(MPI_COMM_WORLD, {"fluid", "wall"});
    MPI_Barrier(MPI_COMM_WORLD);
    record.load(ArchiveReader("power.archive"));
    record.open("restarted.csv", 1.);
    take_step(solver, record, 3);
    take_step(solver, record, 4);
    Summary summary;
    record.finish(solver, summary);
    check::equal("file after a restart", read_text("restarted.csv"), expected);
    check::relative("energy residual after a restart", quantity(summary, "energy residual"),
                    0.0625 / 14., 1e-14);
    check::relative("energy change after a restart", quantity(summary, "total energy change"), 0.4,
                    1e-14);
    check::relative("fluid: strain after a restart",
                    quantity(summary, "strain energy taken", "fluid"), 4., 1e-14);
  }

  // Two materials, the wall's stresses relax: it is given 0.5 + 0.5 W for 2 s, of which its springs
  // hold 0.25 + 0.5 J at the end and 0.125 + 0.25 J at the start.
  {
    FakeSolver<2> solver;
    solver.present_energy = energy(7., 0.125, 0.25);
    PowerRecord<2> record(MPI_COMM_WORLD, {"fluid", "wall"}, {false, true});
    record.open("relaxing.csv");
    record.start(solver);
    for (unsigned int n = 1; n <= 4; ++n)
    {
      const Step step = step_from(0.5 * (n - 1));
      solver.balance = {
          step.balance_time, 8., {{{1., 2., 3., 0.5}}, {{0.25, 0.5, 0.125, 0.5}}}, {}, 0., 8.};
      solver.balance.materials[1].relaxation = 0.375;
      record.record(solver, step, n == 4);
    }
    solver.present_energy = energy(7., 0.25, 0.5);
    Summary summary;
    record.finish(solver, summary);
    check::equal("file with relaxation", read_text("relaxing.csv"),
                 "time [s],balance time [s],external [W],kinetic [W],strain [W],viscous [W],"
                 "compressive [W],relaxation [W],"
                 "fluid: kinetic [W],fluid: strain [W],fluid: viscous [W],fluid: compressive [W],"
                 "wall: kinetic [W],wall: strain [W],wall: viscous [W],wall: compressive [W],"
                 "wall: relaxation [W],"
                 "residual [W],share [1],kinetic energy [J],strain energy [J],"
                 "compressive energy [J],work of loads [J]\n"
                 "2,1.75,8,1.25,2.5,3.125,1,0.375,1,2,3,0.5,0.25,0.5,0.125,0.5,0.375,"
                 "0,0,7,0.125,0.25,16\n");
    check::relative("energy relaxed", quantity(summary, "energy relaxed", "wall"),
                    2. * 0.5 - 0.125 + 2. * 0.5 - 0.25, 1e-14);
    check::relative("held by the springs", quantity(summary, "strain energy taken", "wall"), 0.125,
                    1e-14);
    check::relative("given to the fluid's", quantity(summary, "strain energy taken", "fluid"), 4.,
                    1e-14);
  }

  // The same where relaxation is known after each step, also after a restart: of what is given,
  // 0.375 W turn into heat and 0.375 J are held.
  {
    FakeSolver<2> solver;
    solver.present_energy = energy(7., 0.125, 0.25);
    const auto new_relaxing = []()
    {
      return PowerRecord<2>(MPI_COMM_WORLD, {"fluid", "wall"}, {false, true}, {}, false,
                            equation_terms(Problem()), true);
    };
    const auto take = [&](PowerRecord<2> &record, const unsigned int n)
    {
      const Step step = step_from(0.5 * (n - 1));
      solver.balance = {
          step.balance_time, 8., {{{1., 2., 3., 0.5}}, {{0.25, 0.5, 0.125, 0.5}}}, {}, 0., 8.};
      solver.balance.materials[1].relaxation = 0.375;
      record.record(solver, step, false);
    };
    PowerRecord<2> first = new_relaxing(), second = new_relaxing();
    first.start(solver);
    take(first, 1);
    take(first, 2);
    if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    {
      ArchiveWriter archive;
      first.save(archive);
      archive.write("relaxing.archive");
    }
    MPI_Barrier(MPI_COMM_WORLD);
    second.load(ArchiveReader("relaxing.archive"));
    take(second, 3);
    take(second, 4);
    solver.present_energy = energy(7., 0.25, 0.5);
    Summary summary;
    second.finish(solver, summary);
    check::relative("loss of the scheme", quantity(summary, "loss of the scheme"),
                    2. * (1. + 2. + 0.5 + 0.25 + 0.5 + 0.5 - 0.375) - 0.375, 1e-14);
  }

  // Two outlets, of which one stores: it is given 3 W for 2 s, of which it keeps 1 W.
  {
    FakeSolver<2> solver;
    solver.present_energy = {{{0.}, {0.}, {0.}, {0.}}, 0.};
    Outlet windkessel, resistance;
    windkessel.name = "artery";
    windkessel.impedance = Impedance::windkessel(1., 2., 3.);
    resistance.name = "vein";
    resistance.impedance = Impedance::resistance(4.);
    const std::vector<Outlet> outlets = {windkessel, resistance};
    {
      PowerRecord<2> record(MPI_COMM_WORLD, {"fluid"}, {}, outlets);
      record.open("outlets.csv");
      record.start(solver);
      for (unsigned int n = 1; n <= 4; ++n)
      {
        const Step step = step_from(0.5 * (n - 1));
        solver.balance = {step.balance_time,    8., {{{1., 2., 0., 0.}}},
                          {{3., 1.}, {2., 0.}}, 0., 8.};
        record.record(solver, step, n == 1);
        if (n == 2 && dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
        {
          ArchiveWriter archive;
          record.save(archive);
          archive.write("outlets.archive");
        }
      }
      Summary summary;
      record.finish(solver, summary);
      check::equal("file with outlets", read_text("outlets.csv"),
                   "time [s],balance time [s],external [W],kinetic [W],strain [W],viscous [W],"
                   "compressive [W],outlet artery: leaving [W],outlet artery: stored [W],"
                   "outlet vein: leaving [W],residual [W],share [1],kinetic energy [J],"
                   "strain energy [J],compressive energy [J],work of loads [J],"
                   "loss of the scheme [J]\n"
                   "0.5,0.25,8,1,2,0,0,3,1,2,0,0,0,0,0,4,1.5\n");
      check::relative("energy left", quantity(summary, "energy left", "artery"), 6., 1e-14);
      check::relative("energy dissipated", quantity(summary, "energy dissipated", "artery"), 4.,
                      1e-14);
      check::relative("energy left by a resistance", quantity(summary, "energy left", "vein"), 4.,
                      1e-14);
    }
    MPI_Barrier(MPI_COMM_WORLD);
    PowerRecord<2> record(MPI_COMM_WORLD, {"fluid"}, {}, outlets);
    record.load(ArchiveReader("outlets.archive"));
    Summary summary;
    record.finish(solver, summary);
    check::relative("energy left before a restart", quantity(summary, "energy left", "artery"), 3.,
                    1e-14);
  }

  // One material, at rest, nothing to compare with.
  {
    FakeSolver<3> solver;
    solver.present_energy = {{{0.}, {0.}, {0.}, {0.}}, 0.};
    PowerRecord<3> record(MPI_COMM_WORLD, {"body"});
    record.open("rest.csv");
    record.start(solver);
    solver.balance.materials = {{{0., 0., 0., 0.}}};
    record.record(solver, step_from(0.), true);
    Summary summary;
    record.finish(solver, summary);
    check::is_true("no quantities at rest", summary.quantities().empty());
    check::equal("file at rest", read_text("rest.csv"),
                 "time [s],balance time [s],external [W],kinetic [W],strain [W],viscous [W],"
                 "compressive [W],residual [W],share [1],kinetic energy [J],strain energy [J],"
                 "compressive energy [J],work of loads [J],loss of the scheme [J]\n"
                 "0.5,0,0,0,0,0,0,0,0,0,0,0,0,0\n");
  }

  check::throws<RunError>(
      "no such folder",
      []() { PowerRecord<2>(MPI_COMM_WORLD, {"body"}).open("no such folder/power.csv"); },
      "no such folder/power.csv");
}
} // namespace test_of_power_record
