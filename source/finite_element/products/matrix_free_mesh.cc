#include <continua/finite_element/products/matrix_free_mesh.h>

// CONTINUA_AVX2 and CONTINUA_AVX512: what cmake/instructions.cmake has chosen.
#include <continua/base/instructions.inc>

#include <deal.II/base/exceptions.h>

namespace Continua
{
template <int dim>
std::unique_ptr<MatrixFreeMesh<dim>>
make_matrix_free_mesh(const InstructionSet instruction_set,
                      const typename MatrixFreeMesh<dim>::Input &input)
{
  AssertThrow(can_run(instruction_set), dealii::ExcInternalError());
  [[maybe_unused]] const InstructionSet set = instruction_set_of_products<dim>(instruction_set);
  if constexpr (dim == 3)
  {
#ifdef CONTINUA_AVX512
    if (set == InstructionSet::avx512)
      return matrix_free_mesh_avx512<dim>(input);
#endif
#ifdef CONTINUA_AVX2
    if (set == InstructionSet::avx2)
      return matrix_free_mesh_avx2<dim>(input);
#endif
  }
  return matrix_free_mesh_baseline<dim>(input);
}

template std::unique_ptr<MatrixFreeMesh<2>>
make_matrix_free_mesh<2>(InstructionSet, const MatrixFreeMesh<2>::Input &);
template std::unique_ptr<MatrixFreeMesh<3>>
make_matrix_free_mesh<3>(InstructionSet, const MatrixFreeMesh<3>::Input &);
} // namespace Continua
