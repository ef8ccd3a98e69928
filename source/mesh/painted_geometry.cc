#include <continua/mesh/painted_geometry.h>
#include <continua/mesh/region_expression.h>

#include <algorithm>
#include <stdexcept>

namespace Continua
{
namespace
{
/// Understands the expression of one entry, or throws InputError.
RegionExpression
parse(const ParameterSection &section, const std::string &key, const std::string &text)
{
  try
  {
    return RegionExpression(text);
  }
  catch (const std::invalid_argument &exception)
  {
    section.refuse(key, "the expression '" + text + "' is not understood: " + exception.what(),
                   "Write an expression in x, y, z and pi that is positive where the region is");
  }
}
} // namespace

template <int dim>
PaintedGeometry<dim>::PaintedGeometry(std::unique_ptr<Geometry<dim>> unpainted_,
                                      ParameterSection section)
    : unpainted(std::move(unpainted_)), region_names(unpainted->regions())
{
  const std::vector<std::string> unpainted_names = region_names;
  const auto entries = section.add_free_entries(
      "NAME = EXPRESSION in x, y, z [m]: the coarse cells at whose centre it is positive are the "
      "region NAME; the first such entry takes the cell");
  std::vector<RegionExpression> functions;
  std::vector<unsigned int> region_of_entry;
  for (const auto &[name, expression] : entries)
  {
    functions.push_back(parse(section, name, expression));
    const auto place = std::find(region_names.begin(), region_names.end(), name);
    region_of_entry.push_back(place - region_names.begin());
    if (place == region_names.end())
      region_names.push_back(name);
  }

  dealii::Triangulation<dim> coarse_mesh;
  unpainted->create(coarse_mesh);
  std::vector<bool> has_cells(region_names.size(), false);
  for (const auto &cell : coarse_mesh.cell_iterators_on_level(0))
  {
    dealii::Point<3> centre;
    for (unsigned int d = 0; d < dim; ++d)
      centre[d] = cell->center()[d];
    dealii::types::material_id region = cell->material_id();
    for (std::size_t i = 0; i < entries.size(); ++i)
      if (functions[i].value(centre[0], centre[1], centre[2]) > 0.)
      {
        region = region_of_entry[i];
        break;
      }
    region_of_cell.push_back(region);
    has_cells[region] = true;
  }

  for (std::size_t region = 0; region < region_names.size(); ++region)
    if (!has_cells[region])
    {
      const std::string &name = region_names[region];
      if (region < unpainted_names.size())
        section.refuse("", "the paint leaves no coarse cell to the region '" + name + "'",
                       "Leave one of the painted regions out, or give it the name '" + name + "'");
      section.refuse(name, "no coarse cell belongs to the region",
                     "Change the expression or an earlier one that takes its cells, use more "
                     "coarse cells, or leave the region out");
    }
}

template <int dim>
std::vector<std::string> PaintedGeometry<dim>::regions() const
{
  return region_names;
}

template <int dim>
std::vector<std::string> PaintedGeometry<dim>::boundaries() const
{
  return unpainted->boundaries();
}

template <int dim>
std::vector<NamedInterface> PaintedGeometry<dim>::interfaces() const
{
  return {};
}

template <int dim>
void PaintedGeometry<dim>::create(dealii::Triangulation<dim> &triangulation) const
{
  unpainted->create(triangulation);
  for (const auto &cell : triangulation.cell_iterators_on_level(0))
    cell->set_material_id(region_of_cell[cell->index()]);
}

template <int dim>
MeshExtent PaintedGeometry<dim>::extent() const
{
  return unpainted->extent();
}

template <int dim>
std::vector<VesselBranch<dim>> PaintedGeometry<dim>::branches() const
{
  return unpainted->branches();
}

template class PaintedGeometry<2>;
template class PaintedGeometry<3>;
} // namespace Continua
