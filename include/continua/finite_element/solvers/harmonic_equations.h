#ifndef continua_finite_element_solvers_harmonic_equations_h
#define continua_finite_element_solvers_harmonic_equations_h

#include <continua/continuum/harmonic_system.h>
#include <continua/continuum/problem.h>
#include <continua/finite_element/assembly/linear_products.h>
#include <continua/finite_element/conditions/boundary_constraints.h>
#include <continua/finite_element/conditions/loads.h>
#include <continua/finite_element/products/region_operators.h>
#include <continua/finite_element/solvers/harmonic_matrix.h>
#include <continua/finite_element/solvers/harmonic_ports.h>
#include <continua/finite_element/solvers/loaded_body.h>
#include <continua/finite_element/space/space.h>

#include <complex>
#include <cstddef>
#include <utility>
#include <vector>

namespace Continua
{
/// A complex vector in the place of two real ones.
struct RealAndImaginary
{
  DistributedVector real, imaginary;

  /// Both have the layout of `vector`.
  explicit RealAndImaginary(const DistributedVector &vector) : real(vector), imaginary(vector) {}
  void set(const std::vector<std::complex<double>> &values);
  std::vector<std::complex<double>> values() const;
};

/// The entries that are not zero, by local index.
std::vector<std::pair<unsigned int, double>> entries_not_zero(const DistributedVector &vector);

/**
 * The left sides of the equations of a motion exp(s t), see HarmonicSystem, with the real products
 * of each region. Vectors hold the owned entries of this rank. All methods with sums or products
 * are collective.
 */
template <int dim>
class HarmonicEquations
{
public:
  using Complex = std::complex<double>;

  /// All must outlive it. `loaded`: null where the motion is about a body without loads.
  HarmonicEquations(const Space<dim> &space,
                    const Problem &problem,
                    const std::vector<RegionOperators> &operators,
                    const BoundaryConstraints<dim> &constraints,
                    const Loads<dim> &loads,
                    const LinearProducts<dim> &products,
                    const HarmonicPorts &ports,
                    LoadedBody<dim> *loaded = nullptr);

  unsigned int n_velocities() const { return space.velocity_owned.n_elements(); }
  unsigned int n_pressures() const { return space.pressure_owned.n_elements(); }
  HarmonicCoefficients coefficients(Complex s) const;
  /// Null where the motion is about a body without loads.
  LoadedBody<dim> *loaded_body() const { return loaded; }
  /// int v . n over the faces of a boundary condition, under loads the present ones [m^2].
  DistributedVector flow_of_velocities(unsigned int condition) const;
  /// The left sides without ports and constraints, of a displacement at all nodes: forces, and
  /// minus the dilatations' deficit, as the rows of the symmetric matrix.
  void apply(const HarmonicCoefficients &at_s,
             const std::vector<Complex> &displacement,
             const std::vector<Complex> &pressure,
             std::vector<Complex> &forces,
             std::vector<Complex> &dilatations);
  /// With ports and constraints, see HarmonicSystem::multiply().
  void multiply(Complex s,
                const HarmonicSolution &solution,
                std::vector<Complex> &forces,
                std::vector<Complex> &dilatations);
  /// T^T of forces, and the pressures' rows of hanging nodes to zero.
  void restrict_rows(std::vector<Complex> &forces, std::vector<Complex> &dilatations) const;
  /// T u of free entries.
  void expand(std::vector<Complex> &displacement) const;

  /// The force q of 1 Pa in a port, times a number, is added to forces.
  void add_port(unsigned int port, Complex pressure, std::vector<Complex> &forces) const;
  /// Out of the body [m^3/s].
  Complex
  flow_of_port(unsigned int port, const std::vector<Complex> &displacement, Complex s) const;
  /// The same, before its parts cancel.
  double size_of_flow(unsigned int port, const std::vector<Complex> &displacement, Complex s) const;

  Complex sum(Complex of_rank) const;
  /// Largest magnitude over all ranks, of all entries or of those from `begin` to `end`; infinite
  /// if one of them is no number.
  double size_of(const std::vector<Complex> &values) const;
  double size_of(const std::vector<Complex> &values, std::size_t begin, std::size_t end) const;
  /// The largest at a surface, a measure of the entries of B [m^2].
  double area_of_node() const { return largest_area; }

private:
  const Space<dim> &space;
  const Problem &problem;
  const std::vector<RegionOperators> &operators;
  const BoundaryConstraints<dim> &constraints;
  const LinearProducts<dim> &products;
  const HarmonicPorts &ports;
  const Loads<dim> &load_list;
  LoadedBody<dim> *const loaded;
  std::vector<std::vector<std::pair<unsigned int, double>>> port_flows; ///< q [m^2]
  double largest_area = 0.;
  DistributedVector velocity_work, pressure_work;

  /// Adds the products of the supports.
  void add_supports(const HarmonicCoefficients &at_s,
                    const RealAndImaginary &displacement,
                    RealAndImaginary &forces);
};
} // namespace Continua

#endif
