#include <continua/finite_element/products/matrix_free_product.h>

// CONTINUA_AVX2 and CONTINUA_AVX512: what cmake/instructions.cmake has chosen.
#include <continua/base/instructions.inc>

#include <deal.II/base/exceptions.h>

namespace Continua
{
template <int dim, typename Number>
std::unique_ptr<MatrixFreeProduct<dim, Number>>
make_matrix_free_product(const InstructionSet instruction_set,
                         const typename MatrixFreeProduct<dim, Number>::Input &input)
{
  AssertThrow(can_run(instruction_set), dealii::ExcInternalError());
  [[maybe_unused]] const InstructionSet set = instruction_set_of_products<dim>(instruction_set);
  if constexpr (dim == 3)
  {
#ifdef CONTINUA_AVX512
    if (set == InstructionSet::avx512)
      return matrix_free_product_avx512<dim, Number>(input);
#endif
#ifdef CONTINUA_AVX2
    if (set == InstructionSet::avx2)
      return matrix_free_product_avx2<dim, Number>(input);
#endif
  }
  return matrix_free_product_baseline<dim, Number>(input);
}

template std::unique_ptr<MatrixFreeProduct<2, double>>
make_matrix_free_product<2, double>(InstructionSet, const MatrixFreeProduct<2, double>::Input &);
template std::unique_ptr<MatrixFreeProduct<3, double>>
make_matrix_free_product<3, double>(InstructionSet, const MatrixFreeProduct<3, double>::Input &);
template std::unique_ptr<MatrixFreeProduct<2, float>>
make_matrix_free_product<2, float>(InstructionSet, const MatrixFreeProduct<2, float>::Input &);
template std::unique_ptr<MatrixFreeProduct<3, float>>
make_matrix_free_product<3, float>(InstructionSet, const MatrixFreeProduct<3, float>::Input &);
} // namespace Continua
