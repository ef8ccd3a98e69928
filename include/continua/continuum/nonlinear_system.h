#ifndef continua_continuum_nonlinear_system_h
#define continua_continuum_nonlinear_system_h

#include <continua/continuum/nonlinear_terms.h>
#include <continua/continuum/state.h>
#include <continua/continuum/step_solution.h>
#include <continua/linear_algebra/distributed_vector.h>

#include <string>

namespace Continua
{
/// Sizes of the terms that cancel in a residual.
struct ResidualScales
{
  double momentum = 0.; ///< [N]
  double mass = 0.;     ///< [m^3/s]
};

/**
 * The terms of the equations that are not linear, and their tangent: what Newton's iteration knows
 * of a discretisation. Rows are those of momentum [N] and of volume [m^3/s]. All is collective but
 * what gives this rank's part.
 */
class NonlinearSystem
{
public:
  virtual ~NonlinearSystem() = default;

  /// Whether a region has such terms, and its energies are those of energy().
  virtual bool is_in(unsigned int region) const = 0;
  /// Whether these are all terms of their regions but for supports and loads, so that
  /// ProductsByRegion and LinearSystem have nothing of such a region in a step. Else they are
  /// corrections of these products.
  virtual bool has_all_terms() const { return false; }

  // The mesh that moves with the iterate.
  /// Sets the displacement and the velocity of the mesh from the displacement of the solids at that
  /// level.
  virtual void move_mesh(StepSolution &) {}
  /// Sets the change of that displacement [m] by a change of velocity [m/s], with that of the
  /// displacement of solids which follows in a step.
  virtual void set_mesh_change(const Step &, const DistributedVector &, DistributedVector &) {}
  /// Throws StepFailure where that displacement turns the mesh inside out.
  virtual void check_mesh(const StepSolution &) {}

  // The residual.
  /// Adds the terms at the level of the step to the rows.
  virtual void
  add(const StepSolution &state, DistributedVector &momentum, DistributedVector &mass) = 0;
  virtual ResidualScales residual_scales(const DistributedVector &velocity,
                                         const DistributedVector &pressure) const = 0;
  /// Where the largest entry of restricted residuals is, or the first one that is no number, for a
  /// message: "in the region 'liquid' near (0.1, 0.2) m".
  virtual std::string place_of_largest(const DistributedVector &momentum,
                                       const DistributedVector &mass,
                                       bool of_momentum) const = 0;

  // The tangent.
  /// Makes the LinearSystem the tangent at this state. Whether it had to make a factor or a
  /// preconditioner. Throws RunError.
  virtual bool linearise(const StepSolution &state) = 0;
  /// Whether solves multiply with the derivative that keep_derivative() was given last, so that
  /// each iterate can have its own at little cost.
  virtual bool solves_with_kept_derivative() const { return false; }
  /// The next linearise() does not make use of what one before has found out, such as an order of
  /// the unknowns.
  virtual void forget_linearisation() {}
  /// Whether there are products with the derivative of the terms, for GMRES of a slow iteration.
  virtual bool has_derivative_products() const { return false; }
  /// Keeps the derivative of the terms at this state, beside the LinearSystem.
  virtual void keep_derivative(const StepSolution &) {}
  /// Adds the kept derivative's product with changes of velocity [m/s] and pressure [Pa] to the
  /// rows; the rates follow as the step has them. The velocity is 0 where it is prescribed.
  virtual void add_derivative_product(const DistributedVector & /*velocity*/,
                                      const DistributedVector & /*pressure*/,
                                      DistributedVector & /*momentum*/,
                                      DistributedVector & /*mass*/)
  {
  }

  // Powers and energies.
  /// Of the terms of one region: adds the powers that their forces have with a velocity, and adds
  /// the forces to rows of momentum unless `momentum` is null.
  virtual void add_powers(unsigned int region,
                          const StepSolution &state,
                          const DistributedVector &of_velocity,
                          TermsTaken taken,
                          NonlinearPowers &powers,
                          DistributedVector *momentum) = 0;
  /// This rank's part of the energies of a region.
  virtual NonlinearEnergy energy(unsigned int region, const State &state) = 0;
  /// This rank's part of what relaxation turns into heat in a region, at the level that the last
  /// step has balanced [W].
  virtual double relaxation_power(unsigned int /*region*/) const { return 0.; }
};
} // namespace Continua

#endif
