#include <continua/finite_volume/cell_mesh.h>
#include <continua/mesh/ghost_exchange.h>

#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_renumbering.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace Continua
{
namespace
{
/// A flat piece of surface: centre and area times normal; of a warped face that of its triangles.
template <int dim>
struct Piece
{
  dealii::Point<dim> centre;
  dealii::Tensor<1, dim> area;
  std::vector<std::array<dealii::Point<dim>, dim>> simplices; ///< that it consists of
};

/// The points of a line from one end to the other, with those where finer cells divide it.
template <int dim, typename Line>
void append_line(const Line &line,
                 const unsigned int first_vertex,
                 std::vector<dealii::Point<dim>> &points)
{
  const bool forward = line->vertex_index(0) == first_vertex;
  if (line->has_children())
  {
    const unsigned int first = forward ? 0 : 1;
    append_line(line->child(first), first_vertex, points);
    const auto &second = line->child(1 - first);
    const unsigned int middle = second->vertex_index(0) == line->vertex_index(1 - first)
                                    ? second->vertex_index(1)
                                    : second->vertex_index(0);
    append_line(second, middle, points);
  }
  else
    points.push_back(line->vertex(forward ? 0 : 1)); // the other end begins the next line
}

Piece<2> measure(const dealii::Triangulation<2>::face_iterator &face)
{
  Piece<2> piece;
  const dealii::Tensor<1, 2> edge = face->vertex(1) - face->vertex(0);
  piece.centre = 0.5 * (face->vertex(0) + face->vertex(1));
  piece.area[0] = edge[1];
  piece.area[1] = -edge[0];
  piece.simplices.push_back({{face->vertex(0), face->vertex(1)}});
  return piece;
}

Piece<3> measure(const dealii::Triangulation<3>::face_iterator &face)
{
  // Around the face, through the vertices 0, 1, 3, 2; hanging nodes on its edges belong to it, else
  // the cells would not be closed where these are not on straight lines.
  const std::array<unsigned int, 4> around = {{0, 1, 3, 2}};
  std::vector<dealii::Point<3>> points;
  for (unsigned int v = 0; v < 4; ++v)
  {
    const unsigned int from = face->vertex_index(around[v]);
    const unsigned int to = face->vertex_index(around[(v + 1) % 4]);
    for (unsigned int l = 0; l < 4; ++l)
    {
      const auto line = face->line(l);
      if ((line->vertex_index(0) == from && line->vertex_index(1) == to) ||
          (line->vertex_index(1) == from && line->vertex_index(0) == to))
        append_line(line, from, points);
    }
  }
  dealii::Point<3> middle;
  for (const auto &point : points)
    middle += point / double(points.size());

  Piece<3> piece;
  for (unsigned int i = 0; i < points.size(); ++i)
  {
    piece.simplices.push_back({{middle, points[i], points[(i + 1) % points.size()]}});
    piece.area += 0.5 * dealii::cross_product_3d(points[i] - middle,
                                                 points[(i + 1) % points.size()] - middle);
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

template <int dim>
CellMesh<dim>::CellMesh(dealii::parallel::TriangulationBase<dim> &triangulation,
                        const bool axisymmetric)
    : triangulation(triangulation), element(0), cell_dofs(triangulation), axisymmetric(axisymmetric)
{
  Assert(dim == 2 || !axisymmetric, dealii::ExcMessage("Axisymmetric models are 2-D."));
}

template <int dim>
void CellMesh<dim>::build()
{
  // A mesh that is read from a checkpoint has its cells in another order than the run that wrote
  // it; along the tree they are in the same one.
  cell_dofs.distribute_dofs(element);
  dealii::DoFRenumbering::hierarchical(cell_dofs);
  number_cells();
  make_faces();
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
void CellMesh<dim>::number_cells()
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
void CellMesh<dim>::make_faces()
{
  // The faces of owned cells; what the first of two owned cells has made, the second has already.
  surfaces.clear();
  std::vector<dealii::Tensor<1, dim>> moments(volumes.size());
  for (unsigned int number = 0; number < n_owned; ++number)
  {
    const auto cell = volumes[number].iterator;
    for (const unsigned int f : cell->face_indices())
      if (cell->at_boundary(f))
        add_face(number, VolumeFace<dim>::none, cell->face(f), f, moments);
      else if (cell->neighbor(f)->has_children())
        for (unsigned int s = 0; s < cell->face(f)->n_children(); ++s)
          add_face(number, cell_number(cell->neighbor_child_on_subface(f, s)),
                   cell->face(f)->child(s), f, moments);
      else
        add_face(number, cell_number(cell->neighbor(f)), cell->face(f), f, moments);
  }
  for (unsigned int number = 0; number < n_owned; ++number)
    volumes[number].centre =
        volumes[number].iterator->center() + moments[number] / volumes[number].plane_volume;
}

template <int dim>
void CellMesh<dim>::add_face(const unsigned int cell,
                             const unsigned int other,
                             const typename dealii::Triangulation<dim>::face_iterator &on,
                             const unsigned int f,
                             std::vector<dealii::Tensor<1, dim>> &moments)
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
  const Piece<dim> piece = measure(on);
  face.centre = piece.centre;
  face.plane_area = piece.area.norm();
  face.normal = piece.area / face.plane_area;
  double sense = 1.;
  if (face.normal * (face.centre - volumes[face.owner].iterator->center()) < 0.)
  {
    face.normal *= -1.;
    sense = -1.;
  }
  face.area = face.plane_area;
  if (axisymmetric)
    // Points of the axis may be off it by round-off.
    face.area *=
        face.centre[1] < 1e-10 * face.plane_area ? 0. : 2. * dealii::numbers::PI * face.centre[1];
  // Volumes and first moments about a point inside come from the simplices between that point and
  // the faces, so that a cell with hanging nodes is bounded by the faces of its finer neighbours.
  for (unsigned int side = 0; side < face.n_sides(); ++side)
  {
    const unsigned int number = face.cell(side);
    volumes[number].faces.push_back(surfaces.size());
    if (!volumes[number].is_owned)
      continue;
    const dealii::Point<dim> inside = volumes[number].iterator->center();
    for (const auto &simplex : piece.simplices)
    {
      const double measure = (side == 0 ? sense : -sense) * simplex_measure(inside, simplex);
      volumes[number].plane_volume += measure;
      for (const auto &point : simplex)
        moments[number] += measure / (dim + 1.) * (point - inside);
    }
  }
  surfaces.push_back(face);
}

template <int dim>
void CellMesh<dim>::exchange_measures()
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
CellMesh<dim>::cell_number(const typename dealii::Triangulation<dim>::cell_iterator &cell) const
{
  const unsigned int number = local_numbers[cell->active_cell_index()];
  Assert(number != dealii::numbers::invalid_unsigned_int,
         dealii::ExcMessage("This cell is neither of this rank nor a ghost."));
  return number;
}

template <int dim>
dealii::Tensor<1, dim> CellMesh<dim>::distance(const unsigned int face,
                                               const unsigned int side) const
{
  const VolumeFace<dim> &on = surfaces[face];
  if (on.has_value())
    return on.centre - volumes[on.cell(side)].centre;
  return side == 0 ? on.distance : -1. * on.distance;
}

template class CellMesh<2>;
template class CellMesh<3>;
} // namespace Continua
