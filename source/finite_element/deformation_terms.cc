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
#include <sstream>

namespace Continua
{
using namespace dealii;

namespace
{
const SymmetricTensor<2, 3> unit = unit_symmetric_tensor<3>();
/// Of the terms of a stress at rest, which cancel: what of them a residual keeps is far below.
constexpr double share_of_rest = 0.1;
} // namespace

template <int dim>
DeformationTerms<dim>::DeformationTerms(const Space<dim> &space,
                                        const Problem &problem,
                                        MetricHistory<dim> *const metrics)
    // As the linear stress, to which the terms come close where the deformation is small.
    : Base(space, problem, QGauss<dim>(space.n_quadrature_points()), RegionModel::finite_solid),
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
  const unsigned int n_functions = cells.n_functions(), n_velocity = dim * n_functions,
                     n_pressure = cells.n_pressures();
  for (Vector<double> *vector : {&cell_velocity, &cell_displacement, &cell_unloaded,
                                 &cell_potentials, &cell_acceleration, &cell_load})
    vector->reinit(n_velocity);
  for (Vector<double> &forces : cell_forces)
    forces.reinit(n_velocity);
  for (Vector<double> *vector : {&cell_pressure, &cell_pressure_rate, &cell_volume})
    vector->reinit(n_pressure);
  slopes.resize(n_functions);
  reference_slopes.resize(n_functions);
  hoops.resize(n_functions);
  reference_hoops.resize(n_functions);
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
  displacement_by_velocity = step.branch(std::numeric_limits<double>::infinity()).velocity;
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
typename DeformationTerms<dim>::Point DeformationTerms<dim>::point(const unsigned int q) const
{
  const double *const pressure_values = cells.pressure_values(q);
  Point point{Kinematics(gradient(cell_displacement, q)),
              {},
              present->points[q].weight,
              0.,
              0.,
              rest_states.empty() ? 1. : rest_states[present - cells.all().data()][q].volume_ratio};
  point.velocity_gradient = point.kinematics.gradient(gradient(cell_velocity, q));
  for (unsigned int k = 0; k < cells.n_pressures(); ++k)
  {
    point.pressure += cell_pressure[k] * pressure_values[k];
    point.pressure_rate += cell_pressure_rate[k] * pressure_values[k];
  }
  return point;
}

template <int dim>
void DeformationTerms<dim>::set_strain(const Point &here, const unsigned int q)
{
  strain_at_point.gradient = here.kinematics.deformation_gradient();
  strain_at_point.determinant = here.kinematics.volume_ratio();
  if (rest_states.empty())
    return;
  const RestState &rest = rest_states[present - cells.all().data()][q];
  strain_at_point.fibres = rest.fibres;
  strain_at_point.gradient = strain_at_point.gradient * rest.prestretch;
  strain_at_point.determinant /= rest.volume_ratio;
}

template <int dim>
void DeformationTerms<dim>::set_functions(const Point &here, const unsigned int q)
{
  const typename Cell::Point &geometry = present->points[q];
  const Tensor<2, 3> &inverse = here.kinematics.inverse();
  for (unsigned int a = 0; a < cells.n_functions(); ++a)
  {
    const Tensor<1, dim> slope = cells.gradients(q)[a] * geometry.inverse_jacobian;
    for (unsigned int d = 0; d < dim; ++d)
      reference_slopes[a][d] = slope[d];
    slopes[a] = reference_slopes[a] * inverse;
    reference_hoops[a] = geometry.hoop * cells.values(q)[a];
    hoops[a] = reference_hoops[a] * inverse[2][2];
  }
}

template <int dim>
void DeformationTerms<dim>::add_metric_stress(const unsigned int q,
                                              SymmetricTensor<2, 3> &stress) const
{
  if (!relaxes())
    return;
  SymmetricTensor<2, 3> of_branches;
  MetricStress(metrics->predicted(cell_number(), q)).set_stress(strain_at_point, of_branches);
  stress += of_branches;
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
        set_strain(point(q), q);
        visit_point(q);
      }
    }
}

template <int dim>
void DeformationTerms<dim>::start_from(const DistributedVector &of_displacement)
{
  if (metrics == nullptr)
    return;
  visit_relaxing_points(
      of_displacement, [this](const unsigned int q)
      { metrics->start(cell_number(), q, inverse_isochoric_metric(strain_at_point)); });
}

