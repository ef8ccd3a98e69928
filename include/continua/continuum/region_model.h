#ifndef continua_continuum_region_model_h
#define continua_continuum_region_model_h

namespace Continua
{
/// Which equations a region has.
enum class RegionModel
{
  linear,      ///< of small deformation without convection: products with matrices that stay
  flow,        ///< of a liquid with convection, or on a mesh that moves
  finite_solid ///< of a solid in finite deformation
};
} // namespace Continua

#endif
