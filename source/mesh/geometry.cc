#include <continua/mesh/beam_geometry.h>
#include <continua/mesh/bifurcation_geometry.h>
#include <continua/mesh/box_geometry.h>
#include <continua/mesh/cook_membrane_geometry.h>
#include <continua/mesh/curved_vessel_geometry.h>
#include <continua/mesh/cylinder_channel_geometry.h>
#include <continua/mesh/geometry.h>
#include <continua/mesh/gmsh_geometry.h>
#include <continua/mesh/hollow_cylinder_geometry.h>
#include <continua/mesh/layered_channel_geometry.h>
#include <continua/mesh/mesh_parameters.h>
#include <continua/mesh/painted_geometry.h>
#include <continua/mesh/tube_geometry.h>

#include <functional>
#include <sstream>

namespace Continua
{
namespace
{
/// Some 10 GB of memory on each rank.
constexpr double most_coarse_cells = 1e7;

/// A row of the table of geometries: to add a geometry, add its files and a row.
template <int dim>
struct GeometryType
{
  std::string name;
  std::string description;
  /// Makes the geometry from the sections Geometry and Mesh; empty where the Model has none.
  using Create = std::function<std::unique_ptr<Geometry<dim>>(const ParameterSection &,
                                                              const ParameterSection &)>;
  Create in_plane_or_space;
  Create in_axisymmetry;
};

template <int dim, typename SomeGeometry, typename... Flags>
typename GeometryType<dim>::Create creator(const Flags... axisymmetric)
{
  return [axisymmetric...](const ParameterSection &geometry, const ParameterSection &mesh)
  {
    return std::make_unique<SomeGeometry>(
        SomeGeometry::Parameters::read(geometry, mesh, axisymmetric...), axisymmetric...);
  };
}

/// As `creator`, for a geometry that two dimensions alone have.
template <int dim, typename SomeGeometry, typename... Flags>
typename GeometryType<dim>::Create creator_in_2d(const Flags... axisymmetric)
{
  if constexpr (dim == 2)
    return creator<dim, SomeGeometry>(axisymmetric...);
  else
    return {};
}

/// As `creator`, for a geometry that is there in three dimensions, but not in the plane.
template <int dim, typename SomeGeometry>
typename GeometryType<dim>::Create creator_in_3d()
{
  if constexpr (dim == 3)
    return creator<dim, SomeGeometry>();
  else
    return {};
}

template <int dim>
const std::vector<GeometryType<dim>> &table()
{
  static const std::vector<GeometryType<dim>> rows = {
      {"box", "rectangle or cuboid, may be graded and turned; every model",
       creator<dim, BoxGeometry<dim>>(false), creator<dim, BoxGeometry<dim>>(true)},
      {"beam",
       "cantilever along x; plane and three-dimensional models",
       creator<dim, BeamGeometry<dim>>(),
       {}},
      {"layered channel",
       "fluid under an elastic wall of one or more layers; plane and three-dimensional models",
       creator<dim, LayeredChannelGeometry<dim>>(),
       {}},
      {"channel with cylinder",
       "channel around a rigid cylinder, with or without an elastic beam behind it; plane and "
       "three-dimensional models",
       creator<dim, CylinderChannelGeometry<dim>>(),
       {}},
      {"tube",
       "circular tube full of fluid with a wall of one or more layers, whose diameter and wall "
       "thickness may vary along it; axisymmetric and three-dimensional models",
       creator_in_3d<dim, TubeGeometry<dim>>(), creator_in_2d<dim, TubeGeometry<dim>>()},
      {"curved vessel",
       "round vessel full of fluid along a line in space, with a wall of one or more layers, from "
       "a "
       "table; three-dimensional models",
       creator_in_3d<dim, CurvedVesselGeometry>(),
       {}},
      {"bifurcation",
       "vessel full of fluid that divides into two, with a wall of one or more layers; "
       "three-dimensional models",
       creator_in_3d<dim, BifurcationGeometry>(),
       {}},
      {"hollow cylinder",
       "axial section (axisymmetric model) or quarter of the cross section (plane models)",
       creator_in_2d<dim, HollowCylinderGeometry>(false),
       creator_in_2d<dim, HollowCylinderGeometry>(true)},
      {"cook membrane",
       "Cook's tapered panel; plane models",
       creator_in_2d<dim, CookMembraneGeometry>(),
       {}},
      {"gmsh", "any mesh of quadrilaterals or hexahedra from a file of gmsh; every model",
       creator<dim, GmshGeometry<dim>>(false), creator<dim, GmshGeometry<dim>>(true)}};
  return rows;
}
} // namespace

template <int dim>
std::vector<std::pair<std::string, std::string>> geometry_types()
{
  std::vector<std::pair<std::string, std::string>> types;
  for (const auto &row : table<dim>())
    types.emplace_back(row.name, row.description);
  return types;
}

template <int dim>
std::unique_ptr<Geometry<dim>> make_geometry(ParameterSection geometry,
                                             ParameterSection mesh,
                                             const bool axisymmetric,
                                             const std::set<std::string> &held_boundaries)
{
  Assert(!(axisymmetric && dim == 3), dealii::ExcInternalError());
  std::string type = table<dim>().front().name;
  std::vector<std::string> all_types;
  std::string types_of_model;
  std::string text = "The shape:";
  for (const auto &row : table<dim>())
  {
    all_types.push_back(row.name);
    text += (all_types.size() == 1 ? " '" : "; '") + row.name + "', " + row.description;
    if (axisymmetric ? row.in_axisymmetry : row.in_plane_or_space)
      types_of_model += (types_of_model.empty() ? "" : ", ") + row.name;
  }
  geometry.add_choice("Type", type, all_types, text);

  std::unique_ptr<Geometry<dim>> result;
  for (const auto &row : table<dim>())
    if (row.name == type)
    {
      const auto &create = axisymmetric ? row.in_axisymmetry : row.in_plane_or_space;
      if (!create)
      {
        const std::string model = dim == 3       ? "three-dimensional"
                                  : axisymmetric ? "axisymmetric"
                                                 : "plane strain or plane stress";
        geometry.refuse("Type", "'" + type + "' does not exist with Model = " + model,
                        "Choose another Model, or one of " + types_of_model);
      }
      result = create(geometry, mesh);
    }

  if (result->extent().n_cells > most_coarse_cells)
  {
    std::ostringstream problem;
    problem << "the coarse mesh would have " << result->extent().n_cells
            << " cells, and every rank keeps all of them; the most is " << most_coarse_cells;
    mesh.refuse(entry_of_cells(mesh), problem.str(),
                "Give fewer cells, and divide them by Mesh/Refinements");
  }
  result->note_held_boundaries(held_boundaries);
  if (geometry.has_subsection("Regions"))
    result =
        std::make_unique<PaintedGeometry<dim>>(std::move(result), geometry.subsection("Regions"));
  return result;
}

template std::vector<std::pair<std::string, std::string>> geometry_types<2>();
template std::vector<std::pair<std::string, std::string>> geometry_types<3>();
template std::unique_ptr<Geometry<2>>
make_geometry(ParameterSection, ParameterSection, bool, const std::set<std::string> &);
template std::unique_ptr<Geometry<3>>
make_geometry(ParameterSection, ParameterSection, bool, const std::set<std::string> &);
} // namespace Continua