template <int dim>
void DeformationTerms<dim>::finish_step(const BalancedStep &balanced, const State &state)
{
  if (metrics == nullptr || balanced.step.finds_unloaded_shape)
    return;
  std::fill(heat.begin(), heat.end(), 0.);
  visit_relaxing_points(balanced.displacement,
                        [this](const unsigned int q)
                        {
                          heat[present->region] +=
                              present->points[q].weight * point(q).rest_ratio *
                              metrics->dissipation(present->region, cell_number(), q,
                                                   strain_at_point);
                        });
  visit_relaxing_points(state.history.displacement(),
                        [this](const unsigned int q)
                        {
                          metrics->advance(present->region, cell_number(), q,
                                           inverse_isochoric_metric(strain_at_point));
                        });
}

template <int dim>
SymmetricTensor<2, 3> DeformationTerms<dim>::viscous_stress(const Point &here) const
{
  return 2. * acting_viscosity() * here.kinematics.volume_ratio() *
         deviator(symmetrize(here.velocity_gradient));
}

template <int dim>
void DeformationTerms<dim>::add_stress(const SymmetricTensor<2, 3> &stress,
                                       const double weight,
                                       Vector<double> &rows) const
{
  const std::size_t n_functions = cells.n_functions();
  for (unsigned int c = 0; c < dim; ++c)
  {
    Tensor<1, 3> by_slope;
    for (unsigned int d = 0; d < 3; ++d)
      by_slope[d] = weight * stress[c][d];
    const double by_hoop = c == 1 ? weight * stress[2][2] : 0.;
    double *const of_component = rows.begin() + c * n_functions;
    for (unsigned int a = 0; a < n_functions; ++a)
      of_component[a] += by_slope * slopes[a] + by_hoop * hoops[a];
  }
}

template <int dim>
void DeformationTerms<dim>::add_inertia(const Point &here,
                                        const unsigned int q,
                                        Vector<double> &rows) const
{
  const std::size_t n_functions = cells.n_functions();
  const double *const values = cells.values(q);
  const double of_mass = mass(here);
  for (unsigned int c = 0; c < dim; ++c)
  {
    const double *const of_component = cell_acceleration.begin() + c * n_functions;
    double of_point = 0.;
    for (unsigned int a = 0; a < n_functions; ++a)
      of_point += of_component[a] * values[a];
    for (unsigned int a = 0; a < n_functions; ++a)
      rows[c * n_functions + a] += of_mass * of_point * values[a];
  }
}

template <int dim>
void DeformationTerms<dim>::add_derivative_of_inertia(const Point &here,
                                                      const unsigned int q,
                                                      FullMatrix<double> &matrix) const
{
  const std::size_t n_functions = cells.n_functions();
  const double *const values = cells.values(q);
  const double factor = mass(here) * step.a0;
  for (unsigned int a = 0; a < n_functions; ++a)
    for (unsigned int f = 0; f < n_functions; ++f)
      for (unsigned int c = 0; c < dim; ++c)
        matrix(c * n_functions + a, c * n_functions + f) += factor * values[a] * values[f];
}

template <int dim>
double DeformationTerms<dim>::volume_row(const Point &here) const
{
  const StrainLaw &law = *material().strain_law;
  const double inverse_bulk_modulus = material().inverse_bulk_modulus();
  if (law.has_own_mean_stress())
  {
    double mean_stress = 0.;
    SymmetricTensor<2, 3> derivative;
    law.set_mean_stress(strain_at_point, mean_stress, derivative);
    return step.extrapolate
               ? inverse_bulk_modulus *
                     (here.pressure_rate + derivative * symmetrize(here.velocity_gradient))
               : inverse_bulk_modulus * (here.pressure + mean_stress) / displacement_by_velocity;
  }
  if (step.extrapolate)
    return trace(here.velocity_gradient) + inverse_bulk_modulus * here.pressure_rate;
  const double strain = std::log1p(here.kinematics.volume_change()) - std::log(here.rest_ratio);
  return (strain + inverse_bulk_modulus * here.pressure) / displacement_by_velocity;
}

