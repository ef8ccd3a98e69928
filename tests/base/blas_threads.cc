// OpenBLAS has one thread where the environment does not say how many; of another BLAS nothing is
// known.

#include <continua/base/blas_threads.h>

#include <dlfcn.h>

#include <cstdlib>

#include "../unit_test.h"

namespace test_of_blas_threads
{
using namespace Continua;

UNIT_TEST(blas_threads)
{
  using Set = void (*)(int);
  const auto set = reinterpret_cast<Set>(dlsym(RTLD_DEFAULT, "openblas_set_num_threads"));
  const auto threads_after = [&](const char *const variable)
  {
    for (const char *const name : {"OPENBLAS_NUM_THREADS", "GOTO_NUM_THREADS", "OMP_NUM_THREADS"})
      unsetenv(name);
    if (variable != nullptr)
      setenv(variable, "2", 1);
    if (set != nullptr)
      set(2);
    limit_blas_threads();
    return blas_threads();
  };
  // A machine with one core may have one thread at most.
  const bool can_have_two = set != nullptr && (set(2), blas_threads() == 2);
  const int expected = can_have_two ? 2 : (set != nullptr ? 1 : 0);
  check::absolute("OPENBLAS_NUM_THREADS", threads_after("OPENBLAS_NUM_THREADS"), expected, 0.);
  check::absolute("OMP_NUM_THREADS", threads_after("OMP_NUM_THREADS"), expected, 0.);
  check::absolute("nothing", threads_after(nullptr), set != nullptr ? 1 : 0, 0.);
}
} // namespace test_of_blas_threads
