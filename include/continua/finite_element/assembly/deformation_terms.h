#ifndef continua_finite_element_assembly_deformation_terms_h
#define continua_finite_element_assembly_deformation_terms_h

#include <continua/base/instruction_set.h>
#include <continua/finite_element/assembly/metric_history.h>
#include <continua/finite_element/assembly/nonlinear_cell_terms.h>
#include <continua/finite_element/assembly/solid_at_points.h>
#include <continua/finite_element/assembly/solid_cell.h>
#include <continua/finite_element/assembly/stress_free_states.h>
#include <continua/finite_element/terms/solid_face_terms.h>
#include <continua/finite_element/terms/solid_terms.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <vector>

namespace Continua
{
/**
 * The regions of RegionModel::finite_solid: the SolidTerms, the SolidFaceTerms and BodyForce. For
 * test functions v and q, on the reference mesh with gradients by the present place,
 *
 *   int rho0 v . dU/dt dV + int ( tau(F) + J 2 eta dev sym grad U - J p I ) : grad v dV
 *   int q (1/b) ( ln J + p/K ) J dV
 *
 * with F = I + Grad D, D = D_plus + b U, J = det F and tau the law's deviatoric Kirchhoff stress.
 * In the middle of a step (Crank-Nicolson) the row of volume is its rate, int q ( div U + (dp/dt)/K
 * ) J dV, which keeps the energy; the closed one keeps the volume. A law with a mean stress s of
 * its own has (p + s(F))/K in the place of ln J + p/K. Branches that relax add to tau the stress of
 * a metric that the step knows beforehand (MetricHistory). With a prestretch F0 the laws have the
 * elastic deformation F F0^-1, and the stress-free volume, with the mass, is det F0 dV; loads that
 * come in steps bring it in the same share. Where the unloaded shape X + D0 is another than the
 * mesh, F0 is 1 + Grad D0. A step that finds this shape has F = 1 and D0 = -D, and the mass of the
 * mesh's volume.
 */
template <int dim>
class DeformationTerms : public NonlinearCellTerms<dim>
{
public:
  /// All must outlive it; `metrics`: null where nothing relaxes; `set_of_terms`: of the terms
  /// inside the cells.
  DeformationTerms(const Space<dim> &space,
                   const Problem &problem,
                   MetricHistory<dim> *metrics = nullptr,
                   InstructionSet set_of_terms = widest_instruction_set());

  void reinit() override;

  /// Throws StepFailure where the body is turned inside out.
  void
  add(const StepSolution &state, DistributedVector &momentum, DistributedVector &volume) override;
  /// By the law, and of the pressure K (J ln J - J + 1) with J = exp(-p/K), per reference volume.
  NonlinearEnergy energy_of(unsigned int region, const State &state) override;
  void start_from(const DistributedVector &displacement) override;
  void set_branch(unsigned int region,
                  unsigned int number,
                  const DistributedVector &displacement) override;
  void visit_state(StateVisitor &visitor) override { stress_free_states.visit_state(visitor); }
  void take_own_state() override { stress_free_states.take_state(); }
  const DistributedVector *unloaded_displacement() const override
  {
    return stress_free_states.unloaded_displacement();
  }
  const DistributedVector *wall_potentials() const override
  {
    return stress_free_states.wall_potentials();
  }
  void set_unloaded_displacement(const DistributedVector &of_unloaded) override;
  void finish_step(const StepSolution &solution, const State &state) override;
  double relaxation_power(const unsigned int region) const override { return heat[region]; }
  typename NonlinearCellTerms<dim>::Sizes sizes_of_terms() const override { return sizes; }

private:
  using Base = NonlinearCellTerms<dim>;
  using Base::assembly;
  using Base::body_forces;
  using Base::cell_momentum;
  using Base::cell_volume;
  using Base::cells;
  using Base::face_assembly;
  using Base::face_points;
  using Base::faces;
  using Base::pressure;
  using Base::problem;
  using Base::quadrature;
  using Base::space;
  using Base::step;
  using Base::take;
  using Base::velocity;
  using typename Base::Cell;
  using typename Base::Sizes;

  using Point = SolidPoint<dim>;
  using Stress = typename SolidCell<dim>::Stress;

  const SolidTermsAtPoints<dim> solid_terms;
  StressFreeStates<dim> stress_free_states;
  SolidCell<dim> here; ///< the state in the present cell
  MetricHistory<dim> *const metrics;
  std::vector<double> heat; ///< relaxation_power() by region
  // Of the state, with ghost entries.
  DistributedVector displacement, pressure_rate, acceleration;
  Sizes sizes;
  std::vector<double> derivative_at_points; ///< see SolidTermsAtPoints

  void take(const StepSolution &state) override;
  void set_derivative(const Cell &cell, dealii::FullMatrix<double> &matrix) override;
  bool couples_pressures(const Cell &) const override { return true; }
  /// Calls visit(q, point) at each point of the cells that relax, by this displacement.
  template <typename Visit>
  void visit_relaxing_points(const DistributedVector &of_displacement, const Visit &visit_point);
  void visit(const Cell &cell) override { here.visit(cell); }
  /// The least volume ratio.
  double integrate() override;
  /// The derivative of the terms inside the cell at one point after the other, to the assembly.
  void take_derivatives_of_points(bool has_body_force);
  NonlinearEnergy energy_at(unsigned int q);
  /// Throws StepFailure where a volume ratio of some rank is not positive. Collective.
  void refuse_inversion(double least_ratio, const Cell *worst) const;
};
} // namespace Continua

#endif
