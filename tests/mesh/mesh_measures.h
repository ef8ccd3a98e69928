#ifndef continua_tests_mesh_measures_h
#define continua_tests_mesh_measures_h

// What the tests of geometries measure, by the names that the geometry publishes.

#include <continua/mesh/geometry.h>

#include <algorithm>

namespace measures
{
template <int dim>
struct Measures
{
  explicit Measures(const Continua::Geometry<dim> &geometry)
      : region_names(geometry.regions()), boundary_names(geometry.boundaries())
  {
    geometry.create(mesh);
  }

  /// Area (volume) of a region; -1 if there is no such name.
  double region(const std::string &name) const
  {
    const auto place = std::find(region_names.begin(), region_names.end(), name);
    if (place == region_names.end())
      return -1.;
    double sum = 0.;
    for (const auto &cell : mesh.active_cell_iterators())
      if (cell->material_id() == place - region_names.begin())
        sum += cell->measure();
    return sum;
  }

  /// Length (area) of a boundary; -1 if there is no such name.
  double boundary(const std::string &name) const
  {
    const auto place = std::find(boundary_names.begin(), boundary_names.end(), name);
    if (place == boundary_names.end())
      return -1.;
    double sum = 0.;
    for (const auto &cell : mesh.active_cell_iterators())
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary() && face->boundary_id() == place - boundary_names.begin())
          sum += face->measure();
    return sum;
  }

  dealii::Triangulation<dim> mesh;
  std::vector<std::string> region_names;
  std::vector<std::string> boundary_names;
};
} // namespace measures

#endif
