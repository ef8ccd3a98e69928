#ifndef continua_linear_algebra_velocity_blocks_h
#define continua_linear_algebra_velocity_blocks_h

#include <limits>
#include <vector>

namespace Continua
{
/// What a preconditioner of the velocities knows of them.
struct VelocityBlocks
{
  std::vector<unsigned int> stiff; ///< local indices, node by node
  std::vector<unsigned int> fluid; ///< the others, node by node
  bool stiff_is_direct = true;     ///< else multigrid
  /// Of a factor of the stiff ones, see make_block_factor().
  double most_factor_bytes = std::numeric_limits<double>::infinity();
  bool fluid_is_viscous = false; ///< algebraic multigrid on the fluid, else relaxation
  /// Motions that take next to no force, by mode and local index: rigid ones. For multigrid alone.
  std::vector<std::vector<double>> modes;
  unsigned int n_components = 1; ///< unknowns of a node
};
} // namespace Continua

#endif
