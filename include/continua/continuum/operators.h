#ifndef continua_continuum_operators_h
#define continua_continuum_operators_h

#include <continua/base/archive.h>
#include <continua/continuum/balanced_step.h>
#include <continua/continuum/continuum_solver.h>
#include <continua/continuum/load_list.h>
#include <continua/continuum/nonlinear_terms.h>
#include <continua/continuum/state.h>
#include <continua/continuum/state_archive.h>
#include <continua/continuum/state_vectors.h>
#include <continua/continuum/system_coefficients.h>
#include <continua/linear_algebra/distributed_vector.h>

#include <string>
#include <vector>

namespace Continua
{
/// What preparing a step's system has changed.
enum class SystemChange
{
  none,         ///< the coefficients are those of the last step
  coefficients, ///< other coefficients, for which a factor was kept
  factor        ///< a factor or a preconditioner was made
};

/// Sizes of the terms that cancel in a residual.
struct ResidualScales
{
  double momentum = 0.; ///< [N]
  double mass = 0.;     ///< [m^3/s]
};

/**
 * The operators of a discretisation on its present mesh: what the step in time, the ledger and the
 * outlets know of it. With the forces v.( ) on the velocities and the rates q.( ) on the pressures
 * as rows, the equations of a step are, summed over the regions,
 *
 *   rho M dU/dt + S (eta U + sum_k mu_k D_k) + G p + supports = loads
 *   M_p (c p - c p_plus) + B U                     = 0
 *
 * with M, S, G, B and M_p of one region each, free of moduli and of the time step. Vectors are the
 * owned entries of velocities, internal displacements and pressures. Products overwrite their
 * target. Vectors, products, loads, the system and the transfer are collective; functions that give
 * this rank's part say so.
 *
 * A discretisation that needs more than these products in a step has hooks for it at the end. Their
 * defaults are the step without anything of its own.
 */
class Operators
{
public:
  virtual ~Operators() = default;

  /// Makes everything anew on the present mesh.
  virtual void setup() = 0;

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

  // Products with the matrices of a region.
  /// M U [kg m/s over density].
  virtual void multiply_mass(unsigned int region,
                             DistributedVector &momentum,
                             const DistributedVector &velocity) = 0;
  /// S w: minus the forces of the stress 2 dev sym grad w [N for Pa m].
  virtual void multiply_stiffness(unsigned int region,
                                  DistributedVector &force,
                                  const DistributedVector &mixture) = 0;
  /// Whether the linear terms of a region are these two products, B U and G p, and nothing else, so
  /// that products of sums may be sums of products.
  virtual bool has_level_products() const { return false; }
  /// Sets M v, S v and S w at once, of a velocity and a displacement; null targets are left out.
  virtual void multiply_levels(unsigned int region,
                               const DistributedVector &velocity,
                               const DistributedVector &displacement,
                               DistributedVector *mass_of_velocity,
                               DistributedVector *stiffness_of_velocity,
                               DistributedVector *stiffness_of_displacement);
  /// G p: minus the forces of the pressure [N].
  virtual void multiply_gradient(unsigned int region,
                                 DistributedVector &force,
                                 const DistributedVector &pressure) = 0;
  /// B U: the rate of dilatation, weakly [m^3/s].
  virtual void multiply_divergence(unsigned int region,
                                   DistributedVector &rate,
                                   const DistributedVector &velocity) = 0;
  /// M_p p [Pa m^3].
  virtual void multiply_pressure_mass(unsigned int region,
                                      DistributedVector &product,
                                      const DistributedVector &pressure) = 0;
  /// Minus the forces by which what is around a region pushes back, of a displacement and of a
  /// velocity [N]. For discretisations that have supports, with Problem::has_supports().
  virtual void multiply_support_stiffness(unsigned int region,
                                          DistributedVector &force,
                                          const DistributedVector &displacement);
  virtual void multiply_support_damping(unsigned int region,
                                        DistributedVector &force,
                                        const DistributedVector &velocity);
  /// This rank's part of U . G p [W].
  virtual double pressure_power(unsigned int region,
                                const DistributedVector &velocity,
                                const DistributedVector &pressure) = 0;
  /// This rank's part of the integral of p q over the region [Pa^2 m^3].
  virtual double
  pressure_product(unsigned int region, const DistributedVector &p, const DistributedVector &q) = 0;
  /// Largest |div U| weakly (|B U| over M_p) [1/s].
  virtual double divergence(const DistributedVector &velocity) = 0;

