#include <continua/base/input_error.h>
#include <continua/linear_algebra/eigenpairs.h>

#include <slepceps.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <string>

namespace Continua
{
namespace
{
/// PETSc's objects do not throw: what a map throws waits here until SLEPc has returned.
struct ShellMap
{
  LinearMap function;
  std::vector<double> x, y;
  std::exception_ptr exception;
};

void check_petsc(const PetscErrorCode code, const std::string &what)
{
  if (code != 0)
    throw RunError("SLEPc, " + what + ": error " + std::to_string(code) + ".");
}

PetscErrorCode apply(ShellMap &map, Vec in, Vec out)
{
  const PetscScalar *x = nullptr;
  PetscScalar *y = nullptr;
  PetscErrorCode code = VecGetArrayRead(in, &x);
  if (code != 0)
    return code;
  std::copy_n(x, map.x.size(), map.x.begin());
  code = VecRestoreArrayRead(in, &x);
  if (code != 0)
    return code;
  try
  {
    map.function(map.x, map.y);
  }
  catch (...)
  {
    map.exception = std::current_exception();
    return PETSC_ERR_LIB;
  }
  code = VecGetArray(out, &y);
  if (code != 0)
    return code;
  std::copy(map.y.begin(), map.y.end(), y);
  return VecRestoreArray(out, &y);
}

PetscErrorCode multiply(Mat matrix, Vec in, Vec out)
{
  void *map = nullptr;
  const PetscErrorCode code = MatShellGetContext(matrix, &map);
  return code != 0 ? code : apply(*static_cast<ShellMap *>(map), in, out);
}

PetscErrorCode precondition(PC preconditioner, Vec in, Vec out)
{
  void *map = nullptr;
  const PetscErrorCode code = PCShellGetContext(preconditioner, &map);
  return code != 0 ? code : apply(*static_cast<ShellMap *>(map), in, out);
}

/// A matrix of which only products are known, and the solver of its eigenvalues.
struct Solver
{
  ShellMap map;
  Mat matrix = nullptr;
  EPS eps = nullptr;
  Vec real = nullptr, imaginary = nullptr;

  Solver(const LinearMap &function, const unsigned int n_local, const MPI_Comm communicator)
      : map{function, std::vector<double>(n_local), std::vector<double>(n_local), nullptr}
  {
    const auto n = static_cast<PetscInt>(n_local);
    check_petsc(MatCreateShell(communicator, n, n, PETSC_DETERMINE, PETSC_DETERMINE, &map, &matrix),
                "start");
    // PETSc keeps functions of all kinds as this one.
    using Function = void (*)();
    check_petsc(MatShellSetOperation(matrix, MATOP_MULT, reinterpret_cast<Function>(multiply)),
                "start");
    check_petsc(MatCreateVecs(matrix, &real, &imaginary), "start");
    check_petsc(EPSCreate(communicator, &eps), "start");
  }
  Solver(const Solver &) = delete;
  Solver &operator=(const Solver &) = delete;
  ~Solver()
  {
    VecDestroy(&real);
    VecDestroy(&imaginary);
    // Where a product failed SLEPc's objects are half-way, and would say so.
    PetscPushErrorHandler(PetscReturnErrorHandler, nullptr);
    EPSDestroy(&eps);
    PetscPopErrorHandler();
    MatDestroy(&matrix);
  }

  /// The number of values found.
  PetscInt solve(const unsigned int n_wanted, const std::vector<const ShellMap *> &maps)
  {
    PetscInt n = 0;
    check_petsc(MatGetSize(matrix, &n, nullptr), "start");
    check_petsc(
        EPSSetDimensions(eps, std::min<PetscInt>(n_wanted, n), PETSC_DEFAULT, PETSC_DEFAULT),
        "start");
    check_petsc(EPSSetTolerances(eps, 1e-12, 1000), "start");
    // An error is thrown here; PETSc need not print it as well.
    PetscPushErrorHandler(PetscReturnErrorHandler, nullptr);
    const PetscErrorCode code = EPSSolve(eps);
    PetscPopErrorHandler();
    for (const ShellMap *const used : maps)
      if (used->exception)
        std::rethrow_exception(used->exception);
    check_petsc(code, "eigenvalues");
    PetscInt n_converged = 0;
    check_petsc(EPSGetConverged(eps, &n_converged), "eigenvalues");
    return n_converged;
  }

