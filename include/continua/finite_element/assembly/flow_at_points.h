#ifndef continua_finite_element_assembly_flow_at_points_h
#define continua_finite_element_assembly_flow_at_points_h

#include <continua/base/instruction_set.h>
#include <continua/finite_element/assembly/terms_at_points.h>
#include <continua/finite_element/space/numbers_at_points.h>
#include <continua/finite_element/terms/flow_point.h>
#include <continua/materials/flow_curve.h>
#include <continua/materials/volume_law.h>

namespace Continua
{
/// The state of a liquid at all quadrature points of a cell.
template <int dim>
struct FlowAtPoints
{
  unsigned int n_points = 0;                ///< at least eight
  const CellPoint<dim> *geometry = nullptr; ///< at each point, of the present place
  FlowScheme scheme;
  double density = 0.;             ///< at the reference pressure [kg/m^3]
  double viscosity = 0.;           ///< of a liquid without a flow curve [Pa s]
  double grad_div_over_speed = 0.; ///< see FlowPoint [Pa s^2/m]
  VolumeLaw volume_law;
  const FlowCurve *flow_curve = nullptr; ///< null: it has none
  /// Of the velocity with its derivatives [m/s], of the pressure likewise [Pa], and values of their
  /// rates.
  NumbersAtPoints<const double> velocity, acceleration, pressure, pressure_rate;
  NumbersAtPoints<const double> mesh_velocity; ///< values [m/s]; null: the mesh stays
};

/// What the FlowTerms give at all points of a cell, computed for several points at a time: the
/// width of an instruction set.
template <int dim>
struct FlowTermsAtPoints
{
  /// Where powers are asked for, only the terms that are taken count. The least of
  /// VolumeLaw::stiffening().
  double (*set)(const FlowAtPoints<dim> &cell,
                const PowersAtPoints *asked,
                const TestedAtPoints &result);
  /// Sets what the derivative gives, times the weight: at each point, in each of n_directions(),
  /// the numbers one after the other.
  void (*set_derivative)(const FlowAtPoints<dim> &cell, bool has_pressure_gradient, double *result);
};

/// Of the instruction set that is given. It must be one that can run here.
template <int dim>
FlowTermsAtPoints<dim> flow_terms_of(InstructionSet instruction_set);

// One for each instruction set, each in a file that is compiled for it alone.
template <int dim>
FlowTermsAtPoints<dim> flow_terms_avx2();
template <int dim>
FlowTermsAtPoints<dim> flow_terms_avx512();
} // namespace Continua

#endif
