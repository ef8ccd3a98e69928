#include <continua/finite_element/assembly/convective_terms.h>

#include <continua/base/input_error.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <utility>

namespace Continua
{
using namespace dealii;

template <int dim>
ConvectiveTerms<dim>::ConvectiveTerms(const Space<dim> &space,
                                      const Problem &problem,
                                      const std::optional<InstructionSet> instruction_set,
                                      const InstructionSet set_of_terms)
    // Products of three functions and of the radius are integrated exactly on parallelograms, where
    // density and compressibility are constant.
    : Base(space,
           problem,
           space.quadrature((3 * space.degree() + 2 + (space.is_axisymmetric() ? 1 : 0)) / 2),
           RegionModel::flow,
           kinds_of<StreamlineFlowTerms, BodyForceTerms, FlowFaceTerms>()),
      flow_terms(flow_terms_of<dim>(set_of_terms)),
      streamline_terms(space, problem, quadrature),
      here(problem,
           cells,
           {velocity, acceleration, pressure, pressure_rate, mesh_displacement, mesh_velocity}),
      product(space, problem, instruction_set)
{
  // The terms take up to eight points at a time.
  AssertThrow(cells.n_points() >= 8, ExcInternalError());
}

template <int dim>
void ConvectiveTerms<dim>::reinit()
{
  Base::reinit();
  acceleration.reinit(space.velocity_owned, space.velocity_relevant, space.communicator);
  pressure_rate.reinit(space.pressure_owned, space.pressure_relevant, space.communicator);
  if (!problem.mesh_moves)
    return;
  for (DistributedVector *vector : {&mesh_displacement, &mesh_velocity})
    vector->reinit(space.velocity_owned, space.velocity_relevant, space.communicator);
}

template <int dim>
void ConvectiveTerms<dim>::forget_derivative()
{
  product.forget();
  Base::forget_derivative();
}

template <int dim>
void ConvectiveTerms<dim>::keep_derivative(const StepSolution &state, const KeptDerivative form)
{
  if (form == KeptDerivative::matrices || streamline_terms.are_on())
    product.forget();
  else
    product.make(cells, [this](const Cell &cell) { return faces.of(cell).empty(); });
  Base::keep_derivative(state, form);
  if (product.exists())
    product.set(state, pressure, pressure_rate);
}

template <int dim>
void ConvectiveTerms<dim>::add_derivative_product(const DistributedVector &of_velocity,
                                                  const DistributedVector &of_pressure,
                                                  DistributedVector &momentum,
                                                  DistributedVector &volume)
{
  if (!product.exists() || product.leaves_cells())
    Base::add_derivative_product(of_velocity, of_pressure, momentum, volume);
  else
    space.copy_pressure(of_pressure, pressure);
  if (product.exists())
    product.add(of_velocity, pressure, cells, momentum, volume);
}

template <int dim>
std::vector<double> ConvectiveTerms<dim>::grad_div_viscosities(const StepSolution &state)
{
  if (problem.convection.stabilisation == ConvectionStabilisation::none)
    return {};
  take(state);
  std::vector<double> result(space.triangulation.n_active_cells(), 0.);
  for (const Cell &cell : cells.all())
  {
    here.visit(cell);
    double integral = 0., volume = 0.;
    for (unsigned int q = 0; q < cells.n_points(); ++q)
    {
      integral += cell.points[q].weight * here.point(q).gamma();
      volume += cell.points[q].weight;
    }
    result[cell.velocity_cell->active_cell_index()] = integral / volume;
  }
  return result;
}

template <int dim>
void ConvectiveTerms<dim>::take(const StepSolution &state)
{
  step = state.step;
  here.set_step(step);
  take(state.velocity, state.pressure);
  space.copy_velocity(state.acceleration, acceleration);
  space.copy_pressure(state.pressure_rate, pressure_rate);
  face_points.set_step(step, state.boundary_pressures);
  if (!problem.mesh_moves)
    return;
  space.copy_velocity(state.mesh_displacement, mesh_displacement);
  space.copy_velocity(state.mesh_velocity, mesh_velocity);
}

template <int dim>
double ConvectiveTerms<dim>::add_flow_terms()
{
  double least_stiffening = 1.;
  Base::set_terms([&](const PowersAtPoints *const asked, const TestedAtPoints &result)
                  { least_stiffening = flow_terms.set(here.all_points(), asked, result); });
  return least_stiffening;
}

template <int dim>
double ConvectiveTerms<dim>::add_streamline_terms()
{
  const VolumeLaw law = here.material().volume_law();
  streamline_terms.visit(here.cell().velocity_cell, step);
  double least_stiffening = 1.;
  for (unsigned int q = 0; q < cells.n_points(); ++q)
  {
    const typename Cell::Point &geometry = here.points()[q];
    Point at_point = here.point(q);
    least_stiffening = std::min(least_stiffening, law.stiffening(at_point.pressure));
    streamline_terms.set_point(q, here.state(), at_point);
    Base::template add_terms<StreamlineFlowTerms>(q, geometry.inverse_jacobian, geometry.weight,
                                                  at_point);
  }
  return least_stiffening;
}

template <int dim>
double ConvectiveTerms<dim>::integrate()
{
  const double least_stiffening =
      streamline_terms.are_on() ? add_streamline_terms() : add_flow_terms();
  if (body_forces.visit(here.cell(), step, here.mesh_displacement()))
    for (unsigned int q = 0; q < cells.n_points(); ++q)
    {
      const typename Cell::Point &geometry = here.points()[q];
      Base::template add_terms<BodyForceTerms>(q, geometry.inverse_jacobian, geometry.weight,
                                               body_forces.point(q), StreamlineFlowTerms::size);
    }
  assembly.finish_rows(cell_momentum, cell_volume);
  for (const TermFace<dim> &face : faces.of(here.cell()))
    for (unsigned int q = 0; q < face.points.size(); ++q)
      Base::template add_face_terms<FlowFaceTerms>(
          face.points[q], face_points.of_flow(face, q, here.material(), here.state()),
          StreamlineFlowTerms::size + BodyForceTerms::size);
  return least_stiffening;
}

template <int dim>
void ConvectiveTerms<dim>::add(const StepSolution &state,
                               DistributedVector &momentum,
                               DistributedVector &volume)
{
  take(state);
  double least_stiffening = 1.;
  unsigned int softest = 0;
  for (const Cell &cell : cells.all())
  {
    here.visit(cell);
    const double stiffening = integrate();
    if (!(stiffening >= least_stiffening))
    {
      least_stiffening = stiffening;
      softest = cell.region;
    }
    Base::add_rows(cell);
  }
  Base::finish_rows(momentum, volume);
  refuse_softening(least_stiffening, softest);
}

template <int dim>
void ConvectiveTerms<dim>::refuse_softening(const double least_stiffening,
                                            unsigned int softest) const
{
  const auto least = Utilities::MPI::min_max_avg(least_stiffening, space.communicator);
  if (least.min > 0.)
    return;
  softest = Utilities::MPI::max(least_stiffening == least.min ? softest : 0, space.communicator);
  std::ostringstream text;
  text << "the pressure in the region '" << problem.regions[softest]
       << "' is so low that its bulk modulus K + n (p - p0) is not positive: K/n is "
       << 1. / (problem.materials[softest].volume_law().inverse_bulk_modulus *
                problem.materials[softest].volume_law().exponent)
       << " Pa; use smaller loads, or Volume exponent = 0";
  throw StepFailure(text.str());
}

template <int dim>
NonlinearEnergy ConvectiveTerms<dim>::energy_of(const unsigned int region, const State &state)
{
  NonlinearEnergy energy;
  const VolumeLaw law = problem.materials[region].volume_law();
  take(state.velocity, state.pressure);
  if (problem.mesh_moves)
    space.copy_velocity(*state.mesh_displacement, mesh_displacement);
  for (const Cell &cell : cells.all())
    if (cell.region == region)
    {
      here.visit(cell);
      for (unsigned int q = 0; q < cells.n_points(); ++q)
      {
        const Point at_point = here.point(q);
        energy.kinetic += here.points()[q].weight * FlowInertia::energy(at_point);
        energy.compressive += here.points()[q].weight * law.energy(at_point.pressure);
      }
    }
  return energy;
}

template <int dim>
void ConvectiveTerms<dim>::take_derivatives()
{
  const bool has_pressure_gradient = couples_pressures(here.cell());
  const std::size_t n_of_point =
      n_directions<dim>(has_pressure_gradient) * n_numbers_of_direction<dim>;
  derivative_at_points.resize(n_of_point * cells.n_points());
  flow_terms.set_derivative(here.all_points(), has_pressure_gradient, derivative_at_points.data());
  for (unsigned int q = 0; q < cells.n_points(); ++q)
    assembly.take_derivative(q, &derivative_at_points[n_of_point * q], has_pressure_gradient);
}

template <int dim>
void ConvectiveTerms<dim>::take_derivatives_with_streamline()
{
  streamline_terms.visit(here.cell().velocity_cell, step);
  typename CellAssembly<dim>::Directions directions;
  directions.pressure_gradient = true;
  directions.viscous_forces = &streamline_terms.viscous_forces();
  for (unsigned int q = 0; q < cells.n_points(); ++q)
  {
    const typename Cell::Point &geometry = here.points()[q];
    Point at_point = here.point(q);
    streamline_terms.set_point(q, here.state(), at_point);
    assembly.take_derivative(q, geometry.inverse_jacobian, geometry.weight, directions,
                             [&](const PointChange<dim> &of_unknowns, Tested<dim> &tested) {
                               StreamlineFlowTerms::add_derivative(
                                   at_point, FlowChange<dim>(at_point, of_unknowns), tested);
                             });
  }
}

template <int dim>
void ConvectiveTerms<dim>::set_derivative(const Cell &cell, FullMatrix<double> &matrix)
{
  here.visit(cell);
  if (streamline_terms.are_on())
    take_derivatives_with_streamline();
  else
    take_derivatives();
  assembly.finish_matrix(matrix);
  // A body force does not change where the mesh is held.
  for (const TermFace<dim> &face : faces.of(cell))
  {
    if (!face.has_total_pressure)
      continue;
    for (unsigned int q = 0; q < face.points.size(); ++q)
    {
      const FlowFacePoint<dim> point = face_points.of_flow(face, q, here.material(), here.state());
      face_assembly.add_derivative(
          face.points[q], nullptr, &face.pressure_values[q], point.weight,
          [&point](const PointChange<dim> &of_unknowns, TestedOnFace<dim> &tested) {
            FlowFaceTerms::add_derivative(point, FlowFaceChange<dim>(point, of_unknowns), tested);
          },
          matrix);
    }
  }
}

template class ConvectiveTerms<2>;
template class ConvectiveTerms<3>;
} // namespace Continua
