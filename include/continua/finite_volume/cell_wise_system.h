#ifndef continua_finite_volume_cell_wise_system_h
#define continua_finite_volume_cell_wise_system_h

#include <continua/continuum/continuum_solver.h>
#include <continua/continuum/system_coefficients.h>
#include <continua/finite_volume/cell_wise_operators.h>
#include <continua/linear_algebra/distributed_vector.h>

#include <functional>
#include <vector>

namespace Continua
{
/// What the equations of a step are made of, by material id. The displacement form has D in the
/// place of U: its mass is the coefficient of D in d2D/dt2.
struct CellWiseCoefficients
{
  bool with_pressure = true;           ///< whether p is an unknown
  std::vector<double> mass;            ///< a0 rho [kg/(m^3 s)]; displacement: [kg/(m^3 s^2)]
  std::vector<double> stiffness;       ///< alpha, equation 7.4 [Pa s]; displacement: mu [Pa]
  std::vector<double> compressibility; ///< 1/(K b) [1/(Pa s)]
  /// What Rhie and Chow's correction of the increment p - p_plus is multiplied by besides h^2/4: 1
  /// over a modulus and b [1/(Pa s)]; 0 where the correction acts on p itself, with 1/a_P.
  std::vector<double> increment_mobility;
  bool correct_fluxes = true; ///< whether there is a correction at all

  bool operator==(const CellWiseCoefficients &other) const;
};

/**
 * The linear equations of a step, put together from the operators of the regions:
 *
 *   a0 rho V U + alpha S U + G p             = f   (cells; on faces the balance of tractions)
 *   V/(K b) p + B U - R_p p - R_i (p - p_plus) = g   (cells, faces with an equation of state)
 *   p_face - (what the cells say)            = h   (other faces' pressures)
 *
 * On boundary faces the equations in prescribed directions are U = prescribed, scaled. R is Rhie
 * and Chow's correction of the flux through a face inside a region, area tau (compact - wide normal
 * gradient), tau = 1/a_P of the momentum equation (R_p), or h^2/4 times increment_mobility (R_i).
 * Where the region has ExcessVelocity, 1/tau is a0 rho plus the mean of the cells' viscous part.
 * There is none through the face between two materials, where the pressure is broken.
 */
template <int dim>
class CellWiseSystem
{
public:
  using Matrix = dealii::TrilinosWrappers::SparseMatrix;
  CellWiseSystem(const CellWiseSpace<dim> &space,
                 const Problem &problem,
                 const FaceConditions<dim> &conditions,
                 const std::vector<CellWiseOperators> &operators,
                 const PressureClosure &closure,
                 const CellWiseParameters &parameters);

  /// The mesh has changed.
  void reinit();
  /// The mesh has moved: what is prepared is made anew for the present shapes of the cells.
  void remeasure();
  /// Whether these are new, so that everything made of the old ones is stale.
  bool prepare(const CellWiseCoefficients &coefficients);
  const CellWiseCoefficients &coefficients() const { return present; }

  /// Left sides of the equations above for U and p, R_i's p_plus apart; prescribed directions as
  /// the momentum equation has them.
  void multiply(const DistributedVector &velocity,
                const DistributedVector &pressure,
                DistributedVector &momentum,
                DistributedVector &mass) const;
  /// target += (a0 rho V + alpha S) U, and the same with the transposed matrix.
  void add_velocity_product(const DistributedVector &velocity, DistributedVector &target) const;
  void add_transposed_velocity_product(const DistributedVector &velocity,
                                       DistributedVector &target) const;
  /// target += R_p p and target += R_i p.
  void add_pressure_correction(double factor,
                               const DistributedVector &pressure,
                               DistributedVector &target) const;
  void add_increment_correction(double factor,
                                const DistributedVector &pressure,
                                DistributedVector &target) const;
  /// tau of Rhie and Chow's correction of the flux through a face inside a region [m^3 s/kg]; 0
  /// where there is no correction of p itself.
  double flux_mobility(unsigned int face) const;
  /// Compact minus wide normal gradient of p there [1/m].
  Stencil<double> pressure_difference(unsigned int face) const;
  /// Whether what the correction lets through the faces of a region has a momentum of its own: that
  /// of fluids, unless it is made anew in each step.
  bool has_excess_velocity(unsigned int region) const;
  /// Puts prescribed velocities (in their directions) into right sides: rows f -> scale *
  /// prescribed.
  void set_prescribed(const DistributedVector &prescribed, DistributedVector &momentum) const;
  /// The factor of the prescribed directions' equations at a face.
  double scale(const typename FaceConditions<dim>::Face &face) const;

  /// Adds a value to a local row and a global column.
  using AddEntry = std::function<void(unsigned int, int, double)>;
  /// Further entries of the rows of momentum and of mass, in the numbers of for_entries().
  using Tangent = std::function<void(const AddEntry &momentum_row, const AddEntry &mass_row)>;
  /// What makes for_entries() those of a tangent; empty: of the linear equations above.
  void set_tangent(const Tangent &entries) { tangent = entries; }
  bool has_tangent() const { return static_cast<bool>(tangent); }

  /// Adds -R_p p - R_i p and the rows of faces' pressures.
  void add_flux_correction(const DistributedVector &pressure, DistributedVector &mass) const;
  /// Calls function(global row, global column, value) for every entry of this rank's rows, the
  /// prescribed directions' equations in place; pressures' numbers follow those of the velocities
  /// (n_velocities()). Entries that occur twice add.
  void for_entries(const std::function<void(int, int, double)> &function) const;
  unsigned int n_velocities() const { return dim * space.velocities.n_values(); }

  /// Momentum diagonal a_P over volume of each local cell, owned and ghost [kg/(m^3 s)].
  const std::vector<double> &momentum_diagonal() const { return diagonal; }
  /// R_p and R_i as they are; null where they have no entries.
  const Matrix *pressure_correction() const { return has_correction ? &correction : nullptr; }
  const Matrix *increment_correction() const
  {
    return has_increment_correction ? &increment : nullptr;
  }

  const CellWiseSpace<dim> &space;
  const Problem &problem;
  const FaceConditions<dim> &conditions;
  const std::vector<CellWiseOperators> &operators;
  const PressureClosure &closure;
  const CellWiseParameters &parameters;

private:
  Tangent tangent;
  CellWiseCoefficients present;
  bool is_prepared = false;
  Matrix correction, increment;
  bool has_correction = false, has_increment_correction = false;
  std::vector<double> diffusion; ///< sum of area/d over a cell's faces over its volume [1/m^2]
  std::vector<double> diagonal, viscous_diagonal; ///< the second without inertia
  mutable DistributedVector velocity_work, pressure_work;

  void measure_diffusion();
  void assemble_corrections();
};

/// Solves the equations of a step: all at once, or component by component.
template <int dim>
class CellWiseSolve
{
public:
  virtual ~CellWiseSolve() = default;

  /// The system is new: whatever is made of its matrix is made now. Throws RunError.
  virtual void reinit() = 0;
  /**
   * In: right sides (prescribed velocities put in), and in `velocity` and `pressure` what the loop
   * starts from. Out: the solution. `report` gets corrections, residual and whether the cap was
   * reached.
   */
  virtual void solve(const DistributedVector &momentum,
                     const DistributedVector &mass,
                     DistributedVector &velocity,
                     DistributedVector &pressure,
                     StepReport &report) = 0;
  virtual double factor_entries() const = 0;
  virtual double factor_memory() const = 0; ///< bytes over all ranks
  virtual std::string name() const = 0;
};
} // namespace Continua

#endif
