#include <continua/finite_element/convective_terms.h>

#include <continua/base/input_error.h>

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
                                      const std::optional<InstructionSet> instruction_set)
    // Products of three functions and of the radius are integrated exactly on parallelograms, where
    // density and compressibility are constant.
    : Base(space,
           problem,
           QGauss<dim>((3 * space.degree() + 2 + (space.is_axisymmetric() ? 1 : 0)) / 2),
           RegionModel::flow),
      carries(problem.convection.is_on ? 1. : 0.),
      inflow_terms(space, problem),
      streamline_terms(space, problem, quadrature),
      follower_pressure(space, problem),
      body_force(space, problem, quadrature),
      instruction_set(instruction_set)
{
  const unsigned int n_velocity = dim * cells.n_functions(), n_pressure = cells.n_pressures();
  for (Vector<double> *vector : {&cell_velocity, &cell_acceleration, &cell_inflow,
                                 &cell_mesh_displacement, &cell_mesh_velocity})
    vector->reinit(n_velocity);
  for (Vector<double> &forces : cell_forces)
    forces.reinit(n_velocity);
  for (Vector<double> *vector : {&cell_pressure, &cell_pressure_rate, &cell_volume})
    vector->reinit(n_pressure);
  functions.gradients.resize(cells.n_functions());
  functions.pressure_gradients.resize(n_pressure);
  along.resize(cells.n_functions());
  for (std::vector<double> *derivatives : {&traces, &sources})
    derivatives->resize(n_velocity);
  for (std::vector<double> *derivatives : {&pressure_sources, &densities})
    derivatives->resize(n_pressure);
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
  follower_pressure.reinit();
  moved_points.resize(quadrature.size());
}

template <int dim>
void ConvectiveTerms<dim>::make_product()
{
  typename Product::Input input(space.mapping, space.velocity_dofs, space.velocity_hanging);
  input.is_axisymmetric = space.is_axisymmetric();
  input.is_skew = problem.convection.term == ConvectiveTerm::skew;
  input.constant_viscosity = problem.convection.constant_viscosity();
  has_compressible_liquid = false;
  for (unsigned int region = 0; region < problem.materials.size(); ++region)
  {
    const Material &of_region = problem.materials[region];
    typename Product::Liquid liquid;
    liquid.density = of_region.density;
    liquid.viscosity = of_region.shear.viscosity;
    liquid.volume_law = of_region.volume_law();
    liquid.flow_curve = of_region.shear.flow_curve;
    input.liquids.push_back(liquid);
    if (Base::are_of(region) && !of_region.is_incompressible())
      has_compressible_liquid = true;
  }
  const unsigned int n_cells = space.triangulation.n_active_cells();
  input.has_cell.resize(n_cells);
  input.viscosity_over_speed.resize(n_cells);
  input.pressure_places.resize(std::size_t(n_cells) * Product::n_pressures);
  some_cells_have_matrices = false;
  for (const Cell &cell : cells.all())
    if (inflow_terms.has_face(cell.pressure_cell))
      some_cells_have_matrices = true;
    else
    {
      const unsigned int index = cell.velocity_cell->active_cell_index();
      input.has_cell[index] = true;
      input.viscosity_over_speed[index] = problem.convection.viscosity_over_speed(
          problem.materials[cell.region].density, cell.size);
      std::copy(cell.pressure_places.begin(), cell.pressure_places.end(),
                input.pressure_places.begin() + std::size_t(index) * Product::n_pressures);
    }
  some_cells_have_matrices =
      Utilities::MPI::max(some_cells_have_matrices ? 1 : 0, space.communicator) > 0;
  product = make_matrix_free_convection<dim>(*instruction_set, input);
  of_product.volume.assign(input.pressure_places.size(), 0.);
  for (typename Product::Vector *const vector :
       {&of_product.state.velocity, &of_product.state.acceleration, &of_product.velocity,
        &of_product.momentum})
    product->initialise(*vector);
}

template <int dim>
void ConvectiveTerms<dim>::forget_derivative()
{
  product = nullptr;
  Base::forget_derivative();
}

