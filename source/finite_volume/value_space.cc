#include <continua/finite_volume/value_space.h>
#include <continua/mesh/ghost_exchange.h>
#include <continua/mesh/tree_places.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/mpi.h>

#include <algorithm>
#include <map>
#include <numeric>

namespace Continua
{
template <int dim>
ValueSpace<dim>::ValueSpace(const CellWiseMesh<dim> &mesh, const InterfaceValue interface_value)
    : mesh(mesh), interface_value(interface_value)
{
}

template <int dim>
void ValueSpace<dim>::distribute()
{
  const auto &cells = mesh.cells();
  const auto &faces = mesh.faces();
  const unsigned int none = dealii::numbers::invalid_unsigned_int;

  // A face's values belong to cells: how many there are, and which side's cell has them.
  const auto n_face_values = [&](const VolumeFace<dim> &face) -> unsigned int
  {
    if (!face.has_value())
      return 0;
    return interface_value == InterfaceValue::common ? 1 : face.n_sides();
  };

  cell_values.assign(cells.size(), none);
  face_values.assign(faces.size(), {{none, none}});
  n_local = mesh.n_owned_cells();
  for (unsigned int f = 0; f < faces.size(); ++f)
    for (unsigned int side = 0; side < n_face_values(faces[f]); ++side)
      if (owns_face(f, side))
        face_values[f][side] = n_local++;
  first = 0;
  const int error = MPI_Exscan(&n_local, &first, 1, MPI_UNSIGNED, MPI_SUM, mesh.communicator());
  AssertThrowMPI(error);
  n_global = dealii::Utilities::MPI::sum(n_local, mesh.communicator());
  for (unsigned int c = 0; c < mesh.n_owned_cells(); ++c)
    cell_values[c] = first + c;
  for (auto &values : face_values)
    for (unsigned int &value : values)
      if (value != none)
        value += first;

  // Each cell tells other ranks its own number and those of its faces, by the cell beyond them.
  std::map<std::array<unsigned int, 2>, unsigned int> of_ghost;
  exchange_with_ghosts<dim>(
      mesh.triangulation,
      [&](const auto &cell)
      {
        const unsigned int c = mesh.cell_number(cell);
        std::vector<double> numbers = {static_cast<double>(cell_values[c])};
        for (const unsigned int f : cells[c].faces)
        {
          const unsigned int side = mesh.side(f, c);
          if (side < n_face_values(faces[f]) && !faces[f].at_boundary())
          {
            numbers.push_back(cells[faces[f].cell(1 - side)].number);
            numbers.push_back(face_values[f][side]);
          }
        }
        return numbers;
      },
      [&](const auto &cell, const std::vector<double> &numbers)
      {
        const unsigned int c = mesh.cell_number(cell);
        cell_values[c] = static_cast<unsigned int>(numbers[0]);
        for (unsigned int i = 1; i < numbers.size(); i += 2)
          of_ghost[{{cells[c].number, static_cast<unsigned int>(numbers[i])}}] =
              static_cast<unsigned int>(numbers[i + 1]);
      });
  for (unsigned int f = 0; f < faces.size(); ++f)
    for (unsigned int side = 0; side < n_face_values(faces[f]); ++side)
      if (!owns_face(f, side))
        face_values[f][side] = of_ghost.at(
            {{cells[faces[f].cell(side)].number, cells[faces[f].cell(1 - side)].number}});
}

template <int dim>
unsigned int ValueSpace<dim>::beyond(const unsigned int face, const unsigned int side) const
{
  const VolumeFace<dim> &on = mesh.faces()[face];
  return on.has_value() ? of_face(face, side) : of_cell(on.cell(1 - side));
}

template <int dim>
bool ValueSpace<dim>::owns_face(const unsigned int face, const unsigned int side) const
{
  const unsigned int cell =
      mesh.faces()[face].cell(interface_value == InterfaceValue::common ? 0 : side);
  return mesh.cells()[cell].is_owned;
}

template <int dim>
dealii::IndexSet ValueSpace<dim>::owned(const unsigned int n_components) const
{
  dealii::IndexSet indices(n_global * n_components);
  indices.add_range(first * n_components, (first + n_local) * n_components);
  return indices;
}

template <int dim>
dealii::TrilinosWrappers::MPI::Vector ValueSpace<dim>::vector(const unsigned int n_components) const
{
  return dealii::TrilinosWrappers::MPI::Vector(owned(n_components), mesh.communicator());
}

template <int dim>
std::vector<unsigned long> ValueSpace<dim>::numbers(const unsigned int n_components) const
{
  const auto &cells = mesh.cells();
  const auto &faces = mesh.faces();
  const std::vector<unsigned long> places = tree_places(mesh.triangulation);
  const auto place = [&](const unsigned int cell) -> unsigned long {
    return places.empty() ? cells[cell].number : places[cells[cell].iterator->active_cell_index()];
  };
  // Behind a cell's own value those of its faces, and of each those of the finer cells beyond it.
  constexpr unsigned int n_children = dealii::GeometryInfo<dim>::max_children_per_cell;
  constexpr unsigned long n_per_cell = 1 + dealii::GeometryInfo<dim>::faces_per_cell * n_children;
  const auto place_of_face = [&](const unsigned int face, const unsigned int side)
  {
    const VolumeFace<dim> &on = faces[face];
    const auto &cell = cells[on.cell(side)].iterator;
    unsigned int child = 0;
    if (!on.at_boundary())
    {
      const auto &beyond = cells[on.cell(1 - side)].iterator;
      if (beyond->level() > cell->level())
        while (beyond->parent()->child(child) != beyond)
          ++child;
    }
    return place(on.cell(side)) * n_per_cell + 1 + on.number_in_cell[side] * n_children + child;
  };

  std::vector<unsigned long> of_values(n_local);
  for (unsigned int c = 0; c < mesh.n_owned_cells(); ++c)
    of_values[cell_values[c] - first] = place(c) * n_per_cell;
  for (unsigned int f = 0; f < faces.size(); ++f)
    for (unsigned int side = 0; side < 2; ++side)
      if (face_values[f][side] != dealii::numbers::invalid_unsigned_int && owns_face(f, side))
      {
        // Of a common value which cell is the owner may depend on the ranks.
        const bool other = interface_value == InterfaceValue::common && !faces[f].at_boundary() &&
                           place(faces[f].neighbour) < place(faces[f].owner);
        of_values[face_values[f][side] - first] = place_of_face(f, other ? 1 - side : side);
      }
  if (places.empty())
  {
    // A rank has the cells of one stretch of the curve: without gaps the numbers need less room.
    std::vector<unsigned int> order(n_local);
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(),
              [&](const unsigned int a, const unsigned int b)
              { return of_values[a] < of_values[b]; });
    for (unsigned int i = 0; i < n_local; ++i)
      of_values[order[i]] = first + i;
  }
  std::vector<unsigned long> result;
  result.reserve(n_components * n_local);
  for (const unsigned long value : of_values)
    for (unsigned int c = 0; c < n_components; ++c)
      result.push_back(n_components * value + c);
  return result;
}

template class ValueSpace<2>;
template class ValueSpace<3>;
} // namespace Continua
