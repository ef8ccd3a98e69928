#ifndef continua_finite_element_motion_mesh_motion_h
#define continua_finite_element_motion_mesh_motion_h

#include <continua/continuum/kinematics.h>
#include <continua/continuum/problem.h>
#include <continua/continuum/state_visitor.h>
#include <continua/continuum/step_solution.h>
#include <continua/finite_element/assembly/cell_assembly.h>
#include <continua/finite_element/motion/mesh_multigrid.h>
#include <continua/finite_element/space/cell_sums.h>
#include <continua/finite_element/space/quadrature_cells.h>
#include <continua/finite_element/space/space.h>
#include <continua/finite_element/space/values_at_points.h>
#include <continua/finite_element/terms/mesh_stress.h>
#include <continua/linear_algebra/multigrid_solver.h>
#include <continua/linear_algebra/symmetric_factor.h>

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace Continua
{
/// How much a mesh that moves is deformed.
struct MeshQuality
{
  double least_volume_ratio = 1.; ///< J of the mesh at Gauss points and vertices of the liquids [1]
  double time = 0.;               ///< at which the mesh had it [s]
  std::string place;              ///< of the worst cell: "in the region 'liquid' near (0.1, 0.2) m"
};

/// How the motion of a mesh is solved for.
struct MeshSolver
{
  bool is_iterative = false; ///< else by a factor
  /// Of products without a matrix, for quadratic velocities. Without a set there is a matrix.
  std::optional<InstructionSet> instruction_set;
};

/**
 * The motion of the mesh of the liquids, whose places are X + d: d is the displacement D of the
 * solids at their nodes, and is extended into the liquids by the equilibrium of a body that fills
 * them. With k = 1/(volume of the cell times its distance from what moves), on the undeformed mesh,
 *
 *   elastic:       int k ( 2 eps(d) : eps(z) + 2 div d div z ) dV = 0
 *   hyperelastic:  the energy int k (tr C - 2 ln J)/2 dV is least; a step takes one Newton step of
 *                  it, linearised where the step starts, its residual included, so that d is linear
 *                  in D within the step
 *
 * so that small cells and those at the solids keep their shape (Stein, Tezduyar, Benney 2003 have
 * the stiffening by the volume, Jasak and Tukovic 2007 that by the distance). By the volume alone
 * equal cells at the tip of a beam are turned inside out where the tip moves by four of them. The
 * mesh velocity W follows from d by the very formula by which the step has D from U: D = D_plus + b
 * U. On boundaries whose mesh follows a velocity it is the other way round: d has there the D_plus
 * of its own past and W is what is given.
 *
 * The operator has a factor, or, where the equations of the step have an iterative solver, a
 * MeshMultigrid or a MultigridSolver. What that leaves of d is a difference of shape far below the
 * step's own errors; a change of d is solved for by itself, so that differences of residuals do not
 * amplify it.
 */
template <int dim>
class MeshMotion
{
public:
  /// Both must outlive it.
  MeshMotion(const Space<dim> &space, const Problem &problem);

  /// The undeformed mesh has changed. Collective. Throws RunError.
  void reinit(const MeshSolver &solver);
  /// A step begins from the present state. Collective. Throws RunError.
  void begin_step(const Step &step);
  /// Sets the displacement [m] and the velocity [m/s] of the mesh at the level that a step
  /// balances, from the displacement of the solids there. Collective. A step that finds the
  /// unloaded shape leaves the mesh where it is.
  void move(StepSolution &state);
  /// Sets what a change of velocity [m/s], with that of the displacement which follows in a step,
  /// does to the displacement of the mesh [m]. Collective.
  void set_change(const Step &step,
                  const DistributedVector &of_velocity,
                  DistributedVector &of_mesh_displacement);
  /// The next step goes on as a restart from here would.
  void forget_solver();
  /// A step has ended. Collective.
  void finish_step(const StepSolution &step_solution);
  /// Takes the present displacement of the solids for the start [m]. Collective.
  void start_from(const DistributedVector &displacement);
  /// The run begins at the present shape: steps before it, to find that shape or a mesh, do not
  /// count. Collective.
  void begin_run() { worst_of_steps = quality(present); }
  /// Hands over the part of the state.
  void visit(StateVisitor &visitor);
  /// That part was read from a checkpoint or carried over to another mesh. Collective.
  void take_state();

  /// At the present time [m].
  const DistributedVector &displacement() const { return present; }
  /// Makes a displacement the present one [m].
  void show(const DistributedVector &displacement) { present = displacement; }
  /// Of a displacement of the mesh [m]. Collective.
  MeshQuality quality(const DistributedVector &mesh_displacement);
  /// The worst of the run's start and of all steps that have ended; the place is known since the
  /// run began or went on.
  const MeshQuality &worst() const { return worst_of_steps; }

private:
  using Cell = QuadratureCell<dim>;

  const Space<dim> &space;
  const Problem &problem;
  const MeshMotionKind kind;
  QuadratureCells<dim> cells;
  /// The vertices of the reference cell, as a quadrature.
  QuadratureCells<dim> corners;
  ValuesAtPoints<dim> displacement_at_points, displacement_at_corners;
  CellAssembly<dim> assembly;
  dealii::AffineConstraints<double> constraints; ///< of the mesh, homogeneous
  std::vector<bool> is_of_solid;                 ///< whether an owned entry of d is that of D
  /// An owned entry of d that follows a prescribed motion.
  struct Follower
  {
    unsigned int index; ///< local
    unsigned int condition, component;
    std::array<double, 3> place; ///< undeformed [m]
  };
  std::vector<Follower> followers;
  std::vector<double> followed;  ///< their d at the level of the step [m]
  std::vector<double> stiffness; ///< k of each cell
  std::unique_ptr<SymmetricFactor> factor;
  // One of them in the place of the factor, else null.
  std::unique_ptr<MultigridSolver> multigrid;
  std::unique_ptr<MeshMultigrid<dim>> without_matrix;
  DistributedVector last_extension; ///< of the iterative solver in this step
  DistributedVector change_rows;    ///< its work space
  DistributedVector present, older; ///< d [m]
  DistributedVector predicted;      ///< of the present step [m]
  DistributedVector known, ghosted, right_side, work;
  std::vector<double> packed;
  std::vector<int> owned;
  bool is_linearised = false;
  MeshQuality last, worst_of_steps;
  /// By cell: its operator at the start of the step, if it has nodes whose motion is known, else
  /// empty.
  std::vector<dealii::FullMatrix<double>> matrices;
  std::vector<bool> has_known; ///< whether a cell has such nodes
  dealii::Vector<double> cell_displacement, cell_rows;
  CellSums sums; ///< of these rows

  void set_constraints();
  /// Finds the entries of owned nodes on boundaries that the mesh follows, but for those of solids.
  void find_followers();
  /// Finds the cells with motion that is known.
  void find_known();
  /// Makes the operator at the present displacement, its factor, and the residual there.
  void linearise();
  bool is_iterative() const { return multigrid != nullptr || without_matrix != nullptr; }
  void make_multigrid();
  void make_products(InstructionSet instruction_set);
  void
  solve_iteratively(DistributedVector &solution, const DistributedVector &rows, double tolerance);
  /// Sets k.
  void set_stiffness();
  /// Sets the matrix of a cell at its displacement, and cell_rows to less its residual.
  void integrate(const Cell &cell, double cell_stiffness, dealii::FullMatrix<double> &matrix);
  /// Sets d to that at the start of the step and what follows of the change of D.
  void extend(const DistributedVector &solid_displacement, DistributedVector &mesh_displacement);
  void solve_by_factor(DistributedVector &rows);
  /// The rows of what is constrained, and those of a cell.
  void begin_triplets(SymmetricTriplets &triplets) const;
  void add_triplets(const Cell &cell,
                    const dealii::FullMatrix<double> &matrix,
                    SymmetricTriplets &triplets) const;
  /// Takes the operator's product with `known` from rows, in which hanging nodes are condensed.
  void subtract_known(DistributedVector &rows);
  void subtract_known_by_matrices(DistributedVector &rows);
};
} // namespace Continua

#endif
