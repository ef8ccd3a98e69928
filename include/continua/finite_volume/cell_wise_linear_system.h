#ifndef continua_finite_volume_cell_wise_linear_system_h
#define continua_finite_volume_cell_wise_linear_system_h

#include <continua/base/log.h>
#include <continua/continuum/linear_system.h>
#include <continua/continuum/problem.h>
#include <continua/finite_volume/cell_wise_convection.h>
#include <continua/finite_volume/cell_wise_system.h>
#include <continua/linear_algebra/distributed_vector.h>

#include <functional>
#include <memory>
#include <vector>

namespace Continua
{
/// The equations of a step of cells and faces, and the way they are solved: together, or by the
/// segregated loop.
template <int dim>
class CellWiseLinearSystem : public LinearSystem
{
public:
  /// All must outlive it.
  CellWiseLinearSystem(const Problem &problem,
                       const CellWiseSpace<dim> &space,
                       const std::vector<CellWiseOperators> &operators,
                       const PressureClosure &closure,
                       CellWiseSystem<dim> &system,
                       Log &log);
  ~CellWiseLinearSystem() override;

  /// The mesh has changed. Collective.
  void reinit();
  /// Directions in which velocities are prescribed have turned: the factor is stale.
  void turn_conditions() { conditions_have_turned = true; }

  /// The coefficients of the equations for those of the regions. `pressure_time` as for prepare().
  CellWiseCoefficients cell_coefficients(const SystemCoefficients &coefficients,
                                         double pressure_time) const;
  SystemChange prepare(const SystemCoefficients &coefficients, double pressure_time) override;
  SystemChange prepare_cells(const CellWiseCoefficients &coefficients);
  /// Nothing: prescribed velocities have equations of their own, which solve() sets.
  void
  eliminate_prescribed(const DistributedVector &, DistributedVector &, DistributedVector &) override
  {
  }
  bool starts_from_guess() const override { return true; }
  void solve(const DistributedVector &prescribed,
             DistributedVector &momentum,
             DistributedVector &mass,
             DistributedVector &velocity,
             DistributedVector &pressure,
             StepReport &report) override;
  void add_velocity_product(const DistributedVector &velocity, DistributedVector &result) override
  {
    system.add_velocity_product(velocity, result);
  }
  void add_divergence(const DistributedVector &velocity, DistributedVector &result) override;
  void add_flux_correction(const DistributedVector &pressure, DistributedVector &mass) override
  {
    system.add_flux_correction(pressure, mass);
  }
  /// The equations of faces' pressures that have no volume are linear: each solve meets them.
  void restrict_residuals(DistributedVector &momentum, DistributedVector &mass) const override;
  void set_reaction(const DistributedVector &profile,
                    DistributedVector &of_velocity,
                    DistributedVector &of_pressure,
                    DistributedVector &momentum,
                    DistributedVector &mass) override;
  /// Makes the system the tangent, with the derivative of the convective terms at this state.
  void linearise(CellWiseConvection<dim> &convection, const StepSolution &state);

  CellWiseSolve<dim> &cell_solve() { return *solver; }
  /// A step begins that ends at this time [s].
  void begin_step(const double end_time) { end_of_step = end_time; }
  /// `sink` is told of each correction of the segregated loop.
  void report_corrections(const std::function<void(const LoopCorrection &)> &sink)
  {
    correction_sink = sink;
  }
  /// Sets what is known of the solver.
  void set_sizes(SolverSizes &sizes) const;

private:
  const Problem &problem;
  const CellWiseSpace<dim> &space;
  const std::vector<CellWiseOperators> &operators;
  const PressureClosure &closure;
  CellWiseSystem<dim> &system;
  Log &log;
  double end_of_step = 0.; ///< [s], for the report of corrections
  std::function<void(const LoopCorrection &)> correction_sink; ///< may be empty
  std::unique_ptr<CellWiseSolve<dim>> solver;
  bool conditions_have_turned = false;
  double smallest_distance = 0.; ///< between two cells, or from a cell to a boundary face [m]
  DistributedVector pressure_work;
};
} // namespace Continua

#endif
