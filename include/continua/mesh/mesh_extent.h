#ifndef continua_mesh_mesh_extent_h
#define continua_mesh_mesh_extent_h

namespace Continua
{
/// How many cells a mesh has, without the mesh. Numbers that are too large for whole ones are
/// welcome: whoever asks wants to refuse them.
struct MeshExtent
{
  double n_cells = 1.;  ///< coarse cells
  double n_layers = 1.; ///< layers of coarse cells along the longest direction

  /// Coarse cells of one layer.
  double cells_per_layer() const { return n_cells / n_layers; }
};
} // namespace Continua

#endif
