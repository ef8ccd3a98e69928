#ifndef continua_finite_element_products_matrix_free_convection_h
#define continua_finite_element_products_matrix_free_convection_h

#include <continua/base/instruction_set.h>
#include <continua/materials/flow_curve.h>
#include <continua/materials/volume_law.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <memory>
#include <optional>
#include <vector>

namespace Continua
{
/**
 * Products with the derivative of the ConvectiveTerms without its matrix, for quadratic velocities:
 * the integrals are formed anew from the state in each product, for several cells at once. It has
 * neither FlowFaceTerms nor StreamlineTerms. On a mesh that moves the integrals are those of the
 * present place, which is held.
 */
template <int dim>
class MatrixFreeConvection
{
public:
  using Vector = dealii::LinearAlgebra::distributed::Vector<double>;
  static constexpr unsigned int n_pressures = 1U << dim; ///< of a cell

  /// The liquid of a region.
  struct Liquid
  {
    double density = 0.;   ///< at the reference pressure [kg/m^3]
    double viscosity = 0.; ///< where there is no flow curve [Pa s]
    VolumeLaw volume_law;
    std::optional<FlowCurve> flow_curve;
  };
  struct Input
  {
    Input(const dealii::MappingQ<dim> &mapping,
          const dealii::DoFHandler<dim> &dof_handler,
          const dealii::AffineConstraints<double> &hanging)
        : mapping(mapping), dof_handler(dof_handler), hanging(hanging)
    {
    }
    // These must outlive the product.
    const dealii::MappingQ<dim> &mapping;
    const dealii::DoFHandler<dim> &dof_handler;       ///< of dim quadratic components
    const dealii::AffineConstraints<double> &hanging; ///< of hanging nodes alone
    bool is_axisymmetric = false;
    bool mesh_moves = false;
    double carries = 1.;            ///< FlowScheme::carries
    bool is_skew = false;           ///< ConvectiveTerm::skew
    double constant_viscosity = 0.; ///< of grad-div [Pa s]
    std::vector<Liquid> liquids;    ///< by material id
    // By active_cell_index():
    std::vector<bool> has_cell;               ///< whether an owned cell counts
    std::vector<double> viscosity_over_speed; ///< of grad-div [Pa s^2/m]
    /// The places of a cell's pressures in the arrays of pressures, n_pressures for each cell.
    std::vector<int> pressure_places;
  };
  /// The state at which the derivative is taken, and how it follows the unknowns.
  struct State
  {
    Vector velocity, acceleration;               ///< [m/s], [m/s^2]
    Vector mesh_displacement, mesh_velocity;     ///< of a mesh that moves alone [m], [m/s]
    std::vector<double> pressure, pressure_rate; ///< with ghost entries [Pa], [Pa/s]; these and
                                                 ///< the acceleration of compressible liquids alone
    double acceleration_by_velocity = 0.;        ///< [1/s]
    double pressure_rate_by_pressure = 0.;       ///< [1/s]
  };

  virtual ~MatrixFreeConvection() = default;
  /// Gives a vector of velocities the layout that products need; the owned entries are those of the
  /// DoFHandler in their order. Collective.
  virtual void initialise(Vector &vector) const = 0;
  /// Of the next products. Its vectors must have the layout, and their ghost entries. Hanging
  /// nodes need no values.
  virtual void set(const State *state) = 0;
  /// Sets the rows of momentum [N], hanging nodes condensed, and those of volume [m^3/s] of each
  /// cell, n_pressures by active_cell_index(), from changes of velocity [m/s] and pressure [Pa]
  /// (with ghost entries). Collective.
  virtual void multiply(Vector &momentum,
                        std::vector<double> &volume,
                        const Vector &velocity,
                        const double *pressure) const = 0;
};

/// Of the instruction set that is given. It must be one that can run here.
template <int dim>
std::unique_ptr<MatrixFreeConvection<dim>>
make_matrix_free_convection(InstructionSet instruction_set,
                            const typename MatrixFreeConvection<dim>::Input &input);

// One for each instruction set, each in a file that is compiled for it alone.
template <int dim>
std::unique_ptr<MatrixFreeConvection<dim>>
matrix_free_convection_baseline(const typename MatrixFreeConvection<dim>::Input &input);
template <int dim>
std::unique_ptr<MatrixFreeConvection<dim>>
matrix_free_convection_avx2(const typename MatrixFreeConvection<dim>::Input &input);
template <int dim>
std::unique_ptr<MatrixFreeConvection<dim>>
matrix_free_convection_avx512(const typename MatrixFreeConvection<dim>::Input &input);
} // namespace Continua

#endif
