#ifndef continua_finite_volume_value_space_h
#define continua_finite_volume_value_space_h

#include <continua/finite_volume/cell_wise_mesh.h>
#include <continua/finite_volume/stencil.h>

#include <deal.II/base/index_set.h>
#include <deal.II/lac/trilinos_vector.h>

#include <array>
#include <vector>

namespace Continua
{
/// What the two cells beside an interface between materials have on their common face.
enum class InterfaceValue
{
  common, ///< one value: velocity and displacement are continuous
  broken  ///< one value each: the pressure jumps
};

/**
 * Global numbers for the values of one quantity: one per cell, one per boundary face, and one or
 * two per face between materials. Each rank's numbers are contiguous, its cells' first (in the
 * order of CellWiseMesh). A vector field has `dim` entries for each value, number dim * value +
 * component.
 */
template <int dim>
class ValueSpace
{
public:
  ValueSpace(const CellWiseMesh<dim> &mesh, InterfaceValue interface_value);

  /// Numbers the values of the present mesh.
  void distribute();

  /// Global numbers of the value of a cell (owned or ghost) and of a face on one of its sides; the
  /// face must have a value.
  unsigned int of_cell(const unsigned int cell) const { return cell_values[cell]; }
  unsigned int of_face(const unsigned int face, const unsigned int side) const
  {
    return face_values[face][interface_value == InterfaceValue::common ? 0 : side];
  }
  /// The value beyond a face, seen from one side: the face's own or the other cell's.
  unsigned int beyond(unsigned int face, unsigned int side) const;
  /// Whether a face's value is this rank's: the common one is the owner cell's rank's, a broken one
  /// that of the cell on its side.
  bool owns_face(unsigned int face, unsigned int side) const;

  unsigned int n_values() const { return n_global; }
  unsigned int first_owned() const { return first; }
  unsigned int n_owned() const { return n_local; }
  /// The entries of a field with so many components on this rank.
  dealii::IndexSet owned(unsigned int n_components) const;
  dealii::TrilinosWrappers::MPI::Vector vector(unsigned int n_components) const;
  /// Numbers of a field's entries on this rank, for VectorNumbering: along the cells in the order
  /// of the tree, of each its own value and then those of its faces.
  std::vector<unsigned long> numbers(unsigned int n_components) const;

private:
  const CellWiseMesh<dim> &mesh;
  InterfaceValue interface_value;
  unsigned int first = 0, n_local = 0, n_global = 0;
  std::vector<unsigned int> cell_values;
  std::vector<std::array<unsigned int, 2>> face_values;
};
} // namespace Continua

#endif
