#include <continua/continuum/steady_solve.h>

#include <continua/base/input_error.h>
#include <continua/continuum/step_extremes.h>
#include <continua/continuum/system_coefficients.h>

#include <algorithm>
#include <cmath>

namespace Continua
{
namespace
{
bool has_branches(const Material &material)
{
  return !material.shear.branches.empty();
}
} // namespace

SteadySolve::SteadySolve(const Problem &problem,
                         Operators &operators,
                         OutletCoupling &outlets,
                         StepRightSide &right_side,
                         Log &log)
    : problem(problem), operators(operators), outlets(outlets), right_side(right_side), log(log)
{
}

bool SteadySolve::applies() const
{
  const std::vector<Material> &materials = problem.materials;
  return !operators.is_nonlinear() &&
         (std::all_of(materials.begin(), materials.end(), has_branches) ||
          std::none_of(materials.begin(), materials.end(), has_branches));
}

bool SteadySolve::is_of_solids() const
{
  return has_branches(problem.materials.front());
}

void SteadySolve::solve(const double time,
                        DistributedVector &solved,
                        DistributedVector &pressure,
                        StepSolution &solution)
{
  AssertThrow(applies(), dealii::ExcInternalError());
  const bool flows = !is_of_solids();
  StepReport report;
  SystemCoefficients coefficients;
  {
    SectionTimer::Scope scope(log.timer(), "factor");
    coefficients.set_steady(problem);
    if (operators.system().prepare(coefficients, 1.) != SystemChange::none && flows)
      outlets.respond(report);
  }
  DistributedVector &momentum = right_side.momentum(), &mass = right_side.mass();
  momentum = 0.;
  mass = 0.;
  operators.loads().add(time, momentum);
  outlets.take_forces(momentum);
  solution.prescribed = 0.;
  // A solid at rest has no velocity to prescribe: its supports hold.
  if (flows && !operators.prescribed().is_homogeneous())
  {
    solution.prescribed.equ(1., right_side.prescribed_at(time));
    operators.system().eliminate_prescribed(solution.prescribed, momentum, mass);
  }
  {
    SectionTimer::Scope scope(log.timer(), "solve");
    solved = 0.;
    operators.system().solve(solution.prescribed, momentum, mass, solved, pressure, report);
  }
  // Nothing flows out of a solid at rest.
  if (flows)
    outlets.couple_steady(time, solved, pressure);
  if (!std::isfinite(solved.linfty_norm()))
    throw RunError("the steady solution is not finite" +
                   reason_not_finite(solved.get_mpi_communicator()));
}
} // namespace Continua
