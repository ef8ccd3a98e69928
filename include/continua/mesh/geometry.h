#ifndef continua_mesh_geometry_h
#define continua_mesh_geometry_h

#include <continua/base/parameter_section.h>
#include <continua/mesh/mesh_extent.h>
#include <continua/mesh/vessel_branch.h>

#include <deal.II/grid/tria.h>

#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace Continua
{
/// Faces between regions that a mesh gives a name. They need no condition; probes can name them.
struct NamedInterface
{
  std::string name;
  /// The places of the two regions on its sides, the smaller first, and whether the name has all
  /// faces between the two.
  std::map<std::pair<unsigned int, unsigned int>, bool> sides;
};

/**
 * A named geometry: makes the coarse mesh and publishes what its regions and boundaries are called.
 * A cell's material id is its region's place in `regions()`, a face's boundary id its boundary's
 * place in `boundaries()`. The coarse cells fit the interfaces. In axisymmetry x is the axial and y
 * >= 0 the radial coordinate.
 */
template <int dim>
class Geometry
{
public:
  virtual ~Geometry() = default;
  virtual std::vector<std::string> regions() const = 0;
  virtual std::vector<std::string> boundaries() const = 0;
  /// The interfaces of regions that have names.
  virtual std::vector<NamedInterface> interfaces() const { return {}; }
  virtual void create(dealii::Triangulation<dim> &triangulation) const = 0;
  /// The size of the coarse mesh; nothing is made for it.
  virtual MeshExtent extent() const = 0;
  /// The same body in about `most_cells` coarse cells or fewer, for checks of the input alone. Null
  /// where the cells themselves are input.
  virtual std::unique_ptr<Geometry<dim>> coarsened(double most_cells) const;
  /// Takes note of the boundaries, by name, along which nothing moves but as it is prescribed: a
  /// geometry whose cells are to be small at them makes them so in `create`.
  virtual void note_held_boundaries(const std::set<std::string> & /* names */) {}
  /// What it has of vessels: one branch of a tube, several where it divides, none of a body that is
  /// no vessel.
  virtual std::vector<VesselBranch<dim>> branches() const { return {}; }
};

template <int dim>
std::unique_ptr<Geometry<dim>> Geometry<dim>::coarsened(double /* most_cells */) const
{
  return nullptr;
}

/// The geometries that exist: name and one line of description, for the manual and `Type`.
template <int dim>
std::vector<std::pair<std::string, std::string>> geometry_types();

/**
 * Reads the sections Geometry and Mesh, makes the geometry of that `Type` (a row of the table in
 * geometry.cc) and wraps it with the painted regions, if the section Geometry/Regions has any: `set
 * NAME = EXPRESSION`, each evaluated at the centre of every coarse cell; the first one that is
 * positive takes the cell. `axisymmetric`: some types and names depend on it (an `axis` boundary).
 * `held_boundaries`: the names of those that are held fast.
 */
template <int dim>
std::unique_ptr<Geometry<dim>> make_geometry(ParameterSection geometry,
                                             ParameterSection mesh,
                                             bool axisymmetric,
                                             const std::set<std::string> &held_boundaries = {});
} // namespace Continua

#endif
