#ifndef continua_vessel_wall_layers_h
#define continua_vessel_wall_layers_h

#include <continua/base/parameter_section.h>

#include <string>
#include <vector>

namespace Continua
{
/// The layers of a vessel's wall, from the inner to the outer one; each has the same part of the
/// thickness everywhere. A vessel without layers is rigid.
struct WallLayers
{
  std::vector<std::string> names = {"wall"};
  std::vector<double> fractions = {1.}; ///< their parts of the thickness; the sum is 1

  /// Declares and reads `Wall layers` and `Layer fractions` of the section Geometry. Throws
  /// InputError.
  static WallLayers read(ParameterSection geometry);
};
} // namespace Continua

#endif
