#ifndef continua_mesh_hollow_cylinder_geometry_h
#define continua_mesh_hollow_cylinder_geometry_h

#include <continua/mesh/geometry.h>

namespace Continua
{
/**
 * `hollow cylinder`: region `body`. In axisymmetry half its axial section (x axial from 0, y
 * radial) with the boundaries `left`, `right` (x), `inside`, `outside`; in the plane a quarter of
 * its cross section, x >= 0, y >= 0, with a manifold that makes the arcs round under refinement,
 * and the boundaries `inside`, `outside`, `symmetry x` (on x = 0, with its normal along x) and
 * `symmetry y` (on y = 0).
 */
class HollowCylinderGeometry : public Geometry<2>
{
public:
  struct Parameters
  {
    double inner_radius = 0.01; ///< [m]
    double outer_radius = 0.02; ///< [m]
    double length = 0.1;        ///< in axisymmetry [m]
    unsigned int radial_cells = 4;
    unsigned int axial_cells = 10;          ///< in axisymmetry
    unsigned int circumferential_cells = 8; ///< of the quarter, in the plane
    double radial_grading = 1.;             ///< outermost over innermost cell

    /// Throws InputError.
    static Parameters read(ParameterSection geometry, ParameterSection mesh, bool axisymmetric);
  };

  HollowCylinderGeometry(const Parameters &parameters, bool axisymmetric);

  std::vector<std::string> regions() const override;
  std::vector<std::string> boundaries() const override;
  void create(dealii::Triangulation<2> &triangulation) const override;
  MeshExtent extent() const override;
  std::unique_ptr<Geometry<2>> coarsened(double most_cells) const override;

private:
  const Parameters parameters;
  const bool axisymmetric;
};
} // namespace Continua

#endif
