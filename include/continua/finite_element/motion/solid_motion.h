#ifndef continua_finite_element_motion_solid_motion_h
#define continua_finite_element_motion_solid_motion_h

#include <continua/continuum/motion_extremes.h>
#include <continua/continuum/state.h>
#include <continua/finite_element/space/quadrature_cells.h>

#include <array>
#include <vector>

namespace Continua
{
/// How far the solids of the Taylor-Hood discretisation are from rest: their strains and rotations
/// at as many Gauss points of a cell as the degree of the velocity, where gradients are best, and
/// the displacement of the walls of liquids across their faces, at the nodes.
template <int dim>
class SolidMotion
{
public:
  /// Both must outlive it.
  SolidMotion(const Space<dim> &space, const Problem &problem);

  /// The mesh has changed: the next take() sets everything up.
  void forget() { is_set_up = false; }
  /// Takes this rank's solids into the extremes, and sets the sizes of the liquid. Collective.
  void take(const State &state, MotionExtremes &extremes);

private:
  /// Of a face of a solid's cell beside a liquid.
  struct WallNode
  {
    std::array<int, dim> places; ///< of the components, in vectors with ghost entries
    dealii::Tensor<1, dim> normal;
  };

  const Space<dim> &space;
  const Problem &problem;
  bool is_set_up = false;
  QuadratureCells<dim> cells;
  std::vector<WallNode> nodes;
  LiquidSizes liquid; ///< of all ranks
  DistributedVector displacement;

  void set_up();
  /// Finds the nodes of the walls that are solids.
  void find_nodes();
  void measure_liquid();
  bool is_wall_of_liquid(const typename dealii::DoFHandler<dim>::active_cell_iterator &cell,
                         unsigned int face) const;
};
} // namespace Continua

#endif
