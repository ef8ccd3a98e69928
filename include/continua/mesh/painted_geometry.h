#ifndef continua_mesh_painted_geometry_h
#define continua_mesh_painted_geometry_h

#include <continua/mesh/geometry.h>

namespace Continua
{
/**
 * Another geometry, in which coarse cells belong to further regions: cells where an expression
 * in x, y, z (metres; z = 0 in two dimensions) is positive at the cell's centre. The first
 * expression that is positive takes the cell; a name that the geometry has already means that
 * region. The boundaries stay as they are.
 */
template <int dim>
class PaintedGeometry : public Geometry<dim>
{
public:
  /**
   * Reads every entry NAME = EXPRESSION of `regions`. Throws InputError if an expression is not
   * understood or a region has no cell in the end.
   */
  PaintedGeometry(std::unique_ptr<Geometry<dim>> unpainted, ParameterSection regions);

  std::vector<std::string> regions() const override;
  std::vector<std::string> boundaries() const override;
  /// None if regions are painted: what the names lay between may be gone.
  std::vector<NamedInterface> interfaces() const override;
  void create(dealii::Triangulation<dim> &triangulation) const override;
  MeshExtent extent() const override;
  std::vector<VesselBranch<dim>> branches() const override;

private:
  std::unique_ptr<Geometry<dim>> unpainted;
  std::vector<std::string> region_names;
  /// The region of each coarse cell.
  std::vector<dealii::types::material_id> region_of_cell;
};
} // namespace Continua

#endif
