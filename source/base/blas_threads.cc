#include <continua/base/blas_threads.h>

#include <dlfcn.h>

#include <cstdlib>
#include <initializer_list>

namespace Continua
{
namespace
{
// Found by name: Debian's alternatives decide at run time which BLAS there is.
void *function_of_blas(const char *const name)
{
  return dlsym(RTLD_DEFAULT, name);
}
} // namespace

int blas_threads()
{
  using Get = int (*)();
  const auto get = reinterpret_cast<Get>(function_of_blas("openblas_get_num_threads"));
  return get == nullptr ? 0 : get();
}

void limit_blas_threads()
{
  for (const char *const variable : {"OPENBLAS_NUM_THREADS", "GOTO_NUM_THREADS", "OMP_NUM_THREADS"})
    if (std::getenv(variable) != nullptr)
      return;
  using Set = void (*)(int);
  const auto set = reinterpret_cast<Set>(function_of_blas("openblas_set_num_threads"));
  if (set != nullptr)
    set(1);
}
} // namespace Continua
