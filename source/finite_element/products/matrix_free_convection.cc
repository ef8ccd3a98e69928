#include <continua/finite_element/products/matrix_free_convection.h>

// CONTINUA_AVX2 and CONTINUA_AVX512: what cmake/instructions.cmake has chosen.
#include <continua/base/instructions.inc>

#include <deal.II/base/exceptions.h>

namespace Continua
{
template <int dim>
std::unique_ptr<MatrixFreeConvection<dim>>
make_matrix_free_convection(const InstructionSet instruction_set,
                            const typename MatrixFreeConvection<dim>::Input &input)
{
  AssertThrow(can_run(instruction_set), dealii::ExcInternalError());
  [[maybe_unused]] const InstructionSet set = instruction_set_of_products<dim>(instruction_set);
  if constexpr (dim == 3)
  {
#ifdef CONTINUA_AVX512
    if (set == InstructionSet::avx512)
      return matrix_free_convection_avx512<dim>(input);
#endif
#ifdef CONTINUA_AVX2
    if (set == InstructionSet::avx2)
      return matrix_free_convection_avx2<dim>(input);
#endif
  }
  return matrix_free_convection_baseline<dim>(input);
}

template std::unique_ptr<MatrixFreeConvection<2>>
make_matrix_free_convection<2>(InstructionSet, const MatrixFreeConvection<2>::Input &);
template std::unique_ptr<MatrixFreeConvection<3>>
make_matrix_free_convection<3>(InstructionSet, const MatrixFreeConvection<3>::Input &);
} // namespace Continua
