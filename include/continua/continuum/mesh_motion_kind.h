#ifndef continua_continuum_mesh_motion_kind_h
#define continua_continuum_mesh_motion_kind_h

#include <continua/base/words.h>

namespace Continua
{
/// How the motion of the solids is extended into the mesh of the liquids, see MeshMotion.
enum class MeshMotionKind
{
  hyperelastic,
  elastic
};

inline const Words<MeshMotionKind> &mesh_motion_words()
{
  static const Words<MeshMotionKind> words = {{"hyperelastic", MeshMotionKind::hyperelastic},
                                              {"elastic", MeshMotionKind::elastic}};
  return words;
}
} // namespace Continua

#endif
