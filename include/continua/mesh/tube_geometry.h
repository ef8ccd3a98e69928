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
    /// Size of the cells at both ends over that in the middle; 0: as `automatic_axial_grading`.
    double axial_grading = 0.;
    unsigned int radial_cells = 6;              ///< of the fluid; in three dimensions its rings
    double radial_grading = 0.05;               ///< of those, outermost over innermost
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
  const TubeLaw *tube_law() const override;

  /**
   * The size of the cells at both ends over that in the middle with which the first cell is
   * sqrt(R h)/2 long, R the inner radius and h the wall's thickness at the end where that is less:
   * there a clamped wall bends, over the length sqrt(R h) / (3 (1 - nu^2))^(1/4). At most 1, and
   * not so small that neighbours differ by more than a factor of 1.5.
   */
  static double automatic_axial_grading(const TubeLaw &law, unsigned int axial_cells);

private:
  std::vector<double> axial_points() const;

  const Parameters parameters;
  /// Along the scaled radius: the fluid from 0 to 1, the wall from 1 to 2.
  LayeredStack stack;
};
} // namespace Continua

#endif
