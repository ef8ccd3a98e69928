#ifndef continua_finite_element_solvers_harmonic_matrix_h
#define continua_finite_element_solvers_harmonic_matrix_h

#include <continua/finite_element/conditions/boundary_constraints.h>
#include <continua/finite_element/products/region_operators.h>
#include <continua/finite_element/space/space.h>
#include <continua/linear_algebra/symmetric_factor.h>

#include <complex>
#include <vector>

namespace Continua
{
/// What the matrix of a motion exp(s t) is made of, by material id, for displacements.
struct HarmonicCoefficients
{
  using Complex = std::complex<double>;
  std::vector<Complex> mass;            ///< s^2 rho [kg/(m^3 s^2)]
  std::vector<Complex> stiffness;       ///< mu*(s) [Pa]
  std::vector<Complex> compressibility; ///< 1/K*(s) [1/Pa]
  Complex support_stiffness = 1., support_damping = 0.; ///< [1], s [1/s]
};

/**
 * The matrix [A -B^T; -B -C] of a motion exp(s t), with the boundary constraints eliminated on both
 * sides, as a sum of real matrices with complex coefficients. The real ones are assembled once, and
 * of all of them each rank has one pattern: a new s costs one pass over their entries. Velocities
 * come first; of the symmetric matrix the lower triangle.
 */
class HarmonicMatrix
{
public:
  /// Assembles the parts; each rank gets those of all ranks. Collective.
  template <int dim>
  void build(const Space<dim> &space,
             const std::vector<RegionOperators> &operators,
             const BoundaryConstraints<dim> &constraints);

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
  /// Row times n plus column, in increasing order.
  std::vector<unsigned long long> pattern;
  Part constant, support_stiffness, support_damping;
  std::vector<Part> mass, stiffness, compression; ///< by region

  /// Adds the places of the entries to the pattern.
  void take_places(const SymmetricTriplets &triplets);
  Part part_of(const SymmetricTriplets &triplets) const;
};
} // namespace Continua

#endif
