#include <continua/finite_element/motion/moving_mesh.h>

#include <continua/base/input_error.h>

#include <sstream>

namespace Continua
{
using namespace dealii;

namespace
{
/// Of the mesh: below it cells are flat.
constexpr double least_good_volume_ratio = 0.2;
} // namespace

template <int dim>
std::unique_ptr<MovingMesh<dim>>
MovingMesh<dim>::make(const Space<dim> &space, const Problem &problem, Log &log)
{
  return problem.mesh_moves ? std::make_unique<MovingMesh>(space, problem, log) : nullptr;
}

template <int dim>
MovingMesh<dim>::MovingMesh(const Space<dim> &space, const Problem &problem, Log &log)
    : log(log), motion(space, problem), liquid_balance(space, problem)
{
}

template <int dim>
void MovingMesh<dim>::reinit(const MeshSolver &solver)
{
  motion.reinit(solver);
  liquid_balance.reinit();
}

template <int dim>
void MovingMesh<dim>::begin_step(const Step &step)
{
  SectionTimer::Scope scope(log.timer(), "mesh motion");
  motion.begin_step(step);
}

template <int dim>
void MovingMesh<dim>::check(const StepSolution &state)
{
  const MeshQuality quality = motion.quality(state.mesh_displacement);
  if (quality.least_volume_ratio > 0.)
    return;
  std::ostringstream text;
  text << "the mesh is turned inside out " << quality.place
       << ": the ratio of its volume to the undeformed one is " << quality.least_volume_ratio
       << " there; a smaller time step, loads that begin smoothly, Mesh = slides on "
          "a plane boundary along which it moves, another Mesh motion or a coarser mesh beside "
          "what moves help";
  throw StepFailure(text.str());
}

template <int dim>
void MovingMesh<dim>::finish_step(const StepSolution &solution)
{
  motion.finish_step(solution);
  liquid_balance.finish_step(solution);
  const MeshQuality &worst = motion.worst();
  if (worst.least_volume_ratio >= least_good_volume_ratio || warning_was_given)
    return;
  warning_was_given = true;
  std::ostringstream text;
  text << "at t = " << solution.step.time << " s the mesh is compressed " << worst.place
       << (worst.place.empty() ? "to " : " to ") << worst.least_volume_ratio
       << " of its undeformed volume; below " << least_good_volume_ratio
       << " results there lose digits, and at 0 the run ends";
  log.warning(text.str());
}

template <int dim>
void MovingMesh<dim>::visit(StateVisitor &visitor)
{
  motion.visit(visitor);
  liquid_balance.visit(visitor);
}

template <int dim>
void MovingMesh<dim>::take_extremes(MotionExtremes &extremes) const
{
  extremes.mesh_volume_ratio = motion.worst().least_volume_ratio;
  extremes.mesh_volume_time = motion.worst().time;
}

template class MovingMesh<2>;
template class MovingMesh<3>;
} // namespace Continua
