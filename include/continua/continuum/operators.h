#ifndef continua_continuum_operators_h
#define continua_continuum_operators_h

#include <continua/continuum/cavities.h>
#include <continua/continuum/continuum_solver.h>
#include <continua/continuum/linear_system.h>
#include <continua/continuum/load_list.h>
#include <continua/continuum/nonlinear_system.h>
#include <continua/continuum/ports.h>
#include <continua/continuum/prescribed_velocities.h>
#include <continua/continuum/products_by_region.h>
#include <continua/continuum/state.h>
#include <continua/continuum/state_archive.h>
#include <continua/continuum/state_vectors.h>
#include <continua/continuum/step_solution.h>
#include <continua/continuum/step_variant.h>
#include <continua/continuum/wall_shear.h>
#include <continua/linear_algebra/distributed_vector.h>

#include <vector>

namespace Continua
{
/**
 * The operators of a discretisation on its present mesh: what the step in time, the ledger and the
 * outlets know of it. With the forces v.( ) on the velocities and the rates q.( ) on the pressures
 * as rows, the equations of a step are, summed over the regions,
 *
 *   rho M dU/dt + S (eta U + sum_k mu_k D_k) + G p + supports = loads
 *   M_p (c p - c p_plus) + B U                     = 0
 *
 * Vectors are the owned entries of velocities, internal displacements and pressures. A
 * discretisation hands out the parts that it has; all but vectors, state and mesh are in parts.
 */
class Operators
{
public:
  virtual ~Operators() = default;

  /// Makes everything anew on the present mesh. Collective.
  virtual void setup() = 0;

  // The parts.
  virtual ProductsByRegion &products() = 0;
  virtual PrescribedVelocities &prescribed() = 0;
  virtual LinearSystem &system() = 0;
  /// Where Newton's iteration makes the steps, else null: then system() is that of the tangent.
  virtual NonlinearSystem *nonlinear() { return nullptr; }
  virtual StepVariant &variant() = 0;
  /// Without the loads that follow the present shape: those are terms of the equations.
  virtual const LoadList &loads() const = 0;
  /// The loads on the cells of one region and on their faces; for discretisations that have forces
  /// at nodes. Made when they are first asked for on a mesh. Collective.
  virtual const LoadList &loads_of(unsigned int /*region*/) { return loads(); }
  virtual Ports &ports() = 0;
  /// Null where the discretisation has none.
  virtual Cavities *cavities() { return nullptr; }
  virtual WallShear *wall_shear() { return nullptr; }

  /// Whether Newton's iteration makes the steps.
  bool is_nonlinear() { return nonlinear() != nullptr; }
  /// Whether a region has terms that are not linear.
  bool is_nonlinear_in(const unsigned int region)
  {
    return is_nonlinear() && nonlinear()->is_in(region);
  }
  /// Whether system() and products() have nothing of a region in a step: all its terms but supports
  /// and loads are those of nonlinear().
  bool has_all_terms_in(const unsigned int region)
  {
    return is_nonlinear_in(region) && nonlinear()->has_all_terms();
  }

  // Vectors.
  /// Zeros.
  virtual DistributedVector velocity_vector() const = 0;
  virtual DistributedVector pressure_vector() const = 0;
  /// Of internal metrics; empty where there are none.
  virtual DistributedVector internal_metric_vector() const { return {}; }
  /// Of vertices of a mesh that move between steps; empty where there are none.
  virtual DistributedVector mesh_vertex_vector() const { return {}; }
  /// Local indices of the entries of each region.
  virtual std::vector<std::vector<unsigned int>> velocity_nodes() const = 0;
  virtual std::vector<std::vector<unsigned int>> pressure_nodes() const = 0;
  /// Local indices of the pressures that no compressible material determines: they follow from the
  /// constraint of constant volume alone.
  virtual std::vector<unsigned int> pressures_without_history() const = 0;
  /// How vectors are numbered on any number of ranks.
  virtual StateNumbering numbering() const = 0;

  // The state, and the discretisation's own part of it.
  /// Sets velocity, displacement and pressure at t = 0 by the problem's interior data.
  virtual void set_initial_state(DistributedVector &velocity,
                                 DistributedVector &displacement,
                                 DistributedVector &pressure) = 0;
  /// Hands over the discretisation's own part of the state.
  virtual void visit(StateVisitor &) {}
  /// The state of t = 0 was set. (Not after a checkpoint is loaded or the mesh has changed: what is
  /// needed then is part of the state.)
  virtual void start_from(const State &) {}
  /// A step begins, as StepVariant::adapted() has made it, from this state. Throws StepFailure.
  virtual void begin_step(const Step &, const State & /*start*/) {}
  /// A step has ended, whose equations held for what is balanced.
  virtual void finish_step(const StepSolution &, const State &) {}
  /// The state was read from a checkpoint.
  virtual void finish_load() {}
  /// See WallPotentials; null where the directions of walls do not need them.
  virtual const DistributedVector *wall_potentials() const { return nullptr; }
  /// Of a mesh that moves, at the present time [m]; null where the mesh stays.
  virtual const DistributedVector *mesh_displacement() const { return nullptr; }
  /// From the mesh to the shape without stress [m]; null where that is the mesh's.
  virtual const DistributedVector *unloaded_displacement() const { return nullptr; }
  virtual void set_unloaded_displacement(const DistributedVector &) {}

  // Change of the mesh, and sizes.
  /// Call when cells are flagged and before the triangulation changes. Collective.
  virtual void prepare_transfer(const StateVectors &vectors) = 0;
  /// Call after setup() on the new mesh; fills the vectors, of the new size, in the same order.
  /// Collective.
  virtual void finish_transfer(const StateVectors &vectors) = 0;
  virtual SolverSizes sizes() const = 0;
};
} // namespace Continua

#endif
