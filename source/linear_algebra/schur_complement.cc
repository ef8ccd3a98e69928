#include <continua/linear_algebra/schur_complement.h>

#include <EpetraExt_MatrixMatrix.h>
#include <EpetraExt_Transpose_RowMatrix.h>
#include <Epetra_CrsMatrix.h>
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
/// C + B D B^T.
void make_laplacian(const Epetra_CrsMatrix &divergence,
                    const Epetra_CrsMatrix &compression,
                    const Epetra_Vector &mobility,
                    TrilinosWrappers::SparseMatrix &laplacian)
{
  // What is not needed any more goes before the next matrix comes: this is where a run with a large
  // mesh has most in memory.
  auto product = std::make_unique<Epetra_CrsMatrix>(Copy, divergence.RowMap(), 0);
  {
    // The transpose as a matrix of its own: EpetraExt takes twenty times as long without it.
    EpetraExt::RowMatrix_Transpose transpose;
    auto &transposed = dynamic_cast<Epetra_CrsMatrix &>(
        transpose(const_cast<Epetra_CrsMatrix &>(divergence))); // which it does not change
    transposed.LeftScale(mobility);
    EpetraExt::MatrixMatrix::Multiply(divergence, false, transposed, false, *product);
  }
  Epetra_CrsMatrix *sum = nullptr;
  EpetraExt::MatrixMatrix::Add(*product, false, 1., compression, false, 1., sum);
  product = nullptr;
  const std::unique_ptr<Epetra_CrsMatrix> owner(sum);
  sum->FillComplete();
  laplacian.reinit(*sum);
}

std::vector<unsigned int> all_rows(const TrilinosWrappers::SparseMatrix &matrix)
{
  std::vector<unsigned int> rows(matrix.local_size());
  std::iota(rows.begin(), rows.end(), 0u);
  return rows;
}
} // namespace

SchurComplement::SchurComplement(const TrilinosWrappers::SparseMatrix &divergence,
                                 const TrilinosWrappers::SparseMatrix &compression,
                                 const TrilinosWrappers::SparseMatrix *const mass_form,
                                 const DistributedVector *const mobility,
                                 const Places &places)
    : SchurComplement(divergence, compression, mass_form, mobility, places, all_rows(divergence))
{
}

SchurComplement::SchurComplement(const TrilinosWrappers::SparseMatrix &divergence,
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
    const Epetra_CrsMatrix &b = divergence.trilinos_matrix();
    if (map.SameAs(b.RowMap()))
      make_laplacian(b, part->matrix(), *mobility->trilinos_vector()(0), laplacian);
    else
      make_laplacian(rows_of(b, pressures, map), part->matrix(), *mobility->trilinos_vector()(0),
                     laplacian);
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
  {
    mobility_of_columns = std::make_unique<Epetra_Vector>(b.ColMap());
    const Epetra_Vector &owned = *mobility->trilinos_vector()(0);
    if (b.Importer() != nullptr)
      mobility_of_columns->Import(owned, *b.Importer(), Insert);
    else
      mobility_of_columns->Update(1., owned, 0.);
  }
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
