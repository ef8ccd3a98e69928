#ifndef continua_finite_volume_cell_wise_motion_h
#define continua_finite_volume_cell_wise_motion_h

#include <continua/continuum/motion_extremes.h>
#include <continua/continuum/state.h>
#include <continua/finite_volume/linear_reconstruction.h>

#include <vector>

namespace Continua
{
/// How far the solids of the cell-wise discretisation are from rest: strains and rotations of the
/// cells' gradients, and the displacement of the walls of liquids across their faces.
template <int dim>
class CellWiseMotion
{
public:
  /// All must outlive it.
  CellWiseMotion(const CellWiseSpace<dim> &space,
                 const Problem &problem,
                 const LinearReconstruction<dim> &linear)
      : space(space), problem(problem), linear(linear)
  {
  }

  /// The mesh has changed: the next take() sets everything up.
  void forget() { is_set_up = false; }
  /// On the present mesh, which is at rest.
  void set_up();
  /// Takes this rank's solids into the extremes, and sets the sizes of the liquid. Collective.
  void take(const State &state, MotionExtremes &extremes);

private:
  struct SolidCell
  {
    unsigned int region;
    Stencil<dealii::Tensor<1, dim>> gradient;
    Stencil<double> hoop;
  };
  struct WallFace
  {
    dealii::Tensor<1, dim> normal;
    Stencil<double> displacement;
  };

  const CellWiseSpace<dim> &space;
  const Problem &problem;
  const LinearReconstruction<dim> &linear;
  bool is_set_up = false;
  std::vector<SolidCell> cells;
  std::vector<WallFace> faces;
  LiquidSizes liquid; ///< of all ranks

  bool is_solid(unsigned int cell) const;

  /// Keeps the solids' faces beside liquids, and measures the liquids' walls.
  void set_up_faces();
};
} // namespace Continua

#endif
