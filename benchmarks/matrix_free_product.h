#ifndef continua_benchmarks_matrix_free_product_h
#define continua_benchmarks_matrix_free_product_h

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/mapping.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace Benchmarks
{
/**
 * The velocity block of a step in three dimensions, a0 rho M + alpha S by material, on quadratic
 * elements without its matrix: the integrals are formed anew in every product, several cells at a
 * time.
 */
class MatrixFreeProduct
{
public:
  using Vector = dealii::LinearAlgebra::distributed::Vector<double>;

  /// `mass` [kg/(m^3 s)] and `stiffness` [Pa s] by material id.
  struct Input
  {
    const dealii::Mapping<3> &mapping;
    const dealii::DoFHandler<3> &dof_handler;
    const dealii::AffineConstraints<double> &constraints;
    const std::vector<double> &mass, &stiffness;
  };

  virtual ~MatrixFreeProduct() = default;
  virtual void initialise(Vector &vector) const = 0;
  /// target = A source.
  virtual void multiply(Vector &target, const Vector &source) const = 0;
  /// Bytes of what it keeps.
  virtual std::size_t memory() const = 0;
};

// One for each set of instructions, in a file of its own that is compiled for it. The caller asks
// the processor whether it has them.
std::unique_ptr<MatrixFreeProduct> matrix_free_product_1(const MatrixFreeProduct::Input &input);
std::unique_ptr<MatrixFreeProduct> matrix_free_product_avx2(const MatrixFreeProduct::Input &input);
std::unique_ptr<MatrixFreeProduct>
matrix_free_product_avx512(const MatrixFreeProduct::Input &input);
} // namespace Benchmarks

#endif
