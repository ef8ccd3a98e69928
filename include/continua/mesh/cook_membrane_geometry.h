#ifndef continua_mesh_cook_membrane_geometry_h
#define continua_mesh_cook_membrane_geometry_h

#include <continua/mesh/geometry.h>

namespace Continua
{
/**
 * `cook membrane`: the tapered panel with the corners (0, 0), (48, 44), (48, 60) and (0, 44), in
 * unit lengths, of Cook, Journal of the Structural Division 100 (1974) 1851. Region `membrane`.
 * Boundaries `clamped end` (x = 0), `loaded end` (x = 48), `bottom`, `top`.
 */
class CookMembraneGeometry : public Geometry<2>
{
public:
  struct Parameters
  {
    double unit_length = 1.; ///< [m]
    std::vector<unsigned int> cells = {8, 8};

    /// Throws InputError.
    static Parameters read(ParameterSection geometry, ParameterSection mesh);
  };

  explicit CookMembraneGeometry(const Parameters &parameters);

  std::vector<std::string> regions() const override;
  std::vector<std::string> boundaries() const override;
  void create(dealii::Triangulation<2> &triangulation) const override;
  MeshExtent extent() const override;
  std::unique_ptr<Geometry<2>> coarsened(double most_cells) const override;

private:
  const Parameters parameters;
};
} // namespace Continua

#endif
