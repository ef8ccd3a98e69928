#ifndef continua_mesh_bifurcation_geometry_h
#define continua_mesh_bifurcation_geometry_h

#include <continua/mesh/bifurcation_shape.h>
#include <continua/mesh/geometry.h>
#include <continua/mesh/tube_cross_section.h>
#include <continua/mesh/tube_section_cells.h>
#include <continua/vessel/wall_layers.h>

#include <array>

namespace Continua
{
/**
 * `bifurcation`: a vessel that divides into two, filled with fluid, with a wall of one or more
 * layers; in three dimensions alone. The parent's axis is the x axis from the inlet at x = 0 to x =
 * its length, where the daughters' axes begin: all three lie in the plane z = 0. The first daughter
 * turns off towards +y, the second one towards -y. All branches are round and straight but near the
 * point where they meet, where they go over into each other smoothly (BifurcationShape).
 *
 * Regions `fluid`, then the layers of the wall from the inner to the outer one: `wall`, or as they
 * are called. Boundaries `inlet`, `first outlet`, `second outlet` (the fluid's part of the ends),
 * `wall inlet end`, `wall first outlet end`, `wall second outlet end` (the wall's), `outside`, and,
 * of the half with z >= 0, its plane of symmetry `side z`. The cross-sections are those of
 * TubeCrossSection; curved surfaces are the manifold's, under refinement as well.
 */
class BifurcationGeometry : public Geometry<3>
{
public:
  static constexpr unsigned int n_branches = 3;

  struct Parameters
  {
    struct Branch
    {
      double length;                         ///< of the axis [m]
      double inner_diameter, wall_thickness; ///< [m]
      /// Between the continuation of the parent's axis and the daughter's [rad]; of the parent, 0.
      double angle;
      unsigned int axial_cells;
      bool held = false; ///< the wall cannot widen at the end
    };
    /// Parent, first daughter, second daughter.
    std::array<Branch, n_branches> branches = {{{0.04, 6.2e-3, 0.5e-3, 0., 16},
                                                {0.04, 4.5e-3, 0.5e-3, 0.4363323129985824, 16},
                                                {0.04, 3.5e-3, 0.5e-3, 0.4363323129985824, 16}}};
    WallLayers layers;
    TubeCrossSection::Sector sector = TubeCrossSection::Sector::half; ///< half or full
    /// Length of the first cell at an end where the wall is held over that of equal cells; 0:
    /// that cell is sqrt(R h)/2 long.
    double axial_grading = 0.;
    TubeSectionCells section;

    /// Throws InputError, also where the mesh would be folded.
    static Parameters read(ParameterSection geometry, ParameterSection mesh);
    /// The point where the axes meet [m].
    dealii::Point<3> centre() const { return {branches[0].length, 0., 0.}; }
    BifurcationShape shape() const;
  };

  explicit BifurcationGeometry(const Parameters &parameters);

  std::vector<std::string> regions() const override;
  std::vector<std::string> boundaries() const override;
  void create(dealii::Triangulation<3> &triangulation) const override;
  MeshExtent extent() const override;
  std::unique_ptr<Geometry<3>> coarsened(double most_cells) const override;
  /// Grades the cells towards the held ends of the wall.
  void note_held_boundaries(const std::set<std::string> &names) override;
  /// `parent`, `first daughter`, `second daughter`. Positions along the parent count from the
  /// inlet, along a daughter from the point where the axes meet; the axes reach over what is a
  /// round tube.
  std::vector<VesselBranch<3>> branches() const override;

  /// The least BifurcationShape::least_scaled_determinant() of a mesh that is good for anything.
  static constexpr double least_determinant = 0.04;

private:
  /// The vertices along a branch as distances from the point where the axes meet [m], 0 and the
  /// end included: equal cells in the junction and on the tube, and shorter ones at a held end.
  std::vector<double> axial_points(unsigned int branch) const;

  Parameters parameters;
  LayeredStack stack;
  std::shared_ptr<const BifurcationShape> shape;
};
} // namespace Continua

#endif
