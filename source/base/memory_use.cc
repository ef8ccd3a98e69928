#include <continua/base/memory_use.h>

#ifdef __GLIBC__
#include <malloc.h>
#endif
#include <unistd.h>

#include <algorithm>
#include <fstream>

namespace Continua
{
double memory_held()
{
  // In pages: the size of the address space, and what of it is in memory.
  double size = 0., resident = 0.;
  std::ifstream("/proc/self/statm") >> size >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

void return_freed_memory()
{
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

std::vector<MemoryUse::Part>::iterator MemoryUse::find(const std::string &part)
{
  return std::find_if(bytes_of_parts.begin(), bytes_of_parts.end(),
                      [&](const Part &entry) { return entry.first == part; });
}

void MemoryUse::mark(const std::string &part)
{
  return_freed_memory();
  const double now = memory_held();
  auto place = find(part);
  if (place == bytes_of_parts.end())
    place = bytes_of_parts.insert(bytes_of_parts.end(), {part, 0.});
  place->second += now - last;
  last = now;
}

void MemoryUse::mark_again(const std::string &part)
{
  const auto place = find(part);
  if (place == bytes_of_parts.end())
  {
    mark(part);
    return;
  }
  const double now = memory_held();
  place->second += now - last;
  last = now;
}
} // namespace Continua
