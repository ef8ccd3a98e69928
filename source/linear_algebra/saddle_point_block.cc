#include <continua/linear_algebra/saddle_point_block.h>

#include <Epetra_Import.h>
#include <Epetra_IntVector.h>
#include <Epetra_Map.h>
#include <Epetra_MpiComm.h>

#include <algorithm>
#include <utility>

namespace Continua
{
namespace
{
/// The numbers in the block of some rows of a map, counted from `first`; -1 of the others.
Epetra_IntVector
numbers_of(const Epetra_BlockMap &map, const std::vector<unsigned int> &rows, const int first)
{
  Epetra_IntVector result(map);
  result.PutValue(-1);
  for (std::size_t k = 0; k < rows.size(); ++k)
    result[rows[k]] = first + static_cast<int>(k);
  return result;
}

/// The same for the columns of a matrix, from those of its domain.
Epetra_IntVector numbers_of_columns(const Epetra_CrsMatrix &matrix,
                                    const Epetra_IntVector &of_domain)
{
  Epetra_IntVector result(matrix.ColMap());
  if (matrix.Importer() != nullptr)
    result.Import(of_domain, *matrix.Importer(), Insert);
  else
    for (int k = 0; k < result.MyLength(); ++k)
      result[k] = of_domain[k];
  return result;
}

/// Adds the part on and below the diagonal of the block's rows and columns.
void add_entries(const Epetra_CrsMatrix &matrix,
                 const double factor,
                 const std::vector<unsigned int> &rows,
                 const int first_row,
                 const Epetra_IntVector &numbers,
                 SymmetricTriplets &result)
{
  for (std::size_t k = 0; k < rows.size(); ++k)
  {
    int n_entries = 0;
    double *values = nullptr;
    int *columns = nullptr;
    matrix.ExtractMyRowView(static_cast<int>(rows[k]), n_entries, values, columns);
    const int row = first_row + static_cast<int>(k);
    for (int e = 0; e < n_entries; ++e)
      if (numbers[columns[e]] >= 0 && numbers[columns[e]] <= row)
      {
        result.rows.push_back(row);
        result.columns.push_back(numbers[columns[e]]);
        result.values.push_back(factor * values[e]);
      }
  }
}
} // namespace

SaddlePointBlock::SaddlePointBlock(const Epetra_CrsMatrix &divergence,
                                   const Epetra_CrsMatrix &compression,
                                   std::vector<unsigned int> velocities_of_block,
                                   std::vector<unsigned int> pressures_of_block)
    : velocities(std::move(velocities_of_block)),
      pressures(std::move(pressures_of_block)),
      communicator(dynamic_cast<const Epetra_MpiComm &>(divergence.Comm()).Comm()),
      part(velocities.size() + pressures.size())
{
  // Velocities of all ranks come first.
  const Epetra_Map of_velocities(-1, static_cast<int>(velocities.size()), 0, divergence.Comm());
  const Epetra_Map of_pressures(-1, static_cast<int>(pressures.size()), 0, divergence.Comm());
  const int n_velocities = of_velocities.NumGlobalElements();
  first_velocity = velocities.empty() ? 0 : of_velocities.MinMyGID();
  const int first_pressure = n_velocities + (pressures.empty() ? 0 : of_pressures.MinMyGID());

  block.n = n_velocities + of_pressures.NumGlobalElements();
  numbers = std::make_unique<Epetra_IntVector>(
      numbers_of(divergence.DomainMap(), velocities, first_velocity));
  add_entries(divergence, -1., pressures, first_pressure, numbers_of_columns(divergence, *numbers),
              block);
  add_entries(compression, -1., pressures, first_pressure,
              numbers_of_columns(compression,
                                 numbers_of(compression.DomainMap(), pressures, first_pressure)),
              block);
  for (std::size_t k = 0; k < velocities.size(); ++k)
    owned.push_back(first_velocity + static_cast<int>(k));
  for (std::size_t k = 0; k < pressures.size(); ++k)
    owned.push_back(first_pressure + static_cast<int>(k));
}

void SaddlePointBlock::add_velocity_entries(const Epetra_CrsMatrix &matrix)
{
  add_entries(matrix, 1., velocities, first_velocity, numbers_of_columns(matrix, *numbers), block);
}

void SaddlePointBlock::learn_numbers(const std::vector<int> &of_velocities)
{
  std::vector<int> of_others;
  for (const int velocity : of_velocities)
    if (!numbers->Map().MyGID(velocity))
      of_others.push_back(velocity);
  std::sort(of_others.begin(), of_others.end());
  of_others.erase(std::unique(of_others.begin(), of_others.end()), of_others.end());
  const Epetra_Map map(-1, static_cast<int>(of_others.size()), of_others.data(), 0,
                       numbers->Map().Comm());
  numbers_of_others = std::make_unique<Epetra_IntVector>(map);
  numbers_of_others->Import(*numbers, Epetra_Import(map, numbers->Map()), Insert);
}

void SaddlePointBlock::reserve(const std::size_t n_entries)
{
  for (std::vector<int> *const indices : {&block.rows, &block.columns})
    indices->reserve(indices->size() + n_entries);
  block.values.reserve(block.values.size() + n_entries);
}

void SaddlePointBlock::factorize(const double most_bytes)
{
  numbers = nullptr;
  numbers_of_others = nullptr;
  inverse = make_block_factor(std::move(block), owned, most_bytes, communicator);
}

void SaddlePointBlock::add_solution(const double *const momentum,
                                    const double *const mass,
                                    double *const velocity,
                                    double *const pressure)
{
  const std::size_t n = velocities.size();
  for (std::size_t k = 0; k < n; ++k)
    part[k] = momentum[velocities[k]];
  for (std::size_t k = 0; k < pressures.size(); ++k)
    part[n + k] = mass[pressures[k]];
  inverse->solve(part);
  for (std::size_t k = 0; k < n; ++k)
    velocity[velocities[k]] += part[k];
  for (std::size_t k = 0; k < pressures.size(); ++k)
    pressure[pressures[k]] += part[n + k];
}
} // namespace Continua
