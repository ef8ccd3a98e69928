#include <continua/theory/wall_end.h>

namespace Continua
{
std::vector<WaveMode::Junction> zero_quantities(const WallEnd end, const unsigned int n_families)
{
  const bool clamped = end == WallEnd::clamped;
  std::vector<WaveMode::Junction> quantities;
  if (n_families > 1)
  {
    quantities.push_back(clamped ? WaveMode::radial_displacement : WaveMode::shear_force);
    quantities.push_back(clamped ? WaveMode::rotation : WaveMode::bending_moment);
  }
  // A wall that is held along its outside has no axial wave to end.
  if (n_families > 3 && end != WallEnd::absorbing)
    quantities.push_back(clamped ? WaveMode::axial_displacement : WaveMode::axial_force);
  return quantities;
}
} // namespace Continua