  Eigenpair pair(const PetscInt i)
  {
    PetscScalar a = 0., b = 0.;
    check_petsc(EPSGetEigenpair(eps, i, &a, &b, real, imaginary), "eigenvectors");
    return {{a, b}, values_of(real), values_of(imaginary), 0.};
  }

private:
  std::vector<double> values_of(Vec vector) const
  {
    const PetscScalar *x = nullptr;
    check_petsc(VecGetArrayRead(vector, &x), "reading a vector");
    std::vector<double> result(x, x + map.x.size());
    check_petsc(VecRestoreArrayRead(vector, &x), "reading a vector");
    return result;
  }
};

double norm(const std::vector<double> &a, const std::vector<double> &b, const MPI_Comm communicator)
{
  double sum = 0.;
  for (std::size_t i = 0; i < a.size(); ++i)
    sum += a[i] * a[i] + b[i] * b[i];
  MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_DOUBLE, MPI_SUM, communicator);
  return std::sqrt(sum);
}

double residual(const Eigenpair &pair, const LinearMap &map, const MPI_Comm communicator)
{
  const std::size_t n = pair.real.size();
  const double a = pair.value.real(), b = pair.value.imag();
  std::vector<double> real(n), imaginary(n, 0.);
  map(pair.real, real);
  if (b != 0.)
    map(pair.imaginary, imaginary);
  for (std::size_t i = 0; i < n; ++i)
  {
    real[i] -= a * pair.real[i] - b * pair.imaginary[i];
    imaginary[i] -= a * pair.imaginary[i] + b * pair.real[i];
  }
  return norm(real, imaginary, communicator) /
         (std::abs(pair.value) * norm(pair.real, pair.imaginary, communicator));
}

/// Adds the pair with its residual, unless its value is zero beside the first.
void append(std::vector<Eigenpair> &pairs,
            Eigenpair &&pair,
            const LinearMap &map,
            const MPI_Comm communicator)
{
  const double magnitude = std::abs(pair.value);
  const double largest = pairs.empty() ? magnitude : std::abs(pairs.front().value);
  if (!(magnitude > 1e-12 * largest))
    return;
  pair.residual = residual(pair, map, communicator);
  pairs.push_back(std::move(pair));
}
} // namespace

std::vector<Eigenpair> dominant_eigenpairs(const LinearMap &map,
                                           const unsigned int n_local,
                                           const unsigned int n_wanted,
                                           const MPI_Comm communicator)
{
  Solver solver(map, n_local, communicator);
  check_petsc(EPSSetOperators(solver.eps, solver.matrix, nullptr), "start");
  check_petsc(EPSSetProblemType(solver.eps, EPS_NHEP), "start");
  check_petsc(EPSSetWhichEigenpairs(solver.eps, EPS_LARGEST_MAGNITUDE), "start");
  // Both of a conjugate pair count there.
  const PetscInt n_converged = solver.solve(2 * n_wanted, {&solver.map});
  std::vector<Eigenpair> pairs;
  for (PetscInt i = 0; i < n_converged && pairs.size() < n_wanted; ++i)
  {
    Eigenpair pair = solver.pair(i);
    if (pair.value.imag() >= 0.)
      append(pairs, std::move(pair), map, communicator);
  }
  return pairs;
}

std::vector<Eigenpair> dominant_eigenpairs(const LinearMap &symmetric_map,
                                           const LinearMap &inner_product,
                                           const unsigned int n_local,
                                           const unsigned int n_wanted,
                                           const MPI_Comm communicator)
{
  // To SLEPc the problem is S^-1 x = M x / value, of which it inverts the left side: by the
  // preconditioner S alone. S^-1 itself plays no part, so that M may stand in its place.
  Solver solver(inner_product, n_local, communicator);
  check_petsc(EPSSetOperators(solver.eps, solver.matrix, solver.matrix), "start");
  check_petsc(EPSSetProblemType(solver.eps, EPS_GHEP), "start");
  check_petsc(EPSSetTarget(solver.eps, 0.), "start");
  check_petsc(EPSSetWhichEigenpairs(solver.eps, EPS_TARGET_MAGNITUDE), "start");
  ShellMap inverse{symmetric_map, solver.map.x, solver.map.y, nullptr};
  ST transformation = nullptr;
  check_petsc(EPSGetST(solver.eps, &transformation), "start");
  check_petsc(STSetType(transformation, STSINVERT), "start");
  check_petsc(STSetMatMode(transformation, ST_MATMODE_SHELL), "start");
  KSP krylov = nullptr;
  check_petsc(STGetKSP(transformation, &krylov), "start");
  check_petsc(KSPSetType(krylov, KSPPREONLY), "start");
  PC preconditioner = nullptr;
  check_petsc(KSPGetPC(krylov, &preconditioner), "start");
  check_petsc(PCSetType(preconditioner, PCSHELL), "start");
  check_petsc(PCShellSetContext(preconditioner, &inverse), "start");
  check_petsc(PCShellSetApply(preconditioner, precondition), "start");

  const PetscInt n_converged = solver.solve(n_wanted, {&solver.map, &inverse});
  std::vector<double> work(n_local);
  const LinearMap map = [&](const std::vector<double> &x, std::vector<double> &y)
  {
    inner_product(x, work);
    symmetric_map(work, y);
  };
  std::vector<Eigenpair> pairs;
  for (PetscInt i = 0; i < n_converged && pairs.size() < n_wanted; ++i)
  {
    Eigenpair pair = solver.pair(i);
    pair.value = 1. / pair.value;
    append(pairs, std::move(pair), map, communicator);
  }
  return pairs;
}
} // namespace Continua
