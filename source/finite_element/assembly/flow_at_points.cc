#include <continua/finite_element/assembly/flow_at_points.templates.h>

// CONTINUA_AVX2 and CONTINUA_AVX512: what cmake/instructions.cmake has chosen.
#include <continua/base/instructions.inc>

#include <deal.II/base/exceptions.h>

namespace Continua
{
template <int dim>
FlowTermsAtPoints<dim> flow_terms_of(const InstructionSet instruction_set)
{
  AssertThrow(can_run(instruction_set), dealii::ExcInternalError());
#ifdef CONTINUA_AVX512
  if (instruction_set == InstructionSet::avx512)
    return flow_terms_avx512<dim>();
#endif
#ifdef CONTINUA_AVX2
  if (instruction_set == InstructionSet::avx2)
    return flow_terms_avx2<dim>();
#endif
  return {FlowOfWidth<dim, 1>::set_all, FlowOfWidth<dim, 1>::set_derivative_of_all};
}

template FlowTermsAtPoints<2> flow_terms_of<2>(InstructionSet);
template FlowTermsAtPoints<3> flow_terms_of<3>(InstructionSet);
} // namespace Continua
