#ifndef continua_finite_element_motion_moving_mesh_h
#define continua_finite_element_motion_moving_mesh_h

#include <continua/base/log.h>
#include <continua/continuum/continuum_solver.h>
#include <continua/continuum/problem.h>
#include <continua/continuum/state.h>
#include <continua/continuum/state_visitor.h>
#include <continua/continuum/step_solution.h>
#include <continua/finite_element/motion/liquid_balance.h>
#include <continua/finite_element/motion/mesh_motion.h>
#include <continua/finite_element/space/space.h>
#include <continua/linear_algebra/distributed_vector.h>

#include <memory>

namespace Continua
{
/// A mesh that moves: its motion, what is said of its quality, and the mass of the liquids on it.
/// What a method does is said in MeshMotion or in NonlinearSystem under the same name.
template <int dim>
class MovingMesh
{
public:
  /// Null where the mesh stays. All must outlive it.
  static std::unique_ptr<MovingMesh>
  make(const Space<dim> &space, const Problem &problem, Log &log);
  MovingMesh(const Space<dim> &space, const Problem &problem, Log &log);

  void reinit(const MeshSolver &solver);
  void begin_step(const Step &step);
  void move(StepSolution &state) { motion.move(state); }
  void set_change(const Step &step,
                  const DistributedVector &of_velocity,
                  DistributedVector &of_mesh_displacement)
  {
    motion.set_change(step, of_velocity, of_mesh_displacement);
  }
  /// Throws StepFailure where the mesh is turned inside out. Collective.
  void check(const StepSolution &state);
  void forget_solver() { motion.forget_solver(); }
  /// Warns once where the mesh has become flat. Collective.
  void finish_step(const StepSolution &solution);
  void start_from(const DistributedVector &displacement) { motion.start_from(displacement); }
  void begin_run() { motion.begin_run(); }
  void visit(StateVisitor &visitor);
  void take_state() { motion.take_state(); }

  /// At the present time [m].
  const DistributedVector &displacement() const { return motion.displacement(); }
  /// Makes a displacement the present one, so that fields are those on that mesh [m].
  void show(const DistributedVector &of_mesh) { motion.show(of_mesh); }
  /// Sets what the extremes have of the mesh.
  void take_extremes(MotionExtremes &extremes) const;
  LiquidMass liquid_mass(const State &state) { return liquid_balance.mass(state); }

private:
  Log &log;
  MeshMotion<dim> motion;
  LiquidBalance<dim> liquid_balance;
  bool warning_was_given = false;
};
} // namespace Continua

#endif
