#include <continua/base/words.h>
#include <continua/mesh/centreline_axis.h>
#include <continua/mesh/clamped_end.h>
#include <continua/mesh/grading.h>
#include <continua/mesh/structured_extent.h>
#include <continua/mesh/structured_mesh.h>
#include <continua/mesh/tube_cross_section.h>
#include <continua/mesh/tube_geometry.h>
#include <continua/mesh/tube_manifold.h>

#include <deal.II/grid/tria_description.h>

#include <cmath>
#include <limits>

namespace Continua
{
namespace
{
void create_mesh(dealii::Triangulation<2> &triangulation,
                 const TubeLaw &law,
                 const LayeredStack &stack,
                 const std::vector<double> &axial,
                 const unsigned int /* n_side_cells */,
                 const TubeCrossSection::Sector /* sector */,
                 const std::shared_ptr<const Centreline> & /* centreline */)
{
  const unsigned int n_wall_ends = law.is_rigid() ? 0 : 2;
  StructuredMesh<2>({axial, stack.points()})
      .create(
          triangulation, [&stack](const auto &cell) { return stack.region(cell[1]); },
          [&stack, n_wall_ends](const auto &cell, const unsigned int face)
          {
            const unsigned int id = stack.boundary(cell[1], face);
            return id < 4 ? id : id + n_wall_ends - 2;
          },
          [&law](const dealii::Point<2> &point)
          { return dealii::Point<2>(point[0], TubeManifold<2>::radius(law, point[0], point[1])); });
  // The cells of a uniform tube are rectangles.
  if (!law.is_uniform())
  {
    triangulation.set_all_manifold_ids(0);
    triangulation.set_manifold(0, TubeManifold<2>(law, TubeManifold<2>::Part::rings));
  }
}

/// Which of the boundaries along the axis a face belongs to: 0 outside, then the sides. `a` and
/// `b`: the places in the section of two opposite vertices of the face. TubeCrossSection puts
/// vertices on the planes of symmetry exactly.
unsigned int
side_of(const dealii::Point<2> &a, const dealii::Point<2> &b, const TubeCrossSection::Sector sector)
{
  using Sector = TubeCrossSection::Sector;
  if (sector == Sector::quarter && a[0] == 0. && b[0] == 0.)
    return 1;
  if (sector != Sector::full && a[1] == 0. && b[1] == 0.)
    return sector == Sector::quarter ? 2 : 1;
  return 0;
}

void create_mesh(dealii::Triangulation<3> &triangulation,
                 const TubeLaw &law,
                 const LayeredStack &stack,
                 const std::vector<double> &axial,
                 const unsigned int n_side_cells,
                 const TubeCrossSection::Sector sector,
                 const std::shared_ptr<const Centreline> &centreline)
{
  const TubeCrossSection section(stack.points(), n_side_cells, sector);
  const TubeManifold<3> core(law, TubeManifold<3>::Part::core, centreline);
  const TubeManifold<3> rings(law, TubeManifold<3>::Part::rings, centreline);
  const std::size_t n_section_vertices = section.vertices().size();
  const std::size_t n_section_cells = section.cells().size();

  std::vector<dealii::Point<3>> vertices;
  vertices.reserve(axial.size() * n_section_vertices);
  for (const double x : axial)
    for (const dealii::Point<2> &vertex : section.vertices())
      // The core's chart is the scaled tube itself.
      vertices.push_back(core.push_forward({x, vertex[0], vertex[1]}));

  std::vector<dealii::CellData<3>> cells;
  for (std::size_t i = 0; i + 1 < axial.size(); ++i)
    for (const TubeCrossSection::Cell &section_cell : section.cells())
    {
      dealii::CellData<3> cell;
      for (unsigned int v = 0; v < 8; ++v)
        cell.vertices[v] = (i + v % 2) * n_section_vertices + section_cell.vertices[v / 2];
      cell.material_id = section_cell.is_core ? 0 : stack.region(section_cell.ring);
      cells.push_back(cell);
    }
  triangulation.create_triangulation(vertices, cells, dealii::SubCellData());

  const unsigned int n_ends = law.is_rigid() ? 2 : 4;
  const auto place = [&](const unsigned int vertex)
  { return section.vertices()[vertex % n_section_vertices]; };
  for (const auto &cell : triangulation.cell_iterators_on_level(0))
    for (const unsigned int f : cell->face_indices())
      if (cell->face(f)->at_boundary())
      {
        const bool is_fluid = cell->material_id() == 0;
        const auto face = cell->face(f);
        face->set_all_boundary_ids(f < 2 ? (is_fluid ? f : f + 2)
                                         : n_ends + side_of(place(face->vertex_index(0)),
                                                            place(face->vertex_index(3)), sector));
      }
  // Rings last: both charts agree on their surface with the core.
  triangulation.set_all_manifold_ids(0);
  for (const auto &cell : triangulation.cell_iterators_on_level(0))
    if (!section.cells()[cell->index() % n_section_cells].is_core)
      cell->set_all_manifold_ids(1);
  triangulation.set_manifold(0, core);
  triangulation.set_manifold(1, rings);
}
} // namespace

template <int dim>
typename TubeGeometry<dim>::Parameters
TubeGeometry<dim>::Parameters::read(ParameterSection geometry, ParameterSection mesh)
{
  Parameters parameters;
  geometry.renamed("Wall thicknesses", "Wall thickness', with 'Wall layers' and 'Layer fractions");
  parameters.law = TubeLaw::read(geometry);
  if (dim == 3)
  {
    using Sector = TubeCrossSection::Sector;
    add_choice(
        geometry, "Sector", parameters.sector,
        {{"quarter", Sector::quarter}, {"half", Sector::half}, {"full", Sector::full}},
        "Which part of the cross-section there is: the quarter y, z >= 0 or the half z >= 0, "
        "whose planes of symmetry are the boundaries 'side y' (y = 0, of the quarter) and "
        "'side z' (z = 0), on which a symmetric flow has Type = roller; or all of it");
  }
  parameters.read_mesh(mesh);
  return parameters;
}

template <int dim>
void TubeGeometry<dim>::Parameters::read_mesh(ParameterSection mesh)
{
  mesh.add("Axial cells", axial_cells, "Coarse cells along the axis", 1);
  add_axial_grading(mesh, axial_grading, "wall inlet end and wall outlet end");
  TubeSectionCells::read(mesh, law.layer_fractions().size(), dim);
}

template <int dim>
TubeGeometry<dim>::TubeGeometry(const Parameters &parameters)
    : parameters(parameters), stack(parameters.stack(parameters.law.layer_fractions(), dim))
{
}

template <int dim>
std::vector<std::string> TubeGeometry<dim>::regions() const
{
  std::vector<std::string> names = {"fluid"};
  const std::vector<std::string> &layers = parameters.law.layer_names();
  names.insert(names.end(), layers.begin(), layers.end());
  return names;
}

template <int dim>
std::vector<std::string> TubeGeometry<dim>::boundaries() const
{
  std::vector<std::string> names = {"inlet", "outlet"};
  if (!parameters.law.is_rigid())
    names.insert(names.end(), {"wall inlet end", "wall outlet end"});
  if (dim == 2)
  {
    names.insert(names.end(), {"axis", "outside"});
    return names;
  }
  names.push_back("outside");
  if (parameters.sector == TubeCrossSection::Sector::quarter)
    names.push_back("side y");
  if (parameters.sector != TubeCrossSection::Sector::full)
    names.push_back("side z");
  return names;
}

template <int dim>
void TubeGeometry<dim>::note_held_boundaries(const std::set<std::string> &names)
{
  // Where the liquid's section holds its rim, the wall cannot widen at its inner surface.
  const std::array<std::string, 2> ends = {{"inlet", "outlet"}};
  for (unsigned int i = 0; i < 2; ++i)
    parameters.held[i] = !parameters.law.is_rigid() &&
                         (names.count(ends[i]) > 0 || names.count("wall " + ends[i] + " end") > 0);
}

template <int dim>
std::vector<double> TubeGeometry<dim>::axial_points() const
{
  const TubeLaw &law = parameters.law;
  std::array<double, 2> end_cells;
  end_cells.fill(std::numeric_limits<double>::infinity());
  for (unsigned int i = 0; i < 2; ++i)
    if (parameters.held[i])
    {
      const double z = i == 0 ? 0. : law.length();
      end_cells[i] =
          clamped_end_cell(parameters.axial_grading, law.length() / parameters.axial_cells,
                           0.5 * law.inner_diameter(z), law.wall_thickness(z));
    }
  return points_with_end_zones(0., law.length(), parameters.axial_cells, end_cells, axial_growth);
}

template <int dim>
void TubeGeometry<dim>::create(dealii::Triangulation<dim> &triangulation) const
{
  create_mesh(triangulation, parameters.law, stack, axial_points(),
              parameters.circumferential_cells / 2, parameters.sector, parameters.centreline);
}

template <int dim>
MeshExtent TubeGeometry<dim>::extent() const
{
  const double n_section_cells =
      dim == 2 ? stack.n_cells()
               : static_cast<unsigned int>(parameters.sector) *
                     parameters.n_cells_of_quarter(parameters.law.layer_fractions().size());
  return {parameters.axial_cells * n_section_cells, static_cast<double>(parameters.axial_cells)};
}

template <int dim>
std::unique_ptr<Geometry<dim>> TubeGeometry<dim>::coarsened(const double most_cells) const
{
  // The cross-section stays.
  Parameters coarse = parameters;
  coarse.axial_cells =
      coarsened_cells({parameters.axial_cells}, most_cells / extent().cells_per_layer()).front();
  return std::make_unique<TubeGeometry<dim>>(coarse);
}

template <int dim>
std::vector<VesselBranch<dim>> TubeGeometry<dim>::branches() const
{
  const bool is_rigid = parameters.law.is_rigid();
  VesselBranch<dim> branch{
      "",
      parameters.law,
      nullptr,
      {{"inlet", is_rigid ? "" : "wall inlet end", 0.},
       {"outlet", is_rigid ? "" : "wall outlet end", parameters.law.length()}}};
  if constexpr (dim == 3)
    if (parameters.centreline != nullptr)
      branch.axis = std::make_shared<CentrelineAxis>(parameters.centreline);
  return {branch};
}

template class TubeGeometry<2>;
template class TubeGeometry<3>;
} // namespace Continua
