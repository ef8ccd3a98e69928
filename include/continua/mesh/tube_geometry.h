#ifndef continua_mesh_tube_geometry_h
#define continua_mesh_tube_geometry_h

#include <continua/mesh/geometry.h>
#include <continua/mesh/layered_stack.h>
#include <continua/vessel/tube_law.h>

namespace Continua
{
/**
 * `tube`: a circular tube, filled with fluid, whose diameter and wall follow a TubeLaw, along x
 * from 0. Regions `fluid`, then the layers of the wall from the inner to the outer one: `wall`, or
 * as they are called. Boundaries `inlet`, `outlet` (the fluid's part of x = 0 and x = length),
 * `wall inlet end`, `wall outlet end` (the wall's), `outside`.
 *
 * In two dimensions half its axial section, y the radius, with the further boundary `axis`. In
 * three dimensions the whole tube or the quarter of it with y, z >= 0, whose planes of symmetry are
 * the boundaries `side y` (y = 0) and `side z` (z = 0); the cross-section is that of
 * TubeCrossSection. Curved surfaces are the manifold's, under refinement as well.
 */
template <int dim>
class TubeGeometry : public Geometry<dim>
{
public:
  struct Parameters
  {
    TubeLaw law;
    bool full = false; ///< in three dimensions: not a quarter alone
    unsigned int axial_cells = 20;
    /// Length of the first cell at an end where the wall is clamped over length / axial_cells; 0:
    /// that cell is sqrt(R h)/2 long.
    double axial_grading = 0.;
    std::array<bool, 2> clamped = {{false, false}}; ///< the wall, at the inlet and at the outlet
    unsigned int radial_cells = 6;                  ///< of the fluid; in three dimensions its rings
    /// Of those, outermost over innermost; 0: the outermost is R / `cells_at_wall` thick.
    double radial_grading = 0.;
    std::vector<unsigned int> wall_cells = {1}; ///< of each layer, or one number for all
    unsigned int circumferential_cells = 6;     ///< of a quarter, in three dimensions; even

    /// Throws InputError.
    static Parameters read(ParameterSection geometry, ParameterSection mesh);
  };

  explicit TubeGeometry(const Parameters &parameters);

  std::vector<std::string> regions() const override;
  std::vector<std::string> boundaries() const override;
  void create(dealii::Triangulation<dim> &triangulation) const override;
  MeshExtent extent() const override;
  std::unique_ptr<Geometry<dim>> coarsened(double most_cells) const override;
  /// Grades the cells towards the clamped ends of the wall.
  void note_fixed_boundaries(const std::set<std::string> &names) override;
  const TubeLaw *tube_law() const override;

  /// How often the fluid's outermost cell fits into the radius by default. The Stokes layer
  /// sqrt(2 nu/omega) = sqrt(2) R / (Womersley number) is thicker up to a Womersley number of 181.
  static constexpr double cells_at_wall = 128.;
  /// By how much neighbouring cells differ at most, along the axis and across it.
  static constexpr double axial_growth = 1.5, radial_growth = 2.5;

private:
  /**
   * The vertices along the axis [m]: equal cells, and shorter ones at clamped ends, since the wall
   * bends there over the length sqrt(R h) / (3 (1 - nu^2))^(1/4), R its inner radius, h its
   * thickness.
   */
  std::vector<double> axial_points() const;

  Parameters parameters;
  /// Along the scaled radius: the fluid from 0 to 1, the wall from 1 to 2.
  LayeredStack stack;
};
} // namespace Continua

#endif
