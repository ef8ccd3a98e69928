// Which BLAS is slow, and that every library tells its version.

#include <continua/base/version.h>

#include "../unit_test.h"

#include <deal.II/base/mpi.h>

namespace test_of_version
{
using namespace Continua;

UNIT_TEST(version)
{
  // deal.II brings the BLAS along.
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const std::string debian = "/usr/lib/x86_64-linux-gnu/";
  check::is_true("netlib is the reference", blas_is_reference(debian + "blas/libblas.so.3.11.0"));
  for (const char *const file :
       {"openblas-pthread/libblas.so.3", "openblas-pthread/libopenblasp-r0.3.21.so",
        "atlas/libblas.so.3.10.3", "blis-serial/libblas.so.4", "libmkl_rt.so"})
    check::is_true(std::string("optimised: ") + file, !blas_is_reference(debian + file));
  check::is_true("unknown is not called slow", !blas_is_reference("unknown"));

  const std::map<std::string, std::string> versions = library_versions();
  const std::string number = "[0-9]+\\.[0-9]+";
  for (const char *const name : {"deal.II", "Trilinos", "p4est", "MUMPS", "CHOLMOD", "MPI"})
    check::is_true(name, versions.count(name) == 1 && check::matches(versions.at(name), number));
  check::is_true("BLAS is a file", versions.at("BLAS").front() == '/');
  check::is_true("version", check::matches(version(), "^[0-9]+\\.[0-9]+\\.[0-9]+$"));
  check::is_true("revision", !revision().empty());
}
} // namespace test_of_version
