#ifndef continua_mesh_indicator_field_h
#define continua_mesh_indicator_field_h

namespace Continua
{
/// The field whose normal derivative Kelly's indicator looks at.
enum class IndicatorField
{
  velocity,
  displacement,
  pressure
};
} // namespace Continua

#endif
