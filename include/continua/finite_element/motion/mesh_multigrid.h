#ifndef continua_finite_element_motion_mesh_multigrid_h
#define continua_finite_element_motion_mesh_multigrid_h

#include <continua/finite_element/products/linear_velocities.h>
#include <continua/finite_element/products/matrix_free_mesh.h>
#include <continua/finite_element/products/matrix_free_product.h>
#include <continua/finite_element/products/polynomial_cycle.h>
#include <continua/finite_element/space/space.h>
#include <continua/linear_algebra/distributed_vector.h>

#include <memory>
#include <string>
#include <vector>

namespace Continua
{
/**
 * The linear equations of MeshMotion without a matrix, for quadratic displacements: conjugate
 * gradients by products of MatrixFreeMesh, preconditioned by a PolynomialCycle. The cycle is that
 * of the undeformed mesh and serves the whole run: it depends on no state, and a mesh that is
 * deformed has an operator of the same kind.
 */
template <int dim>
class MeshMultigrid
{
public:
  struct Input
  {
    InstructionSet instruction_set;
    const dealii::AffineConstraints<double> &constraints; ///< see MatrixFreeMesh
    bool is_hyperelastic;
    unsigned int n_regions;
    std::vector<double> stiffness; ///< see MatrixFreeMesh
    std::vector<bool> has_given;   ///< likewise
  };

  /// The space and the constraints must outlive it. Collective.
  MeshMultigrid(const Space<dim> &space, const Input &input);

  /// Takes the operator at a displacement [m], and sets the rows to less the residual there,
  /// hanging nodes condensed. Collective.
  void linearise(const DistributedVector &displacement, DistributedVector &rows);
  /// Takes the operator's product with given displacements [m] from rows. Collective.
  void subtract_product(const DistributedVector &given, DistributedVector &rows);
  /// Solves from the solution that is given until the residual is below `tolerance` times the right
  /// side; entries of both that are constrained must be 0. Collective. Throws StepFailure if that
  /// takes too many iterations.
  void
  solve(DistributedVector &solution, const DistributedVector &right_hand_side, double tolerance);
  /// Of the last solve.
  unsigned int n_iterations() const { return iterations; }
  /// What the cycle is made of.
  std::string name() const { return cycle->name(); }

private:
  using Product = MatrixFreeProduct<dim, float>;
  using Vector = typename MatrixFreeMesh<dim>::Vector;

  const std::unique_ptr<MatrixFreeMesh<dim>> product;
  const std::unique_ptr<Product> undeformed_product;
  std::unique_ptr<LinearVelocities<dim>> linear;
  std::unique_ptr<PolynomialCycle<dim>> cycle;
  Vector given_entries, given_rows, source, target;
  unsigned int iterations = 0;
  typename Product::Vector cycle_source, cycle_solution;

  void make_cycle(const Space<dim> &space, const Input &input);
  void precondition(Vector &to, const Vector &from);
};
} // namespace Continua

#endif
