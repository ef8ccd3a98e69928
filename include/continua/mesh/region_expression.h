#ifndef continua_mesh_region_expression_h
#define continua_mesh_region_expression_h

#include <memory>
#include <string>

namespace Continua
{
/**
 * A muParser expression of the place x, y, z [m] that says where a painted region is. Constants pi
 * and e; operators
 * + - * / ^ < <= > >= == != && || ?: and muParser's functions (abs, sqrt, min, max, atan2, ...)
 * besides if(condition, a, b) and pow.
 */
class RegionExpression
{
public:
  /// Throws std::invalid_argument with a reason if `text` does not parse.
  explicit RegionExpression(const std::string &text);
  ~RegionExpression();
  RegionExpression(RegionExpression &&) noexcept;

  double value(double x, double y, double z) const;

private:
  struct Parser;
  std::unique_ptr<Parser> parser;
};
} // namespace Continua

#endif
