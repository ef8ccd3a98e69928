#include <continua/finite_element/deformation_terms.h>

#include <continua/base/input_error.h>
#include <continua/continuum/rest_state.h>
#include <continua/continuum/right_stretch.h>
#include <continua/materials/metric_stress.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>

namespace Continua
{
using namespace dealii;

namespace
{
/// Of the terms of a stress at rest, which cancel: what of them a residual keeps is far below.
constexpr double share_of_rest = 0.1;
} // namespace

template <int dim>
DeformationTerms<dim>::DeformationTerms(const Space<dim> &space,
                                        const Problem &problem,
                                        MetricHistory<dim> *const metrics)
    // As the linear stress, to which the terms come close where the deformation is small.
    : Base(space, problem, QGauss<dim>(space.n_quadrature_points()), RegionModel::finite_solid),
      assembly(cells),
      metrics(metrics),
      heat(problem.regions.size(), 0.),
      follower_pressure(space, problem),
      body_force(space, problem, quadrature),
      potentials(space, problem.wall_directions),
      has_other_rest(problem.finds_unloaded_shape() ||
                     std::any_of(problem.materials.begin(),
                                 problem.materials.end(),
                                 [](const Material &of_region)
                                 { return of_region.prestretch.exists(); }))
{
  const unsigned int n_velocity = dim * cells.n_functions(), n_pressure = cells.n_pressures();
  for (Vector<double> *vector : {&cell_velocity, &cell_displacement, &cell_unloaded,
                                 &cell_potentials, &cell_acceleration, &cell_load})
    vector->reinit(n_velocity);
  for (Vector<double> &forces : cell_forces)
    forces.reinit(n_velocity);
  for (Vector<double> *vector : {&cell_pressure, &cell_pressure_rate, &cell_volume})
    vector->reinit(n_pressure);
}

template <int dim>
void DeformationTerms<dim>::reinit()
{
  Base::reinit();
  displacement.reinit(space.velocity_owned, space.velocity_relevant, space.communicator);
  pressure_rate.reinit(space.pressure_owned, space.pressure_relevant, space.communicator);
  acceleration.reinit(space.velocity_owned, space.velocity_relevant, space.communicator);
  if (problem.finds_unloaded_shape())
    ghosted_unloaded.reinit(space.velocity_owned, space.velocity_relevant, space.communicator);
  follower_pressure.reinit();
  potentials.reinit();
  prestretch_share = 1.;
  set_rest_states();
}

template <int dim>
void DeformationTerms<dim>::set_rest_states()
{
  rest_states.clear();
  if (!has_other_rest && std::none_of(problem.materials.begin(), problem.materials.end(),
                                      [](const Material &of_region)
                                      { return of_region.strain_law_parameters.has_fibres(); }))
    return;
  const DistributedVector ghosted_potentials =
      potentials.exist() ? space.ghosted_velocity(potentials.potentials()) : DistributedVector();
  const FE_Q<dim> element(space.degree());
  FEValues<dim> places(space.mapping, element, quadrature, update_quadrature_points);
  for (const Cell &cell : cells.all())
  {
    places.reinit(
        static_cast<typename Triangulation<dim>::active_cell_iterator>(cell.velocity_cell));
    rest_states.emplace_back();
    present = &cell;
    if (problem.finds_unloaded_shape())
      Base::set_entries(cell.velocity_places, ghosted_unloaded, cell_unloaded);
    if (potentials.exist())
      Base::set_entries(cell.velocity_places, ghosted_potentials, cell_potentials);
    const Material &of_region = problem.materials[cell.region];
    for (unsigned int q = 0; q < cells.n_points(); ++q)
      rest_states.back().push_back(rest_state_at(
          of_region,
          has_directions(of_region)
              ? problem.wall_directions.at(problem.model, places.quadrature_point(q),
                                           potentials.exist() ? gradient(cell_potentials, q)
                                                              : Tensor<2, 3>())
              : TubeDirections(),
          prestretch_share,
          problem.finds_unloaded_shape() ? gradient(cell_unloaded, q) : Tensor<2, 3>()));
  }
}

template <int dim>
void DeformationTerms<dim>::visit_state(StateVisitor &visitor)
{
  if (problem.finds_unloaded_shape())
    visitor.vector("unloaded displacement", StateKind::velocity, unloaded);
}

template <int dim>
void DeformationTerms<dim>::take_own_state()
{
  if (!problem.finds_unloaded_shape())
    return;
  space.copy_velocity(unloaded, velocity_work, ghosted_unloaded);
  set_rest_states();
}

template <int dim>
void DeformationTerms<dim>::set_unloaded_displacement(const DistributedVector &of_unloaded)
{
  unloaded.equ(1., of_unloaded);
  take_own_state();
  // In the shape of the mesh all branches have relaxed.
  start_from(space.velocity_vector());
}

template <int dim>
void DeformationTerms<dim>::take(const BalancedStep &state)
{
  step = state.step;
  scheme.displacement_by_velocity = step.branch(std::numeric_limits<double>::infinity()).velocity;
  scheme.rate_by_velocity = step.a0;
  scheme.pressure_rate_by_pressure = 1. / step.pressure_time;
  scheme.volume_is_rate = step.extrapolate;
  take(state.velocity, state.pressure);
  space.copy_pressure(state.pressure_rate, Base::pressure_work, pressure_rate);
  if (step.finds_unloaded_shape)
  {
    // The mesh stays, and what the displacement leads from is the unloaded shape.
    // From deal.II 9.8 on, a vector with ghosts changes by assignment alone.
    velocity_work.equ(-1., state.displacement);
    space.velocity_hanging.distribute(velocity_work);
    ghosted_unloaded = velocity_work;
    set_rest_states();
    displacement = 0.;
  }
  else
    space.copy_velocity(state.displacement, velocity_work, displacement);
  follower_pressure.set_cavity_pressures(state.cavity_pressures);
  space.copy_velocity(state.acceleration, velocity_work, acceleration);
  if (has_other_rest && step.load_factor != prestretch_share)
  {
    prestretch_share = step.load_factor;
    set_rest_states();
  }
}

template <int dim>
void DeformationTerms<dim>::visit(const Cell &cell)
{
  present = &cell;
  const Material &solid = material();
  scheme.density = solid.density;
  scheme.viscosity = step.is_towards_rest || step.finds_unloaded_shape ? 0. : solid.shear.viscosity;
  scheme.inverse_bulk_modulus = solid.inverse_bulk_modulus();
  scheme.has_own_mean_stress = solid.strain_law->has_own_mean_stress();
  Base::set_entries(cell.velocity_places, velocity, cell_velocity);
  Base::set_entries(cell.velocity_places, displacement, cell_displacement);
  Base::set_entries(cell.velocity_places, acceleration, cell_acceleration);
  if (step.finds_unloaded_shape)
    Base::set_entries(cell.velocity_places, ghosted_unloaded, cell_unloaded);
  Base::set_entries(cell.pressure_places, pressure, cell_pressure);
  Base::set_entries(cell.pressure_places, pressure_rate, cell_pressure_rate);
}

template <int dim>
Tensor<2, 3> DeformationTerms<dim>::gradient(const Vector<double> &entries,
                                             const unsigned int q) const
{
  const typename Cell::Point &geometry = present->points[q];
  const std::size_t n_functions = cells.n_functions();
  const Tensor<1, dim> *const gradients = cells.gradients(q);
  Tensor<2, dim> result;
  for (unsigned int c = 0; c < dim; ++c)
  {
    const double *const of_component = entries.begin() + c * n_functions;
    Tensor<1, dim> slope; // on the reference cell
    for (unsigned int a = 0; a < n_functions; ++a)
      slope += of_component[a] * gradients[a];
    result[c] = slope * geometry.inverse_jacobian;
  }
  double radial = 0.;
  if (geometry.hoop != 0.)
  {
    const double *const values = cells.values(q), *const of_component =
                                                      entries.begin() + n_functions;
    for (unsigned int a = 0; a < n_functions; ++a)
      radial += of_component[a] * values[a];
  }
  return whole_gradient<dim>(result, radial * geometry.hoop);
}

template <int dim>
typename DeformationTerms<dim>::Point DeformationTerms<dim>::point(const unsigned int q,
                                                                   const Stress of_law)
{
  const std::size_t n_functions = cells.n_functions();
  const double *const values = cells.values(q), *const pressure_values = cells.pressure_values(q);
  Point point(scheme, Kinematics(gradient(cell_displacement, q)));
  point.hoop = present->points[q].hoop * point.kinematics.inverse()[2][2];
  for (unsigned int c = 0; c < dim; ++c)
    for (unsigned int a = 0; a < n_functions; ++a)
    {
      point.velocity[c] += cell_velocity[c * n_functions + a] * values[a];
      point.acceleration[c] += cell_acceleration[c * n_functions + a] * values[a];
    }
  point.velocity_gradient = point.kinematics.gradient(gradient(cell_velocity, q));
  for (unsigned int k = 0; k < cells.n_pressures(); ++k)
  {
    point.pressure += cell_pressure[k] * pressure_values[k];
    point.pressure_rate += cell_pressure_rate[k] * pressure_values[k];
  }
  if (!rest_states.empty())
    point.rest_ratio = rest_states[present - cells.all().data()][q].volume_ratio;
  // A step that finds the unloaded shape ends at rest, whatever the mass on the way there.
  point.mass_ratio = step.finds_unloaded_shape ? 1. : point.rest_ratio;
  if (!(std::min(point.volume_ratio(), point.rest_ratio) > 0.))
    return point;
  set_strain(point, q);
  if (of_law == Stress::alone)
    set_stress(q, point);
  else if (of_law == Stress::with_tangent)
    set_tangent(q, point);
  if (of_law != Stress::none && scheme.has_own_mean_stress)
    material().strain_law->set_mean_stress(strain_at_point, point.mean_stress,
                                           point.mean_stress_slope);
  return point;
}

template <int dim>
void DeformationTerms<dim>::set_strain(const Point &here, const unsigned int q)
{
  strain_at_point.gradient = here.kinematics.deformation_gradient();
  strain_at_point.determinant = here.volume_ratio();
  if (rest_states.empty())
    return;
  const RestState &rest = rest_states[present - cells.all().data()][q];
  strain_at_point.fibres = rest.fibres;
  strain_at_point.gradient = strain_at_point.gradient * rest.prestretch;
  strain_at_point.determinant /= rest.volume_ratio;
}

template <int dim>
void DeformationTerms<dim>::set_stress(const unsigned int q, Point &here) const
{
  material().strain_law->set_stress(strain_at_point, here.stress);
  if (relaxes())
  {
    SymmetricTensor<2, 3> of_branches;
    MetricStress(metrics->predicted(cell_number(), q)).set_stress(strain_at_point, of_branches);
    here.stress += of_branches;
  }
  here.stress *= here.rest_ratio;
}

template <int dim>
void DeformationTerms<dim>::set_tangent(const unsigned int q, Point &here) const
{
  material().strain_law->set_tangent(strain_at_point, here.stress, here.tangent);
  if (relaxes())
  {
    SymmetricTensor<2, 3> of_branches;
    SymmetricTensor<4, 3> tangent_of_branches;
    MetricStress(metrics->predicted(cell_number(), q))
        .set_tangent(strain_at_point, of_branches, tangent_of_branches);
    here.stress += of_branches;
    here.tangent += tangent_of_branches;
  }
  here.stress *= here.rest_ratio;
  here.tangent *= here.rest_ratio;
}

template <int dim>
Tensor<2, dim> DeformationTerms<dim>::present_jacobian(const Point &here,
                                                       const unsigned int q) const
{
  Tensor<2, dim> inverse;
  for (unsigned int c = 0; c < dim; ++c)
    for (unsigned int d = 0; d < dim; ++d)
      inverse[c][d] = here.kinematics.inverse()[c][d];
  return present->points[q].inverse_jacobian * inverse;
}

template <int dim>
template <typename Visit>
void DeformationTerms<dim>::visit_relaxing_points(const DistributedVector &of_displacement,
                                                  const Visit &visit_point)
{
  space.copy_velocity(of_displacement, velocity_work, displacement);
  for (const Cell &cell : cells.all())
    if (metrics->relaxes(cell.region))
    {
      visit(cell);
      for (unsigned int q = 0; q < cells.n_points(); ++q)
      {
        visit_point(q, point(q, Stress::none));
      }
    }
}

template <int dim>
void DeformationTerms<dim>::start_from(const DistributedVector &of_displacement)
{
  if (metrics == nullptr)
    return;
  visit_relaxing_points(
      of_displacement, [this](const unsigned int q, const Point &)
      { metrics->start(cell_number(), q, inverse_isochoric_metric(strain_at_point)); });
}

template <int dim>
void DeformationTerms<dim>::finish_step(const BalancedStep &balanced, const State &state)
{
  if (metrics == nullptr || balanced.step.finds_unloaded_shape)
    return;
  std::fill(heat.begin(), heat.end(), 0.);
  visit_relaxing_points(balanced.displacement,
                        [this](const unsigned int q, const Point &here)
                        {
                          heat[present->region] +=
                              present->points[q].weight * here.rest_ratio *
                              metrics->dissipation(present->region, cell_number(), q,
                                                   strain_at_point);
                        });
  visit_relaxing_points(state.history.displacement(),
                        [this](const unsigned int q, const Point &)
                        {
                          metrics->advance(present->region, cell_number(), q,
                                           inverse_isochoric_metric(strain_at_point));
                        });
}

template <int dim>
double DeformationTerms<dim>::integrate(const bool by_term)
{
  for (Vector<double> &forces : cell_forces)
    forces = 0.;
  cell_volume = 0.;
  double least_ratio = std::numeric_limits<double>::max();
  for (unsigned int q = 0; q < cells.n_points(); ++q)
  {
    const Point here = point(q, Stress::alone);
    const double least = std::min(here.volume_ratio(), here.rest_ratio);
    // What is no number fails the comparisons.
    if (!(least >= least_ratio))
      least_ratio = least;
    if (!(least > 0.))
      continue;
    sizes.stress =
        std::max(sizes.stress, here.stress.norm() + std::abs(here.volume_ratio() * here.pressure));
    const double weight = present->points[q].weight;
    const Tensor<2, dim> jacobian = present_jacobian(here, q);
    if (by_term)
    {
      unsigned int number = 0;
      SolidTerms::for_each(
          [&](const auto term)
          {
            Tested<dim> tested;
            term.add(here, tested);
            assembly.add_momentum(q, jacobian, weight, tested, cell_forces[number++]);
          });
      continue;
    }
    Tested<dim> sum;
    SolidTerms::add(here, sum);
    assembly.add_momentum(q, jacobian, weight, sum, cell_forces[0]);
    assembly.add_volume(q, weight, sum, cell_volume);
  }
  return least_ratio;
}

template <int dim>
void DeformationTerms<dim>::add(const BalancedStep &state,
                                DistributedVector &momentum,
                                DistributedVector &volume)
{
  take(state);
  sizes.stress = 0.;
  double least_ratio = std::numeric_limits<double>::max(), largest_way = 0.;
  const Cell *worst = nullptr;
  for (const Cell &cell : cells.all())
  {
    visit(cell);
    const double ratio = integrate(false);
    // The round-off of a displacement is a strain, also of a body that is moved far, and a law has
    // that of the deformation gradient 1, from which it takes its stress.
    const StrainLaw &law = *material().strain_law;
    const double way =
                     (step.finds_unloaded_shape ? cell_unloaded : cell_displacement).linfty_norm(),
                 of_rest = share_of_rest * cell.size;
    sizes.stress = std::max(sizes.stress, material().instantaneous_shear_modulus() *
                                              std::max(way, of_rest) / cell.size);
    // ln J has no round-off of that kind, but ln det F0 has.
    largest_way = std::max(
        largest_way, law.has_own_mean_stress() || has_other_rest ? std::max(way, of_rest) : way);
    if (!(ratio >= least_ratio))
    {
      least_ratio = ratio;
      worst = &cell;
    }
    Vector<double> &sum = cell_forces[0];
    if (has_load_changes(cell))
    {
      set_load_changes(cell);
      sum -= cell_load;
    }
    space.velocity_hanging.distribute_local_to_global(sum, cell.velocity_indices, momentum);
    space.pressure_hanging.distribute_local_to_global(cell_volume, cell.pressure_indices, volume);
  }
  momentum.compress(VectorOperation::add);
  volume.compress(VectorOperation::add);
  sizes.stress = Utilities::MPI::max(sizes.stress, space.communicator);
  sizes.velocity =
      Utilities::MPI::max(largest_way, space.communicator) / scheme.displacement_by_velocity;
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
           : ": the ratio of its volume to that at rest is not positive there; a smaller time "
             "step, "
             "loads that begin smoothly or a finer mesh help"));
}

