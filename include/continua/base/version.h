#ifndef continua_base_version_h
#define continua_base_version_h

#include <map>
#include <string>

namespace Continua
{
std::string version();    ///< "0.1.0"
std::string revision();   ///< git revision the program was built from, or "unknown"
bool revision_is_dirty(); ///< the tree had uncommitted changes
/// deal.II, Trilinos, p4est, MUMPS, CHOLMOD, MPI, BLAS: name -> version; BLAS -> its library file.
std::map<std::string, std::string> library_versions();
/// Whether the BLAS that the program has loaded is the slow reference implementation.
bool blas_is_reference();
/// The same of a library file (links resolved): OpenBLAS, ATLAS, MKL and BLIS have their name in
/// the path.
bool blas_is_reference(const std::string &library_file);
} // namespace Continua

#endif
