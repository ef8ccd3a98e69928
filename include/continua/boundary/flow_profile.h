#ifndef continua_boundary_flow_profile_h
#define continua_boundary_flow_profile_h

#include <continua/base/words.h>
#include <continua/boundary/profile_table.h>
#include <continua/signal/waveform.h>

#include <array>
#include <memory>
#include <vector>

namespace Continua
{
/// What a womersley profile takes the liquid to have done before t = 0.
enum class FlowPast
{
  at_rest, ///< nothing
  steady,  ///< it has carried the flow rate of t = 0 for ever
  periodic ///< it has carried a flow rate of a period for ever
};

const Words<FlowPast> &flow_past_words();

/// What a womersley profile needs to know of the liquid and of the run.
struct FlowHistory
{
  double kinematic_viscosity = 0.; ///< nu [m^2/s]
  double end_time = 0.;            ///< [s]
  double time_step = 0.;           ///< [s] over which the flow rate may be taken as linear
  FlowPast past = FlowPast::at_rest;
  double period = 0.; ///< [s] of a periodic past
};

/**
 * The velocity along the normal over a section through which a flow rate Q(t) passes: a disc of
 * radius R, or the gap of a plane channel of the height 2 R, of which Q [m^2/s] is that of a unit
 * of its depth. It is a sum of products
 *
 *   u(r, t) = sum_m S_m(r/R) a_m(t)
 *
 * whose shapes S_m have no dimension and whose amplitudes a_m are in m/s. S_0 has the mean 1 over
 * the section and a_0 = Q/A, where A is pi R^2 or 2 R; the others have the mean 0. All vanish at
 * the rim.
 *
 * flat: S_0 = 1 inside; parabolic: S_0 = 2 (1 - (r/R)^2) in a disc, 3/2 (1 - (r/R)^2) in a channel;
 * table: see ProfileTable.
 *
 * womersley: the flow of a viscous liquid in a rigid tube or channel. In the Laplace transform,
 * with x^2 = s R^2/nu, the velocity over its mean is (I0(x) - I0(x r/R))/I2(x) in a disc, for s = i
 * omega Womersley's profile, and (cosh x - cosh(x r/R))/(cosh x - sinh(x)/x) in a channel. Its
 * poles are at s = -nu j_m^2/R^2, where J2(j_m) = 0 or tan j_m = j_m, and its partial fractions
 * give
 *
 *   S_0 as parabolic,  S_m = 4/j_m^2 (J0(j_m r/R)/J0(j_m) - 1) or
 *                            2/j_m^2 (cos(j_m r/R)/cos(j_m) - 1),
 *   da_m/dt = d/dt Q/A - nu j_m^2/R^2 a_m,
 *
 * exactly, for any Q and without a transform over a finite time that could wrap round. The past
 * gives a_m(0): Q(0)/A of a liquid at rest, 0 of a steady flow, and what comes back after a period
 * of a periodic one. The modes that are left out act together as one more, with the shape that
 * their quasi-steady sum has. In all amplitudes but a_0 Q is taken as linear over a time step.
 */
class FlowProfile
{
public:
  enum class Shape
  {
    flat,
    parabolic,
    womersley,
    table
  };
  /// Through which the liquid flows: a disc or a gap.
  struct Section
  {
    double radius = 1.;                            ///< [m], of a channel half of its gap
    double fraction = 1.;                          ///< the part that the mesh has: 1, 1/2 or 1/4
    std::array<double, 3> centre = {{0., 0., 0.}}; ///< [m]
    bool is_channel = false;
    std::array<double, 3> across = {{0., 1., 0.}}; ///< of a channel, from wall to wall, of length 1
  };
  /// A womersley profile needs `history`, a table its `table`.
  FlowProfile(Shape shape,
              const Waveform &flow_rate,
              const Section &section,
              const FlowHistory &history = FlowHistory(),
              const std::shared_ptr<const ProfileTable> &table = nullptr);

  /// S_m at r/R, in a channel negative on one side; beyond the rim zero.
  std::vector<double> shapes(double relative_radius) const;
  /// S_m at a point of the section; coordinates [m], those that a model does not have are zero.
  std::vector<double> shapes_at(const std::array<double, 3> &point) const;
  /// a_m [m/s]; the vector stays valid until the next call. At `mean_over_period`: of a steady flow
  /// with the mean flow rate.
  const std::vector<double> &amplitudes(double time) const;
  bool depends_on_time() const;
  /// Of the part of the section that the mesh has [m^2]; of a channel its length [m].
  double area() const;

private:
  Shape shape;
  Waveform flow_rate;
  Section section;
  std::shared_ptr<const ProfileTable> table;
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

  double whole_area() const;
  double mean_velocity(double time) const;
  /// S_0, and for a mode of this zero S_m times j_m^2.
  double first_shape(double relative_radius) const;
  double shape_of_mode(double zero, double relative_radius) const;
  void tabulate(const FlowHistory &history);
  /// a_m, m > 0, at t = 0.
  std::vector<double> first_amplitudes(const FlowHistory &history) const;
  /// All rows of a block from its first one, and the first one of the next.
  void fill_block(std::size_t index) const;
  /// Carries a_m, m > 0, over `length` in which the mean velocity changes by `change`.
  void advance(const double *from, double length, double change, double *to) const;
};
} // namespace Continua

#endif
