#include <continua/finite_element/convective_terms.h>

#include <continua/base/input_error.h>
#include <continua/mesh/cells_in_tree_order.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <utility>

namespace Continua
{
using namespace dealii;

namespace
{
/// The unknowns that an unknown of a cell stands for, with their weights.
using Masters = std::vector<std::pair<int, double>>;

void set_masters(const AffineConstraints<double> &constraints,
                 const types::global_dof_index index,
                 const int first,
                 Masters &masters)
{
  masters.clear();
  if (!constraints.is_constrained(index))
    masters.emplace_back(first + static_cast<int>(index), 1.);
  else
    for (const auto &entry : *constraints.get_constraint_entries(index))
      masters.emplace_back(first + static_cast<int>(entry.first), entry.second);
}
} // namespace

template <int dim>
ConvectiveTerms<dim>::ConvectiveTerms(const Space<dim> &space, const Problem &problem)
    : space(space),
      problem(problem),
      scalar_element(space.degree()),
      // One point more than the linear terms: products of three functions are integrated exactly on
      // parallelograms, where density and compressibility are constant.
      quadrature(space.n_quadrature_points() + 1),
      values(space.mapping,
             scalar_element,
             quadrature,
             update_values | update_gradients | update_quadrature_points | update_JxW_values),
      hp_pressure_values(space.mappings,
                         space.pressure_elements,
                         hp::QCollection<dim>(quadrature),
                         update_values | update_gradients),
      inflow_terms(space, problem),
      streamline_terms(space, problem, quadrature)
{
  const unsigned int n_velocity = space.velocity_element.n_dofs_per_cell();
  for (auto &indices : place)
    indices.resize(scalar_element.n_dofs_per_cell());
  for (unsigned int i = 0; i < n_velocity; ++i)
  {
    const auto component = space.velocity_element.system_to_component_index(i);
    place[component.first][component.second] = i;
  }
  velocity_indices.resize(n_velocity);
  for (Vector<double> *vector :
       {&cell_velocity, &cell_acceleration, &cell_inertia, &cell_convection, &cell_stabilisation,
        &cell_viscosity, &cell_inflow})
    vector->reinit(n_velocity);
}

template <int dim>
void ConvectiveTerms<dim>::reinit()
{
  for (DistributedVector *vector : {&velocity, &acceleration})
    vector->reinit(space.velocity_owned, space.velocity_relevant, space.communicator);
  for (DistributedVector *vector : {&pressure, &pressure_rate})
    vector->reinit(space.pressure_owned, space.pressure_relevant, space.communicator);
  velocity_work = space.velocity_vector();
  pressure_work = space.pressure_vector();
  cell_derivatives.clear();
  cells.clear();
  for (const auto &cell : cells_in_tree_order(space.velocity_dofs))
    if (cell->is_locally_owned() && has_terms(cell->material_id()))
      cells.push_back(cell);
}

template <int dim>
bool ConvectiveTerms<dim>::has_terms(const unsigned int of_region) const
{
  return problem.materials[of_region].phase() < 1.;
}

template <int dim>
void ConvectiveTerms<dim>::take(const DistributedVector &of_velocity,
                                const DistributedVector &of_pressure)
{
  space.copy_velocity(of_velocity, velocity_work, velocity);
  space.copy_pressure(of_pressure, pressure_work, pressure);
}

template <int dim>
void ConvectiveTerms<dim>::take(const BalancedStep &state)
{
  step = state.step;
  take(state.velocity, state.pressure);
  space.copy_velocity(state.acceleration, velocity_work, acceleration);
  space.copy_pressure(state.pressure_rate, pressure_work, pressure_rate);
}

template <int dim>
void ConvectiveTerms<dim>::visit_indices(const typename DoFHandler<dim>::active_cell_iterator &cell)
{
  present_cell = cell;
  region = cell->material_id();
  const typename DoFHandler<dim>::active_cell_iterator pressure_cell = present_pressure_cell();
  pressure_indices.resize(pressure_cell->get_fe().n_dofs_per_cell());
  cell->get_dof_indices(velocity_indices);
  pressure_cell->get_dof_indices(pressure_indices);
}

template <int dim>
void ConvectiveTerms<dim>::visit(const typename DoFHandler<dim>::active_cell_iterator &cell)
{
  visit_indices(cell);
  values.reinit(static_cast<typename Triangulation<dim>::active_cell_iterator>(cell));
  hp_pressure_values.reinit(present_pressure_cell());
  pressure_values = &hp_pressure_values.get_present_fe_values();
  const unsigned int n_pressure = pressure_indices.size();
  for (Vector<double> *vector : {&cell_pressure, &cell_pressure_rate, &cell_volume})
    vector->reinit(n_pressure);
  for (unsigned int i = 0; i < velocity_indices.size(); ++i)
  {
    cell_velocity[i] = velocity(velocity_indices[i]);
    cell_acceleration[i] = acceleration(velocity_indices[i]);
  }
  for (unsigned int k = 0; k < n_pressure; ++k)
  {
    cell_pressure[k] = pressure(pressure_indices[k]);
    cell_pressure_rate[k] = pressure_rate(pressure_indices[k]);
  }
}

template <int dim>
typename DoFHandler<dim>::active_cell_iterator ConvectiveTerms<dim>::present_pressure_cell() const
{
  return {&space.triangulation, present_cell->level(), present_cell->index(), &space.pressure_dofs};
}

template <int dim>
double ConvectiveTerms<dim>::viscosity_over_speed() const
{
  return problem.convection.viscosity_over_speed(
      problem.materials[region].density,
      Convection::cell_size<dim>(present_cell->diameter(), space.degree()));
}

template <int dim>
double ConvectiveTerms<dim>::trace(const unsigned int component,
                                   const unsigned int function,
                                   const unsigned int q) const
{
  double sum = values.shape_grad(function, q)[component];
  if (space.is_axisymmetric() && component == 1)
    sum += values.shape_value(function, q) / values.quadrature_point(q)[1];
  return sum;
}

template <int dim>
typename ConvectiveTerms<dim>::Point ConvectiveTerms<dim>::point(const unsigned int q) const
{
  Point point;
  point.weight = (1. - problem.materials[region].phase()) * values.JxW(q) *
                 space.measure(values.quadrature_point(q));
  for (unsigned int c = 0; c < dim; ++c)
    for (unsigned int a = 0; a < place[c].size(); ++a)
    {
      const unsigned int i = place[c][a];
      point.velocity[c] += cell_velocity[i] * values.shape_value(a, q);
      point.acceleration[c] += cell_acceleration[i] * values.shape_value(a, q);
      point.velocity_gradient[c] += cell_velocity[i] * values.shape_grad(a, q);
      point.divergence += cell_velocity[i] * trace(c, a, q);
    }
  for (unsigned int k = 0; k < cell_pressure.size(); ++k)
  {
    point.pressure += cell_pressure[k] * pressure_values->shape_value(k, q);
    point.pressure_rate += cell_pressure_rate[k] * pressure_values->shape_value(k, q);
    point.pressure_gradient += cell_pressure[k] * pressure_values->shape_grad(k, q);
  }
  if (problem.materials[region].shear.flow_curve)
    set_strain_rate(point, q);
  return point;
}

template <int dim>
void ConvectiveTerms<dim>::set_strain_rate(Point &point, const unsigned int q) const
{
  const double mean = point.divergence / 3.;
  for (unsigned int c = 0; c < dim; ++c)
    for (unsigned int d = 0; d < dim; ++d)
      point.strain_rate[c][d] =
          0.5 * (point.velocity_gradient[c][d] + point.velocity_gradient[d][c]) -
          (c == d ? mean : 0.);
  if (space.is_axisymmetric())
    point.hoop = 1. / values.quadrature_point(q)[1];
  if (dim == 2)
    point.across = point.velocity[1] * point.hoop - mean;
  point.shear_rate =
      std::sqrt(2. * (point.strain_rate.norm_square() + point.across * point.across));
}

template <int dim>
double ConvectiveTerms<dim>::shear(const Point &point,
                                   const unsigned int component,
                                   const unsigned int function,
                                   const unsigned int q) const
{
  double sum = point.strain_rate[component] * values.shape_grad(function, q);
  if (component == 1)
    sum += point.across * point.hoop * values.shape_value(function, q);
  return sum;
}

template <int dim>
void ConvectiveTerms<dim>::integrate_viscosity(const Point &here, const unsigned int q)
{
  const FlowCurve &curve = *problem.materials[region].shear.flow_curve;
  const double factor =
      2. * here.weight * (curve.viscosity(here.shear_rate) - curve.zero_rate_viscosity);
  for (unsigned int c = 0; c < dim; ++c)
    for (unsigned int a = 0; a < place[c].size(); ++a)
      cell_viscosity[place[c][a]] += factor * shear(here, c, a, q);
}

template <int dim>
void ConvectiveTerms<dim>::add_derivative_of_viscosity(const Point &here,
                                                       const unsigned int q,
                                                       FullMatrix<double> &matrix)
{
  const FlowCurve &curve = *problem.materials[region].shear.flow_curve;
  const double excess =
      2. * here.weight * (curve.viscosity(here.shear_rate) - curve.zero_rate_viscosity);
  const double slope = 4. * here.weight * curve.slope_over_rate(here.shear_rate);
  for (unsigned int c = 0; c < dim; ++c)
    for (unsigned int a = 0; a < place[c].size(); ++a)
    {
      const Tensor<1, dim> test = values.shape_grad(a, q);
      const double sheared = slope * shear(here, c, a, q);
      for (unsigned int d = 0; d < dim; ++d)
        for (unsigned int b = 0; b < place[d].size(); ++b)
        {
          const Tensor<1, dim> trial = values.shape_grad(b, q);
          double same = 0.5 * ((c == d ? test * trial : 0.) + test[d] * trial[c]) -
                        trace(c, a, q) * trace(d, b, q) / 3.;
          if (c == 1 && d == 1)
            same += here.hoop * here.hoop * values.shape_value(a, q) * values.shape_value(b, q);
          matrix(place[c][a], place[d][b]) += excess * same + sheared * shear(here, d, b, q);
        }
    }
}

template <int dim>
double ConvectiveTerms<dim>::integrate()
{
  const Material &material = problem.materials[region];
  const VolumeLaw law = material.volume_law();
  const bool is_skew = problem.convection.term == ConvectiveTerm::skew;
  const double constant_gamma = problem.convection.constant_viscosity(),
               gamma_over_speed = viscosity_over_speed();
  if (streamline_terms.are_on())
    streamline_terms.visit(present_cell, step);
  double least_stiffening = 1.;
  for (Vector<double> *vector : {&cell_inertia, &cell_convection, &cell_stabilisation,
                                 &cell_viscosity, &cell_inflow, &cell_volume})
    *vector = 0.;
  for (unsigned int q = 0; q < quadrature.size(); ++q)
  {
    const Point here = point(q);
    least_stiffening = std::min(least_stiffening, law.stiffening(here.pressure));
    const double density = material.density * law.density_ratio(here.pressure);
    const double compressibility = law.compressibility(here.pressure);
    const double compression =
        compressibility * (here.pressure_rate + here.velocity * here.pressure_gradient);
    const double source = compression + here.divergence;
    const Tensor<1, dim> inertia = here.weight * (density - material.density) * here.acceleration;
    Tensor<1, dim> convective = density * (here.velocity_gradient * here.velocity);
    if (is_skew)
      convective += 0.5 * density * source * here.velocity;
    convective *= here.weight;
    const double gamma = constant_gamma + gamma_over_speed * here.velocity.norm();
    const double second_pressure = here.weight * gamma * source;
    for (unsigned int c = 0; c < dim; ++c)
      for (unsigned int a = 0; a < place[c].size(); ++a)
      {
        const unsigned int i = place[c][a];
        cell_inertia[i] += inertia[c] * values.shape_value(a, q);
        cell_convection[i] += convective[c] * values.shape_value(a, q);
        cell_stabilisation[i] += second_pressure * trace(c, a, q);
      }
    if (streamline_terms.are_on())
      streamline_terms.add(here, q, cell_state(), cell_stabilisation);
    if (material.shear.flow_curve)
      integrate_viscosity(here, q);
    const double rate = compression - law.inverse_bulk_modulus * here.pressure_rate;
    for (unsigned int k = 0; k < cell_volume.size(); ++k)
      cell_volume[k] += here.weight * rate * pressure_values->shape_value(k, q);
  }
  if (const auto cell = present_pressure_cell(); inflow_terms.has_face(cell))
    inflow_terms.add(cell, cell_state(), cell_inflow);
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
  for (const auto &cell : cells)
  {
    visit(cell);
    const double stiffening = integrate();
    if (!(stiffening >= least_stiffening))
    {
      least_stiffening = stiffening;
      softest = region;
    }
    for (const Vector<double> *part :
         {&cell_convection, &cell_stabilisation, &cell_viscosity, &cell_inflow})
      cell_inertia += *part;
    space.velocity_hanging.distribute_local_to_global(cell_inertia, velocity_indices, momentum);
    space.pressure_hanging.distribute_local_to_global(cell_volume, pressure_indices, volume);
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
void ConvectiveTerms<dim>::set_forces_of(const unsigned int of_region,
                                         const BalancedStep &state,
                                         NonlinearForces &forces)
{
  const std::array<std::pair<const Vector<double> *, DistributedVector *>, 5> parts = {
      {{&cell_inertia, &forces.inertia},
       {&cell_convection, &forces.convection},
       {&cell_stabilisation, &forces.stabilisation},
       {&cell_viscosity, &forces.viscosity},
       {&cell_inflow, &forces.inflow}}};
  for (const auto &part : parts)
    *part.second = 0.;
  if (!has_terms(of_region))
    return;
  take(state);
  for (const auto &cell : cells)
    if (cell->material_id() == of_region)
    {
      visit(cell);
      integrate();
      for (const auto &part : parts)
        space.velocity_hanging.distribute_local_to_global(*part.first, velocity_indices,
                                                          *part.second);
    }
  for (const auto &part : parts)
    part.second->compress(VectorOperation::add);
}

template <int dim>
NonlinearEnergy ConvectiveTerms<dim>::energy_of(const unsigned int of_region,
                                                const DistributedVector &of_velocity,
                                                const DistributedVector &of_pressure)
{
  NonlinearEnergy energy;
  const Material &material = problem.materials[of_region];
  const VolumeLaw law = material.volume_law();
  take(of_velocity, of_pressure);
  for (const auto &cell : cells)
    if (cell->material_id() == of_region)
    {
      visit(cell);
      for (unsigned int q = 0; q < quadrature.size(); ++q)
      {
        const Point here = point(q);
        energy.kinetic += here.weight * 0.5 * material.density * law.density_ratio(here.pressure) *
                          here.velocity.norm_square();
        energy.compressive += here.weight * law.energy(here.pressure);
      }
    }
  return energy;
}

template <int dim>
void ConvectiveTerms<dim>::integrate_derivative(FullMatrix<double> &matrix)
{
  const Material &material = problem.materials[region];
  const VolumeLaw law = material.volume_law();
  const double skew = problem.convection.term == ConvectiveTerm::skew ? 0.5 : 0.;
  const double constant_gamma = problem.convection.constant_viscosity(),
               gamma_over_speed = viscosity_over_speed();
  if (streamline_terms.are_on())
    streamline_terms.visit(present_cell, step);
  const double rate_by_pressure = 1. / step.pressure_time;
  const unsigned int n_scalar = place[0].size(), n_velocity = velocity_indices.size(),
                     n_pressure = pressure_indices.size();
  matrix.reinit(n_velocity + n_pressure, n_velocity + n_pressure);
  // Derivatives by the unknowns at one point: of the divergence and of the source m.
  std::vector<double> traces(n_velocity), sources(n_velocity), along(n_scalar),
      pressure_sources(n_pressure), pressure_rates(n_pressure), densities(n_pressure);
  for (unsigned int q = 0; q < quadrature.size(); ++q)
  {
    const Point here = point(q);
    const double density = material.density * law.density_ratio(here.pressure);
    const double compressibility = law.compressibility(here.pressure);
    const double slope = law.compressibility_slope(here.pressure);
    const double motion = here.pressure_rate + here.velocity * here.pressure_gradient;
    const double source = compressibility * motion + here.divergence;
    const Tensor<1, dim> inertia = here.acceleration + here.velocity_gradient * here.velocity;
    const double speed = here.velocity.norm();
    const double gamma = constant_gamma + gamma_over_speed * speed;
    // Of gamma times the source by the velocity; at rest the speed has no derivative.
    const Tensor<1, dim> gamma_slope =
        speed > 0. ? gamma_over_speed / speed * source * here.velocity : Tensor<1, dim>();
    for (unsigned int b = 0; b < n_scalar; ++b)
    {
      along[b] = here.velocity * values.shape_grad(b, q);
      for (unsigned int d = 0; d < dim; ++d)
      {
        traces[place[d][b]] = trace(d, b, q);
        sources[place[d][b]] =
            compressibility * values.shape_value(b, q) * here.pressure_gradient[d] +
            traces[place[d][b]];
      }
    }
    for (unsigned int l = 0; l < n_pressure; ++l)
    {
      const double shape = pressure_values->shape_value(l, q);
      const double moved =
          rate_by_pressure * shape + here.velocity * pressure_values->shape_grad(l, q);
      pressure_sources[l] = slope * shape * motion + compressibility * moved;
      pressure_rates[l] = pressure_sources[l] - law.inverse_bulk_modulus * rate_by_pressure * shape;
      densities[l] = density * compressibility * shape;
    }
    for (unsigned int a = 0; a < n_scalar; ++a)
    {
      const double test = here.weight * values.shape_value(a, q);
      for (unsigned int c = 0; c < dim; ++c)
      {
        const unsigned int i = place[c][a];
        const double test_trace = here.weight * gamma * traces[i];
        const double by_source = test * skew * density * here.velocity[c] + test_trace;
        for (unsigned int b = 0; b < n_scalar; ++b)
        {
          const double shape = values.shape_value(b, q);
          const double same = test * ((density - material.density) * step.a0 * shape +
                                      density * along[b] + skew * density * source * shape);
          for (unsigned int d = 0; d < dim; ++d)
          {
            const unsigned int j = place[d][b];
            matrix(i, j) +=
                (c == d ? same : 0.) + test * density * shape * here.velocity_gradient[c][d] +
                by_source * sources[j] + here.weight * traces[i] * gamma_slope[d] * shape;
          }
        }
        const double by_density = test * (inertia[c] + skew * source * here.velocity[c]);
        for (unsigned int l = 0; l < n_pressure; ++l)
          matrix(i, n_velocity + l) += by_density * densities[l] + by_source * pressure_sources[l];
      }
    }
    if (streamline_terms.are_on())
      streamline_terms.add_derivative(here, q, cell_state(), *pressure_values, matrix);
    if (material.shear.flow_curve)
      add_derivative_of_viscosity(here, q, matrix);
    for (unsigned int k = 0; k < n_pressure; ++k)
    {
      const double test = -here.weight * pressure_values->shape_value(k, q);
      for (unsigned int j = 0; j < n_velocity; ++j)
        matrix(n_velocity + k, j) += test * (sources[j] - traces[j]);
      for (unsigned int l = 0; l < n_pressure; ++l)
        matrix(n_velocity + k, n_velocity + l) += test * pressure_rates[l];
    }
  }
}

template <int dim>
void ConvectiveTerms<dim>::add_derivative(const BalancedStep &state,
                                          const AffineConstraints<double> &constraints,
                                          Triplets &matrix)
{
  take(state);
  const int first_pressure = static_cast<int>(space.velocity_dofs.n_dofs());
  FullMatrix<double> local;
  std::vector<Masters> masters;
  for (const auto &cell : cells)
  {
    set_derivative(cell, local);
    masters.resize(local.m());
    for (unsigned int i = 0; i < velocity_indices.size(); ++i)
      set_masters(constraints, velocity_indices[i], 0, masters[i]);
    for (unsigned int k = 0; k < pressure_indices.size(); ++k)
      set_masters(space.pressure_hanging, pressure_indices[k], first_pressure,
                  masters[velocity_indices.size() + k]);
    // The same places for any state, so that an analysis of the matrix can be kept. Pressures of a
    // liquid that is incompressible enter by SUPG alone.
    const bool is_compressible = !problem.materials[region].is_incompressible();
    const unsigned int n_velocity = velocity_indices.size();
    const unsigned int n_rows = is_compressible ? local.m() : n_velocity;
    const unsigned int n_columns =
        is_compressible || streamline_terms.are_on() ? local.n() : n_velocity;
    for (unsigned int i = 0; i < n_rows; ++i)
      for (unsigned int j = 0; j < n_columns; ++j)
        for (const auto &[row, row_weight] : masters[i])
          for (const auto &[column, column_weight] : masters[j])
          {
            matrix.rows.push_back(row);
            matrix.columns.push_back(column);
            matrix.values.push_back(row_weight * column_weight * local(i, j));
          }
  }
}

template <int dim>
void ConvectiveTerms<dim>::set_derivative(
    const typename DoFHandler<dim>::active_cell_iterator &cell, FullMatrix<double> &matrix)
{
  visit(cell);
  integrate_derivative(matrix);
  if (const auto pressure_cell = present_pressure_cell(); inflow_terms.has_face(pressure_cell))
    inflow_terms.add_derivative(pressure_cell, cell_state(), matrix);
}

template <int dim>
void ConvectiveTerms<dim>::keep_derivative(const BalancedStep &state)
{
  take(state);
  cell_derivatives.resize(cells.size());
  for (std::size_t k = 0; k < cells.size(); ++k)
    set_derivative(cells[k], cell_derivatives[k]);
}

template <int dim>
void ConvectiveTerms<dim>::add_derivative_product(const DistributedVector &of_velocity,
                                                  const DistributedVector &of_pressure,
                                                  DistributedVector &momentum,
                                                  DistributedVector &volume)
{
  take(of_velocity, of_pressure);
  const unsigned int n_velocity = velocity_indices.size();
  for (std::size_t k = 0; k < cells.size(); ++k)
  {
    visit_indices(cells[k]);
    const unsigned int n_pressure = pressure_indices.size();
    cell_change.reinit(n_velocity + n_pressure, true);
    cell_product.reinit(n_velocity + n_pressure, true);
    for (unsigned int i = 0; i < n_velocity; ++i)
      cell_change[i] = velocity(velocity_indices[i]);
    for (unsigned int i = 0; i < n_pressure; ++i)
      cell_change[n_velocity + i] = pressure(pressure_indices[i]);
    cell_derivatives[k].vmult(cell_product, cell_change);
    cell_volume.reinit(n_pressure, true);
    for (unsigned int i = 0; i < n_velocity; ++i)
      cell_inertia[i] = cell_product[i];
    for (unsigned int i = 0; i < n_pressure; ++i)
      cell_volume[i] = -cell_product[n_velocity + i];
    space.velocity_hanging.distribute_local_to_global(cell_inertia, velocity_indices, momentum);
    space.pressure_hanging.distribute_local_to_global(cell_volume, pressure_indices, volume);
  }
  momentum.compress(VectorOperation::add);
  volume.compress(VectorOperation::add);
}

template class ConvectiveTerms<2>;
template class ConvectiveTerms<3>;
} // namespace Continua
