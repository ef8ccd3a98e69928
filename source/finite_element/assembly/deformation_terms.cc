#include <continua/finite_element/assembly/deformation_terms.h>

#include <continua/base/input_error.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace Continua
{
using namespace dealii;

namespace
{
/// Of the terms of a stress in balance, which cancel: what of them a residual keeps is far below.
constexpr double least_share = 0.1;
} // namespace

template <int dim>
DeformationTerms<dim>::DeformationTerms(const Space<dim> &space,
                                        const Problem &problem,
                                        MetricHistory<dim> *const metrics,
                                        const InstructionSet set_of_terms)
    // As the linear stress, to which the terms come close where the deformation is small.
    : Base(space,
           problem,
           space.quadrature(space.n_quadrature_points()),
           RegionModel::finite_solid,
           kinds_of<SolidTerms, BodyForceTerms, SolidFaceTerms>()),
      solid_terms(solid_terms_of<dim>(set_of_terms)),
      stress_free_states(space, problem, quadrature, cells),
      here(problem,
           cells,
           stress_free_states,
           metrics,
           {velocity, displacement, acceleration, pressure, pressure_rate}),
      metrics(metrics),
      heat(problem.regions.size(), 0.)
{
  // The terms take up to eight points at a time.
  AssertThrow(cells.n_points() >= 8, ExcInternalError());
}

template <int dim>
void DeformationTerms<dim>::reinit()
{
  Base::reinit();
  displacement.reinit(space.velocity_owned, space.velocity_relevant, space.communicator);
  pressure_rate.reinit(space.pressure_owned, space.pressure_relevant, space.communicator);
  acceleration.reinit(space.velocity_owned, space.velocity_relevant, space.communicator);
  stress_free_states.reinit();
}

template <int dim>
void DeformationTerms<dim>::set_unloaded_displacement(const DistributedVector &of_unloaded)
{
  stress_free_states.set_unloaded_displacement(of_unloaded);
  // In the shape of the mesh all branches have relaxed.
  start_from(space.velocity_vector());
}

template <int dim>
void DeformationTerms<dim>::take(const StepSolution &state)
{
  step = state.step;
  here.set_step(step);
  take(state.velocity, state.pressure);
  space.copy_pressure(state.pressure_rate, pressure_rate);
  if (step.finds_unloaded_shape)
  {
    // The mesh stays, and what the displacement leads from is the unloaded shape.
    stress_free_states.unload_by(state.displacement);
    displacement = 0.;
  }
  else
    space.copy_velocity(state.displacement, displacement);
  face_points.set_step(step, state.boundary_pressures);
  space.copy_velocity(state.acceleration, acceleration);
  stress_free_states.set_share(step.load_factor);
}

template <int dim>
template <typename Visit>
void DeformationTerms<dim>::visit_relaxing_points(const DistributedVector &of_displacement,
                                                  const Visit &visit_point)
{
  space.copy_velocity(of_displacement, displacement);
  for (const Cell &cell : cells.all())
    if (metrics->relaxes(cell.region))
    {
      here.visit(cell);
      for (unsigned int q = 0; q < cells.n_points(); ++q)
        visit_point(q, here.point(q, Stress::none));
    }
}

template <int dim>
void DeformationTerms<dim>::start_from(const DistributedVector &of_displacement)
{
  if (metrics == nullptr)
    return;
  visit_relaxing_points(of_displacement,
                        [this](const unsigned int q, const Point &) {
                          metrics->start(here.number(), q, inverse_isochoric_metric(here.strain()));
                        });
}

template <int dim>
void DeformationTerms<dim>::set_branch(const unsigned int region,
                                       const unsigned int number,
                                       const DistributedVector &of_displacement)
{
  if (metrics == nullptr)
    return;
  visit_relaxing_points(of_displacement,
                        [&](const unsigned int q, const Point &)
                        {
                          if (here.cell().region == region)
                            metrics->set_branch(number, here.number(), q,
                                                inverse_isochoric_metric(here.strain()));
                        });
}

template <int dim>
void DeformationTerms<dim>::finish_step(const StepSolution &solution, const State &state)
{
  if (metrics == nullptr || solution.step.finds_unloaded_shape)
    return;
  std::fill(heat.begin(), heat.end(), 0.);
  visit_relaxing_points(solution.displacement,
                        [this](const unsigned int q, const Point &point)
                        {
                          const unsigned int region = here.cell().region;
                          heat[region] +=
                              here.cell().points[q].weight * point.stress_free_ratio *
                              metrics->dissipation(region, here.number(), q, here.strain());
                        });
  visit_relaxing_points(state.history.displacement(),
                        [this](const unsigned int q, const Point &)
                        {
                          metrics->advance(here.cell().region, here.number(), q,
                                           inverse_isochoric_metric(here.strain()));
                        });
}

template <int dim>
double DeformationTerms<dim>::integrate()
{
  SolidExtremes extremes;
  Base::set_terms([&](const PowersAtPoints *const asked, const TestedAtPoints &result)
                  { extremes = solid_terms.set(here.all_points(), asked, result); });
  sizes.stress = std::max(sizes.stress, extremes.stress);
  if (extremes.volume_ratio > 0. && body_forces.visit(here.cell(), step, here.displacement()))
    for (unsigned int q = 0; q < cells.n_points(); ++q)
      Base::template add_terms<BodyForceTerms>(
          q, here.inverse_jacobian(here.point(q, Stress::none), q), here.cell().points[q].weight,
          body_forces.point(q), SolidTerms::size);
  assembly.finish_rows(cell_momentum, cell_volume);
  for (const TermFace<dim> &face : faces.of(here.cell()))
    for (unsigned int q = 0; q < face.points.size(); ++q)
      Base::template add_face_terms<SolidFaceTerms>(
          face.points[q], face_points.of_solid(face, q, here.displacement()),
          SolidTerms::size + BodyForceTerms::size);
  return extremes.volume_ratio;
}

template <int dim>
void DeformationTerms<dim>::add(const StepSolution &state,
                                DistributedVector &momentum,
                                DistributedVector &volume)
{
  take(state);
  sizes.stress = 0.;
  double least_ratio = std::numeric_limits<double>::max(), largest_displacement = 0.;
  const Cell *worst = nullptr;
  for (const Cell &cell : cells.all())
  {
    here.visit(cell);
    const double ratio = integrate();
    // The round-off of a displacement is a strain, also of a body that is moved far, and a law has
    // that of the deformation gradient 1, from which it takes its stress.
    const StrainLaw &law = *here.material().strain_law;
    const double displacement = here.largest_displacement(),
                 least_displacement = least_share * cell.size;
    sizes.stress =
        std::max(sizes.stress, here.material().instantaneous_shear_modulus() *
                                   std::max(displacement, least_displacement) / cell.size);
    // ln J has no round-off of that kind, but ln det F0 has.
    largest_displacement = std::max(
        largest_displacement, law.has_own_mean_stress() || stress_free_states.have_other_volume()
                                  ? std::max(displacement, least_displacement)
                                  : displacement);
    if (!(ratio >= least_ratio))
    {
      least_ratio = ratio;
      worst = &cell;
    }
    Base::add_rows(cell);
  }
  Base::finish_rows(momentum, volume);
  sizes.stress = Utilities::MPI::max(sizes.stress, space.communicator);
  sizes.velocity = Utilities::MPI::max(largest_displacement, space.communicator) /
                   here.displacement_by_velocity();
  refuse_inversion(least_ratio, worst);
}

template <int dim>
void DeformationTerms<dim>::refuse_inversion(const double least_ratio,
                                             const Cell *const worst) const
{
  // A minimum over ranks passes over what is no number.
  const auto over_ranks = Utilities::MPI::min_max_avg(
      std::isnan(least_ratio) ? -std::numeric_limits<double>::max() : least_ratio,
      space.communicator);
  if (over_ranks.min > 0.)
    return;
  std::string place;
  if (worst != nullptr)
  {
    std::ostringstream text;
    text.precision(4);
    text << "in the region '" << problem.regions[worst->region] << "' in the cell at (";
    for (unsigned int c = 0; c < dim; ++c)
      text << (c == 0 ? "" : ", ") << worst->velocity_cell->center()[c];
    text << ") m";
    place = text.str();
  }
  place = Utilities::MPI::broadcast(space.communicator, place, over_ranks.min_index);
  throw StepFailure(
      (step.finds_unloaded_shape ? "the unloaded shape is turned inside out "
                                 : "the body is turned inside out ") +
      place +
      (step.finds_unloaded_shape
           ? ": its volume is not positive there; more Steady/Load steps or a finer mesh help"
           : ": the ratio of its volume to the undeformed one is not positive there; a smaller "
             "time step, loads that begin smoothly or a finer mesh help"));
}

template <int dim>
NonlinearEnergy DeformationTerms<dim>::energy_at(const unsigned int q)
{
  const StrainLaw &law = *here.material().strain_law;
  const double inverse_bulk_modulus = here.material().inverse_bulk_modulus();
  const Point point = here.point(q, Stress::alone);
  const double weight = here.cell().points[q].weight,
               stress_free_weight = weight * point.stress_free_ratio;
  NonlinearEnergy energy;
  energy.kinetic = weight * SolidInertia::energy(point);
  energy.strain = stress_free_weight * law.energy(here.strain());
  if (here.relaxes())
    energy.strain +=
        stress_free_weight * metrics->energy(here.cell().region, here.number(), q, here.strain());
  if (law.has_own_mean_stress())
  {
    // The pressure is not -s at each point, but in the mean over its shape functions.
    const double difference = point.mean_stress + point.pressure;
    energy.strain -=
        weight * point.volume_ratio() * 0.5 * inverse_bulk_modulus * difference * difference;
  }
  // K (J ln J - J + 1) by the pressure, whose J is exp(-p/K).
  const double log_ratio = -inverse_bulk_modulus * point.pressure;
  if (inverse_bulk_modulus > 0. && !law.has_own_mean_stress())
    energy.compressive = stress_free_weight *
                         (log_ratio * std::exp(log_ratio) - std::expm1(log_ratio)) /
                         inverse_bulk_modulus;
  return energy;
}

template <int dim>
NonlinearEnergy DeformationTerms<dim>::energy_of(const unsigned int region, const State &state)
{
  NonlinearEnergy energy;
  take(state.velocity, state.pressure);
  space.copy_velocity(state.history.displacement(), displacement);
  pressure_rate = 0.;
  for (const Cell &cell : cells.all())
    if (cell.region == region)
    {
      here.visit(cell);
      for (unsigned int q = 0; q < cells.n_points(); ++q)
      {
        const NonlinearEnergy of_point = energy_at(q);
        energy.kinetic += of_point.kinetic;
        energy.strain += of_point.strain;
        energy.compressive += of_point.compressive;
      }
    }
  return energy;
}

template <int dim>
void DeformationTerms<dim>::take_derivatives_of_points(const bool has_body_force)
{
  for (unsigned int q = 0; q < cells.n_points(); ++q)
  {
    const Point point = here.point(q, Stress::with_tangent);
    BodyForcePoint<dim> body_force;
    if (has_body_force)
      body_force = body_forces.point_with_slope(q, here.displacement_by_velocity());
    assembly.take_derivative(q, here.inverse_jacobian(point, q), here.cell().points[q].weight, {},
                             [&](const PointChange<dim> &of_unknowns, Tested<dim> &tested)
                             {
                               SolidTerms::add_derivative(
                                   point, SolidChange<dim>(point, of_unknowns), tested);
                               if (has_body_force)
                                 BodyForceTerms::add_derivative(body_force, of_unknowns, tested);
                             });
  }
}

template <int dim>
void DeformationTerms<dim>::set_derivative(const Cell &cell, FullMatrix<double> &matrix)
{
  here.visit(cell);
  // What finds the unloaded shape leaves the place at which the loads act.
  const bool has_body_force =
      body_forces.visit(cell, step, here.displacement()) && !step.finds_unloaded_shape;
  if (has_body_force || here.finds_unloaded())
    take_derivatives_of_points(has_body_force);
  else
  {
    constexpr std::size_t n_numbers = n_numbers_of_direction<dim> * n_numbers_of_direction<dim>;
    derivative_at_points.resize(n_numbers * cells.n_points());
    solid_terms.set_derivative(here.all_points(), derivative_at_points.data());
    for (unsigned int q = 0; q < cells.n_points(); ++q)
      assembly.take_derivative(q, &derivative_at_points[n_numbers * q], false);
  }
  assembly.finish_matrix(matrix);
  for (const TermFace<dim> &face : faces.of(cell))
    for (unsigned int q = 0; q < face.points.size(); ++q)
    {
      const SolidFacePoint<dim> point = face_points.of_solid(face, q, here.displacement());
      face_assembly.add_derivative(
          face.points[q], &point.kinematics, nullptr, point.weight,
          [&point](const PointChange<dim> &of_unknowns, TestedOnFace<dim> &tested) {
            SolidFaceTerms::add_derivative(point, SolidFaceChange<dim>(point, of_unknowns), tested);
          },
          matrix);
    }
}

template class DeformationTerms<2>;
template class DeformationTerms<3>;
} // namespace Continua
