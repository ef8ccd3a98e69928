#ifndef continua_finite_element_solvers_harmonic_matrix_h
#define continua_finite_element_solvers_harmonic_matrix_h

#include <continua/finite_element/conditions/boundary_constraints.h>
#include <continua/finite_element/products/region_operators.h>
#include <continua/finite_element/solvers/harmonic_coefficients.h>
#include <continua/finite_element/solvers/loaded_body.h>
#include <continua/finite_element/space/space.h>
#include <continua/linear_algebra/symmetric_factor.h>

#include <complex>
#include <vector>

namespace Continua
{
/**
 * The matrix [A -B^T; -B -C] of a motion exp(s t), with the boundary constraints eliminated on both
 * sides, as a sum of real matrices with complex coefficients. The real ones are assembled once, and
 * of all of them each rank has one pattern: a new s costs one pass over their entries. Velocities
 * come first; of the symmetric matrix the lower triangle, and all entries about a state under
 * loads, where the matrix is symmetric up to the error of the mesh.
 */
class HarmonicMatrix
{
public:
  /// Assembles the parts; each rank gets those of all ranks. Collective.
  template <int dim>
  void build(const Space<dim> &space,
             const std::vector<RegionOperators> &operators,
             const BoundaryConstraints<dim> &constraints);

  /// The same of a body about a state under loads. Collective.
  template <int dim>
  void build(const Space<dim> &space,
             const std::vector<RegionOperators> &operators,
             const BoundaryConstraints<dim> &constraints,
             const LoadedBody<dim> &loaded);

  bool is_symmetric() const { return has_one_triangle; }
  int size() const { return n; }
  /// Of the entries, from 0, in the order of values().
  std::vector<int> rows() const;
  std::vector<int> columns() const;
  void set_values(const HarmonicCoefficients &coefficients,
                  std::vector<std::complex<double>> &values) const;

private:
  /// Entries of one real matrix, by their place in the pattern.
  struct Part
  {
    std::vector<unsigned int> places;
    std::vector<double> values;
  };
  int n = 0;
  bool has_one_triangle = true;
  /// Row times n plus column, in increasing order.
  std::vector<unsigned long long> pattern;
  Part constant, support_stiffness, support_damping;
  /// By region; those of compression or of viscosity are empty.
  std::vector<Part> mass, stiffness, compression, viscosity;

  /// Adds the places of the entries to the pattern.
  template <typename Entries>
  void take_places(const Entries &triplets);
  template <typename Entries>
  Part part_of(const Entries &triplets) const;
};
} // namespace Continua

#endif
