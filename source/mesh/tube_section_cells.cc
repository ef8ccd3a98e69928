#include <continua/mesh/grading.h>
#include <continua/mesh/tube_cross_section.h>
#include <continua/mesh/tube_section_cells.h>

namespace Continua
{
void TubeSectionCells::read(ParameterSection mesh,
                            const std::size_t n_layers,
                            const unsigned int dimension)
{
  mesh.add("Radial cells", radial_cells,
           "Coarse cells across the fluid's radius; in three dimensions between the wall and the "
           "square core of the cross-section, which reaches to 0.6 of the radius on the diagonals",
           1);
  mesh.add("Radial grading", radial_grading, Dimensions::none,
           "Size of the fluid's cell at the wall over that of the innermost of 'Radial cells'; "
           "below one the cells are small at the wall, as the viscous layer there asks for, which "
           "is sqrt(2 nu/omega) thick. 0 makes the cell at the wall 1/128 of the radius thick, "
           "less than the viscous layer up to a Womersley number of 181; neighbours then differ by "
           "a factor of 2.5 at most [1]",
           Range{0., grading_range.upper, false, false});
  if (radial_grading > 0. && radial_grading < grading_range.lower)
    mesh.refuse("Radial grading", "it is less than " + shortest_number(grading_range.lower),
                "Give 0 for an automatic one, or a larger one");
  if (n_layers == 0 && mesh.given("Wall cells"))
    mesh.refuse("Wall cells", "the vessel has no wall (Wall layers = none)", "Remove the entry");
  LayeredStack layers;
  layers.wall_thicknesses.assign(n_layers, 1.);
  layers.wall_cells = wall_cells;
  layers.read_wall_cells(mesh);
  wall_cells = layers.wall_cells;
  if (dimension == 2)
    return;
  mesh.add("Circumferential cells", circumferential_cells,
           "Coarse cells along a quarter of the circumference; an even number", 2);
  if (circumferential_cells % 2 != 0)
    mesh.refuse("Circumferential cells", "the number is odd",
                "Give an even one: half of them stand on each side of the square core");
}

LayeredStack TubeSectionCells::stack(const std::vector<double> &layer_fractions,
                                     const unsigned int dimension) const
{
  LayeredStack stack;
  stack.fluid_depth = 1.;
  stack.wall_thicknesses = layer_fractions;
  stack.fluid_cells = radial_cells;
  // In three dimensions the rings fill the radius but for the core, the least of it on its
  // diagonals; their outermost cells are thickest where they fill the most.
  const double depth = dimension == 2 ? 1. : 1. - TubeCrossSection::half_side;
  stack.fluid_grading =
      radial_grading > 0.
          ? radial_grading
          : ratio_for_last_cell(radial_cells, 1. / (cells_at_wall * depth), largest_growth);
  stack.wall_cells = wall_cells;
  if (wall_cells.size() == 1)
    stack.wall_cells.assign(layer_fractions.size(), wall_cells.front());
  return stack;
}

double TubeSectionCells::n_cells_of_quarter(const std::size_t n_layers) const
{
  // Numbers that are too large for whole ones are refused later.
  double n_rings = radial_cells;
  for (std::size_t layer = 0; layer < n_layers; ++layer)
    n_rings += wall_cells.size() == 1 ? wall_cells.front() : wall_cells[layer];
  const double quarter = circumferential_cells, side = 0.5 * quarter;
  return side * side + quarter * n_rings;
}
} // namespace Continua
