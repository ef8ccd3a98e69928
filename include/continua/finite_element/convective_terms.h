#ifndef continua_finite_element_convective_terms_h
#define continua_finite_element_convective_terms_h

#include <continua/base/instruction_set.h>
#include <continua/continuum/balanced_step.h>
#include <continua/continuum/nonlinear_terms.h>
#include <continua/continuum/problem.h>
#include <continua/finite_element/flow_point.h>
#include <continua/finite_element/follower_pressure.h>
#include <continua/finite_element/inflow_terms.h>
#include <continua/finite_element/matrix_free_convection.h>
#include <continua/finite_element/moved_body_force.h>
#include <continua/finite_element/nonlinear_cell_terms.h>
#include <continua/finite_element/space.h>
#include <continua/finite_element/streamline_terms.h>
#include <continua/linear_algebra/unsymmetric_factor.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace Continua
{
/**
 * The liquids with convection: for test functions v and q
 *
 *   int v . ( rho dU/dt + rho (U . grad) U + 1/2 rho m U )
 *     + int ( 2 eta dev sym grad U - p I + gamma m I ) : grad v
 *   int q m,                                          m = c (dp/dt + U . grad p) + div U
 *
 * with rho(p), c(p) of the VolumeLaw, eta of the material or of its FlowCurve, gamma of Convection,
 * InflowTerms at open ends, and StreamlineTerms where they are on; the term with 1/2 rho m is that
 * of the skew form, gamma that of grad-div. Temam (1968) has the skew form of an incompressible
 * liquid; with m in the place of div U it holds for any law of the density: the power of inertia
 * and convection is d/dt int rho/2 U^2 + the flux of rho/2 U^2 through the boundary.
 *
 * On a mesh that moves all of this is by the present place X + d, with dU/dt and dp/dt at the nodes
 * of the mesh and U - W in the place of the U that carries, or -W without convection; the
 * derivative is that with d and W held. Loads follow (FollowerPressure, MovedBodyForce).
 */
template <int dim>
class ConvectiveTerms : public NonlinearCellTerms<dim>
{
public:
  /// `instruction_set`: of products with the derivative that need no matrix; they need quadratic
  /// velocities. Without a set, with StreamlineTerms, and in cells with InflowTerms there is a
  /// matrix of each cell in any case. The first two must outlive it.
  ConvectiveTerms(const Space<dim> &space,
                  const Problem &problem,
                  std::optional<InstructionSet> instruction_set);

  void reinit() override;

  /// Throws StepFailure where the exponent leaves a bulk modulus that is not positive.
  void
  add(const BalancedStep &state, DistributedVector &momentum, DistributedVector &volume) override;
  void
  set_forces_of(unsigned int region, const BalancedStep &state, NonlinearForces &forces) override;
  /// With the density and the compressibility that follow the pressure.
  NonlinearEnergy energy_of(unsigned int region, const State &state) override;
  void keep_derivative(const BalancedStep &state,
                       KeptDerivative form = KeptDerivative::matrices) override;
  std::vector<double> grad_div_viscosities(const BalancedStep &state) override;
  void forget_derivative() override;
  void add_loads(const BalancedStep &state,
                 std::optional<unsigned int> region,
                 DistributedVector &forces) override;
  void add_derivative_product(const DistributedVector &of_velocity,
                              const DistributedVector &of_pressure,
                              DistributedVector &momentum,
                              DistributedVector &volume) override;

private:
  using Base = NonlinearCellTerms<dim>;
  using Base::cells;
  using Base::pressure;
  using Base::pressure_work;
  using Base::problem;
  using Base::quadrature;
  using Base::space;
  using Base::step;
  using Base::take;
  using Base::velocity;
  using Base::velocity_work;
  using typename Base::Cell;
  using Point = FlowPoint<dim>;

  /// What tests the rows of momentum at a point: the values and the gradients of test functions.
  struct Tested
  {
    dealii::Tensor<1, dim> by_value;    ///< [N]
    dealii::Tensor<2, dim> by_gradient; ///< [component][direction] [N m]
  };
  /// The kinds of NonlinearForces that are integrals over cells.
  enum Kind
  {
    inertia,
    convection,
    stabilisation,
    viscosity,
    compression,
    n_kinds
  };

  /// Of the velocity in that which carries: 1, or 0 without convection.
  const double carries;
  InflowTerms<dim> inflow_terms;
  StreamlineTerms<dim> streamline_terms;
  // Of the state, with ghost entries.
  DistributedVector acceleration, pressure_rate;
  DistributedVector mesh_displacement, mesh_velocity; ///< empty where the mesh stays
  FollowerPressure<dim> follower_pressure;            ///< likewise without faces
  MovedBodyForce<dim> body_force;
  // Of the present cell; velocities component by component.
  const Cell *present = nullptr;
  dealii::Vector<double> cell_velocity, cell_acceleration, cell_pressure, cell_pressure_rate;
  dealii::Vector<double> cell_volume, cell_inflow, cell_mesh_displacement, cell_mesh_velocity;
  /// The geometry of the present cell, on a mesh that moves.
  std::vector<typename Cell::Point> moved_points;
  std::array<dealii::Vector<double>, n_kinds> cell_forces;
  /// At a point of the present cell.
  FlowFunctions<dim> functions;
  // Derivatives by the unknowns at a point: of the divergence, of the source m, along the flow.
  std::vector<double> traces, sources, along, pressure_sources, densities;

  using Product = MatrixFreeConvection<dim>;
  /// Work space of products without a matrix.
  struct ProductVectors
  {
    typename Product::State state;
    typename Product::Vector velocity, momentum;
    std::vector<double> volume; ///< of each cell
  };
  const std::optional<InstructionSet> instruction_set;
  std::unique_ptr<Product> product; ///< null: there are none
  ProductVectors of_product;
  bool has_compressible_liquid = false, some_cells_have_matrices = true; ///< on any rank

  void take(const BalancedStep &state) override;
  void set_derivative(const Cell &cell, dealii::FullMatrix<double> &matrix) override;
  bool couples_pressures(const Cell &cell) const override
  {
    return !problem.materials[cell.region].is_incompressible();
  }
  bool needs_matrix(const Cell &cell) const override
  {
    return product == nullptr || inflow_terms.has_face(cell.pressure_cell);
  }
  void make_product();
  /// Makes the state's entries those of the cell.
  void visit(const Cell &cell);
  void move_points();
  const typename Cell::Point &geometry_at(const unsigned int q) const
  {
    return problem.mesh_moves ? moved_points[q] : present->points[q];
  }
  const Material &material() const { return problem.materials[present->region]; }
  CellState<dim> cell_state() const
  {
    return {cell_velocity, cell_pressure, problem.mesh_moves ? &cell_mesh_displacement : nullptr,
            problem.mesh_moves ? &cell_mesh_velocity : nullptr};
  }
  /// Whether the loads on a cell change as its mesh moves: those on faces, and the body force.
  bool has_load_changes(const Cell &cell) const;
  /// Sets cell_inflow to these loads less those of the mesh at rest; the cell is the present one.
  void set_load_changes(const Cell &cell);
  Point point(unsigned int q) const;
  /// Adds the strain rate to the point.
  void set_strain_rate(Point &point) const;
  /// Makes the functions and the derivatives of the divergence those of a point.
  void set_functions(unsigned int q);
  /// The strain rate times the gradient of a velocity's shape function.
  double shear(const Point &point, unsigned int component, unsigned int function) const;
  /// At the shear rate of the point [Pa s].
  double viscosity_at(const Point &point) const;
  /// What tests the viscous stress.
  Tested viscous(const Point &point) const;
  void add_derivative_of_viscosity(const Point &point, dealii::FullMatrix<double> &matrix) const;
  /// Adds rows of momentum.
  void add_tested(const Tested &tested, unsigned int q, dealii::Vector<double> &rows) const;
  /// Sets the rows of the present cell: cell_volume, cell_inflow, and cell_forces by kind, or their
  /// sum in the first one. The least of VolumeLaw::stiffening().
  double integrate(bool by_kind);
  /// The derivative of the rows, velocities first.
  void integrate_derivative(dealii::FullMatrix<double> &matrix);
  /// Of grad-div over the local speed, in the present cell [Pa s^2/m].
  double viscosity_over_speed() const;
};
} // namespace Continua

#endif
