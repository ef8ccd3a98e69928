#include <continua/linear_algebra/sub_matrix.h>

#include <Epetra_Comm.h>
#include <Epetra_Import.h>
#include <Epetra_IntVector.h>
#include <Epetra_Map.h>

#include <utility>

namespace Continua
{
SubMatrix::SubMatrix(const Epetra_CrsMatrix &parent, std::vector<unsigned int> rows)
    : local_rows(std::move(rows))
{
  const Epetra_Map map(-1, static_cast<int>(local_rows.size()), 0, parent.Comm());
  // The new number of every row, and of every column of this rank's rows; -1 of those left out.
  Epetra_IntVector number_of_row(parent.RowMap()), number_of_column(parent.ColMap());
  number_of_row.PutValue(-1);
  for (std::size_t k = 0; k < local_rows.size(); ++k)
    number_of_row[local_rows[k]] = map.GID(static_cast<int>(k));
  if (parent.Importer() != nullptr)
    number_of_column.Import(number_of_row, *parent.Importer(), Insert);
  else
    for (int k = 0; k < parent.NumMyRows(); ++k)
      number_of_column[k] = number_of_row[k];

  entries = std::make_unique<Epetra_CrsMatrix>(Copy, map, 0);
  std::vector<int> columns;
  std::vector<double> values;
  for (std::size_t k = 0; k < local_rows.size(); ++k)
  {
    int n_entries = 0;
    double *row_values = nullptr;
    int *row_columns = nullptr;
    parent.ExtractMyRowView(static_cast<int>(local_rows[k]), n_entries, row_values, row_columns);
    columns.clear();
    values.clear();
    for (int e = 0; e < n_entries; ++e)
      if (number_of_column[row_columns[e]] >= 0)
      {
        columns.push_back(number_of_column[row_columns[e]]);
        values.push_back(row_values[e]);
      }
    entries->InsertGlobalValues(map.GID(static_cast<int>(k)), static_cast<int>(columns.size()),
                                values.data(), columns.data());
  }
  entries->FillComplete();
  entries->OptimizeStorage();
}

SymmetricTriplets SubMatrix::lower_triangle() const
{
  SymmetricTriplets result;
  result.n = entries->NumGlobalRows();
  for (int k = 0; k < entries->NumMyRows(); ++k)
  {
    int n_entries = 0;
    double *values = nullptr;
    int *columns = nullptr;
    entries->ExtractMyRowView(k, n_entries, values, columns);
    const int row = entries->GRID(k);
    for (int e = 0; e < n_entries; ++e)
      if (entries->GCID(columns[e]) <= row)
      {
        result.rows.push_back(row);
        result.columns.push_back(entries->GCID(columns[e]));
        result.values.push_back(values[e]);
      }
  }
  return result;
}

std::vector<int> SubMatrix::owned() const
{
  std::vector<int> indices;
  for (int k = 0; k < entries->NumMyRows(); ++k)
    indices.push_back(entries->GRID(k));
  return indices;
}

void SubMatrix::gather(const double *const parent, double *const part) const
{
  for (std::size_t k = 0; k < local_rows.size(); ++k)
    part[k] = parent[local_rows[k]];
}

void SubMatrix::scatter_add(const double *const part, double *const parent) const
{
  for (std::size_t k = 0; k < local_rows.size(); ++k)
    parent[local_rows[k]] += part[k];
}

Epetra_CrsMatrix rows_of(const Epetra_CrsMatrix &matrix,
                         const std::vector<unsigned int> &rows,
                         const Epetra_Map &map)
{
  Epetra_CrsMatrix result(Copy, map, 0);
  std::vector<int> columns;
  for (std::size_t k = 0; k < rows.size(); ++k)
  {
    int n_entries = 0;
    double *values = nullptr;
    int *local_columns = nullptr;
    matrix.ExtractMyRowView(static_cast<int>(rows[k]), n_entries, values, local_columns);
    columns.clear();
    for (int e = 0; e < n_entries; ++e)
      columns.push_back(matrix.GCID(local_columns[e]));
    result.InsertGlobalValues(map.GID(static_cast<int>(k)), n_entries, values, columns.data());
  }
  result.FillComplete(matrix.DomainMap(), map);
  return result;
}
} // namespace Continua
