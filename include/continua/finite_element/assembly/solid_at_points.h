#ifndef continua_finite_element_assembly_solid_at_points_h
#define continua_finite_element_assembly_solid_at_points_h

#include <continua/base/instruction_set.h>
#include <continua/continuum/stress_free_state.h>
#include <continua/finite_element/assembly/terms_at_points.h>
#include <continua/finite_element/space/numbers_at_points.h>
#include <continua/finite_element/terms/solid_point.h>
#include <continua/materials/strain_law.h>

#include <deal.II/base/symmetric_tensor.h>

#include <algorithm>
#include <limits>

namespace Continua
{
/// The state of a solid in finite deformation at all quadrature points of a cell.
template <int dim>
struct SolidAtPoints
{
  unsigned int n_points = 0;                ///< at least eight
  const CellPoint<dim> *geometry = nullptr; ///< at each point, of the reference mesh
  SolidScheme scheme;
  const StrainLaw *law = nullptr;
  const StressFreeState *stress_free = nullptr; ///< at each point; null: it is that of the mesh
  /// M of MetricStress at each point [Pa]; null: nothing relaxes.
  const dealii::SymmetricTensor<2, 3> *branches = nullptr;
  bool has_mass_of_mesh = false; ///< whether the mass is that of the mesh's volume
  /// Of the velocity [m/s] and the displacement [m] with their derivatives, and values.
  NumbersAtPoints<const double> velocity, displacement, acceleration, pressure, pressure_rate;
};

/// What the points of a cell have at most and at least.
struct SolidExtremes
{
  double volume_ratio = std::numeric_limits<double>::max(); ///< the least; what is no number is low
  double stress = 0.;                                       ///< the largest of what cancels [Pa]

  void add(const SolidExtremes &other)
  {
    volume_ratio = std::min(volume_ratio, other.volume_ratio);
    stress = std::max(stress, other.stress);
  }
};

/**
 * What the SolidTerms give at all points of a cell, computed for several points at a time: the
 * width of an instruction set. Where a volume ratio is not positive, the points that are computed
 * with it give nothing.
 */
template <int dim>
struct SolidTermsAtPoints
{
  /// Where powers are asked for, only the terms that are taken count.
  SolidExtremes (*set)(const SolidAtPoints<dim> &cell,
                       const PowersAtPoints *asked,
                       const TestedAtPoints &result);
  /// Sets what the derivative gives, times the weight: at each point, in each direction, the
  /// numbers one after the other.
  void (*set_derivative)(const SolidAtPoints<dim> &cell, double *result);
};

/// Of the instruction set that is given. It must be one that can run here.
template <int dim>
SolidTermsAtPoints<dim> solid_terms_of(InstructionSet instruction_set);

// One for each instruction set, each in a file that is compiled for it alone.
template <int dim>
SolidTermsAtPoints<dim> solid_terms_avx2();
template <int dim>
SolidTermsAtPoints<dim> solid_terms_avx512();
} // namespace Continua

#endif
