#ifndef continua_base_units_h
#define continua_base_units_h

#include <string>

namespace Continua
{
/// The dimension of a quantity as exponents of kilogram, metre and second.
struct Dimension
{
  int mass = 0;
  int length = 0;
  int time = 0;

  bool operator==(const Dimension &other) const;

  /// The SI unit as a person writes it ("Pa", "kg/m^3", "Pa s", "1" if there is none).
  std::string unit() const;
};

/// The dimensions that Continua's entries have.
namespace Dimensions
{
inline constexpr Dimension none{0, 0, 0};
inline constexpr Dimension length{0, 1, 0};
inline constexpr Dimension area{0, 2, 0};
inline constexpr Dimension time{0, 0, 1};
inline constexpr Dimension frequency{0, 0, -1};
inline constexpr Dimension velocity{0, 1, -1};
inline constexpr Dimension acceleration{0, 1, -2};
inline constexpr Dimension density{1, -3, 0};
inline constexpr Dimension pressure{1, -1, -2};
inline constexpr Dimension viscosity{1, -1, -1};
inline constexpr Dimension flow_rate{0, 3, -1};
inline constexpr Dimension force_density{1, -2, -2};
inline constexpr Dimension power{1, 2, -3};
inline constexpr Dimension flow_resistance{1, -4, -1}; ///< pressure over flow rate
inline constexpr Dimension compliance{-1, 4, 2};       ///< volume over pressure
} // namespace Dimensions

/**
 * The factor that turns a number in `unit` ("mm", "kg/m^3", "mPa s", "mmHg", "GPa", "l/min", "%",
 * "1/s", "Hz", "cm3/s") into SI, with its dimension. Products by a blank or '*', quotients by '/'
 * (from left to right: "kg/m/s" is kg/(m s)), whole powers by '^' or a digit, parentheses. m, s,
 * sec, g, N, Pa, J, W, l, Hz, bar and P (poise) take the prefixes n, u (or the letter mu), m, c, d,
 * h, k, M and G; min, h, t, cc, mmHg, cmH2O, dyn, %, rad, deg and 1 stand as they are. Throws
 * std::invalid_argument with a reason if the unit is unknown.
 */
double unit_factor(const std::string &unit, Dimension &dimension);

/**
 * "10 mm" -> 0.01. A number with no unit is SI. Throws std::invalid_argument, with a reason that a
 * user understands, if the text is no number, or its unit is unknown or of another dimension.
 */
double parse_quantity(const std::string &text, const Dimension &dimension);

/// The units a user is likely to want for a dimension, SI first ("Pa, kPa, MPa, GPa, bar, mmHg,
/// cmH2O"), for messages.
std::string usual_units(const Dimension &dimension);

/// The fewest digits that read back as `value`; with an exponent below 1e-4 and from 1e7.
std::string shortest_number(double value);
} // namespace Continua

#endif
