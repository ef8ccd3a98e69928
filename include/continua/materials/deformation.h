#ifndef continua_materials_deformation_h
#define continua_materials_deformation_h

#include <continua/base/words.h>

namespace Continua
{
/// How large a body's deformation may be.
enum class Deformation
{
  small, ///< the equations are those of the reference shape, linear in the displacement
  finite ///< the equations are those of the deformed shape
};

inline const Words<Deformation> &deformation_words()
{
  static const Words<Deformation> words = {{"small", Deformation::small},
                                           {"finite", Deformation::finite}};
  return words;
}

/// In which shape a body of finite deformation is free of stress.
enum class UnloadedShape
{
  mesh,         ///< the shape of the mesh
  inverse_solve ///< the one from which the loads of the start bring the body to that of the mesh
};

inline const Words<UnloadedShape> &unloaded_shape_words()
{
  static const Words<UnloadedShape> words = {{"mesh", UnloadedShape::mesh},
                                             {"inverse solve", UnloadedShape::inverse_solve}};
  return words;
}
} // namespace Continua

#endif
