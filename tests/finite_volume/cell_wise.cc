// What the cell-wise discretisation does beside its tested parts: the pressure's own update in a
// step, by the formulas of the rules.

#include <continua/finite_volume/cell_wise.h>

#include "cell_wise_step.h"

#include "../unit_test.h"

namespace test_of_cell_wise
{
namespace
{
using namespace cell_wise_meshes;
constexpr double h = 0.2;

/// p = p_plus - K b div U; the weights of p_plus and b.
void check_update(const std::string &name,
                  const PressureUpdate update,
                  const Step &step,
                  const double pressure_time,
                  const double old,
                  const double older,
                  const bool with_old_divergence)
{
  CellWiseParameters parameters;
  parameters.pressure_update = update;
  CellWiseStep<2> body([](Triangulation<2> &mesh) { make_uniform_box(mesh, 2); },
                       Model::plane_strain);
  Log log(MPI_COMM_WORLD);
  CellWise<2> cell_wise(body.triangulation, body.problem, parameters, log);
  const Step own = cell_wise.variant().adapted(step);
  check::relative(name + ": time of the pressure", own.pressure_time, pressure_time, 1e-14);
  check::absolute(name + ": pressure at the start", own.pressure_old, old, 1e-14);
  check::absolute(name + ": pressure before", own.pressure_older, older, 1e-14);
  check::is_true(name + ": dilatation at the start", own.divergence_old == with_old_divergence);
  check::is_true(name + ": the velocity's rule stays",
                 own.a0 == step.a0 && own.a1 == step.a1 && own.a2 == step.a2);
}
} // namespace

UNIT_TEST(cell_wise)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  quiet_other_ranks();
  const Step euler = euler_step(0., h, Update::implicit);
  const Step trapezoidal = euler_step(0., h, Update::trapezoidal);
  const Step backward = backward_differencing_step(h, h, h, Update::implicit);
  const Step crank_nicolson = crank_nicolson_step(0., h);
  // dp/dt = -K div U by the mean of both velocities, by the new one, and by three levels.
  check_update("trapezoidal", PressureUpdate::trapezoidal, euler, 0.5 * h, 1., 0., true);
  check_update("euler", PressureUpdate::euler, trapezoidal, h, 1., 0., false);
  check_update("euler, three levels", PressureUpdate::euler, backward, h, 1., 0., false);
  check_update("as the displacement, trapezoidal", PressureUpdate::as_displacement, trapezoidal,
               0.5 * h, 1., 0., true);
  check_update("as the displacement, three levels", PressureUpdate::as_displacement, backward,
               2. * h / 3., 4. / 3., -1. / 3., false);
  check_update("crank-nicolson", PressureUpdate::euler, crank_nicolson, 0.5 * h, 1., 0., false);
}
} // namespace test_of_cell_wise
