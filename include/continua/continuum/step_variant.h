#ifndef continua_continuum_step_variant_h
#define continua_continuum_step_variant_h

#include <continua/continuum/continuum_solver.h>
#include <continua/continuum/products_by_region.h>
#include <continua/continuum/state.h>
#include <continua/continuum/step_solution.h>
#include <continua/linear_algebra/distributed_vector.h>

namespace Continua
{
/// What a discretisation does in a step in another way than by the products of its regions. This
/// base class is the step without anything of its own.
class StepVariant
{
public:
  /// The products must outlive it.
  explicit StepVariant(const ProductsByRegion &products) : products(products) {}
  virtual ~StepVariant() = default;

  /// The step as the discretisation makes it; called before each step.
  virtual Step adapted(const Step &step) { return step; }

  // The past, as the step has it.
  /// S w of the past, which the step knows beforehand.
  virtual void multiply_past_stiffness(const unsigned int region,
                                       DistributedVector &force,
                                       const DistributedVector &mixture)
  {
    products.multiply_stiffness(region, force, mixture);
  }
  /// The rate of dilatation at the step's start, for the trapezoidal rule [m^3/s].
  virtual void
  set_past_dilatation(const unsigned int region, const State &start, DistributedVector &rate)
  {
    products.multiply_divergence(region, rate, start.velocity);
  }
  /// Whether the mass equation has corrections of fluxes, which act on p - p_plus.
  virtual bool corrects_fluxes() const { return false; }
  /// Adds what is known of them beforehand to g [m^3/s]; `p_plus` is the pressure that the past
  /// predicts [Pa].
  virtual void add_past_flux_correction(const DistributedVector & /*p_plus*/,
                                        DistributedVector & /*mass*/)
  {
  }

  // Velocities without mass.
  /// Whether there are any: they deform at once when the forces on them jump.
  virtual bool has_massless_velocities() const { return false; }
  /// Their displacement [m] and the change of the pressures [Pa] under such forces; `forces` is
  /// changed. False if no force acts on them.
  virtual bool deform_at_once(DistributedVector & /*forces*/,
                              DistributedVector & /*displacement*/,
                              DistributedVector & /*pressure*/)
  {
    return false;
  }

  // Other unknowns.
  /// Whether the pressure is an unknown; else the stress has all of it.
  virtual bool has_pressure() const { return true; }
  /// Sets a pressure that is no unknown from the displacement.
  virtual void complete_pressure(const DistributedVector & /*displacement*/,
                                 DistributedVector & /*pressure*/)
  {
  }
  /// Whether steps have the displacement for their unknown; make_displacement_step() makes them.
  virtual bool solves_for_displacement() const { return false; }
  /// In: velocity and displacement at the start. Out: the displacement at the end, and velocity and
  /// acceleration of the balanced step; `report` says of factor and corrections.
  virtual void make_displacement_step(const Step & /*step*/,
                                      const DistributedVector & /*velocity*/,
                                      DistributedVector & /*displacement*/,
                                      StepSolution & /*balanced*/,
                                      StepReport & /*report*/)
  {
  }

  // What the ledger reports.
  /// The force of the branches' stress; `mixture` is changed.
  virtual void set_reported_stress_force(const unsigned int region,
                                         const StepSolution & /*step*/,
                                         DistributedVector &mixture,
                                         DistributedVector &force)
  {
    products.multiply_stiffness(region, force, mixture);
  }
  /// Whether it is the change of the kinetic energy for the kinetic power.
  virtual bool reports_change_of_kinetic_energy() const { return false; }

private:
  const ProductsByRegion &products;
};
} // namespace Continua

#endif