  // Loads and prescribed velocities.
  /// Without the loads that follow the present shape: those are terms of the equations.
  virtual const LoadList &loads() const = 0;
  /// The loads on the cells of one region and on their faces; for discretisations that have forces
  /// at nodes. Made when they are first asked for on a mesh. Collective.
  virtual const LoadList &loads_of(unsigned int /*region*/) { return loads(); }
  /// Whether a prescribed velocity jumps between the two times [s].
  virtual bool prescribed_velocity_jumps(double begin, double end) const = 0;
  /// Whether every prescribed velocity is zero for ever.
  virtual bool is_homogeneous() const = 0;
  /// The prescribed velocities at this time, 0 elsewhere [m/s]; `values` keeps what does not depend
  /// on time.
  virtual void evaluate_prescribed(double time, DistributedVector &values) const = 0;
  /// What a velocity that obeys the conditions has in the place of the prescribed values.
  virtual void prescribed_part(const DistributedVector &velocity,
                               DistributedVector &values) const = 0;
  /// Sets what is prescribed of a velocity to zero; for the error of a velocity.
  virtual void clear_prescribed(DistributedVector &velocity) const = 0;
  /// Sets velocity, displacement and pressure at t = 0 by the problem's interior data.
  virtual void set_initial_state(DistributedVector &velocity,
                                 DistributedVector &displacement,
                                 DistributedVector &pressure) = 0;

  // The linear system of a step: A U + G p = f, B U + C p = g.
  /// Makes the system that of the coefficients; `pressure_time`: b of the step [s], 1 of a solid at
  /// rest. Throws RunError.
  virtual SystemChange prepare(const SystemCoefficients &coefficients, double pressure_time) = 0;
  /// Takes prescribed velocities over to the right-hand sides f [N] and g [m^3/s]. Not needed where
  /// they are 0.
  virtual void eliminate_prescribed(const DistributedVector &prescribed,
                                    DistributedVector &momentum,
                                    DistributedVector &mass) = 0;
  /// Whether solve() starts from what `velocity` and `pressure` hold.
  virtual bool starts_from_guess() const { return false; }
  /// Solves for a velocity that has the prescribed values, 0 where there are none. The right-hand
  /// sides are changed. The report gets what is known of iterations. Throws RunError.
  virtual void solve(const DistributedVector &prescribed,
                     DistributedVector &momentum,
                     DistributedVector &mass,
                     DistributedVector &velocity,
                     DistributedVector &pressure,
                     StepReport &report) = 0;

