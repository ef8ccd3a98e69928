#include <continua/finite_volume/value_space.h>

#include <deal.II/base/mpi.h>
#include <deal.II/grid/grid_tools.h>

#include <map>

namespace Continua
{
template <int dim>
ValueSpace<dim>::ValueSpace(const CellMesh<dim> &mesh, const InterfaceValue interface_value)
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
  using Numbers = std::vector<unsigned int>;
  std::map<std::array<unsigned int, 2>, unsigned int> of_ghost;
  dealii::GridTools::exchange_cell_data_to_ghosts<Numbers, dealii::DoFHandler<dim>>(
      mesh.cell_dofs,
      [&](const auto &cell)
      {
        const unsigned int c = mesh.cell_number(cell);
        Numbers numbers = {cell_values[c]};
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
      [&](const auto &cell, const Numbers &numbers)
      {
        const unsigned int c = mesh.cell_number(cell);
        cell_values[c] = numbers[0];
        for (unsigned int i = 1; i < numbers.size(); i += 2)
          of_ghost[{{cells[c].number, numbers[i]}}] = numbers[i + 1];
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

template class ValueSpace<2>;
template class ValueSpace<3>;
} // namespace Continua
