#ifndef continua_finite_element_solvers_loaded_body_h
#define continua_finite_element_solvers_loaded_body_h

#include <continua/continuum/harmonic_system.h>
#include <continua/continuum/problem.h>
#include <continua/finite_element/assembly/metric_history.h>
#include <continua/finite_element/assembly/nonlinear_cell_terms.h>
#include <continua/finite_element/solvers/harmonic_coefficients.h>
#include <continua/finite_element/solvers/loaded_boundary.h>
#include <continua/finite_element/solvers/loaded_cells.h>
#include <continua/finite_element/space/cell_sums.h>
#include <continua/finite_element/space/space.h>
#include <continua/linear_algebra/distributed_vector.h>
#include <continua/linear_algebra/unsymmetric_factor.h>

#include <deal.II/lac/affine_constraints.h>

#include <array>
#include <complex>
#include <vector>

namespace Continua
{
/**
 * A body in finite deformation that rests under loads, about which a motion exp(s t) is small: the
 * derivative of its equations there by displacement and pressure, cell by cell, as the sum
 *
 *   stiffness + s^2 mass + s viscosity + mu*(s) relaxation,
 *
 * with the rows of volume as in a symmetric system. The stiffness has the tangent of the laws whose
 * branches have relaxed, the geometry of stress and pressures, and the rows and columns of the
 * pressure. A branch that has relaxed adds mu_k s tau/(1 + s tau) 2 dev sym grad D.
 *
 * The mesh of a liquid at rest moves with its walls. Its pressure is uniform, so that it feels of
 * that motion nothing but the pressure on the walls, which follows their faces: the pressure times
 * the change of n da. All other terms of a moving mesh are products with velocities or with the
 * gradient of the pressure, which are zero.
 *
 * Vectors hold the owned entries of this rank. All methods but add_entries() are collective.
 */
template <int dim>
class LoadedBody
{
public:
  using Complex = std::complex<double>;

  /// All must outlive it. `metrics`: null where nothing relaxes. Throws RunError if a liquid
  /// flows, or its pressure is not uniform.
  LoadedBody(const Space<dim> &space,
             const Problem &problem,
             const NonlinearTerms<dim> &terms,
             MetricHistory<dim> *metrics,
             const LoadedState &state);

  /// The state about which the motion is small.
  const LoadedState &state() const { return loaded; }
  /// Coefficients of a motion exp(s t).
  HarmonicCoefficients coefficients(Complex s) const;
  /// Adds the entries of a part in one region, as NonlinearCellTerms::add_derivative() has them.
  void add_entries(LoadedPart part,
                   unsigned int region,
                   const dealii::AffineConstraints<double> &constraints,
                   Triplets &entries) const
  {
    cells.add_entries(part, region, constraints, entries);
  }
  /// Sets the left sides of the equations, without supports, with hanging nodes condensed.
  void apply(const HarmonicCoefficients &at_s,
             const std::vector<Complex> &displacement,
             const std::vector<Complex> &pressure,
             std::vector<Complex> &forces,
             std::vector<Complex> &dilatations);
  /// D* A D of a part in one region: real, since it is symmetric.
  double square(LoadedPart part, unsigned int region, const std::vector<Complex> &displacement);
  /// int v . n over the present faces of a boundary condition [m^2].
  DistributedVector flow_of_velocities(unsigned int condition) const
  {
    return boundary.flow_of_velocities(condition);
  }
  /// Forces of its tractions at `time` [s] that follow the present faces [N].
  DistributedVector following_forces(unsigned int condition, double time) const
  {
    return boundary.following_forces(condition, time);
  }
  /// Makes the branches those of the real part of a sum of motions about the state. The metric of a
  /// branch follows the strain by 1/(1 + s tau): it is that of a displacement which does, up to the
  /// square of the motion.
  void show_branches(const std::vector<WeightedSolution> &parts);
  /// A displacement [m] over which the state is nearly linear: a part of the smallest cell.
  double small_displacement() const;

private:
  using Cell = LoadedCell<dim>;

  const Space<dim> &space;
  const Problem &problem;
  const NonlinearTerms<dim> &terms;
  const LoadedState loaded;
  const LoadedCells<dim> cells;
  const LoadedBoundary<dim> boundary;
  /// With ghost entries: of the real and of the imaginary part.
  std::array<DistributedVector, 2> velocities, pressures;
  std::array<CellSums, 2> momentum_sums, volume_sums;

  void take(const std::vector<Complex> &of_velocities, const std::vector<Complex> &of_pressures);
};
} // namespace Continua

#endif
