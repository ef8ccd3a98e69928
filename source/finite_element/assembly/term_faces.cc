#include <continua/finite_element/assembly/term_faces.h>

#include <continua/finite_element/conditions/following_loads.h>

#include <deal.II/fe/fe_values.h>
#include <deal.II/hp/fe_values.h>

namespace Continua
{
using namespace dealii;

template <int dim>
TermFaces<dim>::TermFaces(const Space<dim> &space, const Problem &problem)
    : space(space), problem(problem)
{
}

template <int dim>
bool TermFaces<dim>::has_total_pressure(const unsigned int region,
                                        const BoundaryCondition &condition) const
{
  return problem.region_model(region) == RegionModel::flow && problem.convection.is_on &&
         condition.inflow_pressure == InflowPressure::total &&
         condition.normal.kind == BoundaryPart::Kind::traction;
}

template <int dim>
void TermFaces<dim>::reinit(const std::vector<Cell> &cells)
{
  faces_of_cells.clear();
  // Loads are given functions, and the total pressure is a product of four functions.
  const Quadrature<dim - 1> of_loads = space.face_quadrature(space.n_quadrature_points() + 1),
                            of_inflow = space.face_quadrature(space.n_quadrature_points() + 2);
  const UpdateFlags flags = update_values | update_gradients | update_quadrature_points |
                            update_normal_vectors | update_JxW_values;
  FEFaceValues<dim> load_values(space.mapping, space.scalar_element(), of_loads, flags),
      inflow_values(space.mapping, space.scalar_element(), of_inflow, flags);
  hp::FEFaceValues<dim> pressure_values(space.mappings, space.pressure_elements,
                                        hp::QCollection<dim - 1>(of_inflow), update_values);
  const auto pressures_at_points = [&](const Cell &cell, const unsigned int f)
  {
    pressure_values.reinit(cell.pressure_cell, f);
    const FEFaceValues<dim> &values = pressure_values.get_present_fe_values();
    std::vector<std::vector<double>> at_points(of_inflow.size());
    for (unsigned int q = 0; q < at_points.size(); ++q)
      for (unsigned int k = 0; k < values.dofs_per_cell; ++k)
        at_points[q].push_back(values.shape_value(k, q));
    return at_points;
  };
  for (const Cell &cell : cells)
    for (const unsigned int f : cell.velocity_cell->face_indices())
    {
      if (!cell.velocity_cell->face(f)->at_boundary())
        continue;
      int n_unknown = 0;
      for (const BoundaryCondition &condition : problem.conditions)
      {
        const int unknown_pressure = condition.has_unknown_pressure() ? n_unknown++ : -1;
        if (cell.velocity_cell->face(f)->boundary_id() != condition.boundary_id ||
            condition.region_ids.count(cell.region) == 0)
          continue;
        TermFace<dim> face{&condition,
                           problem.is_deformed(cell.region) ? unknown_pressure : -1,
                           has_following_traction(problem, cell.region, condition),
                           has_total_pressure(cell.region, condition),
                           {},
                           {}};
        if (face.unknown_pressure < 0 && !face.has_traction && !face.has_total_pressure)
          continue;
        FEFaceValues<dim> &values = face.has_total_pressure ? inflow_values : load_values;
        values.reinit(
            static_cast<typename Triangulation<dim>::active_cell_iterator>(cell.velocity_cell), f);
        face.points = deformed_face_points(space, values);
        if (face.has_total_pressure)
          face.pressure_values = pressures_at_points(cell, f);
        faces_of_cells[number_of(cell)].push_back(std::move(face));
      }
    }
}

template class TermFaces<2>;
template class TermFaces<3>;
} // namespace Continua
