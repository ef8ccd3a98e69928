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
/// The set that products without a matrix have in `dim` dimensions if `wanted` is asked for. They
/// are compiled for the wide sets in three dimensions alone, since a compilation takes minutes: in
/// two, direct solvers serve up to a million unknowns.
template <int dim>
constexpr InstructionSet instruction_set_of_products(const InstructionSet wanted)
{
  return dim == 3 ? wanted : InstructionSet::baseline;
}
} // namespace Continua

#endif
