// As deal.II's package is compiled: one cell at a time.
#include "matrix_free_product.templates.h"

namespace Benchmarks
{
std::unique_ptr<MatrixFreeProduct> matrix_free_product_1(const MatrixFreeProduct::Input &input)
{
  return std::make_unique<MatrixFreeProductOfWidth<1>>(input);
}
} // namespace Benchmarks
