#ifndef continua_theory_stream_h
#define continua_theory_stream_h

namespace Continua
{
/// How the velocity of a stream depends on the radius.
enum class StreamProfile
{
  plug,     ///< not at all: the liquid slips along the wall
  power_law ///< V = V_max (1 - (r/R)^m), with no slip; m = 2 is the flow of Poiseuille
};

/// Where the condition of the wall is applied.
enum class StreamWall
{
  mesh_that_stays, ///< on the undeformed wall: the liquid's velocity there is the wall's
  moving           ///< on the wall as it moves: what the liquid carries along it counts
};

/// The mean axial flow of a liquid in a round tube. The place in the section is s = (r/R)^2.
struct Stream
{
  double mean_velocity = 0.; ///< over the section [m/s], not negative
  StreamProfile profile = StreamProfile::power_law;
  double exponent = 2.; ///< m of the power law, at least 2

  double largest_velocity() const; ///< on the axis [m/s]
  double velocity(double s) const; ///< [m/s]
  double slope(double s) const;    ///< dV/ds [m/s]
};
} // namespace Continua

#endif
