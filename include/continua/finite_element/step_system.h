#ifndef continua_finite_element_step_system_h
#define continua_finite_element_step_system_h

#include <continua/finite_element/boundary_constraints.h>
#include <continua/finite_element/region_operators.h>
#include <continua/finite_element/space.h>
#include <continua/linear_algebra/symmetric_factor.h>

#include <memory>
#include <string>
#include <vector>

namespace Continua
{
/// The section Linear solver.
struct LinearSolverParameters
{
  std::string type = "automatic";
  unsigned int refinement_steps = 0;

  void read(ParameterSection section);
};

/// What a step's matrix is made of, by material id.
struct SystemCoefficients
{
  std::vector<double> mass;            ///< a0 rho [kg/(m^3 s)]
  std::vector<double> stiffness;       ///< alpha, equation 7.4 [Pa s]
  std::vector<double> compressibility; ///< 1/(K b) [1/(Pa s)]

  bool operator==(const SystemCoefficients &other) const;
};

/**
 * The symmetric system of a step,
 *
 *   [  A   -B^T ] [ U ]   [ f ]       A = sum a0 rho M + alpha S,  C = sum M_p / (K b)
 *   [ -B   -C   ] [ p ] = [ g ]
 *
 * and its factor, which is kept as long as the coefficients stay what they are. Boundary
 * constraints are eliminated on both sides.
 */
template <int dim>
class StepSystem
{
public:
  StepSystem(const Space<dim> &space,
             const std::vector<RegionOperators> &operators,
             const BoundaryConstraints<dim> &constraints,
             const LinearSolverParameters &parameters);

  /// Forgets the factor: mesh or constraints have changed.
  void reinit();
  /// Makes the factor if the coefficients are new, and says whether it did. Throws RunError.
  bool prepare(const SystemCoefficients &coefficients);
  /// Solves for free dofs; constrained and hanging entries of the result are 0. The right-hand
  /// sides must be restricted. After a new factor the residual is checked once: RunError if it is
  /// larger than 1e-8 of the right-hand side.
  void solve(DistributedVector &momentum,
             DistributedVector &mass,
             DistributedVector &velocity,
             DistributedVector &pressure);
  /// result += A U, of the unconstrained matrix.
  void add_velocity_product(const DistributedVector &velocity, DistributedVector &result);
  /// result += factor B U and result += factor B^T p.
  void add_divergence(double factor, const DistributedVector &velocity, DistributedVector &result);
  void add_gradient(double factor, const DistributedVector &pressure, DistributedVector &result);
  /// result += C p.
  void add_compression(const DistributedVector &pressure, DistributedVector &result);

  /// Null before the first prepare().
  const SymmetricFactor *factor() const { return symmetric_factor.get(); }

private:
  const Space<dim> &space;
  const std::vector<RegionOperators> &operators;
  const BoundaryConstraints<dim> &constraints;
  LinearSolverParameters parameters;
  SystemCoefficients coefficients;
  std::unique_ptr<SymmetricFactor> symmetric_factor;
  bool is_factored = false;
  bool residual_is_checked = false;
  std::vector<unsigned int> pressure_hanging; ///< local indices
  std::vector<double> packed;
  DistributedVector velocity_product, pressure_product, velocity_residual, pressure_residual,
      velocity_correction, pressure_correction;

  /// The constraints of every column of this rank's rows. Where hanging nodes lie on the border of
  /// two ranks a row couples with dofs that are on none of this rank's cells, ghost cells included.
  dealii::AffineConstraints<double> constraints_of_columns() const;
  SymmetricTriplets triplets() const;
  void solve_packed(const DistributedVector &momentum,
                    const DistributedVector &mass,
                    DistributedVector &velocity,
                    DistributedVector &pressure);
  /// Residual of the restricted system for a solution that is zero at constrained dofs; returns its
  /// relative size.
  double residual(const DistributedVector &momentum,
                  const DistributedVector &mass,
                  const DistributedVector &velocity,
                  const DistributedVector &pressure);
};
} // namespace Continua

#endif
