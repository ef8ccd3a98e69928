// Counts what a program allocates by `new` while it runs, as a library that is loaded before it
// (LD_PRELOAD): the calls from the program's own text, not those from libraries. At the end the
// file CONTINUA_ALLOCATIONS gets "CALLS LARGE": how many there were, and how many of at least 4 kB.

#include <link.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <new>

namespace
{
std::uintptr_t first = 0, last = 0; // of the text of the program
unsigned long calls = 0, large_calls = 0;

// The first object is the program itself.
int take_program(struct dl_phdr_info *const object, std::size_t /*size*/, void * /*data*/)
{
  for (int k = 0; k < object->dlpi_phnum; ++k)
  {
    const auto &part = object->dlpi_phdr[k];
    if (part.p_type != PT_LOAD || (part.p_flags & PF_X) == 0)
      continue;
    first = object->dlpi_addr + part.p_vaddr;
    last = first + part.p_memsz;
  }
  return 1;
}

__attribute__((constructor)) void begin()
{
  dl_iterate_phdr(take_program, nullptr);
}

__attribute__((destructor)) void end()
{
  const char *const path = std::getenv("CONTINUA_ALLOCATIONS");
  std::FILE *const file = path != nullptr ? std::fopen(path, "w") : nullptr;
  if (file == nullptr)
    return;
  std::fprintf(file, "%lu %lu\n", calls, large_calls);
  std::fclose(file);
}

void *allocate(const std::size_t size, const void *const caller)
{
  const auto place = reinterpret_cast<std::uintptr_t>(caller);
  if (place >= first && place < last)
  {
    ++calls;
    if (size >= 4096)
      ++large_calls;
  }
  void *const memory = std::malloc(size > 0 ? size : 1);
  if (memory == nullptr)
    throw std::bad_alloc();
  return memory;
}
} // namespace

void *operator new(const std::size_t size)
{
  return allocate(size, __builtin_return_address(0));
}
void *operator new[](const std::size_t size)
{
  return allocate(size, __builtin_return_address(0));
}
void operator delete(void *const memory) noexcept
{
  std::free(memory);
}
void operator delete[](void *const memory) noexcept
{
  std::free(memory);
}
void operator delete(void *const memory, std::size_t /*size*/) noexcept
{
  std::free(memory);
}
void operator delete[](void *const memory, std::size_t /*size*/) noexcept
{
  std::free(memory);
}
