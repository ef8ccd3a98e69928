#ifndef continua_finite_element_taylor_hood_harmonic_h
#define continua_finite_element_taylor_hood_harmonic_h

#include <continua/continuum/field_probes.h>
#include <continua/continuum/harmonic_derivatives.h>
#include <continua/continuum/harmonic_state.h>
#include <continua/continuum/harmonic_system.h>
#include <continua/continuum/problem.h>
#include <continua/finite_element/assembly/linear_products.h>
#include <continua/finite_element/conditions/boundary_constraints.h>
#include <continua/finite_element/conditions/loads.h>
#include <continua/finite_element/motion/moving_mesh.h>
#include <continua/finite_element/products/region_operators.h>
#include <continua/finite_element/solvers/harmonic_equations.h>
#include <continua/finite_element/solvers/harmonic_ledger.h>
#include <continua/finite_element/solvers/harmonic_loads.h>
#include <continua/finite_element/solvers/harmonic_ports.h>
#include <continua/finite_element/solvers/harmonic_sensitivity.h>
#include <continua/finite_element/solvers/harmonic_solver.h>
#include <continua/finite_element/solvers/loaded_body.h>
#include <continua/finite_element/space/space.h>

#include <complex>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace Continua
{
/// Motion exp(s t) of the Taylor-Hood discretisation: hands its work to the classes of its loads,
/// equations, solutions and powers.
template <int dim>
class TaylorHoodHarmonic : public HarmonicSystem<dim>
{
public:
  using Complex = std::complex<double>;

  /// All but the loaded body must outlive it. `loaded`: null where the motion is about a body
  /// without loads; `moving_mesh`: null where the mesh stays. `probes`: of the solver.
  TaylorHoodHarmonic(const Space<dim> &space,
                     const Problem &problem,
                     const std::vector<RegionOperators> &operators,
                     const BoundaryConstraints<dim> &constraints,
                     const Loads<dim> &loads,
                     const LinearProducts<dim> &products,
                     const HarmonicState &state,
                     const FieldProbes<dim> &probes,
                     std::unique_ptr<LoadedBody<dim>> loaded = nullptr,
                     MovingMesh<dim> *moving_mesh = nullptr);

  unsigned int n_local_velocities() const override { return equations.n_velocities(); }
  unsigned int n_local_pressures() const override { return equations.n_pressures(); }
  unsigned long long n_unknowns() const override { return solver.n_unknowns(); }
  std::vector<std::vector<unsigned int>> velocity_nodes() const override;
  std::vector<bool> free_velocities() const override;
  std::vector<VelocityPlace<dim>> velocity_places() const override;
  std::vector<HarmonicLoadSource> sources() const override { return loads.sources(); }
  HarmonicLoad load_of(const HarmonicLoadSource &source, double time) const override
  {
    return loads.load_of(source, time);
  }
  HarmonicLoad unit_load(unsigned int condition) const override
  {
    return loads.unit_load(condition);
  }
  const std::vector<unsigned int> &ports() const override { return port_model.conditions(); }
  void factor(Complex s) override { solver.factor(s); }
  std::vector<HarmonicSolution> solve(const std::vector<HarmonicLoad> &all_loads) override
  {
    return solver.solve(all_loads);
  }
  void
  solve_at(const std::vector<Complex> &s,
           const std::function<std::vector<HarmonicLoad>(std::size_t number)> &loads_at,
           const std::function<void(std::size_t number,
                                    const std::vector<HarmonicLoad> &loads,
                                    const std::vector<HarmonicSolution> &solutions)> &sink) override
  {
    solver.solve_at(s, loads_at, sink);
  }
  std::vector<HarmonicSolution> solve_further(const std::size_t number,
                                              const std::vector<HarmonicLoad> &all_loads) override
  {
    return solver.solve_further(number, all_loads);
  }
  HarmonicFunctional functional(const std::vector<std::pair<unsigned int, double>> &terms,
                                Complex s) const override;
  std::vector<HarmonicLoad> loads_of(const Problem &changed) override;
  std::unique_ptr<HarmonicDerivatives>
  derivatives(const std::vector<ProblemChange> &changes) override
  {
    return std::make_unique<HarmonicSensitivity<dim>>(space, problem, operators, products,
                                                      equations, port_model, changes);
  }
  HarmonicDeterminant determinant() override { return solver.determinant(); }
  void multiply(Complex s,
                const HarmonicSolution &solution,
                std::vector<Complex> &forces,
                std::vector<Complex> &dilatations) override
  {
    equations.multiply(s, solution, forces, dilatations);
  }
  void show_sum(const std::vector<WeightedSolution> &parts) override;
  double part_for_differences(const HarmonicSolution &solution) const override;
  HarmonicPowers powers(const HarmonicSolution &solution, const HarmonicLoad &load) override
  {
    return ledger.powers(solution, load);
  }
  Complex power_of(const HarmonicLoad &part,
                   const HarmonicSolution &solution,
                   const HarmonicLoad &load) override
  {
    return ledger.power_of(part, solution, load);
  }
  Complex flow_rate(unsigned int condition, const HarmonicSolution &solution) override
  {
    return ledger.flow_rate(condition, solution);
  }
  double factor_memory() const override { return solver.factor_memory(); }
  double largest_residual() const override { return solver.largest_residual(); }
  std::string solver_name() const override { return solver.name(); }

private:
  /// Local indices of the velocities of all solids.
  std::vector<unsigned int> velocities_of_solids() const;

  const Space<dim> &space;
  const Problem &problem;
  const std::vector<RegionOperators> &operators;
  const BoundaryConstraints<dim> &constraints;
  const LinearProducts<dim> &products;
  const FieldProbes<dim> &probes;
  HarmonicState state;
  const std::unique_ptr<LoadedBody<dim>> loaded;
  MovingMesh<dim> *const moving_mesh;
  HarmonicPorts port_model;
  HarmonicEquations<dim> equations;
  HarmonicLoads<dim> loads;
  HarmonicSolver<dim> solver;
  HarmonicLedger<dim> ledger;
};
} // namespace Continua

#endif
