#ifndef continua_base_blas_threads_h
#define continua_base_blas_threads_h

namespace Continua
{
/// The threads of OpenBLAS in this process; 0: the BLAS is another one, of which nothing is known.
int blas_threads();
/**
 * Lets OpenBLAS use one thread, unless the environment says how many (OPENBLAS_NUM_THREADS,
 * GOTO_NUM_THREADS or OMP_NUM_THREADS). By itself it takes one for each core, and waits busily for
 * them: the matrices here are small, and beside other work such a wait takes longer than the
 * product.
 */
void limit_blas_threads();
} // namespace Continua

#endif
