#ifndef continua_finite_element_solvers_harmonic_sensitivity_h
#define continua_finite_element_solvers_harmonic_sensitivity_h

#include <continua/continuum/harmonic_derivatives.h>
#include <continua/continuum/problem.h>
#include <continua/finite_element/assembly/linear_products.h>
#include <continua/finite_element/products/region_operators.h>
#include <continua/finite_element/solvers/harmonic_equations.h>
#include <continua/finite_element/solvers/harmonic_ports.h>
#include <continua/finite_element/space/space.h>

#include <deal.II/lac/full_matrix.h>

#include <complex>
#include <vector>

namespace Continua
{
/// HarmonicDerivatives of a body without loads, by its matrices: products of the solution with the
/// matrix of each region, once for each solution, and scalar products of these with the adjoint
/// solutions. An entry then costs a few coefficients.
template <int dim>
class HarmonicSensitivity : public HarmonicDerivatives
{
public:
  using Complex = std::complex<double>;

  /// All must outlive it. Collective: assembles the matrices of the supports that change.
  HarmonicSensitivity(const Space<dim> &space,
                      const Problem &problem,
                      const std::vector<RegionOperators> &operators,
                      const LinearProducts<dim> &products,
                      HarmonicEquations<dim> &equations,
                      const HarmonicPorts &ports,
                      const std::vector<ProblemChange> &changes);

  std::vector<std::vector<Complex>>
  evaluate(const HarmonicSolution &solution,
           const std::vector<HarmonicFunctional> &functionals,
           const std::vector<HarmonicSolution> &adjoints) override;

private:
  /// The spring of one half of a boundary condition: its matrix for a modulus of 1 Pa/m, and the
  /// derivatives of its moduli by change.
  struct Support
  {
    std::vector<RegionOperators> unit;
    std::vector<double> stiffness; ///< [Pa/m over the unit of the entry]
    std::vector<double> damping;   ///< [Pa s/m over the unit of the entry]
  };
  /// lambda^T K U by adjoint, of the matrix K of a coefficient; by region of the first three.
  struct Products
  {
    std::vector<std::vector<Complex>> mass, stiffness, pressure_mass, of_modulus;
    std::vector<std::vector<Complex>> supports; ///< by support
    /// int v . n of the adjoint displacements, by port [m^3].
    std::vector<std::vector<Complex>> port_volumes;
  };

  const Space<dim> &space;
  const Problem &problem;
  const std::vector<RegionOperators> &operators;
  const LinearProducts<dim> &products;
  HarmonicEquations<dim> &equations;
  const HarmonicPorts &ports;
  const std::vector<ProblemChange> &changes;
  std::vector<Support> supports;

  void add_support(unsigned int condition, bool normal);
  Products products_of(const HarmonicSolution &solution,
                       const std::vector<HarmonicFunctional> &functionals,
                       const std::vector<HarmonicSolution> &adjoints);
  /// g - A lambda: what a prescribed displacement adds to J beside its part in g.
  std::vector<Complex> reactions(const HarmonicFunctional &functional,
                                 const HarmonicSolution &adjoint);
  /// dZ/dm at s.
  dealii::FullMatrix<Complex> change_of_impedances(const ProblemChange &change, Complex s) const;
  /// Of this rank, of the load of a change, without the ports.
  Complex share_of_load(const HarmonicLoad &load,
                        const HarmonicSolution &adjoint,
                        const std::vector<Complex> &reactions) const;
};
} // namespace Continua

#endif
