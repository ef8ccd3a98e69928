#include <continua/mesh/beam_geometry.h>
#include <continua/mesh/box_geometry.h>
#include <continua/mesh/list_entries.h>
#include <continua/mesh/structured_extent.h>

namespace Continua
{
template <int dim>
typename BeamGeometry<dim>::Parameters
BeamGeometry<dim>::Parameters::read(ParameterSection geometry, ParameterSection mesh)
{
  Parameters parameters;
  geometry.add("Length", parameters.length, Dimensions::length, "Extent along x [m]",
               Range::positive());
  geometry.add("Height", parameters.height, Dimensions::length, "Extent along y [m]",
               Range::positive());
  if (dim == 3)
    geometry.add("Width", parameters.width, Dimensions::length, "Extent along z [m]",
                 Range::positive());

  const std::string each = one_for_each_direction(dim);
  mesh.add("Cells", parameters.cells, "Numbers of coarse cells, " + each, 1);
  check_number_of_entries(mesh, "Cells", parameters.cells.size(), dim, each);
  return parameters;
}

template <int dim>
BeamGeometry<dim>::BeamGeometry(const Parameters &parameters) : parameters(parameters)
{
}

template <int dim>
std::vector<std::string> BeamGeometry<dim>::regions() const
{
  return {"beam"};
}

template <int dim>
std::vector<std::string> BeamGeometry<dim>::boundaries() const
{
  if (dim == 2)
    return {"clamped end", "free end", "bottom", "top"};
  return {"clamped end", "free end", "bottom", "top", "back", "front"};
}

template <int dim>
void BeamGeometry<dim>::create(dealii::Triangulation<dim> &triangulation) const
{
  typename BoxGeometry<dim>::Parameters box;
  box.size = {parameters.length, parameters.height};
  if (dim == 3)
    box.size.push_back(parameters.width);
  box.cells = parameters.cells;
  // The boundaries are the box's by another name, in the same order.
  BoxGeometry<dim>(box, false).create(triangulation);
}

template <int dim>
MeshExtent BeamGeometry<dim>::extent() const
{
  return structured_extent(parameters.cells);
}

template <int dim>
std::unique_ptr<Geometry<dim>> BeamGeometry<dim>::coarsened(const double most_cells) const
{
  Parameters coarse = parameters;
  coarse.cells = coarsened_cells(coarse.cells, most_cells);
  return std::make_unique<BeamGeometry<dim>>(coarse);
}

template class BeamGeometry<2>;
template class BeamGeometry<3>;
} // namespace Continua