  // Terms that are not linear; for discretisations that have them.
  /// Whether the problem has such terms: Newton's iteration makes the steps then, and prepare() and
  /// solve() are those of the tangent.
  virtual bool is_nonlinear() const { return false; }
  /// Whether these are all terms of their regions but for supports and loads, so that the products
  /// above are not those of such a region in a step. Else they are corrections of these products.
  virtual bool has_whole_terms() const { return false; }
  /// Sets the displacement and the velocity of a mesh that moves from the displacement of the
  /// solids at that level. Collective.
  virtual void move_mesh(BalancedStep &) {}
  /// Sets the change of that displacement [m] by a change of velocity [m/s], with that of the
  /// displacement of solids which follows in a step. Collective.
  virtual void set_mesh_change(const Step &, const DistributedVector &, DistributedVector &) {}
  /// Throws StepFailure where that displacement turns the mesh inside out. Collective.
  virtual void check_mesh(const BalancedStep &) {}
  /// At the present time [m]; null where the mesh stays.
  virtual const DistributedVector *mesh_displacement() const { return nullptr; }
  /// Adds the terms at the level of the step to the rows of momentum [N] and of volume [m^3/s].
  virtual void add_nonlinear_terms(const BalancedStep &, DistributedVector &, DistributedVector &)
  {
  }
  /// Of the terms of one region: adds the powers that their forces have with a velocity, and adds
  /// the forces to rows of momentum [N] unless `momentum` is null.
  virtual void add_nonlinear_powers(unsigned int /*region*/,
                                    const BalancedStep &,
                                    const DistributedVector & /*of_velocity*/,
                                    TermsTaken,
                                    NonlinearPowers &,
                                    DistributedVector * /*momentum*/)
  {
  }
  /// Whether a region has such terms, and its energies are those of nonlinear_energy().
  virtual bool is_nonlinear_in(unsigned int /*region*/) const { return false; }
  /// This rank's part of the energies of such a region.
  virtual NonlinearEnergy nonlinear_energy(unsigned int /*region*/, const State &) { return {}; }
  /// This rank's part of what relaxation turns into heat in such a region, at the level that the
  /// last step has balanced [W].
  virtual double nonlinear_relaxation(unsigned int /*region*/) const { return 0.; }
  /// Adds what the left side of the mass equation has of the pressure besides C p, whose rows may
  /// be others than those of a volume [m^3/s].
  virtual void add_flux_correction(const DistributedVector & /*pressure*/,
                                   DistributedVector & /*mass*/)
  {
  }
  /// Makes the system of solve() the tangent at this state. Whether it had to make a factor or a
  /// preconditioner. Throws RunError.
  virtual bool linearise(const BalancedStep &) { return false; }
  /// Whether solve() multiplies with the derivative that keep_derivative() was given last, so that
  /// each iterate can have its own at little cost.
  virtual bool solves_with_kept_derivative() const { return false; }
  /// The next linearise() does not make use of what one before has found out, such as an order of
  /// the unknowns.
  virtual void forget_linearisation() {}
  /// Whether there are products with the derivative of the terms, for GMRES of a slow iteration.
  virtual bool has_derivative_products() const { return false; }
  /// Keeps the derivative of the terms at this state, beside the system of solve().
  virtual void keep_derivative(const BalancedStep &) {}
  /// Adds the kept derivative's product with changes of velocity [m/s] and pressure [Pa] to rows of
  /// momentum [N] and of volume [m^3/s]; the rates follow as the step has them. The velocity is 0
  /// where it is prescribed.
  virtual void add_derivative_product(const DistributedVector & /*velocity*/,
                                      const DistributedVector & /*pressure*/,
                                      DistributedVector & /*momentum*/,
                                      DistributedVector & /*mass*/)
  {
  }
  /// Sets rows of residuals that are no equations of momentum or volume to zero: prescribed
  /// velocities, hanging nodes, what each solve meets exactly.
  virtual void restrict_residuals(DistributedVector &, DistributedVector &) const {}
  /// Where the largest entry of restricted residuals is, or the first one that is no number, for a
  /// message: "in the region 'liquid' near (0.1, 0.2) m".
  virtual std::string place_of_largest(const DistributedVector & /*momentum*/,
                                       const DistributedVector & /*mass*/,
                                       bool /*of_momentum*/) const
  {
    return "";
  }
  virtual ResidualScales residual_scales(const DistributedVector &, const DistributedVector &) const
  {
    return {};
  }
  /// Sets what is prescribed of a velocity.
  virtual void set_prescribed(const DistributedVector & /*prescribed*/, DistributedVector &) const
  {
  }

  // The wall shear stress; for discretisations that have it. Vectors as the velocities.
  /// Sets the tangential part of the traction of the liquids on their walls at the nodes there, 0
  /// at others [Pa].
  virtual void set_wall_shear_stress(const State &, DistributedVector &) {}
  /// Sets each component of a wall's node to the magnitude of the vector there, others to 0.
  virtual void set_magnitudes_at_walls(const DistributedVector &, DistributedVector &) {}
  /// Sets all but the nodes of walls to 0.
  virtual void keep_walls_alone(DistributedVector &) {}

  // Outlets; for discretisations that have them.
  /// int v . n over the faces of a boundary condition: the flow rate out of the body that each
  /// velocity stands for [m^2].
  virtual DistributedVector flow_of_velocities(unsigned int condition) const;
  /// The same over the present faces of an outlet's port, at a displacement of a mesh that moves.
  virtual void set_flow_of_velocities(unsigned int /*condition*/,
                                      const DistributedVector & /*mesh_displacement*/,
                                      DistributedVector &)
  {
  }
  /// The velocity along x of the flow profile of a condition, of any size.
  virtual DistributedVector flow_profile(unsigned int condition) const;
  /// result += A U and result += B U of the present system, whatever is prescribed.
  virtual void add_velocity_product(const DistributedVector &velocity, DistributedVector &result);
  virtual void add_divergence(const DistributedVector &velocity, DistributedVector &result);
  /// What the motion `profile` of prescribed velocities feels of the body: its power with A U + G p
  /// is of_velocity . U - of_pressure . p, whatever is prescribed. By itself A profile and B
  /// profile, as in a symmetric system.
  /// `momentum` and `mass` are set to the right sides that prescribing the motion leaves. Where the
  /// terms are not linear this is of their derivative at the state of the last linearise(), with
  /// nothing else in between.
  virtual void set_reaction(const DistributedVector &profile,
                            DistributedVector &of_velocity,
                            DistributedVector &of_pressure,
                            DistributedVector &momentum,
                            DistributedVector &mass);

