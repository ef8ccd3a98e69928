#ifndef continua_linear_algebra_node_product_h
#define continua_linear_algebra_node_product_h

#include <continua/linear_algebra/distributed_vector.h>

#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <memory>
#include <vector>

class Epetra_Vector;

namespace Continua
{
/**
 * Products with two matrices of the same velocities in one pass over both: M, which multiplies each
 * component alike, and S, which couples the components. The components of a node are neighbours in
 * the numbering: node n has the rows `dim` n to `dim` n + dim - 1. In a row of a regular node M has
 * the pattern of S but one component, so that the places of both are read once for a node. Other
 * rows, such as those of hanging nodes, are multiplied by themselves. Nothing of the matrices is
 * copied.
 */
template <int dim>
class NodeProduct
{
public:
  /// Both must outlive it and not change. Collective.
  NodeProduct(const dealii::TrilinosWrappers::SparseMatrix &mass,
              const dealii::TrilinosWrappers::SparseMatrix &stiffness);
  ~NodeProduct();

  /// Sets M v, S v and S w; null targets are left out, and `displacement` w may be null without the
  /// last one. Collective.
  void multiply(const DistributedVector &velocity,
                const DistributedVector *displacement,
                DistributedVector *mass_of_velocity,
                DistributedVector *stiffness_of_velocity,
                DistributedVector *stiffness_of_displacement) const;
  /// Of this rank, for tests.
  unsigned int n_regular_nodes() const { return regular_nodes.size(); }

private:
  /// The rows of a matrix as Trilinos keeps them: offsets, local columns and values.
  struct Rows
  {
    const int *offsets = nullptr, *columns = nullptr;
    const double *values = nullptr;
  };
  /// What a pass computes of a region, at local places.
  struct Pass
  {
    const double *velocity, *displacement;
    double *mass_of_velocity, *stiffness_of_velocity, *stiffness_of_displacement;
  };

  const dealii::TrilinosWrappers::SparseMatrix &mass, &stiffness;
  /// Whether both have rows, columns and layout that one pass can serve; the same on every rank.
  bool is_one_pass = false;
  Rows mass_rows, stiffness_rows;
  std::vector<unsigned int> regular_nodes, other_rows; ///< local; rows without entries are in none
  bool has_empty_rows = false;
  /// With the entries of other ranks; null on one rank.
  std::unique_ptr<Epetra_Vector> complete_velocity, complete_displacement;

  bool is_regular(unsigned int node) const;
  template <bool with_mass>
  void multiply_with(const Pass &pass) const;
  template <bool with_mass, bool of_velocity, bool of_displacement>
  void multiply_nodes(const Pass &pass) const;
  void multiply_other_rows(const Pass &pass) const;
};
} // namespace Continua

#endif
