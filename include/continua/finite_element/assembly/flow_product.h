#ifndef continua_finite_element_assembly_flow_product_h
#define continua_finite_element_assembly_flow_product_h

#include <continua/base/instruction_set.h>
#include <continua/continuum/problem.h>
#include <continua/continuum/step_solution.h>
#include <continua/finite_element/products/matrix_free_convection.h>
#include <continua/finite_element/space/cell_sums.h>
#include <continua/finite_element/space/quadrature_cells.h>
#include <continua/finite_element/space/space.h>

#include <deal.II/lac/vector.h>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace Continua
{
/// Products with the derivative of the FlowTerms without a matrix (MatrixFreeConvection), over some
/// of the cells of the liquids, with vectors of the space. Without an instruction set there is
/// none.
template <int dim>
class FlowProduct
{
public:
  using Cell = QuadratureCell<dim>;

  /// The first two must outlive it.
  FlowProduct(const Space<dim> &space,
              const Problem &problem,
              std::optional<InstructionSet> instruction_set);

  /// Makes it of the cells of which `takes` is true, unless it is there. Collective.
  void make(const QuadratureCells<dim> &cells, const std::function<bool(const Cell &)> &takes);
  /// The mesh has changed, or it is needed no more.
  void forget() { product = nullptr; }
  bool exists() const { return product != nullptr; }
  /// Whether some rank has a cell that it does not take. Collective knowledge.
  bool leaves_cells() const { return some_are_left; }
  /// Keeps the state of the next products; pressures with ghost entries. Collective.
  void set(const StepSolution &state,
           const DistributedVector &pressure,
           const DistributedVector &pressure_rate);
  /// Adds the product with changes of velocity [m/s] and pressure [Pa, with ghost entries] to rows
  /// of momentum [N] and of volume [m^3/s], hanging nodes condensed. Collective.
  void add(const DistributedVector &of_velocity,
           const DistributedVector &of_pressure,
           const QuadratureCells<dim> &cells,
           DistributedVector &momentum,
           DistributedVector &volume);

private:
  using Product = MatrixFreeConvection<dim>;

  const Space<dim> &space;
  const Problem &problem;
  const std::optional<InstructionSet> instruction_set;
  std::unique_ptr<Product> product; ///< null: there is none
  typename Product::State state;
  typename Product::Vector velocity, momentum;
  std::vector<double> volume; ///< of each cell
  std::vector<bool> has_cell; ///< by active_cell_index()
  dealii::Vector<double> cell_volume;
  CellSums volume_sums;
  bool has_compressible_liquid = false, some_are_left = true; ///< on any rank

  typename Product::Input input() const;
};
} // namespace Continua

#endif