  // Cavities; for discretisations that have them.
  /// The volumes that the cavities of the problem enclose at this displacement [m^3].
  virtual std::vector<double> cavity_volumes(const DistributedVector &displacement);
  /// Sets the derivative of the volume of a cavity by the displacement and the forces of a pressure
  /// of 1 Pa in it, both [m^2].
  virtual void linearise_cavity(unsigned int cavity,
                                const DistributedVector &displacement,
                                DistributedVector &derivative,
                                DistributedVector &force);

  // Change of the mesh, and sizes.
  /// Call when cells are flagged and before the triangulation changes.
  virtual void prepare_transfer(const StateVectors &vectors) = 0;
  /// Call after setup() on the new mesh; fills the vectors, of the new size, in the same order.
  virtual void finish_transfer(const StateVectors &vectors) = 0;
  virtual SolverSizes sizes() const = 0;

  // Hooks.
  /// Hands over the discretisation's own part of the state.
  virtual void visit(StateVisitor &) {}
  /// The step as the discretisation makes it; called before each step.
  virtual Step own_step(const Step &step) { return step; }
  /// A step begins, as own_step() has made it, from this state. Throws StepFailure.
  virtual void begin_step(const Step &, const State & /*start*/) {}
  /// A step has ended, whose equations held for what is balanced.
  virtual void finish_step(const BalancedStep &, const State &) {}
  /// The state of t = 0 was set. (Not after a checkpoint is loaded or the mesh has changed: what is
  /// needed then is part of the state.)
  virtual void start_from(const State &) {}
  /// The state was read from a checkpoint.
  virtual void finish_load() {}
  /// See WallPotentials; null where the directions of walls do not need them.
  virtual const DistributedVector *wall_potentials() const { return nullptr; }
  /// From the mesh to the shape without stress [m]; null where that is the mesh's.
  virtual const DistributedVector *unloaded_displacement() const { return nullptr; }
  virtual void set_unloaded_displacement(const DistributedVector &) {}
  /// S w of the past, which the step knows beforehand.
  virtual void multiply_past_stiffness(const unsigned int region,
                                       DistributedVector &force,
                                       const DistributedVector &mixture)
  {
    multiply_stiffness(region, force, mixture);
  }
  /// The rate of dilatation at the step's start, for the trapezoidal rule [m^3/s].
  virtual void
  set_past_dilatation(const unsigned int region, const State &start, DistributedVector &rate)
  {
    multiply_divergence(region, rate, start.velocity);
  }
  /// Whether the mass equation has corrections of fluxes, which act on p - p_plus.
  virtual bool corrects_fluxes() const { return false; }
  /// Adds what is known of them beforehand to g [m^3/s]; `p_plus` is the pressure that the past
  /// predicts [Pa].
  virtual void add_past_flux_correction(const DistributedVector & /*p_plus*/,
                                        DistributedVector & /*mass*/)
  {
  }
  /// Whether there are velocities without mass, which deform at once when the forces on them jump.
  virtual bool has_massless_velocities() const { return false; }
  /// Their displacement [m] and the change of the pressures [Pa] under such forces; `forces` is
  /// changed. False if no force acts on them.
  virtual bool deform_at_once(DistributedVector &, DistributedVector &, DistributedVector &)
  {
    return false;
  }
  /// Whether the pressure is an unknown; else the stress has all of it.
  virtual bool has_pressure() const { return true; }
  /// Sets a pressure that is no unknown from the displacement.
  virtual void complete_pressure(const DistributedVector &, DistributedVector &) {}
  /// Whether steps have the displacement for their unknown; make_displacement_step() makes them.
  virtual bool solves_for_displacement() const { return false; }
  /// In: velocity and displacement at the start. Out: the displacement at the end, and velocity and
  /// acceleration of the balanced step; `report` says of factor and corrections.
  virtual void make_displacement_step(
      const Step &, const DistributedVector &, DistributedVector &, BalancedStep &, StepReport &)
  {
  }
  /// The force of the branches' stress as the ledger reports it; `mixture` is changed.
  virtual void set_reported_stress_force(const unsigned int region,
                                         const BalancedStep &,
                                         DistributedVector &mixture,
                                         DistributedVector &force)
  {
    multiply_stiffness(region, force, mixture);
  }
  /// Whether the ledger reports the change of the kinetic energy for the kinetic power.
  virtual bool reports_change_of_kinetic_energy() const { return false; }
};
} // namespace Continua

#endif
