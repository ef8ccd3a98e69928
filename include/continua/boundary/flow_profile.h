#ifndef continua_boundary_flow_profile_h
#define continua_boundary_flow_profile_h

#include <continua/signal/waveform.h>

#include <array>
#include <vector>

namespace Continua
{
/// What a womersley profile needs to know of the liquid and of the run.
struct FlowHistory
{
  double kinematic_viscosity = 0.; ///< nu [m^2/s]
  double end_time = 0.;            ///< [s]
  double time_step = 0.;           ///< [s] over which the flow rate may be taken as linear
};

/**
 * The axial velocity over a round section of radius R through which a flow rate Q(t) [m^3/s]
 * passes, as a sum of products
 *
 *   u(r, t) = sum_m S_m(r/R) a_m(t)
 *
 * whose shapes S_m have no dimension and whose amplitudes a_m are in m/s. S_0 has the mean 1 over
 * the section and a_0 = Q/(pi R^2); the others have the mean 0. All vanish at the rim.
 *
 * flat: S_0 = 1 inside; parabolic: S_0 = 2 (1 - (r/R)^2).
 *
 * womersley: the flow of a viscous liquid in a rigid tube, at rest before t = 0 and with Q(t) from
 * then on. In the Laplace transform, with x^2 = s R^2/nu, the velocity over its mean is
 * (I0(x) - I0(x r/R))/I2(x), for s = i omega Womersley's profile. Its poles are at s = -nu
 * j_m^2/R^2, J2(j_m) = 0, and its partial fractions give
 *
 *   S_0 as parabolic,  S_m = 4/j_m^2 (J0(j_m r/R)/J0(j_m) - 1),
 *   da_m/dt = d/dt Q/(pi R^2) - nu j_m^2/R^2 a_m,
 *
 * exactly, for any Q and without a transform over a finite time that could wrap round. The modes
 * that are left out act together as one more, with the shape that their quasi-steady sum has. In
 * all amplitudes but a_0 Q is taken as linear over a time step.
 */
class FlowProfile
{
public:
  enum class Shape
  {
    flat,
    parabolic,
    womersley
  };
  /// The disc through which the liquid flows.
  struct Disc
  {
    double radius = 1.;                            ///< [m]
    double fraction = 1.;                          ///< the part that the mesh has: 1, 1/2 or 1/4
    std::array<double, 3> centre = {{0., 0., 0.}}; ///< [m]
  };
  /// A womersley profile needs `history`.
  FlowProfile(Shape shape,
              const Waveform &flow_rate,
              const Disc &disc,
              const FlowHistory &history = FlowHistory());

  /// S_m at r/R; beyond the rim zero.
  std::vector<double> shapes(double relative_radius) const;
  /// S_m at a point of the disc; coordinates [m], those that a model does not have are zero.
  std::vector<double> shapes_at(const std::array<double, 3> &point) const;
  /// a_m [m/s]; the vector stays valid until the next call.
  const std::vector<double> &amplitudes(double time) const;
  bool depends_on_time() const;
  /// Of the part of the disc that the mesh has [m^2].
  double area() const;

private:
  bool is_flat;
  Waveform flow_rate;
  Disc disc;
  std::vector<double> zeros; ///< j_m, of the modes that are kept
  std::vector<double> rates; ///< nu j_m^2/R^2 [1/s], the last one of the tail
  double row_length = 0.;    ///< [s]
  std::size_t n_rows = 0;
  /// a_m, m > 0, at the times row * row_length: of the first row of every block, and of all rows of
  /// the block that was asked for last.
  std::vector<double> first_rows;
  mutable std::vector<double> block;
  mutable std::size_t present_block = 0;
  mutable std::vector<double> present;
  mutable double present_time;

  double mean_velocity(double time) const;
  void tabulate(const FlowHistory &history);
  /// All rows of a block from its first one, and the first one of the next.
  void fill_block(std::size_t index) const;
  /// Carries a_m, m > 0, over `length` in which the mean velocity changes by `change`.
  void advance(const double *from, double length, double change, double *to) const;
};
} // namespace Continua

#endif