template <int dim>
void DeformationTerms<dim>::set_forces_of(const unsigned int region,
                                          const BalancedStep &state,
                                          NonlinearForces &forces)
{
  const auto kinds = SolidTerms::forces();
  for (const auto kind : kinds)
    if (kind != nullptr)
      forces.*kind = 0.;
  take(state);
  for (const Cell &cell : cells.all())
    if (cell.region == region)
    {
      visit(cell);
      integrate(true);
      for (std::size_t k = 0; k < kinds.size(); ++k)
        if (kinds[k] != nullptr)
          space.velocity_hanging.distribute_local_to_global(cell_forces[k], cell.velocity_indices,
                                                            forces.*kinds[k]);
    }
  for (const auto kind : kinds)
    if (kind != nullptr)
      (forces.*kind).compress(VectorOperation::add);
}

template <int dim>
NonlinearEnergy DeformationTerms<dim>::energy_at(const unsigned int q)
{
  const StrainLaw &law = *material().strain_law;
  const double inverse_bulk_modulus = scheme.inverse_bulk_modulus;
  const Point here = point(q, Stress::alone);
  const double weight = present->points[q].weight, rest_weight = weight * here.rest_ratio;
  NonlinearEnergy energy;
  energy.kinetic = weight * SolidInertia::energy(here);
  energy.strain = rest_weight * law.energy(strain_at_point);
  if (relaxes())
    energy.strain +=
        rest_weight * metrics->energy(present->region, cell_number(), q, strain_at_point);
  if (law.has_own_mean_stress())
  {
    // The pressure is not -s at each point, but in the mean over its shape functions.
    const double rest = here.mean_stress + here.pressure;
    energy.strain -= weight * here.volume_ratio() * 0.5 * inverse_bulk_modulus * rest * rest;
  }
  // K (J ln J - J + 1) by the pressure, whose J is exp(-p/K).
  const double log_ratio = -inverse_bulk_modulus * here.pressure;
  if (inverse_bulk_modulus > 0. && !law.has_own_mean_stress())
    energy.compressive = rest_weight * (log_ratio * std::exp(log_ratio) - std::expm1(log_ratio)) /
                         inverse_bulk_modulus;
  return energy;
}