template <int dim>
void ConvectiveTerms<dim>::keep_derivative(const BalancedStep &state, const KeptDerivative form)
{
  if (form == KeptDerivative::matrices || !instruction_set || streamline_terms.are_on())
    product = nullptr;
  else if (product == nullptr)
    make_product();
  Base::keep_derivative(state, form);
  if (product == nullptr)
    return;
  typename Product::State &kept = of_product.state;
  std::copy(state.velocity.begin(), state.velocity.end(), kept.velocity.begin());
  kept.velocity.update_ghost_values();
  if (has_compressible_liquid)
  {
    std::copy(state.acceleration.begin(), state.acceleration.end(), kept.acceleration.begin());
    kept.acceleration.update_ghost_values();
    // With the ghost entries, which end() leaves out.
    const unsigned int n_entries = pressure.trilinos_vector().MyLength();
    kept.pressure.assign(pressure.begin(), pressure.begin() + n_entries);
    kept.pressure_rate.assign(pressure_rate.begin(), pressure_rate.begin() + n_entries);
  }
  kept.acceleration_by_velocity = step.a0;
  kept.pressure_rate_by_pressure = 1. / step.pressure_time;
  product->set(&kept);
}

template <int dim>
void ConvectiveTerms<dim>::add_derivative_product(const DistributedVector &of_velocity,
                                                  const DistributedVector &of_pressure,
                                                  DistributedVector &momentum,
                                                  DistributedVector &volume)
{
  if (product == nullptr || some_cells_have_matrices)
    Base::add_derivative_product(of_velocity, of_pressure, momentum, volume);
  else
    space.copy_pressure(of_pressure, pressure_work, pressure);
  if (product == nullptr)
    return;
  std::copy(of_velocity.begin(), of_velocity.end(), of_product.velocity.begin());
  product->multiply(of_product.momentum, of_product.volume, of_product.velocity, pressure.begin());
  for (unsigned int i = 0; i < momentum.locally_owned_size(); ++i)
    momentum.begin()[i] += of_product.momentum.local_element(i);
  for (const Cell &cell : cells.all())
    if (!needs_matrix(cell))
    {
      const double *const rows =
          &of_product
               .volume[std::size_t(cell.velocity_cell->active_cell_index()) * Product::n_pressures];
      std::copy(rows, rows + Product::n_pressures, cell_volume.begin());
      space.pressure_hanging.distribute_local_to_global(cell_volume, cell.pressure_indices, volume);
    }
  volume.compress(VectorOperation::add);
}

template <int dim>
std::vector<double> ConvectiveTerms<dim>::grad_div_viscosities(const BalancedStep &state)
{
  if (problem.convection.stabilisation == ConvectionStabilisation::none)
    return {};
  take(state);
  std::vector<double> result(space.triangulation.n_active_cells(), 0.);
  const unsigned int n_functions = cells.n_functions();
  for (const Cell &cell : cells.all())
  {
    visit(cell);
    double integral = 0., volume = 0.;
    for (unsigned int q = 0; q < cells.n_points(); ++q)
    {
      Tensor<1, dim> here;
      for (unsigned int c = 0; c < dim; ++c)
        for (unsigned int a = 0; a < n_functions; ++a)
          here[c] += cell_velocity[c * n_functions + a] * cells.values(q)[a];
      integral += cell.points[q].weight * viscosity_over_speed() * here.norm();
      volume += cell.points[q].weight;
    }
    result[cell.velocity_cell->active_cell_index()] =
        problem.convection.constant_viscosity() + integral / volume;
  }
  return result;
}

template <int dim>
void ConvectiveTerms<dim>::take(const BalancedStep &state)
{
  step = state.step;
  take(state.velocity, state.pressure);
  space.copy_velocity(state.acceleration, velocity_work, acceleration);
  space.copy_pressure(state.pressure_rate, pressure_work, pressure_rate);
  if (!problem.mesh_moves)
    return;
  space.copy_velocity(state.mesh_displacement, velocity_work, mesh_displacement);
  space.copy_velocity(state.mesh_velocity, velocity_work, mesh_velocity);
  follower_pressure.set_cavity_pressures(state.cavity_pressures);
}

