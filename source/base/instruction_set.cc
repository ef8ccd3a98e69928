#include <continua/base/instruction_set.h>

// CONTINUA_AVX2 and CONTINUA_AVX512: what cmake/instructions.cmake has chosen.
#include <continua/base/instructions.inc>

namespace Continua
{
const Words<InstructionSet> &instruction_set_words()
{
  static const Words<InstructionSet> words = {{"baseline", InstructionSet::baseline},
                                              {"avx2", InstructionSet::avx2},
                                              {"avx512", InstructionSet::avx512}};
  return words;
}

bool can_run(const InstructionSet instruction_set)
{
#ifdef CONTINUA_AVX512
  if (instruction_set == InstructionSet::avx512)
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl");
#endif
#ifdef CONTINUA_AVX2
  if (instruction_set == InstructionSet::avx2)
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#endif
  return instruction_set == InstructionSet::baseline;
}

InstructionSet widest_instruction_set()
{
  for (const InstructionSet set : {InstructionSet::avx512, InstructionSet::avx2})
    if (can_run(set))
      return set;
  return InstructionSet::baseline;
}
} // namespace Continua
