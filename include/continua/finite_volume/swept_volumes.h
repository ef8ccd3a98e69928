#ifndef continua_finite_volume_swept_volumes_h
#define continua_finite_volume_swept_volumes_h

#include <continua/finite_volume/cell_wise_mesh.h>
#include <continua/time_integration/step.h>

#include <vector>

namespace Continua
{
/**
 * The volumes that the faces of a mesh sweep while its vertices move along straight lines, and the
 * changes of the cells' volumes: the geometric conservation law. They are exact, so that what the
 * faces of a cell sweep is the change of its volume but for round-off. A step has the rate of a
 * volume by its own formula,
 *
 *   dV/dt = a0 V + a1 V_old + a2 V_older = a0 (swept in the step) - a2 (swept in the one before),
 *
 * face by face (L. Formaggia, F. Nobile, East-West J. Numer. Math. 7 (1999); J. Mavriplis, Z. Yang,
 * J. Comput. Phys. 213 (2006)).
 */
template <int dim>
class SweptVolumes
{
public:
  /// The mesh must outlive it.
  explicit SweptVolumes(const CellWiseMesh<dim> &mesh) : mesh(mesh) {}

  /// Nothing moves.
  void reset();
  /// Of a step between these places of the vertices. The faces of the mesh have their shape at the
  /// end of the step.
  void measure(const Step &step,
               const VertexPlaces<dim> &older,
               const VertexPlaces<dim> &old,
               const VertexPlaces<dim> &present,
               const std::vector<bool> &materials_that_move);

  /// Whether the mesh of a cell moves in the step.
  bool moves(const unsigned int cell) const
  {
    return !moving_materials.empty() && moving_materials[mesh.cells()[cell].material_id];
  }
  /// What a face sweeps along its normal in a unit of time [m^3/s].
  double rate(const unsigned int face) const { return rates[face]; }
  /// V - V_old of an owned cell and V - V_older [m^3].
  double growth(const unsigned int cell) const { return growths[cell]; }
  double growth_since_older(const unsigned int cell) const { return earlier_growths[cell]; }

private:
  const CellWiseMesh<dim> &mesh;
  std::vector<bool> moving_materials; ///< empty where nothing moves
  std::vector<double> rates, growths, earlier_growths;

  double swept(const VolumeFace<dim> &face,
               const VertexPlaces<dim> &begin,
               const VertexPlaces<dim> &end) const;
};
} // namespace Continua

#endif