template <int dim>
void ConvectiveTerms<dim>::visit(const Cell &cell)
{
  present = &cell;
  Base::set_entries(cell.velocity_places, velocity, cell_velocity);
  Base::set_entries(cell.velocity_places, acceleration, cell_acceleration);
  Base::set_entries(cell.pressure_places, pressure, cell_pressure);
  Base::set_entries(cell.pressure_places, pressure_rate, cell_pressure_rate);
  if (!problem.mesh_moves)
    return;
  Base::set_entries(cell.velocity_places, mesh_displacement, cell_mesh_displacement);
  Base::set_entries(cell.velocity_places, mesh_velocity, cell_mesh_velocity);
  move_points();
}

template <int dim>
void ConvectiveTerms<dim>::move_points()
{
  const std::size_t n_functions = cells.n_functions();
  for (unsigned int q = 0; q < moved_points.size(); ++q)
  {
    const typename Cell::Point &at_rest = present->points[q];
    Tensor<2, dim> gradient;
    double radial = 0.;
    for (unsigned int c = 0; c < dim; ++c)
    {
      const double *const entries = cell_mesh_displacement.begin() + c * n_functions;
      Tensor<1, dim> slope; // on the reference cell
      for (unsigned int a = 0; a < n_functions; ++a)
        slope += entries[a] * cells.gradients(q)[a];
      gradient[c] = slope * at_rest.inverse_jacobian;
      gradient[c][c] += 1.;
      for (unsigned int a = 0; c == 1 && a < n_functions; ++a)
        radial += entries[a] * cells.values(q)[a];
    }
    const double stretch = 1. + radial * at_rest.hoop;
    moved_points[q].weight = at_rest.weight * determinant(gradient) * stretch;
    moved_points[q].hoop = at_rest.hoop / stretch;
    moved_points[q].inverse_jacobian = at_rest.inverse_jacobian * invert(gradient);
  }
}

template <int dim>
double ConvectiveTerms<dim>::viscosity_over_speed() const
{
  return problem.convection.viscosity_over_speed(material().density, present->size);
}

template <int dim>
typename ConvectiveTerms<dim>::Point ConvectiveTerms<dim>::point(const unsigned int q) const
{
  const typename Cell::Point &geometry = geometry_at(q);
  const std::size_t n_functions = cells.n_functions();
  const double *const values = cells.values(q), *const pressure_values = cells.pressure_values(q);
  const Tensor<1, dim> *const gradients = cells.gradients(q), *const pressure_gradients =
                                                                  cells.pressure_gradients(q);
  Point point;
  point.weight = geometry.weight;
  point.hoop = geometry.hoop;
  for (unsigned int c = 0; c < dim; ++c)
  {
    const double *const velocities = cell_velocity.begin() + c * n_functions,
                        *const accelerations = cell_acceleration.begin() + c * n_functions;
    double of_velocity = 0., of_acceleration = 0.;
    Tensor<1, dim> slope; // on the reference cell
    for (unsigned int a = 0; a < n_functions; ++a)
    {
      of_velocity += velocities[a] * values[a];
      of_acceleration += accelerations[a] * values[a];
      slope += velocities[a] * gradients[a];
    }
    point.velocity[c] = of_velocity;
    point.acceleration[c] = of_acceleration;
    point.velocity_gradient[c] = slope * geometry.inverse_jacobian;
    point.carrier[c] = carries * of_velocity;
    for (unsigned int a = 0; problem.mesh_moves && a < n_functions; ++a)
      point.carrier[c] -= cell_mesh_velocity[c * n_functions + a] * values[a];
  }
  point.divergence = trace(point.velocity_gradient) + point.hoop * point.velocity[1];
  Tensor<1, dim> slope;
  for (unsigned int k = 0; k < cells.n_pressures(); ++k)
  {
    point.pressure += cell_pressure[k] * pressure_values[k];
    point.pressure_rate += cell_pressure_rate[k] * pressure_values[k];
    slope += cell_pressure[k] * pressure_gradients[k];
  }
  point.pressure_gradient = slope * geometry.inverse_jacobian;
  set_strain_rate(point);
  return point;
}

