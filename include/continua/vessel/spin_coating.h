#ifndef continua_vessel_spin_coating_h
#define continua_vessel_spin_coating_h

#include <continua/vessel/tube_law.h>

#include <vector>

namespace Continua
{
/**
 * How tubes like the thesis's are made (appendix A): a pump gives a constant flow of polymer
 * solution to a nozzle on a trolley, which a ball screw moves along a turning steel rod of the
 * tube's inner diameter. The nozzle lays a spiral of stripes that merge and dry to the wall. The
 * trolley's speed makes the thickness, the rod's the distance between the stripes. Servomotors
 * count their turns; speeds are in counts/s.
 *
 * What the appendix prints with a slip, and what is meant and done here:
 * - A.3 and A.18 add d and h to the diameter D; the wall's outer diameter is D + 2 h, without which
 *   A.4 and A.20 give half the volume of A.1.
 * - A.19 divides by the concentration, and A.20 does so again; it is to be done once.
 * - A.15 and A.16 subtract 2 x z, while the diameter grows and z of A.5 is positive: to be added.
 * - The stripe distance is 0.2 to 0.3 mm in section A.4.1, at most 3 mm in section A.2; the ratio
 * of the two speeds in figure A.4, about 0.64, means by A.11 about 2 mm.
 *
 * The appendix gives no flow rate. That of the default, with a concentration within the stated 17
 * to 22.73 %, gives the speeds of figure A.4: 6800 to 3400 and 4200 to 2100 counts/s.
 */
struct SpinCoating
{
  unsigned int rod_counts = 2000;     ///< of the rod's motor, a turn
  unsigned int trolley_counts = 4000; ///< of the ball screw's motor, a turn
  double screw_pitch = 2.5e-3;        ///< the trolley's way, a turn of the screw [m]
  double stripe_distance = 2e-3;      ///< along the rod, between turns of the spiral [m]
  double concentration = 0.2;         ///< volume of the dry wall over that of the solution [1]
  double flow_rate = 5e-6 / 60.;      ///< of the pump [m^3/s]
  double increment = 1e-3;            ///< between the rows of `table`, at most [m]

  /// Declares and reads the entries; throws InputError.
  static SpinCoating read(ParameterSection section);

  // Volumes of solution [m^3], lengths in m.
  /// A.2 to A.4: for any wall h on a tapered rod; exact where h is linear, too.
  double tapered_volume(double first_diameter,
                        double last_diameter,
                        double first_thickness,
                        double last_thickness,
                        double length) const;

  /// A.6: how long the pump takes [s] for a volume [m^3].
  double duration(double volume) const;
  /// How fast the trolley moves where diameter and thickness are such [m/s].
  double trolley_velocity(double diameter, double thickness) const;
  /// A.10, A.25 [counts/s].
  double trolley_speed(double diameter, double thickness) const;
  /// A.9, A.24 [counts/s].
  double rod_speed(double diameter, double thickness) const;

  /// What is to be done at a position of the tube.
  struct Row
  {
    double position;      ///< from the inlet [m]
    double diameter;      ///< [m]
    double thickness;     ///< [m]
    double trolley_speed; ///< [counts/s]
    double rod_speed;     ///< [counts/s]
    double volume;        ///< of solution so far [m^3], A.17 to A.20
    double time;          ///< so far [s]
  };
  /// The positions from the inlet to the outlet, equally far apart; of the tube as made, that is,
  /// before any pre-strain.
  std::vector<Row> table(const TubeLaw &law) const;
};
} // namespace Continua

#endif
