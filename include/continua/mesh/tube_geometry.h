#ifndef continua_mesh_tube_geometry_h
#define continua_mesh_tube_geometry_h

#include <continua/mesh/geometry.h>
#include <continua/mesh/tube_cross_section.h>
#include <continua/mesh/tube_section_cells.h>
#include <continua/vessel/centreline.h>
#include <continua/vessel/tube_law.h>

namespace Continua
{
/**
 * `tube`: a circular tube, filled with fluid, whose diameter and wall follow a TubeLaw, along x
 * from 0. Regions `fluid`, then the layers of the wall from the inner to the outer one: `wall`, or
 * as they are called. Boundaries `inlet`, `outlet` (the fluid's part of x = 0 and x = length),
 * `wall inlet end`, `wall outlet end` (the wall's), `outside`. A rigid tube is its fluid alone.
 *
 * In two dimensions half its axial section, y the radius, with the further boundary `axis`. In
 * three dimensions the whole tube, the half of it with z >= 0 or the quarter with y, z >= 0, whose
 * planes of symmetry are the boundaries `side y` (y = 0, of the quarter) and `side z` (z = 0); the
 * cross-section is that of TubeCrossSection. There the axis may also lie on a centreline, whose
 * frame takes the place of the directions y and z. Curved surfaces are the manifold's, under
 * refinement as well.
 */
template <int dim>
class TubeGeometry : public Geometry<dim>
{
public:
  struct Parameters : TubeSectionCells
  {
    TubeLaw law;
    /// In three dimensions, on which the axis comes to lie; null, the x axis.
    std::shared_ptr<const Centreline> centreline;
    TubeCrossSection::Sector sector = TubeCrossSection::Sector::quarter; ///< in three dimensions
    unsigned int axial_cells = 20;
    /// Length of the first cell at an end where the wall is held over length / axial_cells; 0:
    /// that cell is sqrt(R h)/2 long.
    double axial_grading = 0.;
    /// Whether the wall cannot widen at the inlet and at the outlet: its end is clamped, or the
    /// velocity along the section of the liquid beside it is prescribed.
    std::array<bool, 2> held = {{false, false}};

    /// Throws InputError.
    static Parameters read(ParameterSection geometry, ParameterSection mesh);
    /// The section Mesh, for the law that is there; throws InputError.
    void read_mesh(ParameterSection mesh);
  };

  explicit TubeGeometry(const Parameters &parameters);

  std::vector<std::string> regions() const override;
  std::vector<std::string> boundaries() const override;
  void create(dealii::Triangulation<dim> &triangulation) const override;
  MeshExtent extent() const override;
  std::unique_ptr<Geometry<dim>> coarsened(double most_cells) const override;
  /// Grades the cells towards the ends at which the wall is held.
  void note_held_boundaries(const std::set<std::string> &names) override;
  std::vector<VesselBranch<dim>> branches() const override;

  /// By how much neighbouring cells along the axis differ at most.
  static constexpr double axial_growth = 1.5;

private:
  /**
   * The vertices along the axis [m]: equal cells, and shorter ones at held ends, since the wall
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
