#include <continua/base/revision.inc>
#include <continua/base/version.h>

#include <deal.II/base/config.h>

#include <Trilinos_version.h>
#include <cholmod.h>
#include <dlfcn.h>
#include <dmumps_c.h>
#include <mpi.h>
#include <p4est_config.h>

#include <cstdlib>

namespace Continua
{
namespace
{
/// The file of the library whose dgemm the program calls, links resolved: Debian's alternatives
/// decide it at run time.
std::string blas_library()
{
  void *const symbol = dlsym(RTLD_DEFAULT, "dgemm_");
  Dl_info info;
  if (symbol == nullptr || dladdr(symbol, &info) == 0 || info.dli_fname == nullptr)
    return "unknown";
  char *const resolved = realpath(info.dli_fname, nullptr);
  const std::string file = resolved != nullptr ? resolved : info.dli_fname;
  std::free(resolved);
  return file;
}

/// "Open MPI v4.1.4" of a text that goes on with build details.
std::string mpi_library()
{
  char text[MPI_MAX_LIBRARY_VERSION_STRING];
  int length = 0;
  MPI_Get_library_version(text, &length);
  const std::string whole(text, static_cast<std::size_t>(length));
  return whole.substr(0, whole.find_first_of(",\n"));
}
} // namespace

std::string version()
{
  return CONTINUA_VERSION;
}

std::string revision()
{
  return CONTINUA_REVISION;
}

bool revision_is_dirty()
{
  return CONTINUA_DIRTY;
}

std::map<std::string, std::string> library_versions()
{
  return {{"deal.II", DEAL_II_PACKAGE_VERSION},
          {"Trilinos", TRILINOS_VERSION_STRING},
          {"p4est", P4EST_PACKAGE_VERSION},
          {"MUMPS", MUMPS_VERSION},
          {"CHOLMOD", std::to_string(CHOLMOD_MAIN_VERSION) + "." +
                          std::to_string(CHOLMOD_SUB_VERSION) + "." +
                          std::to_string(CHOLMOD_SUBSUB_VERSION)},
          {"MPI", mpi_library()},
          {"BLAS", blas_library()}};
}

bool blas_is_reference()
{
  return blas_is_reference(blas_library());
}

bool blas_is_reference(const std::string &library_file)
{
  for (const char *const optimised : {"openblas", "atlas", "mkl", "blis"})
    if (library_file.find(optimised) != std::string::npos)
      return false;
  // "libblas.so" without one of those names is netlib's; of any other name nothing is known against
  // it.
  return library_file.find("libblas.so") != std::string::npos ||
         library_file.find("netlib") != std::string::npos;
}
} // namespace Continua