template <int dim>
void ConvectiveTerms<dim>::set_strain_rate(Point &point) const
{
  const double mean = point.divergence / 3.;
  for (unsigned int c = 0; c < dim; ++c)
    for (unsigned int d = 0; d < dim; ++d)
      point.strain_rate[c][d] =
          0.5 * (point.velocity_gradient[c][d] + point.velocity_gradient[d][c]) -
          (c == d ? mean : 0.);
  if (dim == 2)
    point.across = point.velocity[1] * point.hoop - mean;
  point.shear_rate =
      std::sqrt(2. * (point.strain_rate.norm_square() + point.across * point.across));
}

template <int dim>
void ConvectiveTerms<dim>::set_functions(const unsigned int q)
{
  const typename Cell::Point &geometry = geometry_at(q);
  const std::size_t n_functions = cells.n_functions();
  functions.values = cells.values(q);
  functions.pressure_values = cells.pressure_values(q);
  for (unsigned int a = 0; a < n_functions; ++a)
    functions.gradients[a] = cells.gradients(q)[a] * geometry.inverse_jacobian;
  for (unsigned int k = 0; k < cells.n_pressures(); ++k)
    functions.pressure_gradients[k] = cells.pressure_gradients(q)[k] * geometry.inverse_jacobian;
  for (unsigned int c = 0; c < dim; ++c)
    for (unsigned int a = 0; a < n_functions; ++a)
      traces[c * n_functions + a] =
          functions.gradients[a][c] + (c == 1 ? geometry.hoop * functions.values[a] : 0.);
}

template <int dim>
double ConvectiveTerms<dim>::shear(const Point &point,
                                   const unsigned int component,
                                   const unsigned int function) const
{
  double sum = point.strain_rate[component] * functions.gradients[function];
  if (component == 1)
    sum += point.across * point.hoop * functions.values[function];
  return sum;
}

template <int dim>
double ConvectiveTerms<dim>::viscosity_at(const Point &here) const
{
  const Shear &shear = material().shear;
  return shear.flow_curve ? shear.flow_curve->viscosity(here.shear_rate) : shear.viscosity;
}

template <int dim>
typename ConvectiveTerms<dim>::Tested ConvectiveTerms<dim>::viscous(const Point &here) const
{
  const double factor = 2. * here.weight * viscosity_at(here);
  Tested tested;
  tested.by_gradient = factor * here.strain_rate;
  tested.by_value[1] = factor * here.across * here.hoop;
  return tested;
}

template <int dim>
void ConvectiveTerms<dim>::add_derivative_of_viscosity(const Point &here,
                                                       FullMatrix<double> &matrix) const
{
  const std::optional<FlowCurve> &curve = material().shear.flow_curve;
  const double factor = 2. * here.weight * viscosity_at(here),
               slope = curve ? 4. * here.weight * curve->slope_over_rate(here.shear_rate) : 0.;
  const std::size_t n_functions = cells.n_functions();
  for (unsigned int c = 0; c < dim; ++c)
    for (unsigned int a = 0; a < n_functions; ++a)
    {
      const unsigned int i = c * n_functions + a;
      const Tensor<1, dim> &test = functions.gradients[a];
      const double sheared = curve ? slope * shear(here, c, a) : 0.;
      for (unsigned int d = 0; d < dim; ++d)
        for (unsigned int b = 0; b < n_functions; ++b)
        {
          const unsigned int j = d * n_functions + b;
          const Tensor<1, dim> &trial = functions.gradients[b];
          double same = 0.5 * ((c == d ? test * trial : 0.) + test[d] * trial[c]) -
                        traces[i] * traces[j] / 3.;
          if (c == 1 && d == 1)
            same += here.hoop * here.hoop * functions.values[a] * functions.values[b];
          matrix(i, j) += factor * same + (curve ? sheared * shear(here, d, b) : 0.);
        }
    }
}

