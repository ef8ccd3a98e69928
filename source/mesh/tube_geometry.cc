#include <continua/base/words.h>
#include <continua/mesh/grading.h>
#include <continua/mesh/structured_extent.h>
#include <continua/mesh/structured_mesh.h>
#include <continua/mesh/tube_cross_section.h>
#include <continua/mesh/tube_geometry.h>
#include <continua/mesh/tube_manifold.h>

#include <cmath>
#include <limits>

namespace Continua
{
namespace
{
/// The fluid and the layers of the wall along the scaled radius.
LayeredStack scaled_stack(const TubeLaw &law)
{
  LayeredStack stack;
  stack.fluid_depth = 1.;
  stack.wall_thicknesses = law.layer_fractions();
  return stack;
}

void create_mesh(dealii::Triangulation<2> &triangulation,
                 const TubeLaw &law,
                 const LayeredStack &stack,
                 const std::vector<double> &axial,
                 const unsigned int /* n_side_cells */,
                 const bool /* full */)
{
  StructuredMesh<2>({axial, stack.points()})
      .create(
          triangulation, [&stack](const auto &cell) { return stack.region(cell[1]); },
          [&stack](const auto &cell, const unsigned int face)
          { return stack.boundary(cell[1], face); },
          [&law](const dealii::Point<2> &point)
          { return dealii::Point<2>(point[0], TubeManifold<2>::radius(law, point[0], point[1])); });
  // The cells of a uniform tube are rectangles.
  if (!law.is_uniform())
  {
    triangulation.set_all_manifold_ids(0);
    triangulation.set_manifold(0, TubeManifold<2>(law, TubeManifold<2>::Part::rings));
  }
}

/// The boundary id of a face along the axis, from two of its vertices that are no neighbours.
unsigned int side_of(const dealii::Point<3> &a, const dealii::Point<3> &b)
{
  return a[1] == 0. && b[1] == 0. ? 5 : a[2] == 0. && b[2] == 0. ? 6 : 4;
}

void create_mesh(dealii::Triangulation<3> &triangulation,
                 const TubeLaw &law,
                 const LayeredStack &stack,
                 const std::vector<double> &axial,
                 const unsigned int n_side_cells,
                 const bool full)
{
  const TubeCrossSection section(stack.points(), n_side_cells, full);
  const TubeManifold<3> core(law, TubeManifold<3>::Part::core);
  const TubeManifold<3> rings(law, TubeManifold<3>::Part::rings);
  const std::size_t n_section_vertices = section.vertices().size();
  const std::size_t n_section_cells = section.cells().size();

  std::vector<dealii::Point<3>> vertices;
  vertices.reserve(axial.size() * n_section_vertices);
  for (const double x : axial)
    for (const dealii::Point<2> &vertex : section.vertices())
      // The core's chart is the scaled tube itself.
      vertices.push_back(core.push_forward({x, vertex[0], vertex[1]}));

  std::vector<dealii::CellData<3>> cells;
  for (std::size_t i = 0; i + 1 < axial.size(); ++i)
    for (const TubeCrossSection::Cell &section_cell : section.cells())
    {
      dealii::CellData<3> cell;
      for (unsigned int v = 0; v < 8; ++v)
        cell.vertices[v] = (i + v % 2) * n_section_vertices + section_cell.vertices[v / 2];
      cell.material_id = section_cell.is_core ? 0 : stack.region(section_cell.ring);
      cells.push_back(cell);
    }
  triangulation.create_triangulation(vertices, cells, dealii::SubCellData());

  for (const auto &cell : triangulation.cell_iterators_on_level(0))
    for (const unsigned int f : cell->face_indices())
      if (cell->face(f)->at_boundary())
      {
        const bool is_fluid = cell->material_id() == 0;
        const auto face = cell->face(f);
        face->set_all_boundary_ids(f < 2 ? (is_fluid ? f : f + 2)
                                         : side_of(face->vertex(0), face->vertex(3)));
      }
  // Rings last: both charts agree on their surface with the core.
  triangulation.set_all_manifold_ids(0);
  for (const auto &cell : triangulation.cell_iterators_on_level(0))
    if (!section.cells()[cell->index() % n_section_cells].is_core)
      cell->set_all_manifold_ids(1);
  triangulation.set_manifold(0, core);
  triangulation.set_manifold(1, rings);
}
} // namespace

template <int dim>
typename TubeGeometry<dim>::Parameters
TubeGeometry<dim>::Parameters::read(ParameterSection geometry, ParameterSection mesh)
{
  Parameters parameters;
  geometry.renamed("Wall thicknesses", "Wall thickness', with 'Wall layers' and 'Layer fractions");
  parameters.law = TubeLaw::read(geometry);
  if (dim == 3)
  {
    add_choice(geometry, "Sector", parameters.full, {{"quarter", false}, {"full", true}},
               "Which part of the cross-section there is: the quarter y, z >= 0, whose "
               "planes of symmetry are the boundaries 'side y' (y = 0) and 'side z' (z = "
               "0), on which a symmetric flow has Type = roller; or all of it");
  }

  mesh.add("Axial cells", parameters.axial_cells, "Coarse cells along the axis", 1);
  mesh.add("Axial grading", parameters.axial_grading, Dimensions::none,
           "Length of the first cell at an end where the wall is clamped (Boundaries/wall inlet "
           "end and wall outlet end with Type = fixed) over Length / 'Axial cells'. From there "
           "each cell is at most 1.5 times as long as the one before, until the equal cells of the "
           "rest of the tube are reached. 0 makes the first cell sqrt(R h)/2 long, R the inner "
           "radius and h the wall's thickness, since a clamped wall bends there; 1 makes all cells "
           "equal, as they are at ends that are not clamped",
           Range{0., 1., false, false});
  if (parameters.axial_grading > 0. && parameters.axial_grading < grading_range.lower)
    mesh.refuse("Axial grading", "it is less than " + shortest_number(grading_range.lower),
                "Give 0 for an automatic one, or a larger one");
  mesh.add("Radial cells", parameters.radial_cells,
           "Coarse cells across the fluid's radius; in three dimensions between the wall and the "
           "square core of the cross-section, which reaches to 0.6 of the radius on the diagonals",
           1);
  mesh.add(
      "Radial grading", parameters.radial_grading, Dimensions::none,
      "Size of the fluid's cell at the wall over that of the innermost of 'Radial cells'; "
      "below one the cells are small at the wall, as the viscous layer there asks for, which "
      "is sqrt(2 nu/omega) thick. 0 makes the cell at the wall 1/128 of the radius thick, less "
      "than the viscous layer up to a Womersley number of 181; neighbours then differ by a "
      "factor of 2.5 at most [1]",
      Range{0., grading_range.upper, false, false});
  if (parameters.radial_grading > 0. && parameters.radial_grading < grading_range.lower)
    mesh.refuse("Radial grading", "it is less than " + shortest_number(grading_range.lower),
                "Give 0 for an automatic one, or a larger one");
  LayeredStack stack = scaled_stack(parameters.law);
  stack.read_wall_cells(mesh);
  parameters.wall_cells = stack.wall_cells;
  if (dim == 3)
  {
    mesh.add("Circumferential cells", parameters.circumferential_cells,
             "Coarse cells along a quarter of the circumference; an even number", 2);
    if (parameters.circumferential_cells % 2 != 0)
      mesh.refuse("Circumferential cells", "the number is odd",
                  "Give an even one: half of them stand on each side of the square core");
  }
  return parameters;
}

template <int dim>
TubeGeometry<dim>::TubeGeometry(const Parameters &parameters)
    : parameters(parameters), stack(scaled_stack(parameters.law))
{
  stack.fluid_cells = parameters.radial_cells;
  // In three dimensions the rings fill the radius but for the core, the least of it on its
  // diagonals; their outermost cells are thickest where they fill the most.
  const double depth = dim == 2 ? 1. : 1. - TubeCrossSection::half_side;
  stack.fluid_grading = parameters.radial_grading > 0.
                            ? parameters.radial_grading
                            : ratio_for_last_cell(parameters.radial_cells,
                                                  1. / (cells_at_wall * depth), radial_growth);
  stack.wall_cells = parameters.wall_cells;
  if (stack.wall_cells.size() == 1)
    stack.wall_cells.assign(stack.wall_thicknesses.size(), stack.wall_cells.front());
}

template <int dim>
std::vector<std::string> TubeGeometry<dim>::regions() const
{
  std::vector<std::string> names = {"fluid"};
  const std::vector<std::string> &layers = parameters.law.layer_names();
  names.insert(names.end(), layers.begin(), layers.end());
  return names;
}

template <int dim>
std::vector<std::string> TubeGeometry<dim>::boundaries() const
{
  if (dim == 2)
    return {"inlet", "outlet", "wall inlet end", "wall outlet end", "axis", "outside"};
  if (parameters.full)
    return {"inlet", "outlet", "wall inlet end", "wall outlet end", "outside"};
  return {"inlet", "outlet", "wall inlet end", "wall outlet end", "outside", "side y", "side z"};
}

template <int dim>
void TubeGeometry<dim>::note_fixed_boundaries(const std::set<std::string> &names)
{
  parameters.clamped = {{names.count("wall inlet end") > 0, names.count("wall outlet end") > 0}};
}

template <int dim>
std::vector<double> TubeGeometry<dim>::axial_points() const
{
  const TubeLaw &law = parameters.law;
  std::array<double, 2> end_cells;
  end_cells.fill(std::numeric_limits<double>::infinity());
  for (unsigned int i = 0; i < 2; ++i)
    if (parameters.clamped[i])
    {
      const double z = i == 0 ? 0. : law.length();
      end_cells[i] = parameters.axial_grading > 0.
                         ? parameters.axial_grading * law.length() / parameters.axial_cells
                         : 0.5 * std::sqrt(0.5 * law.inner_diameter(z) * law.wall_thickness(z));
    }
  return points_with_end_zones(0., law.length(), parameters.axial_cells, end_cells, axial_growth);
}

template <int dim>
void TubeGeometry<dim>::create(dealii::Triangulation<dim> &triangulation) const
{
  create_mesh(triangulation, parameters.law, stack, axial_points(),
              parameters.circumferential_cells / 2, parameters.full);
}

template <int dim>
MeshExtent TubeGeometry<dim>::extent() const
{
  double n_section_cells = stack.n_cells();
  if (dim == 3)
  {
    const double quarter = parameters.circumferential_cells, side = quarter / 2.;
    n_section_cells = (parameters.full ? 4. : 1.) * (side * side + quarter * n_section_cells);
  }
  return {parameters.axial_cells * n_section_cells, static_cast<double>(parameters.axial_cells)};
}

template <int dim>
std::unique_ptr<Geometry<dim>> TubeGeometry<dim>::coarsened(const double most_cells) const
{
  // The cross-section stays.
  Parameters coarse = parameters;
  coarse.axial_cells =
      coarsened_cells({parameters.axial_cells}, most_cells / extent().cells_per_layer()).front();
  return std::make_unique<TubeGeometry<dim>>(coarse);
}

template <int dim>
const TubeLaw *TubeGeometry<dim>::tube_law() const
{
  return &parameters.law;
}

template class TubeGeometry<2>;
template class TubeGeometry<3>;
} // namespace Continua
