#ifndef continua_theory_wall_end_h
#define continua_theory_wall_end_h

#include <continua/theory/wave_mode.h>

#include <vector>

namespace Continua
{
/// How the wall of a tube ends.
enum class WallEnd
{
  clamped,  ///< no displacement
  free,     ///< no stress
  absorbing ///< axially what a long tube behind would do, radially no stress
};

/// What is zero at that end in a tube with so many families of waves (see ExactDispersion).
std::vector<WaveMode::Junction> zero_quantities(WallEnd end, unsigned int n_families);
} // namespace Continua

#endif
