#ifndef continua_finite_element_taylor_hood_harmonic_h
#define continua_finite_element_taylor_hood_harmonic_h

#include <continua/continuum/harmonic_state.h>
#include <continua/continuum/harmonic_system.h>
#include <continua/continuum/problem.h>
#include <continua/finite_element/assembly/linear_products.h>
#include <continua/finite_element/conditions/boundary_constraints.h>
#include <continua/finite_element/conditions/loads.h>
#include <continua/finite_element/products/region_operators.h>
#include <continua/finite_element/solvers/harmonic_factors.h>
#include <continua/finite_element/solvers/harmonic_matrix.h>
#include <continua/finite_element/solvers/harmonic_ports.h>
#include <continua/finite_element/space/space.h>

#include <complex>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace Continua
{
/**
 * Motion exp(s t) of the Taylor-Hood discretisation. The body without the pressures of its ports is
 * factored; the responses to these are further right-hand sides of the same factor. A solution
 * whose residual is above `tolerance` is corrected with the factor, twice at most, and so is the
 * whole with its ports. What is above `largest_accepted_residual` then, or is no number, is a
 * RunError.
 */
template <int dim>
class TaylorHoodHarmonic : public HarmonicSystem<dim>
{
public:
  using Complex = std::complex<double>;
  /// Of the residual, of the largest force at a node. Where a thin wall is much stiffer than what
  /// is around, the forces within it cancel, and round-off leaves no less.
  static constexpr double tolerance = 1e-9;
  static constexpr double largest_accepted_residual = 1e-6;

  /// All must outlive it.
  TaylorHoodHarmonic(const Space<dim> &space,
                     const Problem &problem,
                     const std::vector<RegionOperators> &operators,
                     const BoundaryConstraints<dim> &constraints,
                     const Loads<dim> &loads,
                     const LinearProducts<dim> &products,
                     const HarmonicState &state);

  unsigned int n_local_velocities() const override { return space.velocity_owned.n_elements(); }
  unsigned int n_local_pressures() const override { return space.pressure_owned.n_elements(); }
  unsigned long long n_unknowns() const override { return matrix.size(); }
  std::vector<std::vector<unsigned int>> velocity_nodes() const override;
  std::vector<bool> free_velocities() const override;
  std::vector<HarmonicLoadSource> sources() const override;
  HarmonicLoad load_of(const HarmonicLoadSource &source, double time) const override;
  HarmonicLoad unit_load(unsigned int condition) const override;
  const std::vector<unsigned int> &ports() const override { return port_model.conditions(); }
  void factor(Complex s) override;
  std::vector<HarmonicSolution> solve(const std::vector<HarmonicLoad> &loads) override;
  void solve_at(
      const std::vector<Complex> &s,
      const std::function<std::vector<HarmonicLoad>(std::size_t number)> &loads_at,
      const std::function<void(std::size_t number,
                               const std::vector<HarmonicLoad> &loads,
                               const std::vector<HarmonicSolution> &solutions)> &sink) override;
  HarmonicDeterminant determinant() override;
  void multiply(Complex s,
                const HarmonicSolution &solution,
                std::vector<Complex> &forces,
                std::vector<Complex> &dilatations) override;
  void show(const HarmonicSolution &solution, Complex factor) override;
  HarmonicPowers powers(const HarmonicSolution &solution, const HarmonicLoad &load) override;
  Complex power_of(const HarmonicLoad &part,
                   const HarmonicSolution &solution,
                   const HarmonicLoad &load) override;
  Complex flow_rate(unsigned int condition, const HarmonicSolution &solution) override;
  double factor_memory() const override { return factors->memory(); }
  double largest_residual() const override { return residual_of_all; }
  std::string solver_name() const override;

private:
  /// A complex vector in the place of two real ones.
  struct Pair
  {
    DistributedVector real, imaginary;
  };
  /// The entries that are not zero, by local index.
  using Sparse = std::vector<std::pair<unsigned int, double>>;

  const Space<dim> &space;
  const Problem &problem;
  const std::vector<RegionOperators> &operators;
  const BoundaryConstraints<dim> &constraints;
  const Loads<dim> &load_list;
  const LinearProducts<dim> &products;
  HarmonicState state;
  HarmonicMatrix matrix;
  std::unique_ptr<HarmonicFactors> factors;
  HarmonicPorts port_model;
  std::vector<Sparse> port_flows; ///< q [m^2]
  std::vector<Complex> factored;  ///< the s of the factors
  double residual_of_all = 0.;
  double area_of_node = 0.; ///< the largest at a surface, a measure of the entries of B [m^2]
  const DistributedVector zero_velocity;
  DistributedVector velocity_work;
  DistributedVector pressure_work;

  HarmonicCoefficients coefficients(Complex s) const;
  /// The left sides without ports and constraints, of a displacement at all nodes: forces, and
  /// minus the dilatations' deficit, as the rows of the symmetric matrix.
  void apply(const HarmonicCoefficients &at_s,
             const std::vector<Complex> &displacement,
             const std::vector<Complex> &pressure,
             std::vector<Complex> &forces,
             std::vector<Complex> &dilatations);
  /// T^T of forces, and the pressures' rows of hanging nodes to zero.
  void restrict_rows(std::vector<Complex> &forces, std::vector<Complex> &dilatations) const;
  /// T u of free entries.
  void expand(std::vector<Complex> &displacement) const;
  std::vector<Complex> packed(const std::vector<Complex> &velocities,
                              const std::vector<Complex> &pressures) const;
  /// Largest magnitude over all ranks.
  double size_of(const std::vector<Complex> &values) const;
  /// Sets the factors in use. Throws with the frequency.
  void make_factors(const std::vector<Complex> &all_s);
  /// Takes the left sides off the right ones, with ports where pressures are given; returns what is
  /// left: the larger of the forces over the largest force at a node, and of the dilatations over
  /// the largest displacement times the area of a node. Infinite of what is no number.
  double subtract_left_side(Complex s,
                            const std::vector<Complex> &displacement,
                            const std::vector<Complex> &pressure,
                            const std::vector<Complex> &port_pressures,
                            std::vector<Complex> &right);
  /// Whether no further correction is wanted, with the residuals by factor in use. Throws RunError
  /// if the last one leaves too much.
  bool is_solved(const std::vector<double> &residuals, unsigned int correction);
  /// What the equations of the ports leave, as loads of ports that would mend it; returns the
  /// largest one, relative.
  double residual_of_ports(const HarmonicLoad &load,
                           const HarmonicSolution &solution,
                           std::vector<Complex> &residuals) const;
  /// Corrects solutions with their ports; `columns`: those of loads and ports.
  void correct(const std::vector<std::vector<HarmonicLoad>> &loads,
               const std::vector<HarmonicFactors::Columns> &columns,
               std::vector<std::vector<HarmonicSolution>> &solutions);
  /// Solves and corrects the columns of the factors in use.
  void solve_columns(std::vector<HarmonicFactors::Columns> &columns);
  /// `number`: of a factor in use.
  std::vector<HarmonicSolution> complete(std::size_t number,
                                         const std::vector<HarmonicLoad> &loads,
                                         const HarmonicFactors::Columns &columns);
  /// The right-hand sides of loads at s, and behind them those of the ports.
  HarmonicFactors::Columns right_hand_sides(Complex s, const std::vector<HarmonicLoad> &loads);
  std::vector<std::vector<HarmonicSolution>>
  solve_in_use(const std::vector<std::vector<HarmonicLoad>> &loads);
  Complex
  flow_of_port(unsigned int port, const std::vector<Complex> &displacement, Complex s) const;
  Complex sum(Complex of_rank) const;
  /// What moves the prescribed velocities [N]: A D - B^T p + q P - f.
  std::vector<Complex> reactions(const HarmonicSolution &solution, const HarmonicLoad &load);
};
} // namespace Continua

#endif
