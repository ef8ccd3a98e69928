#include <continua/finite_volume/cell_wise_mesh.h>
#include <continua/mesh/ghost_exchange.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_renumbering.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace Continua
{
namespace
{
/// The vertices of a line from one end to the other, with those where finer cells divide it.
template <typename Line>
void append_line(const Line &line,
                 const unsigned int first_vertex,
                 std::vector<unsigned int> &vertices)
{
  const bool forward = line->vertex_index(0) == first_vertex;
  if (line->has_children())
  {
    const unsigned int first = forward ? 0 : 1;
    append_line(line->child(first), first_vertex, vertices);
    const auto &second = line->child(1 - first);
    const unsigned int middle = second->vertex_index(0) == line->vertex_index(1 - first)
                                    ? second->vertex_index(1)
                                    : second->vertex_index(0);
    append_line(second, middle, vertices);
  }
  else
    vertices.push_back(line->vertex_index(forward ? 0 : 1)); // the other end begins the next line
}

std::vector<unsigned int> vertices_around(const dealii::Triangulation<2>::face_iterator &face)
{
  return {face->vertex_index(0), face->vertex_index(1)};
}

std::vector<unsigned int> vertices_around(const dealii::Triangulation<3>::face_iterator &face)
{
  // Around the face, through the vertices 0, 1, 3, 2; hanging nodes on its edges belong to it, else
  // the cells would not be closed where these are not on straight lines.
  const std::array<unsigned int, 4> around = {{0, 1, 3, 2}};
  std::vector<unsigned int> vertices;
  for (unsigned int v = 0; v < 4; ++v)
  {
    const unsigned int from = face->vertex_index(around[v]);
    const unsigned int to = face->vertex_index(around[(v + 1) % 4]);
    for (unsigned int l = 0; l < 4; ++l)
    {
      const auto line = face->line(l);
      if ((line->vertex_index(0) == from && line->vertex_index(1) == to) ||
          (line->vertex_index(1) == from && line->vertex_index(0) == to))
        append_line(line, from, vertices);
    }
  }
  return vertices;
}

/// The signed measure of the simplex between a point and a piece of surface.
double simplex_measure(const dealii::Point<2> &apex, const std::array<dealii::Point<2>, 2> &base)
{
  const auto a = base[0] - apex, b = base[1] - apex;
  return 0.5 * (a[0] * b[1] - a[1] * b[0]);
}
double simplex_measure(const dealii::Point<3> &apex, const std::array<dealii::Point<3>, 3> &base)
{
  return dealii::cross_product_3d(base[0] - apex, base[1] - apex) * (base[2] - apex) / 6.;
}
} // namespace

SurfacePiece<2> surface_piece(const std::vector<unsigned int> &vertices,
                              const VertexPlaces<2> &places)
{
  const dealii::Point<2> &begin = places[vertices[0]], &end = places[vertices[1]];
  SurfacePiece<2> piece;
  const dealii::Tensor<1, 2> edge = end - begin;
  piece.centre = 0.5 * (begin + end);
  piece.area[0] = edge[1];
  piece.area[1] = -edge[0];
  piece.simplices.push_back({{begin, end}});
  return piece;
}

SurfacePiece<3> surface_piece(const std::vector<unsigned int> &vertices,
                              const VertexPlaces<3> &places)
{
  dealii::Point<3> middle;
  for (const unsigned int vertex : vertices)
    middle += places[vertex] / double(vertices.size());
  SurfacePiece<3> piece;
  for (unsigned int i = 0; i < vertices.size(); ++i)
  {
    const dealii::Point<3> &begin = places[vertices[i]],
                           &end = places[vertices[(i + 1) % vertices.size()]];
    piece.simplices.push_back({{middle, begin, end}});
    piece.area += 0.5 * dealii::cross_product_3d(begin - middle, end - middle);
  }
  const dealii::Tensor<1, 3> normal = piece.area / piece.area.norm();
  for (const auto &triangle : piece.simplices)
  {
    const double area =
        0.5 * dealii::cross_product_3d(triangle[1] - middle, triangle[2] - middle) * normal;
    piece.centre +=
        area / piece.area.norm() * dealii::Point<3>((triangle[0] + triangle[1] + triangle[2]) / 3.);
  }
  return piece;
}

template <int dim>
CellWiseMesh<dim>::CellWiseMesh(dealii::parallel::TriangulationBase<dim> &triangulation,
                                const bool axisymmetric)
    : triangulation(triangulation), element(0), cell_dofs(triangulation), axisymmetric(axisymmetric)
{
  Assert(dim == 2 || !axisymmetric, dealii::ExcMessage("Axisymmetric models are 2-D."));
}

template <int dim>
void CellWiseMesh<dim>::build()
{
  // A mesh that is read from a checkpoint has its cells in another order than the run that wrote
  // it; along the tree they are in the same one.
  cell_dofs.distribute_dofs(element);
  dealii::DoFRenumbering::hierarchical(cell_dofs);
  number_cells();
  make_faces();
  present_places.clear();
  moving_materials.clear();
  measure();
}

template <int dim>
void CellWiseMesh<dim>::move(const VertexPlaces<dim> &places,
                             const std::vector<bool> &materials_that_move)
{
  present_places = places;
  moving_materials = materials_that_move;
  measure();
}

template <int dim>
dealii::Point<dim> CellWiseMesh<dim>::present_place(const unsigned int cell,
                                                    const dealii::Point<dim> &unit_point,
                                                    const dealii::Point<dim> &undeformed) const
{
  dealii::Point<dim> place = undeformed;
  const auto &iterator = volumes[cell].iterator;
  if (moves(cell))
    for (const unsigned int v : iterator->vertex_indices())
      place += dealii::GeometryInfo<dim>::d_linear_shape_function(unit_point, v) *
               (present_places[iterator->vertex_index(v)] - iterator->vertex(v));
  return place;
}

template <int dim>
void CellWiseMesh<dim>::measure()
{
  std::vector<dealii::Tensor<1, dim>> moments(volumes.size());
  std::vector<dealii::Point<dim>> inside(volumes.size());
  for (unsigned int cell = 0; cell < volumes.size(); ++cell)
  {
    volumes[cell].plane_volume = 0.;
    const auto &iterator = volumes[cell].iterator;
    if (!moves(cell))
      inside[cell] = iterator->center();
    else
      for (const unsigned int v : iterator->vertex_indices())
        inside[cell] += present_places[iterator->vertex_index(v)] / double(iterator->n_vertices());
  }
  for (VolumeFace<dim> &face : surfaces)
  {
    face.undeformed_side = VolumeFace<dim>::none;
    std::vector<unsigned int> moving, still;
    for (unsigned int side = 0; side < face.n_sides(); ++side)
      (moves(face.cell(side)) ? moving : still).push_back(side);
    if (moving.empty())
      measure_face(face, triangulation.get_vertices(), still, inside, face, moments);
    else
    {
      measure_face(face, present_places, moving, inside, face, moments);
      if (still.empty())
        continue;
      face.undeformed_side = still.front();
      measure_face(face, triangulation.get_vertices(), still, inside, face.undeformed_shape,
                   moments);
    }
  }
  for (unsigned int number = 0; number < n_owned; ++number)
    volumes[number].centre = inside[number] + moments[number] / volumes[number].plane_volume;
  exchange_measures();
  for (FiniteVolume<dim> &volume : volumes)
  {
    volume.radius = axisymmetric ? volume.centre[1] : 0.;
    volume.volume =
        volume.plane_volume * (axisymmetric ? 2. * dealii::numbers::PI * volume.radius : 1.);
  }
  for (VolumeFace<dim> &face : surfaces)
  {
    const dealii::Point<dim> &centre = volumes[face.owner].centre;
    if (face.at_boundary())
      face.distance = face.centre - centre;
    else
    {
      face.distance = volumes[face.neighbour].centre - centre;
      face.owner_weight = (volumes[face.neighbour].centre - face.centre) * face.normal /
                          (face.distance * face.normal);
    }
  }
}

template <int dim>
void CellWiseMesh<dim>::number_cells()
{
  volumes.clear();
  local_numbers.assign(triangulation.n_active_cells(), dealii::numbers::invalid_unsigned_int);
  for (const bool owned : {true, false})
  {
    const std::size_t begin = volumes.size();
    for (const auto &cell : cell_dofs.active_cell_iterators())
      if (owned ? cell->is_locally_owned() : cell->is_ghost())
      {
        FiniteVolume<dim> volume;
        volume.iterator = cell;
        std::vector<dealii::types::global_dof_index> number(1);
        cell->get_dof_indices(number);
        volume.number = number[0];
        volume.material_id = cell->material_id();
        volume.is_owned = owned;
        volumes.push_back(volume);
      }
    std::sort(volumes.begin() + begin, volumes.end(),
              [](const FiniteVolume<dim> &a, const FiniteVolume<dim> &b)
              { return a.number < b.number; });
    if (owned)
      n_owned = volumes.size();
  }
  for (unsigned int i = 0; i < volumes.size(); ++i)
    local_numbers[volumes[i].iterator->active_cell_index()] = i;
}

template <int dim>
void CellWiseMesh<dim>::make_faces()
{
  // The faces of owned cells; what the first of two owned cells has made, the second has already.
  surfaces.clear();
  for (unsigned int number = 0; number < n_owned; ++number)
  {
    const auto cell = volumes[number].iterator;
    for (const unsigned int f : cell->face_indices())
      if (cell->at_boundary(f))
        add_face(number, VolumeFace<dim>::none, cell->face(f), f);
      else if (cell->neighbor(f)->has_children())
        for (unsigned int s = 0; s < cell->face(f)->n_children(); ++s)
          add_face(number, cell_number(cell->neighbor_child_on_subface(f, s)),
                   cell->face(f)->child(s), f);
      else
        add_face(number, cell_number(cell->neighbor(f)), cell->face(f), f);
  }
}

template <int dim>
void CellWiseMesh<dim>::add_face(const unsigned int cell,
                                 const unsigned int other,
                                 const typename dealii::Triangulation<dim>::face_iterator &on,
                                 const unsigned int f)
{
  const bool at_boundary = other == VolumeFace<dim>::none;
  if (!at_boundary && other < cell)
    return;
  VolumeFace<dim> face;
  face.owner = cell;
  face.number_in_cell[0] = f;
  if (at_boundary)
    face.boundary_id = on->boundary_id();
  else
  {
    face.neighbour = other;
    face.number_in_cell[1] = volumes[cell].iterator->neighbor_face_no(f);
    if (volumes[other].number < volumes[cell].number)
    {
      std::swap(face.owner, face.neighbour);
      std::swap(face.number_in_cell[0], face.number_in_cell[1]);
    }
    face.is_interface = volumes[cell].material_id != volumes[other].material_id;
  }
  face.vertices = vertices_around(on);
  for (unsigned int side = 0; side < face.n_sides(); ++side)
    volumes[face.cell(side)].faces.push_back(surfaces.size());
  surfaces.push_back(face);
}

template <int dim>
void CellWiseMesh<dim>::measure_face(const VolumeFace<dim> &face,
                                     const VertexPlaces<dim> &places,
                                     const std::vector<unsigned int> &sides,
                                     const std::vector<dealii::Point<dim>> &inside,
                                     FaceShape<dim> &shape,
                                     std::vector<dealii::Tensor<1, dim>> &moments)
{
  const SurfacePiece<dim> piece = surface_piece(face.vertices, places);
  shape.centre = piece.centre;
  shape.plane_area = piece.area.norm();
  shape.normal = piece.area / shape.plane_area;
  double sense = 1.;
  // Out of the owner.
  const unsigned int side = sides.front();
  if (shape.normal * (shape.centre - inside[face.cell(side)]) * (side == 0 ? 1. : -1.) < 0.)
  {
    shape.normal *= -1.;
    sense = -1.;
  }
  shape.area = shape.plane_area;
  if (axisymmetric)
    // Points of the axis may be off it by round-off.
    shape.area *= shape.centre[1] < 1e-10 * shape.plane_area
                      ? 0.
                      : 2. * dealii::numbers::PI * shape.centre[1];
  // Volumes and first moments about a point inside come from the simplices between that point and
  // the faces, so that a cell with hanging nodes is bounded by the faces of its finer neighbours.
  for (const unsigned int s : sides)
  {
    const unsigned int number = face.cell(s);
    if (!volumes[number].is_owned)
      continue;
    for (const auto &simplex : piece.simplices)
    {
      const double measure = (s == 0 ? sense : -sense) * simplex_measure(inside[number], simplex);
      volumes[number].plane_volume += measure;
      for (const auto &point : simplex)
        moments[number] += measure / (dim + 1.) * (point - inside[number]);
    }
  }
}

template <int dim>
void CellWiseMesh<dim>::exchange_measures()
{
  exchange_with_ghosts<dim>(
      triangulation,
      [&](const auto &cell)
      {
        const FiniteVolume<dim> &volume = volumes[cell_number(cell)];
        std::vector<double> measures(dim + 1);
        for (unsigned int c = 0; c < dim; ++c)
          measures[c] = volume.centre[c];
        measures[dim] = volume.plane_volume;
        return measures;
      },
      [&](const auto &cell, const std::vector<double> &measures)
      {
        FiniteVolume<dim> &volume = volumes[cell_number(cell)];
        for (unsigned int c = 0; c < dim; ++c)
          volume.centre[c] = measures[c];
        volume.plane_volume = measures[dim];
      });
}

template <int dim>
unsigned int
CellWiseMesh<dim>::cell_number(const typename dealii::Triangulation<dim>::cell_iterator &cell) const
{
  const unsigned int number = local_numbers[cell->active_cell_index()];
  Assert(number != dealii::numbers::invalid_unsigned_int,
         dealii::ExcMessage("This cell is neither of this rank nor a ghost."));
  return number;
}

template <int dim>
dealii::Tensor<1, dim> CellWiseMesh<dim>::distance(const unsigned int face,
                                                   const unsigned int side) const
{
  const VolumeFace<dim> &on = surfaces[face];
  if (on.has_value())
    return on.shape(side).centre - volumes[on.cell(side)].centre;
  return side == 0 ? on.distance : -1. * on.distance;
}

template class CellWiseMesh<2>;
template class CellWiseMesh<3>;
} // namespace Continua
