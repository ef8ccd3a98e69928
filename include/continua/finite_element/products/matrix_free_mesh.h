#ifndef continua_finite_element_products_matrix_free_mesh_h
#define continua_finite_element_products_matrix_free_mesh_h

#include <continua/base/instruction_set.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <memory>
#include <vector>

namespace Continua
{
/**
 * The equilibrium of MeshMotion's body without a matrix, for quadratic displacements: int k P :
 * Grad z of MeshStress at a displacement d, and products with its derivative there, formed anew for
 * several cells at once.
 *
 * Vectors have one of two layouts: `free`, in which the constraints of the mesh are eliminated, and
 * `given`, in which all entries count but those of hanging nodes.
 */
template <int dim>
class MatrixFreeMesh
{
public:
  using Vector = dealii::LinearAlgebra::distributed::Vector<double>;

  struct Input
  {
    // These must outlive the product.
    const dealii::MappingQ<dim> &mapping;
    const dealii::DoFHandler<dim> &dof_handler; ///< of dim quadratic components
    /// Of the mesh, homogeneous, with the hanging nodes; and the hanging nodes alone.
    const dealii::AffineConstraints<double> &constraints, &hanging;
    bool is_axisymmetric;
    bool is_hyperelastic;
    // By active_cell_index() of owned cells:
    std::vector<double> stiffness; ///< k; 0: the cell is no part of the body
    std::vector<bool> has_given;   ///< whether a cell counts in multiply_given()
  };

  virtual ~MatrixFreeMesh() = default;
  /// Give a vector a layout; the owned entries are those of the DoFHandler in their order.
  virtual void initialise_free(Vector &vector) const = 0;
  virtual void initialise_given(Vector &vector) const = 0;
  /// Takes d [m], of the layout `given`, for what follows. Before the first call d is 0.
  /// Collective.
  virtual void set(const Vector &displacement) = 0;
  /// Sets the rows of the residual at d, both of the layout `given`. Collective.
  virtual void set_residual(Vector &rows, const Vector &displacement) const = 0;
  /// target = the product with the derivative at d; both `free`. Allocates nothing. Collective.
  virtual void multiply(Vector &target, const Vector &source) const = 0;
  /// The same over the cells that have_given, both `given`. Collective.
  virtual void multiply_given(Vector &target, const Vector &source) const = 0;
};

/// Of the instruction set that is given. It must be one that can run here.
template <int dim>
std::unique_ptr<MatrixFreeMesh<dim>>
make_matrix_free_mesh(InstructionSet instruction_set,
                      const typename MatrixFreeMesh<dim>::Input &input);

// One for each instruction set, each in a file that is compiled for it alone.
template <int dim>
std::unique_ptr<MatrixFreeMesh<dim>>
matrix_free_mesh_baseline(const typename MatrixFreeMesh<dim>::Input &input);
template <int dim>
std::unique_ptr<MatrixFreeMesh<dim>>
matrix_free_mesh_avx2(const typename MatrixFreeMesh<dim>::Input &input);
template <int dim>
std::unique_ptr<MatrixFreeMesh<dim>>
matrix_free_mesh_avx512(const typename MatrixFreeMesh<dim>::Input &input);
} // namespace Continua

#endif
