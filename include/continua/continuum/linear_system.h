#ifndef continua_continuum_linear_system_h
#define continua_continuum_linear_system_h

#include <continua/continuum/continuum_solver.h>
#include <continua/continuum/system_coefficients.h>
#include <continua/linear_algebra/distributed_vector.h>

namespace Continua
{
/// What preparing a step's system has changed.
enum class SystemChange
{
  none,         ///< the coefficients are those of the last step
  coefficients, ///< other coefficients, for which a factor was kept
  factor        ///< a factor or a preconditioner was made
};

/// The linear system of a step, A U + G p = f, B U + C p = g, or where the terms are not linear the
/// tangent that NonlinearSystem::linearise() has made. All is collective.
class LinearSystem
{
public:
  virtual ~LinearSystem() = default;

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
  /// result += A U and result += B U of the present system, whatever is prescribed.
  virtual void add_velocity_product(const DistributedVector &velocity,
                                    DistributedVector &result) = 0;
  virtual void add_divergence(const DistributedVector &velocity, DistributedVector &result) = 0;
  /// Adds what the left side of the mass equation has of the pressure besides C p, whose rows may
  /// be others than those of a volume [m^3/s].
  virtual void add_flux_correction(const DistributedVector & /*pressure*/,
                                   DistributedVector & /*mass*/)
  {
  }
  /// Sets rows of residuals that are no equations of momentum or volume to zero: prescribed
  /// velocities, hanging nodes, what each solve meets exactly.
  virtual void restrict_residuals(DistributedVector &momentum, DistributedVector &mass) const = 0;
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
};
} // namespace Continua

#endif
