#ifndef continua_base_instruction_set_h
#define continua_base_instruction_set_h

#include <continua/base/words.h>

namespace Continua
{
/// How many numbers the processor takes at a time.
enum class InstructionSet
{
  baseline, ///< one: what every processor of the architecture can run
  avx2,     ///< four of double precision, eight of single precision
  avx512    ///< eight and sixteen
};

const Words<InstructionSet> &instruction_set_words();
/// Whether both this processor and this program have it.
bool can_run(InstructionSet instruction_set);
InstructionSet widest_instruction_set();
} // namespace Continua

#endif
