#include <continua/mesh/cook_membrane_geometry.h>
#include <continua/mesh/grading.h>
#include <continua/mesh/list_entries.h>
#include <continua/mesh/structured_extent.h>
#include <continua/mesh/structured_mesh.h>

namespace Continua
{
CookMembraneGeometry::Parameters CookMembraneGeometry::Parameters::read(ParameterSection geometry,
                                                                        ParameterSection mesh)
{
  Parameters parameters;
  geometry.add("Unit length", parameters.unit_length, Dimensions::length,
               "The length of which the panel is 48 long; 1 mm or 1 m are usual [m]",
               Range::positive());
  mesh.add("Cells", parameters.cells, "Numbers of coarse cells along and across the panel", 1);
  check_number_of_entries(mesh, "Cells", parameters.cells.size(), 2,
                          "one along and one across the panel");
  return parameters;
}

CookMembraneGeometry::CookMembraneGeometry(const Parameters &parameters) : parameters(parameters) {}

std::vector<std::string> CookMembraneGeometry::regions() const
{
  return {"membrane"};
}

std::vector<std::string> CookMembraneGeometry::boundaries() const
{
  return {"clamped end", "loaded end", "bottom", "top"};
}

void CookMembraneGeometry::create(dealii::Triangulation<2> &triangulation) const
{
  std::vector<double> along = {0.};
  std::vector<double> across = {0.};
  append_graded_cells(along, 1., parameters.cells[0], 1.);
  append_graded_cells(across, 1., parameters.cells[1], 1.);
  StructuredMesh<2>({along, across})
      .create(
          triangulation, [](const auto &) { return 0u; },
          [](const auto &, const unsigned int face) { return face; },
          [this](const dealii::Point<2> &point)
          {
            const double bottom = 44. * point[0];
            const double top = 44. + 16. * point[0];
            return parameters.unit_length *
                   dealii::Point<2>(48. * point[0], bottom + (top - bottom) * point[1]);
          });
}

MeshExtent CookMembraneGeometry::extent() const
{
  return structured_extent(parameters.cells);
}

std::unique_ptr<Geometry<2>> CookMembraneGeometry::coarsened(const double most_cells) const
{
  Parameters coarse = parameters;
  coarse.cells = coarsened_cells(coarse.cells, most_cells);
  return std::make_unique<CookMembraneGeometry>(coarse);
}
} // namespace Continua
