#ifndef continua_continuum_harmonic_system_h
#define continua_continuum_harmonic_system_h

#include <deal.II/base/point.h>

#include <complex>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace Continua
{
class HarmonicDerivatives;
struct Problem;
struct ProblemChange;

/// What drives a linear body in motion exp(s t): amplitudes of the owned entries of this rank.
struct HarmonicLoad
{
  using Complex = std::complex<double>;
  std::vector<Complex> forces;     ///< by velocity entry [N]; empty: none
  std::vector<Complex> velocities; ///< prescribed, by velocity entry [m/s]; empty: none
  /// By port, see HarmonicSystem::ports(): the pressure behind an outlet's [Pa], the flow rate that
  /// is given at a free one [m^3/s]. Empty: zero.
  std::vector<Complex> ports;
  /// By pressure entry: right sides of the equations of the dilatations [m^3]; empty: zero. No load
  /// of a file has them.
  std::vector<Complex> dilatations;

  /// Adds factor times the other load.
  void add(Complex factor, const HarmonicLoad &other);
};

/// The motion exp(s t) of the whole body: amplitudes of the owned entries of this rank. The
/// velocity is s times the displacement, in liquids, too.
struct HarmonicSolution
{
  using Complex = std::complex<double>;
  Complex s;                                            ///< [1/s]
  std::vector<Complex> displacement;                    ///< by velocity entry [m]
  std::vector<Complex> pressure;                        ///< by pressure entry [Pa]
  std::vector<Complex> port_pressures, port_flow_rates; ///< by port [Pa], out of the body [m^3/s]

  void add(Complex factor, const HarmonicSolution &other);
};

/// One part of a sum of motions, with the number that it is multiplied by.
struct WeightedSolution
{
  HarmonicSolution solution;
  std::complex<double> factor;
};

/// A number that is linear in the motion exp(s t) at one s, such as that of a probe.
struct HarmonicFunctional
{
  using Complex = std::complex<double>;
  /// As a load: `forces` are what the displacement is multiplied by [unit/m], `dilatations` what
  /// the pressure is multiplied by [unit/Pa], so that the solution under it is the adjoint one.
  HarmonicLoad weights;
  /// By region, the part of these that has the factor mu*(s), without it: local index and weight
  /// [unit/(Pa m)].
  std::vector<std::vector<std::pair<unsigned int, double>>> of_modulus;
};

/// What the entries of the file say of a load: all that acts on one boundary, or in the body.
struct HarmonicLoadSource
{
  std::string name;   ///< of the boundary condition, or "body force"
  int condition = -1; ///< its number in Problem::conditions; -1: body force
  bool depends_on_time = false;
};

/// A number exp(logarithm), so that a determinant neither overflows nor underflows.
struct HarmonicDeterminant
{
  std::complex<double> logarithm; ///< its imaginary part up to multiples of 2 pi
};

/// Where an entry of the velocity is.
template <int dim>
struct VelocityPlace
{
  dealii::Point<dim> point; ///< of its node [m]
  unsigned int component = 0;
};

/// Mean powers over a period of a harmonic motion s = i omega [W].
struct HarmonicPower
{
  double viscosity = 0.;  ///< turned into heat by viscosity
  double relaxation = 0.; ///< and by branches, power laws and volumes that relax
  double supports = 0.;   ///< taken by what is around the region
  double sum() const { return viscosity + relaxation + supports; }
};
struct HarmonicPowers
{
  std::vector<HarmonicPower> regions;
  std::vector<double> ports; ///< taken by what is behind each port, see HarmonicSystem::ports()
  double forces = 0.;        ///< given by forces of the load
  double velocities = 0.;    ///< given by what moves prescribed velocities
  double behind_ports = 0.;  ///< given by pressures behind outlets, and flow rates that are given
  double given() const { return forces + velocities + behind_ports; }
  double taken() const;
};

/**
 * The linear continuum in motion exp(s t), with s = i omega in harmonic motion exp(i omega t), any
 * other complex number on a damped contour or for a resonance. With the displacement D and the
 * pressure p for unknowns the matrix is complex and symmetric, of the matrices of each region that
 * a run in time has:
 *
 *   [s^2 rho M + mu*(s) S + k + s c] D - B^T p = f      forces [N]
 *   -B D - 1/K*(s) M_p p                       = 0      [m^3]
 *
 * mu*(s) and K*(s) are the complex moduli of the material, of a power law too, k and c those of the
 * supports. Outlets and ends answer with their impedance at s. s = 0 is a body at rest; liquids
 * have no displacement there, so that the matrix is singular.
 *
 * All methods are collective. Vectors hold the owned entries of this rank, hanging nodes zero.
 */
template <int dim>
class HarmonicSystem
{
public:
  using Complex = std::complex<double>;
  virtual ~HarmonicSystem() = default;

  virtual unsigned int n_local_velocities() const = 0;
  virtual unsigned int n_local_pressures() const = 0;
  /// Of the whole system, constrained entries included.
  virtual unsigned long long n_unknowns() const = 0;
  /// Local indices of the velocity entries of each region, and whether an entry is free: neither
  /// prescribed nor hanging.
  virtual std::vector<std::vector<unsigned int>> velocity_nodes() const = 0;
  virtual std::vector<bool> free_velocities() const = 0;
  /// By local index.
  virtual std::vector<VelocityPlace<dim>> velocity_places() const = 0;

  /// The loads of the file, in its order.
  virtual std::vector<HarmonicLoadSource> sources() const = 0;
  /// What the entries of a source are at `time` [s], as a real amplitude. Of periodic loads the
  /// amplitude of a harmonic is the sum of these over one period, weighted.
  virtual HarmonicLoad load_of(const HarmonicLoadSource &source, double time) const = 0;
  /// A load of size one at a boundary: a pressure of 1 Pa that pushes on it, where tractions are
  /// given; a velocity of 1 m/s inwards along the normal where that is prescribed; 1 m^3/s inwards
  /// at a flow rate; 1 Pa behind an outlet.
  virtual HarmonicLoad unit_load(unsigned int condition) const = 0;
  /// The boundary conditions of the ports of outlets and of free flow rates.
  virtual const std::vector<unsigned int> &ports() const = 0;

  /// Makes the factor of the system at s. One analysis serves all s. Throws RunError, of a matrix
  /// without an inverse SingularMatrix.
  virtual void factor(Complex s) = 0;
  /// Solves with the last factor, for all loads at once.
  virtual std::vector<HarmonicSolution> solve(const std::vector<HarmonicLoad> &loads) = 0;
  /// Solves at each s for the loads that `loads_at` gives there; `sink` gets the number of the s,
  /// and its solutions, in the order of the s, one after the other. Frequencies are factored side
  /// by side where there are several ranks. `loads_at` is called once for each s, in that order.
  virtual void
  solve_at(const std::vector<Complex> &s,
           const std::function<std::vector<HarmonicLoad>(std::size_t number)> &loads_at,
           const std::function<void(std::size_t number,
                                    const std::vector<HarmonicLoad> &loads,
                                    const std::vector<HarmonicSolution> &solutions)> &sink) = 0;
  /// Within the sink of solve_at(), for the s of this number: solves for other loads with its
  /// factor.
  virtual std::vector<HarmonicSolution> solve_further(std::size_t number,
                                                      const std::vector<HarmonicLoad> &loads) = 0;
  /// The sum of numbers of the solver's probes, with a factor each, at s. Throws
  /// std::invalid_argument for a probe that is not linear in the motion.
  virtual HarmonicFunctional functional(const std::vector<std::pair<unsigned int, double>> &probes,
                                        Complex s) const = 0;
  /// load_of() at t = 0 of each of the sources() as another problem has them, whose entries have
  /// other values.
  virtual std::vector<HarmonicLoad> loads_of(const Problem &changed) = 0;
  /// Of numbers that are linear in the motion, by entries of the file. The changes must outlive it.
  virtual std::unique_ptr<HarmonicDerivatives>
  derivatives(const std::vector<ProblemChange> &changes) = 0;
  /// Of the matrix of the last factor(), constrained rows and ports included, up to a factor that
  /// is the same for all s.
  virtual HarmonicDeterminant determinant() = 0;
  /// The forces [N] and dilatations [m^3] that the system at s leaves of a motion: the left sides
  /// of the equations, with the ports, at free entries, so that they are zero for a free vibration.
  /// `solution.s` plays no part; its ports are taken by their impedance at s.
  virtual void multiply(Complex s,
                        const HarmonicSolution &solution,
                        std::vector<Complex> &forces,
                        std::vector<Complex> &dilatations) = 0;

  /// Makes the real part of factor times the solution the state of the solver: its probes, fields
  /// and energies are then those. A factor exp(i phi) shows the motion at the phase phi, and -i the
  /// imaginary part.
  void show(const HarmonicSolution &solution, Complex factor) { show_sum({{solution, factor}}); }
  /// The same of a sum of motions with different s.
  virtual void show_sum(const std::vector<WeightedSolution> &parts) = 0;
  /// Of a motion about a state under loads: the part of the solution that moves solids by a small
  /// way, so that fields which depend on the state in any way are linear in it. show() adds the
  /// motion to the state then. 0: show() shows the motion alone, and fields are linear.
  virtual double part_for_differences(const HarmonicSolution & /*solution*/) const { return 0.; }
  /// Of a solution at s = i omega under its load.
  virtual HarmonicPowers powers(const HarmonicSolution &solution, const HarmonicLoad &load) = 0;
  /// Half of force times conjugate velocity of a part of the load [W]: the real part is the mean
  /// power that this part gives.
  virtual Complex power_of(const HarmonicLoad &part,
                           const HarmonicSolution &solution,
                           const HarmonicLoad &load) = 0;
  /// Of a boundary condition's faces, out of the body [m^3/s].
  virtual Complex flow_rate(unsigned int condition, const HarmonicSolution &solution) = 0;

  /// Of the last factor, over all ranks [bytes].
  virtual double factor_memory() const = 0;
  virtual std::string solver_name() const = 0;
  /// Of all solutions so far: what is left of the forces, over the largest force at a node.
  virtual double largest_residual() const = 0;
};
} // namespace Continua

#endif
