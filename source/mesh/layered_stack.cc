#include <continua/mesh/grading.h>
#include <continua/mesh/layered_stack.h>
#include <continua/mesh/list_entries.h>

#include <numeric>

namespace Continua
{
void LayeredStack::read_wall_cells(ParameterSection mesh)
{
  mesh.add("Wall cells", wall_cells,
           "Cells across each layer of the wall, from the fluid outwards; one number holds for all",
           1);
  const std::size_t n_layers = wall_thicknesses.size();
  if (wall_cells.size() == 1)
    wall_cells.assign(n_layers, wall_cells[0]);
  check_number_of_entries(mesh, "Wall cells", wall_cells.size(), n_layers,
                          "one for each layer of the wall, or one for all");
}

unsigned int LayeredStack::n_cells() const
{
  return std::accumulate(wall_cells.begin(), wall_cells.end(), fluid_cells);
}

std::vector<double> LayeredStack::points() const
{
  std::vector<double> points = {0.};
  append_graded_cells(points, fluid_depth, fluid_cells, fluid_grading);
  for (std::size_t layer = 0; layer < wall_thicknesses.size(); ++layer)
    append_graded_cells(points, points.back() + wall_thicknesses[layer], wall_cells[layer], 1.);
  return points;
}

unsigned int LayeredStack::region(const unsigned int index) const
{
  unsigned int region = 0;
  for (unsigned int end = fluid_cells; index >= end; ++region)
    end += wall_cells[region];
  return region;
}

unsigned int LayeredStack::boundary(const unsigned int index, const unsigned int face) const
{
  const bool is_at_an_end = face < 2;
  return is_at_an_end && region(index) == 0 ? face : face + 2;
}

std::vector<std::string> LayeredStack::region_names() const
{
  if (wall_thicknesses.size() == 1)
    return {"fluid", "wall"};
  std::vector<std::string> names = {"fluid"};
  for (std::size_t layer = 1; layer <= wall_thicknesses.size(); ++layer)
    names.push_back("wall " + std::to_string(layer));
  return names;
}
} // namespace Continua
