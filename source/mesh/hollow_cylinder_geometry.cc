#include <continua/mesh/grading.h>
#include <continua/mesh/hollow_cylinder_geometry.h>
#include <continua/mesh/structured_extent.h>
#include <continua/mesh/structured_mesh.h>

#include <deal.II/base/numbers.h>
#include <deal.II/grid/manifold_lib.h>

#include <cmath>

namespace Continua
{
HollowCylinderGeometry::Parameters HollowCylinderGeometry::Parameters::read(
    ParameterSection geometry, ParameterSection mesh, const bool axisymmetric)
{
  Parameters parameters;
  geometry.add("Inner radius", parameters.inner_radius, Dimensions::length,
               "Radius of the bore [m]", Range::positive());
  geometry.add("Outer radius", parameters.outer_radius, Dimensions::length,
               "Radius of the outer surface [m]", Range::positive());
  if (parameters.outer_radius <= parameters.inner_radius)
    geometry.refuse("Outer radius", "it is not larger than 'Inner radius'",
                    "Give a larger outer or a smaller inner radius");
  mesh.add("Radial cells", parameters.radial_cells, "Coarse cells through the thickness", 1);
  mesh.add("Radial grading", parameters.radial_grading, Dimensions::none,
           "Size of the outermost cell over that of the innermost", grading_range);
  if (axisymmetric)
  {
    geometry.add("Length", parameters.length, Dimensions::length, "Extent along the axis x [m]",
                 Range::positive());
    mesh.add("Axial cells", parameters.axial_cells, "Coarse cells along the axis", 1);
  }
  else
    mesh.add("Circumferential cells", parameters.circumferential_cells,
             "Coarse cells along the quarter of the circumference", 1);
  return parameters;
}

HollowCylinderGeometry::HollowCylinderGeometry(const Parameters &parameters,
                                               const bool axisymmetric)
    : parameters(parameters), axisymmetric(axisymmetric)
{
}

std::vector<std::string> HollowCylinderGeometry::regions() const
{
  return {"body"};
}

std::vector<std::string> HollowCylinderGeometry::boundaries() const
{
  if (axisymmetric)
    return {"left", "right", "inside", "outside"};
  return {"inside", "outside", "symmetry y", "symmetry x"};
}

void HollowCylinderGeometry::create(dealii::Triangulation<2> &triangulation) const
{
  const auto region = [](const auto &) { return 0u; };
  const auto boundary = [](const auto &, const unsigned int face) { return face; };
  std::vector<double> radii = {parameters.inner_radius};
  append_graded_cells(radii, parameters.outer_radius, parameters.radial_cells,
                      parameters.radial_grading);

  if (axisymmetric)
  {
    std::vector<double> axial = {0.};
    append_graded_cells(axial, parameters.length, parameters.axial_cells, 1.);
    StructuredMesh<2>({axial, radii}).create(triangulation, region, boundary);
    return;
  }

  // In units of the quarter circle, so that its end is known without round-off.
  std::vector<double> quarters = {0.};
  append_graded_cells(quarters, 1., parameters.circumferential_cells, 1.);
  StructuredMesh<2>({radii, quarters})
      .create(triangulation, region, boundary,
              [](const dealii::Point<2> &point)
              {
                const double angle = 0.5 * dealii::numbers::PI * point[1];
                // The symmetry planes are hit exactly, which conditions on single components rely
                // on.
                return dealii::Point<2>(point[1] == 1. ? 0. : point[0] * std::cos(angle),
                                        point[0] * std::sin(angle));
              });
  triangulation.set_all_manifold_ids(0);
  triangulation.set_manifold(0, dealii::SphericalManifold<2>());
}

MeshExtent HollowCylinderGeometry::extent() const
{
  return structured_extent({parameters.radial_cells, axisymmetric
                                                         ? parameters.axial_cells
                                                         : parameters.circumferential_cells});
}

std::unique_ptr<Geometry<2>> HollowCylinderGeometry::coarsened(const double most_cells) const
{
  Parameters coarse = parameters;
  unsigned int &along = axisymmetric ? coarse.axial_cells : coarse.circumferential_cells;
  const std::vector<unsigned int> cells = coarsened_cells({coarse.radial_cells, along}, most_cells);
  coarse.radial_cells = cells[0];
  along = cells[1];
  return std::make_unique<HollowCylinderGeometry>(coarse, axisymmetric);
}
} // namespace Continua
