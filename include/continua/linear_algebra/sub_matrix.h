#ifndef continua_linear_algebra_sub_matrix_h
#define continua_linear_algebra_sub_matrix_h

#include <continua/linear_algebra/symmetric_factor.h>

#include <Epetra_CrsMatrix.h>
#include <Epetra_Map.h>

#include <memory>
#include <vector>

namespace Continua
{
/// The rows and columns of some unknowns of a square distributed matrix, renumbered without gaps in
/// the order in which they are given.
class SubMatrix
{
public:
  /// `rows`: local indices of this rank's rows.
  SubMatrix(const Epetra_CrsMatrix &parent, std::vector<unsigned int> rows);

  const Epetra_CrsMatrix &matrix() const { return *entries; }
  const std::vector<unsigned int> &rows() const { return local_rows; }
  /// For a direct solver, with the indices that this rank owns.
  SymmetricTriplets lower_triangle() const;
  std::vector<int> owned() const;

  /// part = parent vector at the rows, and parent vector += part there.
  void gather(const double *parent, double *part) const;
  void scatter_add(const double *part, double *parent) const;

private:
  std::vector<unsigned int> local_rows;
  std::unique_ptr<Epetra_CrsMatrix> entries;
};

/// Some rows of a distributed matrix, with all their columns and renumbered as those of `map`.
/// `rows`: local indices of this rank's.
Epetra_CrsMatrix rows_of(const Epetra_CrsMatrix &matrix,
                         const std::vector<unsigned int> &rows,
                         const Epetra_Map &map);
} // namespace Continua

#endif
