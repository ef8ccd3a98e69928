#include <continua/base/input_error.h>
#include <continua/mesh/distortion.h>
#include <continua/mesh/quadratic_cell_manifold.h>

#include <deal.II/base/geometry_info.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <random>
#include <vector>

namespace Continua
{
namespace
{
/// For each vertex the length of its shortest edge, or zero where the vertex must stay.
template <int dim>
std::vector<double> mobility(const dealii::Triangulation<dim> &triangulation)
{
  std::vector<double> mobility(triangulation.n_vertices(), std::numeric_limits<double>::max());
  for (const auto &cell : triangulation.cell_iterators_on_level(0))
    for (const unsigned int l : cell->line_indices())
      for (const unsigned int v : {0u, 1u})
      {
        const auto line = cell->line(l);
        double &shortest = mobility[line->vertex_index(v)];
        shortest = std::min(shortest, (line->vertex(1) - line->vertex(0)).norm());
      }
  for (const auto &cell : triangulation.cell_iterators_on_level(0))
    for (const unsigned int f : cell->face_indices())
      if (cell->at_boundary(f) || cell->neighbor(f)->material_id() != cell->material_id())
        for (const unsigned int v : cell->face(f)->vertex_indices())
          mobility[cell->face(f)->vertex_index(v)] = 0.;
  return mobility;
}
} // namespace

template <int dim>
void distort_coarse_mesh(dealii::Triangulation<dim> &triangulation, const double distortion)
{
  Assert(triangulation.n_global_levels() == 1, dealii::ExcMessage("The mesh is refined already."));
  if (distortion == 0.)
    return;

  const auto refuse = []
  {
    throw InputError(Origin(), "Mesh/Distortion", "a cell would be turned inside out",
                     "Give a smaller number");
  };
  const std::vector<double> largest = mobility(triangulation);
  std::vector<bool> is_moved(triangulation.n_vertices(), false);
  // The generator's numbers are standardised, those of the standard library's distributions are
  // not.
  std::mt19937 generator(20261121);
  for (const auto &cell : triangulation.cell_iterators_on_level(0))
    for (const unsigned int v : cell->vertex_indices())
    {
      const unsigned int number = cell->vertex_index(v);
      if (is_moved[number] || largest[number] == 0.)
        continue;
      is_moved[number] = true;
      for (unsigned int d = 0; d < dim; ++d)
      {
        const double random = 2. * generator() / static_cast<double>(generator.max()) - 1.;
        cell->vertex(v)[d] += distortion * largest[number] * random / std::sqrt(dim);
      }
    }

  for (const auto &cell : triangulation.cell_iterators_on_level(0))
  {
    if (const auto *curved =
            dynamic_cast<const QuadraticCellManifold<dim> *>(&cell->get_manifold()))
    {
      std::vector<dealii::Point<dim>> corners;
      for (const unsigned int v : cell->vertex_indices())
        corners.push_back(cell->vertex(v));
      const QuadraticCellManifold<dim> distorted = curved->with_corners(corners);
      triangulation.set_manifold(cell->manifold_id(), distorted);
      if (distorted.range_of_determinants().first <= 0.)
        refuse();
      continue;
    }
    dealii::Point<dim> vertices[dealii::GeometryInfo<dim>::vertices_per_cell];
    dealii::Tensor<0, dim> determinants[dealii::GeometryInfo<dim>::vertices_per_cell];
    for (const unsigned int v : cell->vertex_indices())
      vertices[v] = cell->vertex(v);
    dealii::GeometryInfo<dim>::alternating_form_at_vertices(vertices, determinants);
    if (*std::min_element(std::begin(determinants), std::end(determinants)) <= 0.)
      refuse();
  }
}

template void distort_coarse_mesh(dealii::Triangulation<2> &, double);
template void distort_coarse_mesh(dealii::Triangulation<3> &, double);
} // namespace Continua
