#include <continua/base/lack_of_memory.h>

namespace Continua
{
const std::string lack_of_memory = "the memory of the machine is not enough";
} // namespace Continua
