#ifndef continua_mesh_mesh_parameters_h
#define continua_mesh_mesh_parameters_h

#include <continua/base/parameter_section.h>
#include <continua/mesh/partition.h>

#include <string>

namespace Continua
{
/// The entries of the section Mesh that every geometry has. Whoever makes the mesh applies them, in
/// this order.
struct MeshParameters
{
  double distortion = 0.; ///< displacement of inner coarse vertices over their shortest edge, see
                          ///< distort_coarse_mesh
  unsigned int refinements = 0; ///< how often every cell is divided
  double memory_limit = 0.;     ///< [GB]; 0: what is free
  PartitionParameters partition;

  /// Throws InputError.
  static MeshParameters read(ParameterSection mesh);
};
/// The entry that says how many coarse cells there are; empty where none is given.
std::string entry_of_cells(const ParameterSection &mesh);
} // namespace Continua

#endif