template <int dim>
void ConvectiveTerms<dim>::add_tested(const Tested &tested,
                                      const unsigned int q,
                                      Vector<double> &rows) const
{
  const std::size_t n_functions = cells.n_functions();
  const double *const values = cells.values(q);
  const Tensor<1, dim> *const gradients = cells.gradients(q);
  for (unsigned int c = 0; c < dim; ++c)
  {
    const double by_value = tested.by_value[c];
    // By the gradient on the reference cell.
    const Tensor<1, dim> by_gradient = geometry_at(q).inverse_jacobian * tested.by_gradient[c];
    double *const of_component = rows.begin() + c * n_functions;
    for (unsigned int a = 0; a < n_functions; ++a)
      of_component[a] += by_value * values[a] + by_gradient * gradients[a];
  }
}

template <int dim>
double ConvectiveTerms<dim>::integrate(const bool by_kind)
{
  const Material &liquid = material();
  const VolumeLaw law = liquid.volume_law();
  const bool is_skew = carries > 0. && problem.convection.term == ConvectiveTerm::skew;
  const double constant_gamma = problem.convection.constant_viscosity(),
               gamma_over_speed = viscosity_over_speed();
  if (streamline_terms.are_on())
    streamline_terms.visit(present->velocity_cell, step);
  double least_stiffening = 1.;
  for (Vector<double> &forces : cell_forces)
    forces = 0.;
  cell_inflow = 0.;
  cell_volume = 0.;
  for (unsigned int q = 0; q < cells.n_points(); ++q)
  {
    const Point here = point(q);
    least_stiffening = std::min(least_stiffening, law.stiffening(here.pressure));
    const double density = liquid.density * law.density_ratio(here.pressure);
    const double source = law.compressibility(here.pressure) *
                              (here.pressure_rate + here.carrier * here.pressure_gradient) +
                          here.divergence;
    std::array<Tested, n_kinds> tested;
    tested[inertia].by_value = here.weight * density * here.acceleration;
    tested[convection].by_value =
        here.weight * density *
        (here.velocity_gradient * here.carrier + (is_skew ? 0.5 * source : 0.) * here.velocity);
    const double gamma = constant_gamma + gamma_over_speed * here.velocity.norm();
    const double second_pressure = here.weight * gamma * source;
    for (unsigned int c = 0; c < dim; ++c)
    {
      tested[stabilisation].by_gradient[c][c] = second_pressure;
      tested[compression].by_gradient[c][c] = -here.weight * here.pressure;
    }
    tested[stabilisation].by_value[1] = second_pressure * here.hoop;
    tested[compression].by_value[1] = -here.weight * here.pressure * here.hoop;
    if (streamline_terms.are_on())
      tested[stabilisation].by_gradient +=
          outer_product(streamline_terms.force(here, q, cell_state()), here.carrier);
    tested[viscosity] = viscous(here);
    if (by_kind)
      for (unsigned int kind = 0; kind < n_kinds; ++kind)
        add_tested(tested[kind], q, cell_forces[kind]);
    else
    {
      Tested sum;
      for (const Tested &part : tested)
      {
        sum.by_value += part.by_value;
        sum.by_gradient += part.by_gradient;
      }
      add_tested(sum, q, cell_forces[0]);
    }
    for (unsigned int k = 0; k < cells.n_pressures(); ++k)
      cell_volume[k] += here.weight * source * cells.pressure_values(q)[k];
  }
  if (inflow_terms.has_face(present->pressure_cell))
    inflow_terms.add(present->pressure_cell, cell_state(), cell_inflow);
  return least_stiffening;
}

