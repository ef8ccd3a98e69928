#include <continua/base/input_error.h>
#include <continua/linear_algebra/eigenpairs.h>

#include <deal.II/lac/lapack_templates.h>

#include <slepceps.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <string>

namespace Continua
{
namespace
{
/// Below so much of the largest value one counts as zero.
constexpr double zero_value = 1e-12;

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

  /// Seeks among the vectors that are orthogonal to those in the problem's inner product.
  void leave_out(const std::vector<Eigenpair> &pairs)
  {
    std::vector<Vec> vectors(pairs.size(), nullptr);
    for (std::size_t k = 0; k < pairs.size(); ++k)
    {
      check_petsc(VecDuplicate(real, &vectors[k]), "start");
      PetscScalar *x = nullptr;
      check_petsc(VecGetArray(vectors[k], &x), "start");
      std::copy(pairs[k].real.begin(), pairs[k].real.end(), x);
      check_petsc(VecRestoreArray(vectors[k], &x), "start");
    }
    n_left_out = static_cast<PetscInt>(vectors.size());
    check_petsc(EPSSetDeflationSpace(eps, n_left_out, vectors.data()), "start");
    for (Vec &vector : vectors)
      check_petsc(VecDestroy(&vector), "start");
  }

  /// The number of values found.
  PetscInt solve(const unsigned int n_wanted, const std::vector<const ShellMap *> &maps)
  {
    PetscInt n = 0;
    check_petsc(MatGetSize(matrix, &n, nullptr), "start");
    n -= n_left_out;
    if (n <= 0)
      return 0;
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
  PetscInt n_left_out = 0;

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
  if (!(magnitude > zero_value * largest))
    return;
  pair.residual = residual(pair, map, communicator);
  pairs.push_back(std::move(pair));
}

/// The pairs that SLEPc finds of an unsymmetric map, each of two conjugate ones once.
std::vector<Eigenpair> krylov_schur(const LinearMap &map,
                                    const unsigned int n_local,
                                    const unsigned int n_wanted,
                                    const MPI_Comm communicator)
{
  Solver solver(map, n_local, communicator);
  check_petsc(EPSSetOperators(solver.eps, solver.matrix, nullptr), "start");
  check_petsc(EPSSetProblemType(solver.eps, EPS_NHEP), "start");
  check_petsc(EPSSetWhichEigenpairs(solver.eps, EPS_LARGEST_MAGNITUDE), "start");
  const PetscInt n_converged = solver.solve(n_wanted, {&solver.map});
  std::vector<Eigenpair> pairs;
  for (PetscInt i = 0; i < n_converged; ++i)
  {
    Eigenpair pair = solver.pair(i);
    if (pair.value.imag() >= 0.)
      pairs.push_back(std::move(pair));
  }
  return pairs;
}

/**
 * A space that an unsymmetric map leads into itself, by an orthonormal basis Q: A Q = Q T. The
 * eigenpairs of the small matrix T are those of A in the space. What is left of the map beside it,
 * (1 - Q Q^T) A, has the other values of A; an eigenvector of that one makes the space larger.
 */
class InvariantSpace
{
public:
  InvariantSpace(const LinearMap &map, const unsigned int n_local, const MPI_Comm communicator)
      : map(map), n_local(n_local), communicator(communicator)
  {
  }

  /// Whether the space has become larger.
  bool add(const Eigenpair &pair)
  {
    const bool has_grown = add(pair.real);
    return (pair.value.imag() != 0. && add(pair.imaginary)) || has_grown;
  }

  void remove_from(std::vector<double> &x) const
  {
    // Twice: the first time leaves round-off of what it removes.
    for (unsigned int pass = 0; pass < 2; ++pass)
    {
      const std::vector<double> parts = products_with(x);
      for (std::size_t k = 0; k < basis.size(); ++k)
        for (unsigned int i = 0; i < n_local; ++i)
          x[i] -= parts[k] * basis[k][i];
    }
  }

