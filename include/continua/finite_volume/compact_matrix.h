#ifndef continua_finite_volume_compact_matrix_h
#define continua_finite_volume_compact_matrix_h

#include <continua/finite_volume/cell_wise_mesh.h>
#include <continua/finite_volume/split_equations.h>
#include <continua/linear_algebra/symmetric_factor.h>

#include <array>
#include <vector>

namespace Continua
{
/**
 * A symmetric matrix on the compact stencil: a cell is coupled with the cells behind its faces. It
 * is kept as the sums of its rows and one coefficient a face, so that a product needs no search.
 * Each component of a vector field has its own row sums; all have the same coefficients. Values are
 * those of SplitEquations, whose entries of cells begin at `first` and have the components of a
 * cell side by side.
 */
template <int dim>
class CompactMatrix
{
public:
  using Vector = typename SplitEquations<dim>::Vector;

  explicit CompactMatrix(const CellWiseMesh<dim> &mesh) : mesh(mesh) {}

  /// Without couplings, and row sums of 0.
  void reinit(unsigned int first_entry, unsigned int n_components);
  /// The products with ones in all cells, by this rank's cell and component.
  std::vector<double> &row_sums() { return sums; }
  const std::vector<double> &row_sums() const { return sums; }
  /// Couples the two cells of a face, whose entries are at these places.
  void couple(const VolumeFace<dim> &face,
              const std::array<unsigned int, 2> &places,
              double coefficient);

  /// Of this rank and of one component: an estimate for the choice of a solver.
  std::size_t n_entries() const { return mesh.n_owned_cells() + couplings.size(); }
  /// Factors the matrix of one component. Throws RunError. Collective.
  void factorize(unsigned int component, SymmetricFactor &factor) const;
  /// product = matrix * x on the cells' entries; x's ghosts up to date.
  void multiply(const Vector &x, Vector &product) const;

private:
  struct Coupling
  {
    std::array<unsigned int, 2> places;
    std::array<unsigned int, 2> numbers; ///< of the cells, global
    double coefficient;
  };

  /// Whether the entry at a place is one of this rank's cells.
  bool is_owned(const unsigned int place) const
  {
    return place >= first && place < first + sums.size();
  }

  const CellWiseMesh<dim> &mesh;
  unsigned int first = 0, components = 1;
  std::vector<double> sums;
  std::vector<Coupling> couplings;
};
} // namespace Continua

#endif
