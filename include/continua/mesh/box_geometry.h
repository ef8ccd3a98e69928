#ifndef continua_mesh_box_geometry_h
#define continua_mesh_box_geometry_h

#include <continua/mesh/geometry.h>

namespace Continua
{
/**
 * `box`: a rectangle or cuboid, graded along each direction and turned about the origin in the x-y
 * plane if wished. Region `body`. Boundaries `left`, `right` (lower and upper x), `bottom`, `top`
 * (y), `back`, `front` (z). In axisymmetry y is the radius: `axis` (or `inside`, where the box does
 * not reach the axis) and `outside` take the places of `bottom` and `top`. The names turn with the
 * box.
 */
template <int dim>
class BoxGeometry : public Geometry<dim>
{
public:
  struct Parameters
  {
    std::vector<double> size = std::vector<double>(dim, 1.); ///< [m]
    std::vector<double> origin =
        std::vector<double>(dim, 0.); ///< the corner with the lowest coordinates [m]
    double rotation = 0.;             ///< about the origin of the coordinates, from x to y [rad]
    std::vector<unsigned int> cells = std::vector<unsigned int>(dim, 10);
    std::vector<double> grading = std::vector<double>(dim, 1.); ///< last cell over first cell

    /// Throws InputError.
    static Parameters read(ParameterSection geometry, ParameterSection mesh, bool axisymmetric);
  };

  BoxGeometry(const Parameters &parameters, bool axisymmetric);

  std::vector<std::string> regions() const override;
  std::vector<std::string> boundaries() const override;
  void create(dealii::Triangulation<dim> &triangulation) const override;
  MeshExtent extent() const override;
  std::unique_ptr<Geometry<dim>> coarsened(double most_cells) const override;

private:
  const Parameters parameters;
  const bool axisymmetric;
};
} // namespace Continua

#endif