  /// The pairs of largest magnitude, the largest first.
  std::vector<Eigenpair> pairs(const unsigned int n_wanted) const
  {
    const auto n = static_cast<dealii::types::blas_int>(basis.size());
    if (n == 0)
      return {};
    std::vector<double> matrix, values(n), imaginary_values(n), vectors(n * n);
    for (const std::vector<double> &image : images)
    {
      const std::vector<double> column = products_with(image);
      matrix.insert(matrix.end(), column.begin(), column.end());
    }
    double size = 0.;
    dealii::types::blas_int status = 0, length = -1;
    std::vector<double> work;
    const auto solve = [&](double *const space)
    {
      dealii::geev("N", "V", &n, matrix.data(), &n, values.data(), imaginary_values.data(), nullptr,
                   &n, vectors.data(), &n, space, &length, &status);
    };
    solve(&size);
    length = static_cast<dealii::types::blas_int>(size);
    work.resize(length);
    solve(work.data());
    if (status != 0)
      throw RunError("LAPACK, eigenvalues: error " + std::to_string(status) + ".");
    std::vector<unsigned int> order;
    for (unsigned int k = 0; k < basis.size(); ++k)
      if (imaginary_values[k] >= 0.)
        order.push_back(k);
    const auto magnitude = [&](const unsigned int k)
    { return std::hypot(values[k], imaginary_values[k]); };
    std::stable_sort(order.begin(), order.end(),
                     [&](const unsigned int a, const unsigned int b)
                     { return magnitude(a) > magnitude(b); });
    std::vector<Eigenpair> result;
    for (const unsigned int k : order)
      if (result.size() < n_wanted)
      {
        const bool is_complex = imaginary_values[k] != 0.;
        // LAPACK puts the imaginary part of a vector into the next column.
        Eigenpair pair{{values[k], imaginary_values[k]},
                       combination(&vectors[k * n]),
                       is_complex ? combination(&vectors[(k + 1) * n])
                                  : std::vector<double>(n_local, 0.),
                       0.};
        append(result, std::move(pair), map, communicator);
      }
    return result;
  }

private:
  const LinearMap &map;
  const unsigned int n_local;
  const MPI_Comm communicator;
  std::vector<std::vector<double>> basis, images; ///< q and A q

  std::vector<double> products_with(const std::vector<double> &x) const
  {
    std::vector<double> result(basis.size(), 0.);
    for (std::size_t k = 0; k < basis.size(); ++k)
      for (unsigned int i = 0; i < n_local; ++i)
        result[k] += basis[k][i] * x[i];
    MPI_Allreduce(MPI_IN_PLACE, result.data(), static_cast<int>(result.size()), MPI_DOUBLE, MPI_SUM,
                  communicator);
    return result;
  }

  std::vector<double> combination(const double *const weights) const
  {
    std::vector<double> result(n_local, 0.);
    for (std::size_t k = 0; k < basis.size(); ++k)
      for (unsigned int i = 0; i < n_local; ++i)
        result[i] += weights[k] * basis[k][i];
    return result;
  }

  bool add(std::vector<double> x)
  {
    const std::vector<double> nothing(n_local, 0.);
    const double before = norm(x, nothing, communicator);
    remove_from(x);
    const double after = norm(x, nothing, communicator);
    if (!(after > 1e-8 * before))
      return false;
    for (double &entry : x)
      entry /= after;
    images.emplace_back(n_local);
    map(x, images.back());
    basis.push_back(std::move(x));
    return true;
  }
};
} // namespace

std::vector<Eigenpair> dominant_eigenpairs(const LinearMap &map,
                                           const unsigned int n_local,
                                           const unsigned int n_wanted,
                                           const MPI_Comm communicator)
{
  InvariantSpace space(map, n_local, communicator);
  // Both of a conjugate pair count there.
  for (const Eigenpair &pair : krylov_schur(map, n_local, 2 * n_wanted, communicator))
    space.add(pair);
  std::vector<Eigenpair> pairs = space.pairs(n_wanted);
  const LinearMap rest = [&](const std::vector<double> &x, std::vector<double> &y)
  {
    map(x, y);
    space.remove_from(y);
  };
  while (true)
  {
    const std::vector<Eigenpair> next = krylov_schur(rest, n_local, 1, communicator);
    if (next.empty())
      break;
    const double size = std::abs(next.front().value);
    const double largest = pairs.empty() ? size : std::abs(pairs.front().value);
    const bool continues = pairs.size() < n_wanted
                               ? size > zero_value * largest
                               : size > (1. + 1e-8) * std::abs(pairs.back().value);
    if (!continues || !space.add(next.front()))
      break;
    pairs = space.pairs(n_wanted);
  }
  return pairs;
}

std::vector<Eigenpair> dominant_eigenpairs(const LinearMap &symmetric_map,
                                           const LinearMap &inner_product,
                                           const unsigned int n_local,
                                           const unsigned int n_wanted,
                                           const MPI_Comm communicator,
                                           const std::vector<Eigenpair> &found)
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

  if (!found.empty())
    solver.leave_out(found);
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
