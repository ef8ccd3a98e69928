#ifndef continua_mesh_beam_geometry_h
#define continua_mesh_beam_geometry_h

#include <continua/mesh/geometry.h>

namespace Continua
{
/**
 * `beam`: a cantilever along x with its lowest corner in the origin. Region `beam`. Boundaries
 * `clamped end` (x = 0), `free end` (x = length), `bottom`, `top` (y), and in three dimensions
 * `back`, `front` (z).
 */
template <int dim>
class BeamGeometry : public Geometry<dim>
{
public:
  struct Parameters
  {
    double length = 1.;  ///< along x [m]
    double height = 0.1; ///< along y [m]
    double width = 0.1;  ///< along z, in three dimensions [m]
    std::vector<unsigned int> cells =
        dim == 2 ? std::vector<unsigned int>{20, 2} : std::vector<unsigned int>{20, 2, 2};

    /// Throws InputError.
    static Parameters read(ParameterSection geometry, ParameterSection mesh);
  };

  explicit BeamGeometry(const Parameters &parameters);

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
