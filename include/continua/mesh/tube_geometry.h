#ifndef continua_mesh_tube_geometry_h
#define continua_mesh_tube_geometry_h

#include <continua/mesh/geometry.h>
#include <continua/mesh/layered_stack.h>

namespace Continua
{
/**
 * `tube`: half the axial section of a circular tube, filled with fluid, with a wall of one or more
 * layers; x is the axial, y the radial coordinate. Regions `fluid` and `wall`, or `fluid`, `wall
 * 1`, `wall 2`, ... from the inner to the outer layer. Boundaries `inlet`, `outlet` (the fluid's
 * part of x = 0 and x = length), `wall inlet end`, `wall outlet end` (the wall's), `outside` and
 * `axis`.
 */
class TubeGeometry : public Geometry<2>
{
public:
  struct Parameters
  {
    double length = 0.1; ///< [m]
    unsigned int axial_cells = 20;
    double axial_grading = 1.; ///< size of the cells at both ends over that in the middle
    LayeredStack stack;        ///< its fluid depth is the inner radius

    /// Throws InputError.
    static Parameters read(ParameterSection geometry, ParameterSection mesh);
  };

  explicit TubeGeometry(const Parameters &parameters);

  std::vector<std::string> regions() const override;
  std::vector<std::string> boundaries() const override;
  void create(dealii::Triangulation<2> &triangulation) const override;

private:
  const Parameters parameters;
};
} // namespace Continua

#endif
