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
} // namespace Continua

#endif
