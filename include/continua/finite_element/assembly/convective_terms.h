#ifndef continua_finite_element_assembly_convective_terms_h
#define continua_finite_element_assembly_convective_terms_h

#include <continua/base/instruction_set.h>
#include <continua/continuum/nonlinear_terms.h>
#include <continua/continuum/problem.h>
#include <continua/continuum/step_solution.h>
#include <continua/finite_element/assembly/flow_at_points.h>
#include <continua/finite_element/assembly/flow_cell.h>
#include <continua/finite_element/assembly/flow_product.h>
#include <continua/finite_element/assembly/nonlinear_cell_terms.h>
#include <continua/finite_element/space/space.h>
#include <continua/finite_element/terms/flow_face_terms.h>
#include <continua/finite_element/terms/flow_terms.h>
#include <continua/finite_element/terms/streamline_terms.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <memory>
#include <optional>
#include <vector>

namespace Continua
{
/**
 * The regions of RegionModel::flow: for test functions v and q the FlowTerms
 *
 *   int v . ( rho dU/dt + rho (U . grad) U + s rho m U )
 *     + int ( 2 eta dev sym grad U - p I + gamma m I ) : grad v
 *   int q m,                                          m = c (dp/dt + U . grad p) + div U
 *
 * with rho(p), c(p) of the VolumeLaw, eta of the material or of its FlowCurve, gamma of Convection;
 * Streamline where it is on, the FlowFaceTerms, and BodyForce.
 *
 * On a mesh that moves all of this is by the present place X + d, with dU/dt and dp/dt at the nodes
 * of the mesh and U - W in the place of the U that carries, or -W without convection; the
 * derivative is that with d and W held. GivenTraction and BodyForce act there alone.
 */
template <int dim>
class ConvectiveTerms : public NonlinearCellTerms<dim>
{
public:
  /// `instruction_set`: of products with the derivative that need no matrix; they need quadratic
  /// velocities. Without a set, with StreamlineTerms, and in cells with FlowFaceTerms there is
  /// a matrix of each cell in any case. `set_of_terms`: of the terms themselves. The first two must
  /// outlive it.
  ConvectiveTerms(const Space<dim> &space,
                  const Problem &problem,
                  std::optional<InstructionSet> instruction_set,
                  InstructionSet set_of_terms = widest_instruction_set());

  void reinit() override;

  /// Throws StepFailure where the exponent leaves a bulk modulus that is not positive.
  void
  add(const StepSolution &state, DistributedVector &momentum, DistributedVector &volume) override;
  /// With the density and the compressibility that follow the pressure.
  NonlinearEnergy energy_of(unsigned int region, const State &state) override;
  void keep_derivative(const StepSolution &state,
                       KeptDerivative form = KeptDerivative::matrices) override;
  std::vector<double> grad_div_viscosities(const StepSolution &state) override;
  void forget_derivative() override;
  void add_derivative_product(const DistributedVector &of_velocity,
                              const DistributedVector &of_pressure,
                              DistributedVector &momentum,
                              DistributedVector &volume) override;

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
  using Point = StreamlinePoint<dim>;

  const FlowTermsAtPoints<dim> flow_terms;
  StreamlineTerms<dim> streamline_terms;
  FlowCell<dim> here; ///< the state in the present cell
  FlowProduct<dim> product;
  // Of the state, with ghost entries.
  DistributedVector acceleration, pressure_rate;
  DistributedVector mesh_displacement, mesh_velocity; ///< empty where the mesh stays
  std::vector<double> derivative_at_points;           ///< see FlowTermsAtPoints

  void take(const StepSolution &state) override;
  void set_derivative(const Cell &cell, dealii::FullMatrix<double> &matrix) override;
  bool couples_pressures(const Cell &cell) const override
  {
    return !problem.materials[cell.region].is_incompressible();
  }
  bool needs_matrix(const Cell &cell) const override
  {
    return !product.exists() || !faces.of(cell).empty();
  }
  void visit(const Cell &cell) override { here.visit(cell); }
  /// The least of VolumeLaw::stiffening().
  double integrate() override;
  /// The terms inside the present cell, likewise.
  double add_flow_terms();
  double add_streamline_terms();
  /// The derivative of these, to the assembly.
  void take_derivatives();
  void take_derivatives_with_streamline();
  /// Throws StepFailure where the least of VolumeLaw::stiffening() is not positive. Collective.
  void refuse_softening(double least_stiffening, unsigned int softest) const;
};
} // namespace Continua

#endif