template <int dim>
void ConvectiveTerms<dim>::add(const BalancedStep &state,
                               DistributedVector &momentum,
                               DistributedVector &volume)
{
  take(state);
  double least_stiffening = 1.;
  unsigned int softest = 0;
  for (const Cell &cell : cells.all())
  {
    visit(cell);
    const double stiffening = integrate(false);
    if (!(stiffening >= least_stiffening))
    {
      least_stiffening = stiffening;
      softest = cell.region;
    }
    Vector<double> &sum = cell_forces[0];
    sum += cell_inflow;
    if (has_load_changes(cell))
    {
      set_load_changes(cell);
      sum -= cell_inflow;
    }
    space.velocity_hanging.distribute_local_to_global(sum, cell.velocity_indices, momentum);
    space.pressure_hanging.distribute_local_to_global(cell_volume, cell.pressure_indices, volume);
  }
  momentum.compress(VectorOperation::add);
  volume.compress(VectorOperation::add);
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
void ConvectiveTerms<dim>::set_forces_of(const unsigned int region,
                                         const BalancedStep &state,
                                         NonlinearForces &forces)
{
  const std::array<std::pair<const Vector<double> *, DistributedVector *>, 6> parts = {
      {{&cell_forces[inertia], &forces.inertia},
       {&cell_forces[convection], &forces.convection},
       {&cell_forces[stabilisation], &forces.stabilisation},
       {&cell_forces[viscosity], &forces.viscosity},
       {&cell_forces[compression], &forces.compression},
       {&cell_inflow, &forces.inflow}}};
  for (const auto &part : parts)
    *part.second = 0.;
  take(state);
  for (const Cell &cell : cells.all())
    if (cell.region == region)
    {
      visit(cell);
      integrate(true);
      for (const auto &part : parts)
        space.velocity_hanging.distribute_local_to_global(*part.first, cell.velocity_indices,
                                                          *part.second);
    }
  for (const auto &part : parts)
    part.second->compress(VectorOperation::add);
}

template <int dim>
bool ConvectiveTerms<dim>::has_load_changes(const Cell &cell) const
{
  return problem.mesh_moves &&
         (body_force.has_changes(cell.region) || follower_pressure.has_face(cell.velocity_cell));
}

template <int dim>
void ConvectiveTerms<dim>::set_load_changes(const Cell &cell)
{
  cell_inflow = 0.;
  if (follower_pressure.has_face(cell.velocity_cell))
    follower_pressure.add(cell.velocity_cell, step, cell_mesh_displacement, cell_inflow);
  if (body_force.has_changes(cell.region))
    body_force.add(cells, cell, moved_points, step, cell_mesh_displacement, cell_inflow);
}

template <int dim>
void ConvectiveTerms<dim>::add_loads(const BalancedStep &state,
                                     const std::optional<unsigned int> region,
                                     DistributedVector &forces)
{
  if (!problem.mesh_moves)
    return;
  take(state);
  for (const Cell &cell : cells.all())
    if ((!region || cell.region == *region) && has_load_changes(cell))
    {
      visit(cell);
      set_load_changes(cell);
      space.velocity_hanging.distribute_local_to_global(cell_inflow, cell.velocity_indices, forces);
    }
  forces.compress(VectorOperation::add);
}

template <int dim>
NonlinearEnergy ConvectiveTerms<dim>::energy_of(const unsigned int region, const State &state)
{
  NonlinearEnergy energy;
  const double density = problem.materials[region].density;
  const VolumeLaw law = problem.materials[region].volume_law();
  take(state.velocity, state.pressure);
  if (problem.mesh_moves)
    space.copy_velocity(*state.mesh_displacement, velocity_work, mesh_displacement);
  for (const Cell &cell : cells.all())
    if (cell.region == region)
    {
      visit(cell);
      for (unsigned int q = 0; q < cells.n_points(); ++q)
      {
        const Point here = point(q);
        energy.kinetic += here.weight * 0.5 * density * law.density_ratio(here.pressure) *
                          here.velocity.norm_square();
        energy.compressive += here.weight * law.energy(here.pressure);
      }
    }
  return energy;
}

template <int dim>
void ConvectiveTerms<dim>::integrate_derivative(FullMatrix<double> &matrix)
{
  const Material &liquid = material();
  const VolumeLaw law = liquid.volume_law();
  const double skew = carries > 0. && problem.convection.term == ConvectiveTerm::skew ? 0.5 : 0.;
  const double constant_gamma = problem.convection.constant_viscosity(),
               gamma_over_speed = viscosity_over_speed();
  if (streamline_terms.are_on())
    streamline_terms.visit(present->velocity_cell, step);
  const double rate_by_pressure = 1. / step.pressure_time;
  const std::size_t n_functions = cells.n_functions(), n_velocity = dim * n_functions,
                    n_pressure = cells.n_pressures();
  matrix.reinit(n_velocity + n_pressure, n_velocity + n_pressure);
  for (unsigned int q = 0; q < cells.n_points(); ++q)
  {
    const Point here = point(q);
    set_functions(q);
    const double *const values = functions.values;
    const double density = liquid.density * law.density_ratio(here.pressure);
    const double compressibility = law.compressibility(here.pressure);
    const double slope = law.compressibility_slope(here.pressure);
    const double motion = here.pressure_rate + here.carrier * here.pressure_gradient;
    const double source = compressibility * motion + here.divergence;
    const Tensor<1, dim> inertial = here.acceleration + here.velocity_gradient * here.carrier;
    const double speed = here.velocity.norm();
    const double gamma = constant_gamma + gamma_over_speed * speed;
    // Of gamma times the source by the velocity; at rest the speed has no derivative.
    const Tensor<1, dim> gamma_slope =
        speed > 0. ? gamma_over_speed / speed * source * here.velocity : Tensor<1, dim>();
    for (unsigned int b = 0; b < n_functions; ++b)
      along[b] = here.carrier * functions.gradients[b];
    for (unsigned int d = 0; d < dim; ++d)
      for (unsigned int b = 0; b < n_functions; ++b)
        sources[d * n_functions + b] =
            carries * compressibility * here.pressure_gradient[d] * values[b] +
            traces[d * n_functions + b];
    for (unsigned int l = 0; l < n_pressure; ++l)
    {
      const double shape = functions.pressure_values[l];
      const double moved =
          rate_by_pressure * shape + here.carrier * functions.pressure_gradients[l];
      pressure_sources[l] = slope * shape * motion + compressibility * moved;
      densities[l] = density * compressibility * shape;
    }
    // Of the acceleration and of the velocity that the flow carries along, by that velocity.
    const double carried = density * step.a0 + skew * density * source;
    for (unsigned int c = 0; c < dim; ++c)
      for (unsigned int a = 0; a < n_functions; ++a)
      {
        const unsigned int i = c * n_functions + a;
        const double test = here.weight * values[a];
        const double by_trace = here.weight * traces[i];
        const double by_source = test * skew * density * here.velocity[c] + gamma * by_trace;
        for (unsigned int d = 0; d < dim; ++d)
        {
          double *const row = &matrix(i, d * n_functions);
          const double *const of_source = &sources[d * n_functions];
          const double by_value = carries * test * density * here.velocity_gradient[c][d] +
                                  by_trace * gamma_slope[d] + (c == d ? test * carried : 0.);
          for (unsigned int b = 0; b < n_functions; ++b)
            row[b] += by_value * values[b] + by_source * of_source[b];
          if (c == d)
            for (unsigned int b = 0; b < n_functions; ++b)
              row[b] += test * density * along[b];
        }
        const double by_density = test * (inertial[c] + skew * source * here.velocity[c]);
        for (unsigned int l = 0; l < n_pressure; ++l)
          matrix(i, n_velocity + l) += by_density * densities[l] + by_source * pressure_sources[l] -
                                       by_trace * functions.pressure_values[l];
      }
    if (streamline_terms.are_on())
      streamline_terms.add_derivative(here, functions, q, cell_state(), matrix);
    if (liquid.shear.viscosity > 0.)
      add_derivative_of_viscosity(here, matrix);
    for (unsigned int k = 0; k < n_pressure; ++k)
    {
      const double test = -here.weight * functions.pressure_values[k];
      for (unsigned int j = 0; j < n_velocity; ++j)
        matrix(n_velocity + k, j) += test * sources[j];
      for (unsigned int l = 0; l < n_pressure; ++l)
        matrix(n_velocity + k, n_velocity + l) += test * pressure_sources[l];
    }
  }
}

template <int dim>
void ConvectiveTerms<dim>::set_derivative(const Cell &cell, FullMatrix<double> &matrix)
{
  visit(cell);
  integrate_derivative(matrix);
  if (inflow_terms.has_face(cell.pressure_cell))
    inflow_terms.add_derivative(cell.pressure_cell, cell_state(), matrix);
}

template class ConvectiveTerms<2>;
template class ConvectiveTerms<3>;
} // namespace Continua
