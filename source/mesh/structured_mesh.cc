#include <continua/mesh/structured_mesh.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/grid/tria_description.h>

#include <algorithm>

namespace Continua
{
namespace
{
/// Splits a lexicographic number (x fastest) into its place in each direction.
template <int dim>
std::array<unsigned int, dim> split(unsigned int number,
                                    const std::array<unsigned int, dim> &extent)
{
  std::array<unsigned int, dim> index;
  for (unsigned int d = 0; d < dim; ++d)
  {
    index[d] = number % extent[d];
    number /= extent[d];
  }
  return index;
}

template <int dim>
unsigned int join(const std::array<unsigned int, dim> &index,
                  const std::array<unsigned int, dim> &extent)
{
  unsigned int number = 0;
  for (unsigned int d = dim; d-- > 0;)
    number = number * extent[d] + index[d];
  return number;
}
} // namespace

template <int dim>
StructuredMesh<dim>::StructuredMesh(const std::vector<std::vector<double>> &points) : points(points)
{
  AssertDimension(points.size(), dim);
  for ([[maybe_unused]] const auto &coordinates : points)
    Assert(coordinates.size() > 1 && std::is_sorted(coordinates.begin(), coordinates.end()),
           dealii::ExcInternalError());
}

template <int dim>
void StructuredMesh<dim>::create(dealii::Triangulation<dim> &triangulation,
                                 const RegionOfCell &region,
                                 const BoundaryOfFace &boundary,
                                 const Map &map) const
{
  CellIndex n_points;
  CellIndex n_cells;
  unsigned int n_all_points = 1;
  unsigned int n_all_cells = 1;
  for (unsigned int d = 0; d < dim; ++d)
  {
    n_points[d] = points[d].size();
    n_cells[d] = n_points[d] - 1;
    n_all_points *= n_points[d];
    n_all_cells *= n_cells[d];
  }

  std::vector<dealii::Point<dim>> vertices;
  vertices.reserve(n_all_points);
  for (unsigned int number = 0; number < n_all_points; ++number)
  {
    const CellIndex index = split<dim>(number, n_points);
    dealii::Point<dim> vertex;
    for (unsigned int d = 0; d < dim; ++d)
      vertex[d] = points[d][index[d]];
    vertices.push_back(map(vertex));
  }

  std::vector<dealii::CellData<dim>> cells(n_all_cells);
  for (unsigned int number = 0; number < n_all_cells; ++number)
  {
    const CellIndex index = split<dim>(number, n_cells);
    for (const unsigned int v : dealii::GeometryInfo<dim>::vertex_indices())
    {
      CellIndex vertex_index = index;
      for (unsigned int d = 0; d < dim; ++d)
        vertex_index[d] += (v >> d) & 1u;
      cells[number].vertices[v] = join<dim>(vertex_index, n_points);
    }
    cells[number].material_id = region(index);
  }
  triangulation.create_triangulation(vertices, cells, dealii::SubCellData());

  // The coarse cells are in the order in which they were given, on every rank.
  for (const auto &cell : triangulation.cell_iterators_on_level(0))
    for (const unsigned int f : cell->face_indices())
      if (cell->face(f)->at_boundary())
        cell->face(f)->set_all_boundary_ids(boundary(split<dim>(cell->index(), n_cells), f));
}

template class StructuredMesh<2>;
template class StructuredMesh<3>;
} // namespace Continua
