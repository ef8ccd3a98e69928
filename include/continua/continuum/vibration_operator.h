#ifndef continua_continuum_vibration_operator_h
#define continua_continuum_vibration_operator_h

#include <continua/linear_algebra/distributed_vector.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace Continua
{
/// The fields that a shape of vibration sets; owned entries [m/s], [m], [Pa].
struct VibratingState
{
  DistributedVector &velocity, &displacement, &pressure;
};

/**
 * A solid body's free, undamped vibrations in a discretisation: M u'' + K u = 0, hence K x = lambda
 * M x with lambda = omega^2 [1/s^2] for a shape x exp(i omega t).
 *
 * The unknowns are the displacements that have inertia and of which each has one direction: all
 * velocity dofs of the finite elements (those held at a support stay zero), the cells' values of
 * the cell-wise discretisation. Pressures and values on faces have none; they are not among the
 * unknowns, K is what is left after they are eliminated, and no matrix K need exist: solve() and
 * accelerate() solve with the whole system and forget the rest. So the pressure may be that of an
 * incompressible material. Vectors hold this rank's unknowns, each on one rank. Loads and
 * prescribed motion play no part; what is prescribed is held. All methods are collective.
 */
template <int dim>
class VibrationOperator
{
public:
  virtual ~VibrationOperator() = default;

  virtual unsigned int n_local_unknowns() const = 0;
  /// The Cartesian direction of each local unknown (0 is x).
  virtual std::vector<unsigned int> directions() const = 0;
  /// Whether K and M are symmetric, M positive semi-definite. Then all lambda are real.
  virtual bool is_symmetric() const = 0;

  /// y = M x [kg m].
  virtual void multiply_mass(const std::vector<double> &x, std::vector<double> &y) = 0;
  /// M times the values of a displacement field [m] of the whole body, supports included [kg m]: so
  /// that a rigid motion's has the mass that is held, too.
  virtual std::vector<double>
  momentum(const std::function<dealii::Tensor<1, dim>(const dealii::Point<dim> &)> &field) = 0;

  /// Sets the shift [1/s^2] and makes the factor of K - shift M, which solve() keeps. Throws
  /// RunError if the matrix is singular: the shift is an eigenvalue.
  virtual void set_shift(double shift) = 0;
  /// x becomes (K - shift M)^-1 x: in [kg m/s^2], out [m].
  virtual void solve(std::vector<double> &x) = 0;
  /// The number of lambda below the shift of the last set_shift(), by the signs of the factor's
  /// pivots. Only where is_symmetric().
  virtual std::size_t n_below_shift() const;

  /// Whether accelerate() exists: M must be regular on the unknowns.
  virtual bool has_acceleration() const { return false; }
  /// y = M^-1 K x [m/s^2]: for the highest modes.
  virtual void accelerate(const std::vector<double> &x, std::vector<double> &y);

  /**
   * Makes a shape [m] the solver's displacement, with the pressure that belongs to it and no
   * velocity, so that probes, fields and energies are those of the shape. `eigenvalue` [1/s^2] is
   * the (real part of the) shape's: (eigenvalue - shift) (K - shift M)^-1 M x gives x again, and
   * with it the eliminated pressure. The real and the imaginary part of a complex shape are set one
   * after the other.
   */
  virtual void set_shape(const std::vector<double> &x, double eigenvalue) = 0;
};
} // namespace Continua

#endif
