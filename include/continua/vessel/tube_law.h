#ifndef continua_vessel_tube_law_h
#define continua_vessel_tube_law_h

#include <continua/base/interpolant.h>
#include <continua/base/parameter_section.h>
#include <continua/vessel/wall_layers.h>

#include <functional>
#include <string>
#include <vector>

namespace Continua
{
/**
 * How wide a tube is and how thick its wall is along its axis: inner diameter D(z) and wall
 * thickness h(z) [m] for z from 0 (inlet) to length() [m], as it lies in the experiment, that is,
 * with its axial pre-strain. A value: cheap to copy, does not depend on a mesh.
 *
 * The laws: `uniform`; `taper` (D and h linear); `table` (from a csv file); the tubes `A` to `F` of
 * the thesis (table A.3), 446 mm long:
 *
 *     A   D = 25 mm             h = 0.1 mm
 *     B   D = 25 mm             h = 0.05 mm
 *     C   D = 25 mm             h = 0.05 mm * 25 mm / D_E(z)  (A.14): 0.05 to 0.1 mm, Moens' and
 *                               Korteweg's wave speed is that of E everywhere
 *     D   D = 25 to 12.5 mm     h = 0.1 mm
 *     E   D = 25 to 12.5 mm     h = 0.05 mm
 *     F   D = 25 to 12.5 mm     h = 0.1 mm * D(z) / 25 mm     (A.28): 0.1 to 0.05 mm, that wave
 *                               speed is that of A everywhere
 *
 * and `aorta`, the aorta thoracalis of Westerhof et al., Journal of Biomechanics 2 (1969) 121
 * (table A.1): radius 20 to 11 mm, linear, length 315 mm, with a uniform wall whose thickness is to
 * be given, since only the product Y h/D is published. The wide end is the inlet.
 *
 * Axial pre-strain e: the tube as made, which the law describes, is stretched to (1 + e) times its
 * length. It is a change of geometry alone, with no stress in the stretched state. The wall keeps
 * its volume (Poisson's ratio 1/2) and is free across, so that what is across the axis, D as well
 * as h, becomes (1 + e)^(-1/2) times as large; D/h, the slope's sign and Y h/D stay. At the
 * thesis's 3 % (sections 5.4 and 6.3), D and h are 1.5 % smaller.
 *
 * The wall may have layers, each with the same part of the thickness everywhere.
 */
class TubeLaw
{
public:
  /// Uniform: length 0.1 m, inner diameter 20 mm, wall 1 mm.
  TubeLaw();
  /// All in m.
  static TubeLaw uniform(double length, double inner_diameter, double wall_thickness);
  /// D and h are linear between the inlet and the outlet; all in m.
  static TubeLaw taper(double length,
                       double inlet_diameter,
                       double outlet_diameter,
                       double inlet_thickness,
                       double outlet_thickness);
  /// One of the thesis's tubes, 'A' to 'F'.
  static TubeLaw thesis(char letter);
  /// Through values at positions that increase from 0, in m; positive, as many of each, at least
  /// two.
  static TubeLaw table(const std::vector<double> &positions,
                       const std::vector<double> &inner_diameters,
                       const std::vector<double> &wall_thicknesses,
                       Interpolant::Kind interpolation);
  /// Declares and reads the entries `Law`, `Length`, `Inner diameter`, ... of the section Geometry.
  /// Throws InputError, also for entries that the law does not have, a table that is not right and
  /// a tube whose D or h is not positive somewhere.
  static TubeLaw read(ParameterSection geometry);

  /// This tube stretched to (1 + pre_strain) times its length, see above; pre_strain > -1.
  TubeLaw stretched(double pre_strain) const;
  /// This tube without its pre-strain.
  TubeLaw as_made() const;

  double length() const { return stretch * length_as_made; }
  double inner_diameter(double z) const; ///< [m] at z [m] between 0 and length()
  double wall_thickness(double z) const; ///< [m]
  /// Whether D and h are the same everywhere.
  bool is_uniform() const { return uniform_everywhere; }
  /// As in `Law`: "A", "uniform", ...
  std::string name() const { return law; }
  /// The wall's layers from the inner to the outer one.
  const std::vector<std::string> &layer_names() const { return layers.names; }
  /// Their parts of the thickness; the sum is 1.
  const std::vector<double> &layer_fractions() const { return layers.fractions; }
  bool is_rigid() const { return layers.names.empty(); } ///< there is no wall
  /// For a wall that is not read from a file. Without layers the thickness is zero.
  void set_layers(const std::vector<std::string> &names, const std::vector<double> &fractions);

private:
  using Profile = std::function<double(double)>;
  TubeLaw(const std::string &law,
          double length,
          const Profile &diameter,
          const Profile &thickness,
          bool uniform_everywhere);
  static TubeLaw read_law(ParameterSection &geometry, const std::string &law, bool is_rigid);
  static TubeLaw read_table(ParameterSection &geometry, bool is_rigid);

  std::string law;
  double length_as_made;     ///< [m]
  Profile diameter_as_made;  ///< [m] over [m]
  Profile thickness_as_made; ///< [m] over [m]
  bool uniform_everywhere;
  double stretch = 1.; ///< length over length as made
  WallLayers layers;
};
} // namespace Continua

#endif