template <int dim>
NonlinearEnergy DeformationTerms<dim>::energy_of(const unsigned int region, const State &state)
{
  NonlinearEnergy energy;
  take(state.velocity, state.pressure);
  space.copy_velocity(state.history.displacement(), velocity_work, displacement);
  pressure_rate = 0.;
  for (const Cell &cell : cells.all())
    if (cell.region == region)
    {
      visit(cell);
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
void DeformationTerms<dim>::set_load_changes(const Cell &cell)
{
  cell_load = 0.;
  if (follower_pressure.has_face(cell.velocity_cell))
    follower_pressure.add(cell.velocity_cell, step, cell_displacement, cell_load);
  if (body_force.has_changes(cell.region))
    body_force.add(cells, cell, cell.points, step, cell_displacement, cell_load);
}

template <int dim>
void DeformationTerms<dim>::add_loads(const BalancedStep &state,
                                      const std::optional<unsigned int> region,
                                      DistributedVector &forces)
{
  take(state);
  for (const Cell &cell : cells.all())
    if ((!region || cell.region == *region) && has_load_changes(cell))
    {
      visit(cell);
      set_load_changes(cell);
      space.velocity_hanging.distribute_local_to_global(cell_load, cell.velocity_indices, forces);
    }
  forces.compress(VectorOperation::add);
}

template <int dim>
void DeformationTerms<dim>::set_derivative(const Cell &cell, FullMatrix<double> &matrix)
{
  visit(cell);
  for (unsigned int q = 0; q < cells.n_points(); ++q)
  {
    Point here = point(q, Stress::with_tangent);
    std::optional<RightStretch> unloading;
    if (step.finds_unloaded_shape)
    {
      unloading.emplace(Tensor<2, 3>(unit_symmetric_tensor<3>()) + gradient(cell_unloaded, q));
      here.unloading = &*unloading;
    }
    assembly.take_derivative(
        q, present_jacobian(here, q), cell.points[q].weight, {},
        [&here](const PointChange<dim> &of_unknowns, Tested<dim> &tested)
        { SolidTerms::add_derivative(here, SolidChange<dim>(here, of_unknowns), tested); });
  }
  assembly.finish_matrix(matrix);
  if (step.finds_unloaded_shape)
    return;
  const double b = scheme.displacement_by_velocity;
  if (follower_pressure.has_face(cell.velocity_cell))
    follower_pressure.subtract_derivative(cell.velocity_cell, step, cell_displacement, b, matrix);
  if (body_force.has_changes(cell.region))
    body_force.subtract_derivative(cells, cell, step, cell_displacement, b, matrix);
}

template class DeformationTerms<2>;
template class DeformationTerms<3>;
} // namespace Continua