template <int dim>
double DeformationTerms<dim>::integrate(const bool by_kind)
{
  const StrainLaw &law = *material().strain_law;
  const bool is_viscous = acting_viscosity() != 0. && !step.finds_unloaded_shape;
  for (Vector<double> &forces : cell_forces)
    forces = 0.;
  cell_volume = 0.;
  double least_ratio = std::numeric_limits<double>::max();
  SymmetricTensor<2, 3> stress;
  for (unsigned int q = 0; q < cells.n_points(); ++q)
  {
    const Point here = point(q);
    const double ratio = here.kinematics.volume_ratio(), least = std::min(ratio, here.rest_ratio);
    // What is no number fails the comparisons.
    if (!(least >= least_ratio))
      least_ratio = least;
    if (!(least > 0.))
      continue;
    set_strain(here, q);
    set_functions(here, q);
    law.set_stress(strain_at_point, stress);
    add_metric_stress(q, stress);
    stress *= here.rest_ratio;
    sizes.stress = std::max(sizes.stress, stress.norm() + std::abs(ratio * here.pressure));
    const SymmetricTensor<2, 3> of_pressure = -ratio * here.pressure * unit;
    if (by_kind)
    {
      add_stress(stress, here.weight, cell_forces[strain]);
      if (is_viscous)
        add_stress(viscous_stress(here), here.weight, cell_forces[viscosity]);
      add_stress(of_pressure, here.weight, cell_forces[compression]);
      add_inertia(here, q, cell_forces[inertia]);
    }
    else
    {
      stress += of_pressure;
      if (is_viscous)
        stress += viscous_stress(here);
      add_stress(stress, here.weight, cell_forces[0]);
      add_inertia(here, q, cell_forces[0]);
    }
    const double row = here.weight * ratio * volume_row(here);
    for (unsigned int k = 0; k < cells.n_pressures(); ++k)
      cell_volume[k] += row * cells.pressure_values(q)[k];
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
  sizes.velocity = Utilities::MPI::max(largest_way, space.communicator) / displacement_by_velocity;
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
  const std::array<DistributedVector *, n_kinds> targets = {
      {&forces.strain, &forces.viscosity, &forces.compression, &forces.inertia}};
  for (DistributedVector *const target : targets)
    *target = 0.;
  take(state);
  for (const Cell &cell : cells.all())
    if (cell.region == region)
    {
      visit(cell);
      integrate(true);
      for (unsigned int kind = 0; kind < n_kinds; ++kind)
        space.velocity_hanging.distribute_local_to_global(cell_forces[kind], cell.velocity_indices,
                                                          *targets[kind]);
    }
  for (DistributedVector *const target : targets)
    target->compress(VectorOperation::add);
}

template <int dim>
NonlinearEnergy DeformationTerms<dim>::energy_of(const unsigned int region, const State &state)
{
  NonlinearEnergy energy;
  const Material &of_region = problem.materials[region];
  const StrainLaw &law = *of_region.strain_law;
  const double inverse_bulk_modulus = of_region.inverse_bulk_modulus();
  take(state.velocity, state.pressure);
  space.copy_velocity(state.history.displacement(), velocity_work, displacement);
  pressure_rate = 0.;
  for (const Cell &cell : cells.all())
    if (cell.region == region)
    {
      visit(cell);
      for (unsigned int q = 0; q < cells.n_points(); ++q)
      {
        const Point here = point(q);
        Tensor<1, dim> of_velocity;
        for (unsigned int c = 0; c < dim; ++c)
          for (unsigned int a = 0; a < cells.n_functions(); ++a)
            of_velocity[c] += cell_velocity[c * cells.n_functions() + a] * cells.values(q)[a];
        const double rest_weight = here.weight * here.rest_ratio;
        energy.kinetic += rest_weight * 0.5 * of_region.density * of_velocity.norm_square();
        set_strain(here, q);
        energy.strain += rest_weight * law.energy(strain_at_point);
        if (relaxes())
          energy.strain += rest_weight * metrics->energy(region, cell_number(), q, strain_at_point);
        if (law.has_own_mean_stress())
        {
          // The pressure is not -s at each point, but in the mean over its shape functions.
          double mean_stress = 0.;
          SymmetricTensor<2, 3> unused;
          law.set_mean_stress(strain_at_point, mean_stress, unused);
          const double rest = mean_stress + here.pressure;
          energy.strain -= here.weight * here.kinematics.volume_ratio() * 0.5 *
                           inverse_bulk_modulus * rest * rest;
        }
        // K (J ln J - J + 1) by the pressure, whose J is exp(-p/K).
        const double log_ratio = -inverse_bulk_modulus * here.pressure;
        if (inverse_bulk_modulus > 0. && !law.has_own_mean_stress())
          energy.compressive += rest_weight *
                                (log_ratio * std::exp(log_ratio) - std::expm1(log_ratio)) /
                                inverse_bulk_modulus;
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
  if (step.finds_unloaded_shape)
  {
    integrate_unloading_derivative(matrix);
    return;
  }
  integrate_derivative(matrix);
  if (follower_pressure.has_face(cell.velocity_cell))
    follower_pressure.subtract_derivative(cell.velocity_cell, step, cell_displacement,
                                          displacement_by_velocity, matrix);
  if (body_force.has_changes(cell.region))
    body_force.subtract_derivative(cells, cell, step, cell_displacement, displacement_by_velocity,
                                   matrix);
}

template <int dim>
void DeformationTerms<dim>::integrate_derivative(FullMatrix<double> &matrix)
{
  const StrainLaw &law = *material().strain_law;
  const double viscosity = acting_viscosity(),
               inverse_bulk_modulus = material().inverse_bulk_modulus();
  const double b = displacement_by_velocity, rate_by_pressure = 1. / step.pressure_time;
  const unsigned int n_functions = cells.n_functions(), n_velocity = dim * n_functions,
                     n_pressure = cells.n_pressures();
  matrix.reinit(n_velocity + n_pressure, n_velocity + n_pressure);
  SymmetricTensor<2, 3> stress, metric_stress, mean_derivative;
  SymmetricTensor<4, 3> tangent, metric_tangent;
  const SymmetricTensor<4, 3> of_pressure = outer_product(unit, unit) - 2. * identity_tensor<3>();
  for (unsigned int q = 0; q < cells.n_points(); ++q)
  {
    const Point here = point(q);
    const double ratio = here.kinematics.volume_ratio();
    set_strain(here, q);
    set_functions(here, q);
    law.set_tangent(strain_at_point, stress, tangent);
    if (relaxes())
    {
      MetricStress(metrics->predicted(cell_number(), q))
          .set_tangent(strain_at_point, metric_stress, metric_tangent);
      stress += metric_stress;
      tangent += metric_tangent;
    }
    stress *= here.rest_ratio;
    tangent *= here.rest_ratio;
    const double scaled_pressure = ratio * here.pressure;
    stress -= scaled_pressure * unit;
    tangent -= scaled_pressure * of_pressure;
    const auto whole_stress = static_cast<Tensor<2, 3>>(stress);
    const SymmetricTensor<2, 3> viscous =
        viscosity != 0. ? viscous_stress(here) : SymmetricTensor<2, 3>();
    double mean_stress = 0.;
    if (law.has_own_mean_stress())
      law.set_mean_stress(strain_at_point, mean_stress, mean_derivative);
    const double row = volume_row(here);
    for (unsigned int d = 0; d < dim; ++d)
      for (unsigned int f = 0; f < n_functions; ++f)
      {
        const unsigned int j = d * n_functions + f;
        // The gradient of the change of place by this unknown.
        Tensor<2, 3> change;
        change[d] = slopes[f];
        if (d == 1)
          change[2][2] += hoops[f];
        const SymmetricTensor<2, 3> strain_change = symmetrize(change);
        const double divergence = trace(change);
        // What acts on the gradients of test functions.
        Tensor<2, 3> acting = static_cast<Tensor<2, 3>>(tangent * strain_change);
        acting[d] += slopes[f] * whole_stress;
        if (d == 1)
          acting[2] += hoops[f] * whole_stress[2];
        acting *= b;
        if (viscosity != 0.)
        {
          const Tensor<2, 3> rate = change - b * here.velocity_gradient * change;
          acting += static_cast<Tensor<2, 3>>(2. * viscosity * ratio * deviator(symmetrize(rate)));
          acting += b * (divergence * static_cast<Tensor<2, 3>>(viscous) -
                         static_cast<Tensor<2, 3>>(viscous) * transpose(change));
        }
        acting *= here.weight;
        for (unsigned int c = 0; c < dim; ++c)
        {
          const double by_hoop = c == 1 ? acting[2][2] : 0.;
          for (unsigned int a = 0; a < n_functions; ++a)
            matrix(c * n_functions + a, j) += acting[c] * slopes[a] + by_hoop * hoops[a];
        }
        double row_change = b * row * divergence;
        if (law.has_own_mean_stress())
          // In the middle of a step without the change of the derivative itself, which the rate
          // multiplies.
          row_change +=
              inverse_bulk_modulus *
              (mean_derivative * (step.extrapolate
                                      ? symmetrize(change - b * here.velocity_gradient * change)
                                      : strain_change));
        else if (step.extrapolate)
          row_change +=
              divergence - b * double_contract<0, 1, 1, 0>(here.velocity_gradient, change);
        else
          row_change += divergence;
        const double by_velocity = here.weight * ratio * row_change;
        for (unsigned int k = 0; k < n_pressure; ++k)
          matrix(n_velocity + k, j) -= by_velocity * cells.pressure_values(q)[k];
        const double by_pressure = -here.weight * ratio * divergence;
        for (unsigned int k = 0; k < n_pressure; ++k)
          matrix(j, n_velocity + k) += by_pressure * cells.pressure_values(q)[k];
      }
    add_derivative_of_inertia(here, q, matrix);
    const double row_by_pressure =
        here.weight * ratio * inverse_bulk_modulus * (step.extrapolate ? rate_by_pressure : 1. / b);
    for (unsigned int k = 0; k < n_pressure; ++k)
      for (unsigned int l = 0; l < n_pressure; ++l)
        matrix(n_velocity + k, n_velocity + l) -=
            row_by_pressure * cells.pressure_values(q)[k] * cells.pressure_values(q)[l];
  }
}

template <int dim>
void DeformationTerms<dim>::integrate_unloading_derivative(FullMatrix<double> &matrix)
{
  const StrainLaw &law = *material().strain_law;
  const double inverse_bulk_modulus = material().inverse_bulk_modulus(),
               b = displacement_by_velocity;
  const unsigned int n_functions = cells.n_functions(), n_velocity = dim * n_functions,
                     n_pressure = cells.n_pressures();
  matrix.reinit(n_velocity + n_pressure, n_velocity + n_pressure);
  SymmetricTensor<2, 3> stress, mean_derivative;
  SymmetricTensor<4, 3> tangent;
  for (unsigned int q = 0; q < cells.n_points(); ++q)
  {
    const Point here = point(q);
    const Tensor<2, 3> unit_tensor = unit;
    const RightStretch unloading(unit_tensor + gradient(cell_unloaded, q));
    set_strain(here, q);
    set_functions(here, q);
    law.set_tangent(strain_at_point, stress, tangent);
    const auto whole_stress = static_cast<Tensor<2, 3>>(stress);
    double mean_stress = 0.;
    if (law.has_own_mean_stress())
      law.set_mean_stress(strain_at_point, mean_stress, mean_derivative);
    for (unsigned int d = 0; d < dim; ++d)
      for (unsigned int f = 0; f < n_functions; ++f)
      {
        const unsigned int j = d * n_functions + f;
        // D0 = -D, and dFe Fe^-1 = -U0^-1 dU0 of the elastic deformation Fe = U0^-1 times what is
        // known.
        Tensor<2, 3> change;
        change[d] = reference_slopes[f];
        if (d == 1)
          change[2][2] += reference_hoops[f];
        change = unloading.inverse() * unloading.change(change);
        const double divergence = trace(change);
        // Of det F0 tau, whose volume at rest changes, too.
        const Tensor<2, 3> acting =
            (here.weight * here.rest_ratio * b) *
            (static_cast<Tensor<2, 3>>(tangent * symmetrize(change)) + change * whole_stress +
             whole_stress * transpose(change) - divergence * whole_stress);
        for (unsigned int c = 0; c < dim; ++c)
          for (unsigned int a = 0; a < n_functions; ++a)
            matrix(c * n_functions + a, j) +=
                acting[c] * reference_slopes[a] + (c == 1 ? acting[2][2] * reference_hoops[a] : 0.);
        const double row_change =
            law.has_own_mean_stress()
                ? inverse_bulk_modulus * (mean_derivative * symmetrize(change))
                : divergence;
        const double reference_divergence =
            reference_slopes[f][d] + (d == 1 ? reference_hoops[f] : 0.);
        for (unsigned int k = 0; k < n_pressure; ++k)
        {
          matrix(n_velocity + k, j) -= here.weight * row_change * cells.pressure_values(q)[k];
          matrix(j, n_velocity + k) -=
              here.weight * reference_divergence * cells.pressure_values(q)[k];
        }
      }
    add_derivative_of_inertia(here, q, matrix);
    const double row_by_pressure = here.weight * inverse_bulk_modulus / b;
    for (unsigned int k = 0; k < n_pressure; ++k)
      for (unsigned int l = 0; l < n_pressure; ++l)
        matrix(n_velocity + k, n_velocity + l) -=
            row_by_pressure * cells.pressure_values(q)[k] * cells.pressure_values(q)[l];
  }
}

template class DeformationTerms<2>;
template class DeformationTerms<3>;
} // namespace Continua
