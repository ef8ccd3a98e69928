#ifndef continua_finite_volume_split_equations_h
#define continua_finite_volume_split_equations_h

#include <continua/finite_volume/cell_wise_system.h>

#include <deal.II/lac/la_parallel_vector.h>

#include <utility>
#include <vector>

namespace Continua
{
/**
 * The equations of a step as the segregated loop wants them: all unknowns of this rank in one
 * vector with the ghosts that its rows need, in the order cells' velocities, faces' velocities,
 * cells' pressures, faces' pressures, and the residual of each of these four blocks of rows apart.
 * Nothing is allocated after reinit().
 */
template <int dim>
class SplitEquations
{
public:
  using Vector = dealii::LinearAlgebra::distributed::Vector<double>;

  /// A block of this rank's rows: from the first to before the second.
  using Rows = std::pair<unsigned int, unsigned int>;

  explicit SplitEquations(const CellWiseSystem<dim> &system);

  /// Takes the system's present matrix.
  void reinit();

  Vector vector() const;
  Rows cell_momentum() const { return {0, dim * n_cells}; }
  Rows face_momentum() const { return {dim * n_cells, first_pressure}; }
  Rows cell_mass() const { return {first_pressure, first_pressure + n_cells}; }
  Rows face_pressure() const { return {first_pressure + n_cells, n_rows}; }
  bool has_pressure() const { return first_pressure < n_rows; }

  /// Place in the vector of the first velocity component of a value and of a pressure, by their
  /// global numbers in ValueSpace; owned, or a ghost that some row has.
  unsigned int velocity_index(unsigned int value) const;
  unsigned int pressure_index(unsigned int value) const;

  /// Between the solver's vectors and one of ours, owned entries.
  void pack(const DistributedVector &velocity,
            const DistributedVector &pressure,
            Vector &unknowns) const;
  void
  unpack(const Vector &unknowns, DistributedVector &velocity, DistributedVector &pressure) const;

  /// result = right_side - matrix * unknowns in those rows; the unknowns' ghosts must be up to
  /// date.
  void residual(const Rows &rows,
                const Vector &right_side,
                const Vector &unknowns,
                Vector &result) const;
  /// target += factor times those rows of the matrix, their columns of pressures only, times
  /// unknowns.
  void add_pressure_gradient(const Rows &rows,
                             double factor,
                             const Vector &unknowns,
                             Vector &target) const;
  /// The entry of the matrix; 0 if there is none.
  double entry(unsigned int row, unsigned int column) const;

private:
  const CellWiseSystem<dim> &system;
  unsigned int n_cells = 0, first_pressure = 0, n_rows = 0;
  /// Of every rank, and one past the last: first numbers of its velocities' entries and pressures.
  std::vector<unsigned int> first_velocities, first_pressures;
  std::shared_ptr<const dealii::Utilities::MPI::Partitioner> layout;
  // Compressed rows: all columns, those of pressures last.
  std::vector<std::size_t> row_starts, pressure_starts;
  std::vector<unsigned int> columns;
  std::vector<double> values;

  /// Number of an unknown in the order of our vectors, by its number in CellWiseSystem.
  unsigned int global_index(unsigned int number) const;
};
} // namespace Continua

#endif
