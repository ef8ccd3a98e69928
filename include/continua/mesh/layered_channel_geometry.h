#ifndef continua_mesh_layered_channel_geometry_h
#define continua_mesh_layered_channel_geometry_h

#include <continua/mesh/geometry.h>
#include <continua/mesh/layered_stack.h>

namespace Continua
{
/**
 * `layered channel`: fluid between y = 0 and an elastic wall of one or more layers, along x from 0;
 * in three dimensions extruded along z from 0. Regions `fluid` and `wall`, or `fluid`, `wall 1`,
 * `wall 2`, ... from the fluid outwards. Boundaries `inlet`, `outlet` (the fluid's part of x = 0
 * and x = length), `wall inlet end`, `wall outlet end` (the wall's), `bottom`, `top`, and in three
 * dimensions `back`, `front`.
 */
template <int dim>
class LayeredChannelGeometry : public Geometry<dim>
{
public:
  struct Parameters
  {
    double length = 0.1; ///< [m]
    double width = 0.01; ///< in three dimensions [m]
    unsigned int axial_cells = 20;
    unsigned int width_cells = 2;
    LayeredStack stack;

    /// Throws InputError.
    static Parameters read(ParameterSection geometry, ParameterSection mesh);
  };

  explicit LayeredChannelGeometry(const Parameters &parameters);

  std::vector<std::string> regions() const override;
  std::vector<std::string> boundaries() const override;
  void create(dealii::Triangulation<dim> &triangulation) const override;
  MeshExtent extent() const override;
  std::unique_ptr<Geometry<dim>> coarsened(double most_cells) const override;

private:
  const Parameters parameters;
};
} // namespace Continua

#endif
