#ifndef continua_finite_volume_cell_wise_convection_h
#define continua_finite_volume_cell_wise_convection_h

#include <continua/continuum/nonlinear_terms.h>
#include <continua/continuum/step_solution.h>
#include <continua/finite_volume/excess_velocity.h>
#include <continua/finite_volume/swept_volumes.h>

#include <vector>

namespace Continua
{
/**
 * What convection and a density that follows the pressure add to the equations of the cells of
 * liquids beside the linear terms:
 *
 *   (rho - rho0) V dU/dt + sum_f phi_f (U_f - U_P)                       (momentum of a cell P)
 *   (c - 1/K) V dp/dt + sum_f phi_f/rho_f (rho_f/rho_P - 1)              (volume)
 *   -1/2 rho A min((U - W).n, 0) U              (balance of an open end that has the total
 * pressure)
 *
 * On a mesh that moves the rate of momentum is that of the volumes of the step's levels, which adds
 *
 *   rho [a1 (V - V_old) (U - U_old) + a2 (V - V_older) (U - U_older)]    (momentum)
 *
 * so that with the swept volumes of the faces, SweptVolumes, momentum is conserved, and a uniform
 * flow stays uniform. phi_f = rho_f (A_f u_f - what the face sweeps) is the mass flux out of the
 * cell, u_f the normal velocity whose sum is the cell's change of volume: that of the faces with
 * the correction of Rhie and Chow. The sum of the volume's equation is then the thesis's
 * continuity, rho_P c dp/dt V + sum phi_f = 0, and what the fluxes carry of momentum is conserved.
 * U_f and the pressure that rho_f belongs to are interpolated as the parameters ask for
 * (equations 3.2 to 3.5). Since continuity holds for the same fluxes, the skew form and the
 * advective form of momentum are the same: with central interpolation on a uniform mesh the power
 * of the fluxes is d/dt int rho/2 U^2 + its flux through the boundary.
 */
template <int dim>
class CellWiseConvection
{
public:
  /// All must outlive it.
  CellWiseConvection(const CellWiseSystem<dim> &system,
                     const ExcessVelocity<dim> &excess_velocity,
                     const LinearReconstruction<dim> &reconstruction,
                     const SweptVolumes<dim> &swept_volumes);

  /// The mesh has changed or has moved.
  void reinit();
  /// A step begins with this velocity [m/s].
  void begin_step(const DistributedVector &velocity);
  /// Adds the terms to the rows of momentum [N] and of volume [m^3/s]. Collective. Throws
  /// StepFailure where the exponent leaves a bulk modulus that is not positive.
  void add(const StepSolution &state, DistributedVector &momentum, DistributedVector &volume);
  /// As NonlinearCellTerms::add_powers().
  void add_powers(unsigned int region,
                  const StepSolution &state,
                  const DistributedVector &of_velocity,
                  TermsTaken taken,
                  NonlinearPowers &powers,
                  DistributedVector *momentum);
  /// This rank's part of the energies of one region, with the density that follows the pressure.
  NonlinearEnergy energy_of(unsigned int region,
                            const DistributedVector &velocity,
                            const DistributedVector &pressure) const;
  /// Adds the derivative by U and p, with acceleration and rate of p following as the step has
  /// them, to the rows of momentum and of volume. Collective.
  void add_derivative(const StepSolution &state,
                      const typename CellWiseSystem<dim>::AddEntry &momentum_row,
                      const typename CellWiseSystem<dim>::AddEntry &volume_row);

private:
  /// A face inside a region of liquid, or one side of a face that has a value of its own.
  struct Face
  {
    unsigned int face = 0; ///< of the mesh
    unsigned int first_side = 0, end_side = 0;
    unsigned int region = 0;
    Stencil<double> velocity, pressure; ///< of its central values
    Stencil<double> difference;         ///< compact minus wide normal gradient of p; may be empty
    /// Local row of the balance of an open end with the total pressure, or none.
    unsigned int inflow_row = VolumeFace<dim>::none;
    double weight = 0.; ///< of the balance in `inflow_row` [m^2]
  };
  /// The state on a face.
  struct Flow
  {
    double normal_velocity = 0.;  ///< along the face's normal, with Rhie and Chow's part [m/s]
    double outflow = 0.;          ///< of the owner, through the face as it moves [m^3/s]
    double mobility = 0.;         ///< tau of that part
    dealii::Tensor<1, dim> value; ///< U_f
    double density = 0.;          ///< rho_f
    double density_slope = 0.;    ///< d rho_f / dp_f
    Stencil<double> velocity, pressure; ///< of U_f and p_f
  };

  const CellWiseSystem<dim> &system;
  const ExcessVelocity<dim> &excess_velocity;
  const LinearReconstruction<dim> &reconstruction;
  const SweptVolumes<dim> &swept_volumes;
  DistributedVector velocity_old; ///< at the start of the step
  DistributedVector forces;       ///< work space
  std::vector<Face> faces;
  DistributedVector velocity, pressure; ///< the state with the values of other ranks

  bool has_terms(unsigned int region) const;
  void take(const StepSolution &state);
  void add_face(unsigned int face, unsigned int first_side, unsigned int end_side);
  Flow flow(const Face &face) const;
  dealii::Tensor<1, dim> velocity_of(unsigned int cell) const;
  double pressure_of(unsigned int cell) const;
  /// The part of the face in the momentum of the owned cells beside it, and in their volume.
  void add_fluxes(const Face &face,
                  const Flow &flow,
                  DistributedVector &momentum,
                  DistributedVector *volume) const;
  void add_inflow(const Face &face, const Flow &flow, DistributedVector &momentum) const;
  /// What flows in through an open end as it moves: 0 or negative [m/s].
  double inflow(const Face &face, const Flow &flow) const;
  void add_inertia(unsigned int cell, const StepSolution &state, DistributedVector &momentum) const;
  /// Of the rate of momentum over the density, what the change of the volume of a cell adds, by one
  /// component of its row [m^4/s^2].
  double growth_term(unsigned int cell, const StepSolution &state, unsigned int row) const;
};
} // namespace Continua

#endif
