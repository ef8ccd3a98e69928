#include <continua/base/memory_use.h>
#include <continua/linear_algebra/schur_complement.h>

#include <Epetra_CrsMatrix.h>
#include <Epetra_Export.h>
#include <Epetra_Import.h>
#include <Epetra_Vector.h>
#include <Teuchos_ParameterList.hpp>
#include <ml_MultiLevelPreconditioner.h>

#include <array>
#include <memory>
#include <numeric>
#include <utility>

namespace Continua
{
using namespace dealii;

namespace
{
void check(const int status)
{
  AssertThrow(status >= 0, LACExceptions::ExcTrilinosError(status));
}

/// A vector at the columns that this rank has entries of.
Epetra_Vector at_columns(const Epetra_CrsMatrix &matrix, const DistributedVector &vector)
{
  const Epetra_Vector &owned = *vector.trilinos_vector()(0);
  Epetra_Vector result(matrix.ColMap());
  if (matrix.Importer() != nullptr)
    check(result.Import(owned, *matrix.Importer(), Insert));
  else
    result = owned;
  return result;
}

/// The transpose: complete rows for all columns that this rank has entries of.
std::unique_ptr<Epetra_CrsMatrix> transpose_at_columns(const Epetra_CrsMatrix &matrix)
{
  const Epetra_Map &columns = matrix.ColMap();
  std::vector<int> sizes(columns.NumMyElements(), 0);
  int n_entries = 0;
  double *values = nullptr;
  int *indices = nullptr;
  for (int i = 0; i < matrix.NumMyRows(); ++i)
  {
    matrix.ExtractMyRowView(i, n_entries, values, indices);
    for (int e = 0; e < n_entries; ++e)
      ++sizes[indices[e]];
  }
  // With known sizes the entries are stored once.
  const bool has_fixed_sizes = true;
  auto result = std::make_unique<Epetra_CrsMatrix>(Copy, columns, matrix.RowMap(), sizes.data(),
                                                   has_fixed_sizes);
  for (int i = 0; i < matrix.NumMyRows(); ++i)
  {
    matrix.ExtractMyRowView(i, n_entries, values, indices);
    for (int e = 0; e < n_entries; ++e)
      check(result->InsertMyValues(indices[e], 1, &values[e], &i));
  }
  check(result->FillComplete(matrix.RowMap(), matrix.DomainMap()));
  if (matrix.Comm().NumProc() == 1)
    return result;

  // The rows of other ranks' pressures: added up by the owner of a column, and fetched from there.
  const Epetra_Map &owned = matrix.DomainMap();
  Epetra_CrsMatrix sum(Copy, owned, 0);
  check(sum.Export(*result, Epetra_Export(columns, owned), Add));
  check(sum.FillComplete(matrix.RowMap(), owned));
  result = std::make_unique<Epetra_CrsMatrix>(Copy, columns, 0);
  check(result->Import(sum, Epetra_Import(columns, owned), Insert));
  check(result->FillComplete(matrix.RowMap(), owned));
  return result;
}

/// C + B D B^T without FillComplete, so that the caller can free B first. The product of EpetraExt
/// takes more time and more memory.
std::unique_ptr<Epetra_CrsMatrix> make_laplacian(const Epetra_CrsMatrix &divergence,
                                                 const Epetra_CrsMatrix &compression,
                                                 const DistributedVector &mobility)
{
  const Epetra_Map &map = divergence.RowMap();
  auto sum = std::make_unique<Epetra_CrsMatrix>(Copy, map, 0);
  const Epetra_Vector weights = at_columns(divergence, mobility);
  const std::unique_ptr<Epetra_CrsMatrix> transposed = transpose_at_columns(divergence);
  const Epetra_Map &pressures = transposed->ColMap();
  std::vector<double> entries(pressures.NumMyElements(), 0.), row_values;
  std::vector<bool> is_in_row(entries.size(), false);
  std::vector<int> row, row_columns;
  for (int i = 0; i < divergence.NumMyRows(); ++i)
  {
    row.clear();
    int n_velocities = 0;
    double *of_velocities = nullptr;
    int *velocities = nullptr;
    divergence.ExtractMyRowView(i, n_velocities, of_velocities, velocities);
    for (int v = 0; v < n_velocities; ++v)
    {
      const double factor = of_velocities[v] * weights[velocities[v]];
      int n_pressures = 0;
      double *of_pressures = nullptr;
      int *neighbours = nullptr;
      transposed->ExtractMyRowView(velocities[v], n_pressures, of_pressures, neighbours);
      for (int p = 0; p < n_pressures; ++p)
      {
        const int j = neighbours[p];
        entries[j] += factor * of_pressures[p];
        if (!is_in_row[j])
          row.push_back(j);
        is_in_row[j] = true;
      }
    }
    row_columns.clear();
    row_values.clear();
    for (const int j : row)
    {
      row_columns.push_back(pressures.GID(j));
      row_values.push_back(entries[j]);
      entries[j] = 0.;
      is_in_row[j] = false;
    }
    // FillComplete adds the entries of C to those of the same columns.
    int n_compressions = 0;
    double *compressions = nullptr;
    int *columns = nullptr;
    compression.ExtractMyRowView(i, n_compressions, compressions, columns);
    for (int e = 0; e < n_compressions; ++e)
    {
      row_columns.push_back(compression.GCID(columns[e]));
      row_values.push_back(compressions[e]);
    }
    check(sum->InsertGlobalValues(map.GID(i), static_cast<int>(row_columns.size()),
                                  row_values.data(), row_columns.data()));
  }
  return sum;
}

std::vector<unsigned int> all_rows(const TrilinosWrappers::SparseMatrix &matrix)
{
  std::vector<unsigned int> rows(matrix.local_size());
  std::iota(rows.begin(), rows.end(), 0u);
  return rows;
}
} // namespace

SchurComplement::SchurComplement(TrilinosWrappers::SparseMatrix &&divergence,
                                 const TrilinosWrappers::SparseMatrix &compression,
                                 const TrilinosWrappers::SparseMatrix *const mass_form,
                                 const DistributedVector *const mobility,
                                 const Places &places)
    : SchurComplement(
          std::move(divergence), compression, mass_form, mobility, places, all_rows(compression))
{
}

SchurComplement::SchurComplement(TrilinosWrappers::SparseMatrix &&divergence,
                                 const TrilinosWrappers::SparseMatrix &compression,
                                 const TrilinosWrappers::SparseMatrix *const mass_form,
                                 const DistributedVector *const mobility,
                                 const Places &places,
                                 const std::vector<unsigned int> &pressures)
    : has_mass(mass_form != nullptr), has_laplacian(mobility != nullptr)
{
  diagonal_entries.reinit(divergence.locally_owned_range_indices(),
                          divergence.get_mpi_communicator());
  set_diagonal(divergence, compression, mass_form, mobility);
  part = std::make_unique<SubMatrix>(compression.trilinos_matrix(), pressures);
  const Epetra_Map &map = part->matrix().RowMap();
  is_empty = map.NumGlobalElements() == 0;
  if (is_empty || !has_laplacian)
    divergence.clear();
  if (is_empty)
    return;
  for (std::unique_ptr<Epetra_Vector> *const vector : {&right_hand_side, &solution, &correction})
    *vector = std::make_unique<Epetra_Vector>(map);
  if (has_mass)
  {
    mass.reinit(SubMatrix(mass_form->trilinos_matrix(), pressures).matrix());
    mass_inverse.initialize(mass);
  }
  if (has_laplacian)
  {
    std::unique_ptr<Epetra_CrsMatrix> sum;
    if (map.SameAs(divergence.trilinos_matrix().RowMap()))
      sum = make_laplacian(divergence.trilinos_matrix(), part->matrix(), *mobility);
    else
    {
      const Epetra_CrsMatrix rows = rows_of(divergence.trilinos_matrix(), pressures, map);
      divergence.clear();
      sum = make_laplacian(rows, part->matrix(), *mobility);
    }
    divergence.clear();
    return_freed_memory();
    check(sum->FillComplete());
    laplacian.reinit(*sum);
    sum = nullptr;
    Teuchos::ParameterList list;
    ML_Epetra::SetDefaults("SA", list);
    list.set("ML output", 0);
    list.set("aggregation: type", "Uncoupled");
    // Which couplings are strong follows from distances. By the entries, in a bend with cells ten
    // times as long as thick, FGMRES takes three times as many iterations. With D of SIMPLE alone,
    // which jumps by orders of magnitude at walls, the entries are the better choice.
    const bool by_distance = has_mass && !places.empty();
    list.set("aggregation: threshold", by_distance ? 0. : 0.02);
    list.set("aggregation: aux: enable", by_distance);
    list.set("aggregation: aux: threshold", 0.01);
    list.set("aggregation: aux: max levels", 10);
    const std::array<const char *, 3> directions = {
        {"x-coordinates", "y-coordinates", "z-coordinates"}};
    for (std::size_t c = 0; c < places.size(); ++c)
    {
      places_of_part.emplace_back();
      for (const unsigned int i : pressures)
        places_of_part[c].push_back(places[c][i]);
      places_of_part[c].push_back(0.); // a rank without pressures has no null pointer either
      list.set(directions[c], places_of_part[c].data());
    }
    list.set("smoother: type", "IFPACK");
    list.set("smoother: ifpack type", "ILU");
    list.set("smoother: ifpack overlap", 0);
    // The incomplete factor is that of a rank's rows alone. With one sweep two ranks take a quarter
    // more iterations than one, and fine meshes of branching vessels a fifth more than with three.
    list.set("smoother: sweeps", 3);
    list.set("coarse: max size", 500);
    laplacian_inverse.initialize(laplacian, list);
  }
}

void SchurComplement::set_diagonal(const TrilinosWrappers::SparseMatrix &divergence,
                                   const TrilinosWrappers::SparseMatrix &compression,
                                   const TrilinosWrappers::SparseMatrix *const mass_form,
                                   const DistributedVector *const mobility)
{
  const Epetra_CrsMatrix &b = divergence.trilinos_matrix();
  std::unique_ptr<Epetra_Vector> mobility_of_columns;
  if (has_laplacian)
    mobility_of_columns = std::make_unique<Epetra_Vector>(at_columns(b, *mobility));
  for (unsigned int i = 0; i < diagonal_entries.locally_owned_size(); ++i)
  {
    const auto global = b.GRID(static_cast<int>(i));
    double inverse = 0.;
    if (has_mass)
      inverse += 1. / mass_form->diag_element(global);
    if (has_laplacian)
    {
      double sum = compression.el(global, global); // 0 where nothing is compressible
      int n_entries = 0;
      double *values = nullptr;
      int *columns = nullptr;
      b.ExtractMyRowView(static_cast<int>(i), n_entries, values, columns);
      for (int e = 0; e < n_entries; ++e)
        sum += values[e] * values[e] * (*mobility_of_columns)[columns[e]];
      inverse += 1. / sum;
    }
    diagonal_entries.begin()[i] = 1. / inverse;
  }
}

void SchurComplement::scale_mass_inverse(const DistributedVector &roots)
{
  if (is_empty)
    return;
  if (!mass_roots)
    mass_roots = std::make_unique<Epetra_Vector>(part->matrix().RowMap());
  part->gather(roots.begin(), mass_roots->Values());
}

void SchurComplement::vmult(DistributedVector &target, const DistributedVector &source)
{
  target = 0.;
  if (is_empty)
    return;
  part->gather(source.begin(), right_hand_side->Values());
  if (has_laplacian)
    laplacian_inverse.trilinos_operator().ApplyInverse(*right_hand_side, *solution);
  else
    solution->PutScalar(0.);
  if (has_mass)
  {
    if (mass_roots)
      right_hand_side->Multiply(1., *mass_roots, *right_hand_side, 0.);
    mass_inverse.trilinos_operator().ApplyInverse(*right_hand_side, *correction);
    if (mass_roots)
      correction->Multiply(1., *mass_roots, *correction, 0.);
    solution->Update(1., *correction, 1.);
  }
  part->scatter_add(solution->Values(), target.begin());
}
} // namespace Continua
