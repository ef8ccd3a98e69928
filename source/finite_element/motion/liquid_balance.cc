#include <continua/finite_element/motion/liquid_balance.h>

#include <deal.II/base/mpi.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace Continua
{
using namespace dealii;

namespace
{
/// rho of a material [kg/m^3].
double density_at(const Material &material, const Vector<double> &pressures, const double *values)
{
  double pressure = 0.;
  for (unsigned int l = 0; l < pressures.size(); ++l)
    pressure += pressures[l] * values[l];
  return material.density * material.volume_law().density_ratio(pressure);
}
} // namespace

template <int dim>
LiquidBalance<dim>::LiquidBalance(const Space<dim> &space, const Problem &problem)
    : space(space),
      problem(problem),
      cells(space, problem, space.quadrature(space.n_quadrature_points() + 1), RegionModel::flow)
{
  for (Vector<double> *vector : {&cell_displacement, &cell_velocity})
    vector->reinit(dim * cells.n_functions());
  cell_pressure.reinit(cells.n_pressures());
}

template <int dim>
void LiquidBalance<dim>::reinit()
{
  cells.reinit();
  for (DistributedVector *vector : {&displacement, &velocity})
    vector->reinit(space.velocity_owned, space.velocity_relevant, space.communicator);
  pressure.reinit(space.pressure_owned, space.pressure_relevant, space.communicator);
  faces.clear();
  const FiniteElement<dim> &element = space.scalar_element();
  const FiniteElement<dim> &pressure_element = space.scalar_pressure_element();
  const Quadrature<dim - 1> quadrature = space.face_quadrature(space.n_quadrature_points() + 1);
  FEFaceValues<dim> values(space.mapping, element, quadrature,
                           update_values | update_gradients | update_quadrature_points |
                               update_normal_vectors | update_JxW_values),
      pressures(space.mapping, pressure_element, quadrature, update_values);
  for (std::size_t k = 0; k < cells.all().size(); ++k)
  {
    const auto &cell = cells.all()[k].velocity_cell;
    for (const unsigned int f : cell->face_indices())
    {
      if (!cell->at_boundary(f))
        continue;
      const typename Triangulation<dim>::active_cell_iterator of_mesh = cell;
      values.reinit(of_mesh, f);
      pressures.reinit(of_mesh, f);
      Face face{k, deformed_face_points(space, values), {}};
      // Nothing flows through the axis, where the hoop strain of the points is no number.
      if (std::all_of(face.points.begin(), face.points.end(),
                      [](const DeformedFacePoint<dim> &point) { return point.area.norm() == 0.; }))
        continue;
      for (unsigned int q = 0; q < quadrature.size(); ++q)
      {
        face.pressure_values.emplace_back();
        for (unsigned int l = 0; l < pressure_element.n_dofs_per_cell(); ++l)
          face.pressure_values.back().push_back(pressures.shape_value(l, q));
      }
      faces.push_back(std::move(face));
    }
  }
}

template <int dim>
double LiquidBalance<dim>::rate(const StepSolution &solution)
{
  space.copy_velocity(solution.mesh_displacement, displacement);
  DistributedVector relative = solution.velocity;
  relative.add(-1., solution.mesh_velocity);
  space.copy_velocity(relative, velocity);
  space.copy_pressure(solution.pressure, pressure);
  double sum = 0.;
  for (const Face &face : faces)
  {
    const Cell &cell = cells.all()[face.cell];
    const Material &material = problem.materials[cell.region];
    set_entries(cell.velocity_places, displacement, cell_displacement);
    set_entries(cell.velocity_places, velocity, cell_velocity);
    set_entries(cell.pressure_places, pressure, cell_pressure);
    for (std::size_t q = 0; q < face.points.size(); ++q)
    {
      const DeformedFacePoint<dim> &point = face.points[q];
      const Tensor<1, 3> area = point.kinematics(cell_displacement).area(point.area);
      const Tensor<1, dim> passing = point.value_of(cell_velocity);
      double flow = 0.;
      for (unsigned int c = 0; c < dim; ++c)
        flow += passing[c] * area[c];
      sum -= density_at(material, cell_pressure, face.pressure_values[q].data()) * flow;
    }
  }
  return Utilities::MPI::sum(sum, space.communicator);
}

template <int dim>
void LiquidBalance<dim>::finish_step(const StepSolution &solution)
{
  const BranchCoefficients c = solution.step.branch(std::numeric_limits<double>::infinity());
  double at_level = c.old * inflow + c.older * older_inflow + c.velocity * rate(solution);
  if (solution.step.extrapolate)
    at_level = 2. * at_level - inflow;
  older_inflow = inflow;
  inflow = at_level;
}

template <int dim>
LiquidMass LiquidBalance<dim>::mass(const State &state)
{
  space.copy_velocity(*state.mesh_displacement, displacement);
  space.copy_pressure(state.pressure, pressure);
  double sum = 0.;
  for (const Cell &cell : cells.all())
  {
    const Material &material = problem.materials[cell.region];
    set_entries(cell.velocity_places, displacement, cell_displacement);
    set_entries(cell.pressure_places, pressure, cell_pressure);
    for (unsigned int q = 0; q < cells.n_points(); ++q)
    {
      const Kinematics motion(cells.gradient(cell, cell_displacement, q));
      sum += cell.points[q].weight * motion.volume_ratio() *
             density_at(material, cell_pressure, cells.pressure_values(q));
    }
  }
  return {Utilities::MPI::sum(sum, space.communicator), inflow};
}

template <int dim>
void LiquidBalance<dim>::visit(StateVisitor &visitor)
{
  visitor.levels("inflow of the liquids", &inflow, &older_inflow, 1);
}

template class LiquidBalance<2>;
template class LiquidBalance<3>;
} // namespace Continua
