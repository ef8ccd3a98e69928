#ifndef continua_base_lack_of_memory_h
#define continua_base_lack_of_memory_h

#include <string>

namespace Continua
{
/// What the text of each error says that ends a run for want of memory. By it a study knows that
/// the run says nothing of its numbers.
extern const std::string lack_of_memory;
} // namespace Continua

#endif
