#ifndef continua_finite_volume_vertex_motion_h
#define continua_finite_volume_vertex_motion_h

#include <continua/continuum/problem.h>
#include <continua/continuum/state.h>
#include <continua/continuum/state_visitor.h>
#include <continua/continuum/vector_numbering.h>
#include <continua/finite_volume/linear_reconstruction.h>
#include <continua/finite_volume/vertex_extension.h>
#include <continua/time_integration/step.h>

#include <deal.II/fe/fe_system.h>

#include <array>
#include <string>
#include <vector>

namespace Continua
{
/**
 * The motion of the vertices of a cell-wise mesh, whose places are X + d. A step knows them when it
 * begins. On boundaries whose mesh follows a velocity W, d has the formula by which the step has a
 * displacement from a velocity, D = D_plus + b W. The vertices of a solid go on from its
 * displacement at the start of the step with its velocity there, D + dt U, so that the mesh is
 * behind or before the solid by an amount of the order dt^2, which does not add up. VertexExtension
 * leads from there into the liquids.
 *
 * The displacement of a solid at a vertex is the mean of what its faces there say, with the
 * gradient of their cells along them; where the solid is held that of the faces that are held; far
 * from faces with values of their own that of its cells.
 */
template <int dim>
class VertexMotion
{
public:
  /// All must outlive it.
  VertexMotion(const CellWiseSpace<dim> &space,
               const Problem &problem,
               const LinearReconstruction<dim> &reconstruction);

  /// The undeformed mesh has changed. Collective. Throws RunError.
  void reinit();
  /// Zeros.
  DistributedVector vector() const { return DistributedVector(owned, space.communicator); }
  VectorNumbering numbering() const;

  /// Sets the displacement at the end of a step from the state at its start. Collective.
  void begin_step(const Step &step, const State &start);
  /// Throws StepFailure where the end of the step turns a cell inside out. Collective.
  void check();
  /// A sentence for the log, once, where the mesh is compressed so far that results lose digits;
  /// else empty. `time`: at the end of the step [s].
  std::string finish_step(double time);
  /// Takes the present displacement of the solids for the start. Collective.
  void start_from(const State &state);
  void visit(StateVisitor &visitor);
  /// The state was read: the displacement at the end of the step is the present one.
  void take_state();

  /// Places of the vertices of owned cells and of ghosts at the end of the step that is being made,
  /// else the present ones; at its start; and one step before [m]. Collective.
  VertexPlaces<dim> places() const { return places_at(next); }
  VertexPlaces<dim> places_at_start() const { return places_at(present); }
  VertexPlaces<dim> older_places() const { return places_at(older); }
  /// At the end of the step, with the values of the cells of this rank [m].
  DistributedVector ghosted_displacement() const { return ghosted(next); }
  const dealii::DoFHandler<dim> &dofs() const { return vertex_dofs; }

  /// The least ratio of the volume at a corner of a liquid's cell to the undeformed one, with its
  /// undeformed place: "in the region 'liquid' near (0.1, 0.2) m".
  struct Quality
  {
    double least_volume_ratio = 1.;
    std::string place;
    double time = 0.; ///< [s]
  };
  /// The worst of all steps that have ended; the place is known since the run began or went on.
  const Quality &worst() const { return worst_of_steps; }

private:
  /// What a solid's displacement at a vertex is the mean of, the first kind that there is.
  enum Rank
  {
    held_face,
    own_face,
    cell,
    n_ranks
  };
  struct Part
  {
    std::array<dealii::types::global_dof_index, dim> entries;
    Rank rank;
    Stencil<double> displacement;
  };
  /// An owned entry of d that follows a prescribed motion.
  struct Follower
  {
    unsigned int index; ///< local
    unsigned int condition, component;
    std::array<double, 3> place; ///< undeformed [m]
  };

  const CellWiseSpace<dim> &space;
  const Problem &problem;
  const LinearReconstruction<dim> &reconstruction;
  dealii::FESystem<dim> element; ///< linear, of dim components
  dealii::DoFHandler<dim> vertex_dofs;
  dealii::IndexSet owned, relevant;
  dealii::AffineConstraints<double> hanging;
  VertexExtension<dim> extension;
  std::vector<Part> parts_of_solids;
  std::array<DistributedVector, n_ranks> counts; ///< of the parts of solids, at their entries
  std::vector<bool> is_of_solid, is_held;        ///< owned entries of solids, and those that are 0
  std::vector<Follower> followers;
  DistributedVector next, present, older; ///< d [m]
  DistributedVector solid_motion;         ///< D at the end of the step, as velocities [m]
  Quality last, worst_of_steps;
  bool warning_was_given = false;

  bool is_solid(unsigned int material) const { return problem.materials[material].is_solid(); }
  void find_parts_of_solids();
  void mark_entries();
  void find_followers();
  /// Sets `last` from `next`.
  void measure_quality();
  /// Sets `next` from the displacement of the solids and what the followers have.
  void extend(const std::vector<double> &followed);
  DistributedVector ghosted(const DistributedVector &displacement) const;
  VertexPlaces<dim> places_at(const DistributedVector &displacement) const;
};
} // namespace Continua

#endif
