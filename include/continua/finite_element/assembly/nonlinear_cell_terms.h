#ifndef continua_finite_element_assembly_nonlinear_cell_terms_h
#define continua_finite_element_assembly_nonlinear_cell_terms_h

#include <continua/continuum/nonlinear_terms.h>
#include <continua/continuum/problem.h>
#include <continua/continuum/state.h>
#include <continua/continuum/state_visitor.h>
#include <continua/continuum/step_solution.h>
#include <continua/finite_element/assembly/body_forces.h>
#include <continua/finite_element/assembly/cell_assembly.h>
#include <continua/finite_element/assembly/face_assembly.h>
#include <continua/finite_element/assembly/face_points.h>
#include <continua/finite_element/assembly/term_faces.h>
#include <continua/finite_element/assembly/terms_at_points.h>
#include <continua/finite_element/space/cell_sums.h>
#include <continua/finite_element/space/quadrature_cells.h>
#include <continua/finite_element/space/space.h>
#include <continua/finite_element/space/values_at_points.h>
#include <continua/finite_element/terms/tested.h>
#include <continua/finite_element/terms/tested_on_face.h>
#include <continua/linear_algebra/entry_sums.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace Continua
{
/// How the derivative is kept for products.
enum class KeptDerivative
{
  matrices,      ///< of the cells
  without_matrix ///< the state alone, where the terms can
};

/**
 * All terms of the regions of one RegionModel that is not linear, but for supports and for loads
 * that do not follow the present shape, as integrals over cells and faces: rows of momentum N_u(U,
 * p) [N] and of volume N_p(U, p) [m^3/s], and their derivative. The part that does not depend on
 * what is integrated: the sums over the cells, the derivative as one matrix, and as one matrix a
 * cell for products.
 */
template <int dim>
class NonlinearCellTerms
{
public:
  /// The first two must outlive it. `kinds`: of what integrate() gives, in its order.
  NonlinearCellTerms(const Space<dim> &space,
                     const Problem &problem,
                     const dealii::Quadrature<dim> &quadrature,
                     RegionModel model,
                     const std::vector<PowerKind> &kinds);
  virtual ~NonlinearCellTerms() = default;

  /// Whether they are those of a region.
  bool are_of(const unsigned int region) const { return problem.region_model(region) == model; }

  /// The mesh has changed.
  virtual void reinit();

  /// Adds the terms to the rows of momentum [N] and of volume [m^3/s], with the hanging nodes
  /// condensed. Collective. Throws StepFailure where the state has no meaning.
  virtual void
  add(const StepSolution &state, DistributedVector &momentum, DistributedVector &volume) = 0;
  /// Of the terms of one region: adds the powers that their forces have with a velocity, and adds
  /// the forces to rows of momentum [N] unless `momentum` is null, with the hanging nodes
  /// condensed. Collective.
  void add_powers(unsigned int region,
                  const StepSolution &state,
                  const DistributedVector &of_velocity,
                  TermsTaken taken,
                  NonlinearPowers &powers,
                  DistributedVector *momentum);
  /// This rank's part of the energies of one region. Collective.
  virtual NonlinearEnergy energy_of(unsigned int region, const State &state) = 0;
  /// The state of t = 0 was set. Collective.
  virtual void start_from(const DistributedVector & /*displacement*/) {}
  /// Makes a branch of a region that of a body which has relaxed at this displacement [m]; `number`
  /// counts those that relax. Collective.
  virtual void set_branch(unsigned int /*region*/,
                          unsigned int /*number*/,
                          const DistributedVector & /*displacement*/)
  {
  }
  /// Hands over the terms' own part of the state.
  virtual void visit_state(StateVisitor &) {}
  /// That part was read from a checkpoint or carried over to another mesh. Collective.
  virtual void take_own_state() {}
  /// See NonlinearSystem.
  virtual const DistributedVector *wall_potentials() const { return nullptr; }
  virtual const DistributedVector *unloaded_displacement() const { return nullptr; }
  virtual void set_unloaded_displacement(const DistributedVector &) {}
  /// A step has ended. Collective.
  virtual void finish_step(const StepSolution &, const State &) {}
  /// This rank's part of what relaxation in a region turns into heat at the level that the last
  /// step has balanced [W].
  virtual double relaxation_power(unsigned int /*region*/) const { return 0.; }
  /// The sizes of the parts that cancel in the rows that were added last.
  struct Sizes
  {
    double stress = 0.;   ///< [Pa]
    double velocity = 0.; ///< [m/s]
  };
  virtual Sizes sizes_of_terms() const { return {}; }

  /// Adds the derivative by U and p, with all that follows from them as the step has it, to a
  /// matrix whose unknowns are the velocities and then the pressures and whose rows of volume are
  /// multiplied by -1. `constraints`: of the velocity, homogeneous, hanging nodes included; rows
  /// and columns of what they constrain stay empty.
  void add_derivative(const StepSolution &state,
                      const dealii::AffineConstraints<double> &constraints,
                      EntrySums &matrix);
  /// Calls take with each owned cell and the same derivative of its rows, without constraints.
  /// Collective.
  void visit_derivatives(
      const StepSolution &state,
      const std::function<void(const QuadratureCell<dim> &, const dealii::FullMatrix<double> &)>
          &take_matrix);
  /// Adds products of that derivative, without constraints, with a velocity that is zero in all but
  /// a few cells [m/s]: to rows of momentum [N] and of volume [m^3/s], and those of its transposed
  /// to `of_velocity` and `of_pressure`, whose scalar product with a change is the power of that
  /// velocity with the change of the rows of momentum. At the state of the last add_derivative() or
  /// keep_derivative(), with nothing else in between. Collective.
  void add_products_with(const DistributedVector &local_velocity,
                         DistributedVector &momentum,
                         DistributedVector &volume,
                         DistributedVector &of_velocity,
                         DistributedVector &of_pressure);
  /// Keeps the same derivative for products, without constraints. Collective.
  virtual void keep_derivative(const StepSolution &state,
                               KeptDerivative form = KeptDerivative::matrices);
  /// The mean viscosity of grad-div in each cell, by active_cell_index(), that of cells of other
  /// ranks zero [Pa s]; empty: there is no grad-div. Collective.
  virtual std::vector<double> grad_div_viscosities(const StepSolution &) { return {}; }
  /// Frees what is kept of it.
  virtual void forget_derivative() { cell_derivatives.clear(); }
  /// Adds its product with changes of velocity [m/s] and pressure [Pa], which obey their
  /// constraints, to the rows of momentum [N] and of volume [m^3/s], with the hanging nodes
  /// condensed. Collective.
  virtual void add_derivative_product(const DistributedVector &of_velocity,
                                      const DistributedVector &of_pressure,
                                      DistributedVector &momentum,
                                      DistributedVector &volume);

protected:
  using Cell = QuadratureCell<dim>;

  const Space<dim> &space;
  const Problem &problem;
  const RegionModel model;
  const dealii::Quadrature<dim> quadrature;
  QuadratureCells<dim> cells;
  Step step;                            ///< of the state that was taken
  DistributedVector velocity, pressure; ///< with ghost entries
  CellAssembly<dim> assembly;
  BodyForces<dim> body_forces;
  TermFaces<dim> faces;
  FacePoints<dim> face_points;
  FaceAssembly<dim> face_assembly;
  // Rows of the cell that was visited last.
  dealii::Vector<double> cell_momentum, cell_volume;

  /// Takes a state, with ghost entries.
  virtual void take(const StepSolution &state) = 0;
  /// Makes the state that was taken that of a cell.
  virtual void visit(const Cell &cell) = 0;
  /// Sets the rows of that cell, and adds to the powers where they are asked for. The least of what
  /// must stay positive.
  virtual double integrate() = 0;
  /// The derivative of the rows of a cell at the state that was taken, velocities first, rows of
  /// volume times -1.
  virtual void set_derivative(const Cell &cell, dealii::FullMatrix<double> &matrix) = 0;
  /// Whether the derivative of a cell's rows of volume by its pressures is another than zero: the
  /// same for any state, so that an analysis of the matrix can be kept.
  virtual bool couples_pressures(const Cell &cell) const = 0;
  /// Whether products with the derivative need the matrix of that cell.
  virtual bool needs_matrix(const Cell & /*cell*/) const { return true; }

  void take(const DistributedVector &of_velocity, const DistributedVector &of_pressure);
  /// Whether integrate() is asked for powers.
  bool asks_for_powers() const { return asked != nullptr; }
  /// Calls set(asked, result) for what gives all points of a cell at once: a PowersAtPoints or
  /// null, and a TestedAtPoints of the assembly.
  template <typename Set>
  void set_terms(const Set &set)
  {
    const TestedAtPoints result{assembly.momentum(), assembly.volume()};
    if (!asks_for_powers())
      return set(nullptr, result);
    const PowersAtPoints of_asked{of_powers_at_points.numbers(), asked->taken, asked->powers};
    set(&of_asked, result);
  }
  /// Adds what a list of terms gives at a point, times its weight, to what the assembly sums and to
  /// the powers that are asked for. `number`: that of its first term among the kinds.
  template <typename List, typename Point>
  void add_terms(const unsigned int q,
                 const dealii::Tensor<2, dim> &inverse_jacobian,
                 const double weight,
                 const Point &point,
                 const std::size_t number = 0)
  {
    Tested<dim> sum;
    if (asks_for_powers())
    {
      dealii::Tensor<1, dim> value;
      dealii::Tensor<2, dim> gradient;
      for (unsigned int c = 0; c < dim; ++c)
      {
        value[c] = of_powers_at_points.value(c, q);
        gradient[c] = of_powers_at_points.gradient(c, q, inverse_jacobian);
      }
      add_by_kind<List>(
          point, weight, number, sum,
          [&](const Tested<dim> &tested)
          { return tested.by_value * value + scalar_product(tested.by_gradient, gradient); });
    }
    else
      List::add(point, sum);
    assembly.add(q, inverse_jacobian, weight, sum);
  }
  /// Likewise of a point of a face, to the rows of the cell.
  template <typename List, typename Point>
  void
  add_face_terms(const DeformedFacePoint<dim> &shapes, const Point &point, const std::size_t number)
  {
    TestedOnFace<dim> sum;
    if (asks_for_powers())
    {
      const dealii::Tensor<1, dim> value = shapes.value_of(cell_of_powers);
      add_by_kind<List>(point, point.weight, number, sum,
                        [&](const TestedOnFace<dim> &tested) { return tested.by_value * value; });
    }
    else
      List::add(point, sum);
    face_assembly.add(shapes, point.weight, sum, cell_momentum);
  }
  /// Adds the rows of a cell, which are set, to the sums.
  void add_rows(const Cell &cell);
  /// Adds the sums to the rows of momentum [N] and of volume [m^3/s]. Collective.
  void finish_rows(DistributedVector &momentum, DistributedVector &volume);

private:
  /// What add_powers() was asked for.
  struct AskedPowers
  {
    TermsTaken taken;
    NonlinearPowers &powers;
  };

  const std::vector<PowerKind> kinds;
  CellSums momentum_sums, volume_sums;
  const AskedPowers *asked = nullptr;
  // The velocity of the powers: with ghost entries, in the present cell, and at its points.
  DistributedVector velocity_of_powers;
  dealii::Vector<double> cell_of_powers;
  ValuesAtPoints<dim> of_powers_at_points;
  /// The kept derivative of each cell that needs one, and work space for its product. In single
  /// precision the round-off of rigid motions would be as large as the stiffness of thin bodies.
  std::vector<dealii::FullMatrix<double>> cell_derivatives;
  dealii::Vector<double> cell_change, cell_product;

  /// Adds what each term of a list gives that is asked for: to a sum, and by power_of(what it
  /// gives) to its power.
  template <typename List, typename Point, typename TestedAtPoint, typename PowerOf>
  void add_by_kind(const Point &point,
                   const double weight,
                   std::size_t number,
                   TestedAtPoint &sum,
                   const PowerOf &power_of)
  {
    List::for_each(
        [&](const auto term)
        {
          const PowerKind kind = kinds[number++];
          if (kind == nullptr || !takes_terms_of(asked->taken, kind))
            return;
          TestedAtPoint tested;
          term.add(point, tested);
          asked->powers.*kind += weight * power_of(tested);
          sum += tested;
        });
  }
  /// Sets the rows of a cell to a product of its matrix, those of volume times a sign.
  void set_rows(double sign_of_volume);
};

/// One of them for each model of a region that the problem has and that is not linear.
template <int dim>
using NonlinearTerms = std::vector<std::unique_ptr<NonlinearCellTerms<dim>>>;
} // namespace Continua

#endif
