#ifndef continua_finite_element_products_matrix_free_product_h
#define continua_finite_element_products_matrix_free_product_h

#include <continua/base/instruction_set.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace Continua
{
/**
 * Products with the matrix of the velocities without the matrix, for quadratic elements: the
 * integrals
 *
 *   int m v . u + 2 alpha dev sym grad v : dev sym grad u + lambda div v div u
 *
 * are formed anew in each product, for several cells at once. The coefficients belong to regions
 * (material ids). Constraints are eliminated on both sides; a constrained entry of a product is
 * zero. In axisymmetry the integrals are over the whole circumference.
 */
template <int dim, typename Number>
class MatrixFreeProduct
{
public:
  using Vector = dealii::LinearAlgebra::distributed::Vector<Number>;

  /// All must outlive the product.
  struct Input
  {
    const dealii::MappingQ<dim> &mapping;
    const dealii::DoFHandler<dim> &dof_handler;           ///< of dim quadratic components
    const dealii::AffineConstraints<double> &constraints; ///< homogeneous, on the relevant dofs
    bool is_axisymmetric;
    /// Of the products of single regions: the hanging nodes alone. Null: there are none of these.
    const dealii::AffineConstraints<double> *region_constraints = nullptr;
    /// Of products with the divergence: the places of a cell's linear pressures in arrays of them,
    /// 2^dim for each cell, by active_cell_index(). Empty: there are none of these.
    std::vector<int> pressure_places = {};
  };
  /// By material id.
  struct Coefficients
  {
    std::vector<double> mass;       ///< m [kg/(m^3 s)]
    std::vector<double> stiffness;  ///< alpha [Pa s]
    std::vector<double> volumetric; ///< lambda [Pa s]; empty: none
    /// Added to lambda, by active_cell_index() of owned cells [Pa s]; empty: nothing.
    std::vector<double> volumetric_of_cells = {};
    /// Added to alpha, likewise [Pa s].
    std::vector<double> stiffness_of_cells = {};
  };

  virtual ~MatrixFreeProduct() = default;
  /// Another product with the same cells, and with coefficients of its own. Both use the same
  /// numbering and geometry, which are in memory once. It may outlive this one.
  virtual std::unique_ptr<MatrixFreeProduct> share() const = 0;
  /// Leaves out the cells that have none of the wanted entries, where all that are computed at a
  /// time have none. Products are then right at the wanted entries alone. `is_wanted`: a flag for
  /// each owned entry. Collective.
  virtual void restrict_to(const std::vector<bool> &is_wanted) = 0;
  /// Must be called before the first product.
  virtual void set(const Coefficients &coefficients) = 0;
  /// Gives a vector the layout of sources and targets; the owned entries are those of the
  /// DoFHandler in their order. Collective.
  virtual void initialise(Vector &vector) const = 0;
  /// target = A source [kg/s times the unit of the source]. Allocates nothing. Collective.
  virtual void multiply(Vector &target, const Vector &source) const = 0;
  // B, with B_ki = int q_k div v_i, and the pressures as arrays by the places of the input, hanging
  // ones and those of other ranks' cells included. All are collective and allocate nothing.
  /// momentum = A velocity - B^T pressure, and adds B velocity to `volume`, in one pass.
  virtual void multiply_coupled(Vector &momentum,
                                double *volume,
                                const Vector &velocity,
                                const double *pressure) const = 0;
  /// Adds B velocity to `volume`.
  virtual void add_divergence(double *volume, const Vector &velocity) const = 0;
  /// momentum = B^T pressure.
  virtual void multiply_gradient(Vector &momentum, const double *pressure) const = 0;
  /// The diagonal of A, 0 at constrained entries [kg/s]. Collective.
  virtual void find_diagonal(Vector &diagonal) const = 0;
  // The same of one region alone, with its own constraints and with the coefficients given.
  virtual void initialise_of_region(Vector &vector) const = 0;
  virtual void multiply_region(Vector &target,
                               const Vector &source,
                               unsigned int region,
                               double mass,
                               double stiffness) const = 0;
  virtual void
  find_diagonal(Vector &diagonal, unsigned int region, double mass, double stiffness) const = 0;
  /// Of all that the product keeps [bytes].
  virtual std::size_t memory() const = 0;
};

/// Of the instruction set that is given. It must be one that can run here.
template <int dim, typename Number>
std::unique_ptr<MatrixFreeProduct<dim, Number>>
make_matrix_free_product(InstructionSet instruction_set,
                         const typename MatrixFreeProduct<dim, Number>::Input &input);

// One for each instruction set, each in a file that is compiled for it alone.
template <int dim, typename Number>
std::unique_ptr<MatrixFreeProduct<dim, Number>>
matrix_free_product_baseline(const typename MatrixFreeProduct<dim, Number>::Input &input);
template <int dim, typename Number>
std::unique_ptr<MatrixFreeProduct<dim, Number>>
matrix_free_product_avx2(const typename MatrixFreeProduct<dim, Number>::Input &input);
template <int dim, typename Number>
std::unique_ptr<MatrixFreeProduct<dim, Number>>
matrix_free_product_avx512(const typename MatrixFreeProduct<dim, Number>::Input &input);
} // namespace Continua

#endif
