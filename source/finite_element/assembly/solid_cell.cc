#include <continua/finite_element/assembly/solid_cell.h>

#include <continua/materials/metric_stress.h>

#include <algorithm>
#include <limits>

namespace Continua
{
using namespace dealii;

template <int dim>
SolidCell<dim>::SolidCell(const Problem &problem,
                          const QuadratureCells<dim> &cells,
                          const StressFreeStates<dim> &stress_free_states,
                          const MetricHistory<dim> *const metrics,
                          const Vectors &vectors)
    : problem(problem),
      cells(cells),
      stress_free_states(stress_free_states),
      metrics(metrics),
      vectors(vectors),
      velocity_at_points(cells, ValuesAtPoints<dim>::Field::velocity, true),
      displacement_at_points(cells, ValuesAtPoints<dim>::Field::velocity, true),
      acceleration_at_points(cells, ValuesAtPoints<dim>::Field::velocity, false),
      pressure_at_points(cells, ValuesAtPoints<dim>::Field::pressure, false),
      pressure_rate_at_points(cells, ValuesAtPoints<dim>::Field::pressure, false)
{
  for (Vector<double> *of_cell : {&velocities, &displacements, &accelerations, &unloaded})
    of_cell->reinit(dim * cells.n_functions());
  for (Vector<double> *of_cell : {&pressures, &pressure_rates})
    of_cell->reinit(cells.n_pressures());
}

template <int dim>
void SolidCell<dim>::set_step(const Step &step)
{
  finds_steady_state = step.finds_steady_state;
  finds_unloaded_shape = step.finds_unloaded_shape;
  scheme.displacement_by_velocity = step.branch(std::numeric_limits<double>::infinity()).velocity;
  scheme.rate_by_velocity = step.a0;
  scheme.pressure_rate_by_pressure = 1. / step.pressure_time;
  scheme.volume_is_rate = step.extrapolate;
}

template <int dim>
void SolidCell<dim>::visit(const Cell &cell)
{
  present = &cell;
  const Material &solid = material();
  scheme.density = solid.density;
  scheme.viscosity = finds_steady_state || finds_unloaded_shape ? 0. : solid.shear.viscosity;
  scheme.inverse_bulk_modulus = solid.inverse_bulk_modulus();
  scheme.has_own_mean_stress = solid.strain_law->has_own_mean_stress();
  set_entries(cell.velocity_places, vectors.velocity, velocities);
  set_entries(cell.velocity_places, vectors.displacement, displacements);
  set_entries(cell.velocity_places, vectors.acceleration, accelerations);
  set_entries(cell.pressure_places, vectors.pressure, pressures);
  set_entries(cell.pressure_places, vectors.pressure_rate, pressure_rates);
  velocity_at_points.set(velocities);
  displacement_at_points.set(displacements);
  acceleration_at_points.set(accelerations);
  pressure_at_points.set(pressures);
  pressure_rate_at_points.set(pressure_rates);
  if (finds_unloaded_shape)
    stress_free_states.set_unloaded(cell, unloaded);
}

template <int dim>
double SolidCell<dim>::largest_displacement() const
{
  return (finds_unloaded_shape ? unloaded : displacements).linfty_norm();
}

template <int dim>
SolidAtPoints<dim> SolidCell<dim>::all_points() const
{
  SolidAtPoints<dim> all;
  all.n_points = cells.n_points();
  all.geometry = present->points.data();
  all.scheme = scheme;
  all.law = material().strain_law.get();
  all.stress_free = stress_free_states.at(*present, 0);
  all.branches = relaxes() ? &metrics->predicted(number(), 0) : nullptr;
  all.has_mass_of_mesh = finds_unloaded_shape;
  all.velocity = velocity_at_points.numbers();
  all.displacement = displacement_at_points.numbers();
  all.acceleration = acceleration_at_points.numbers();
  all.pressure = pressure_at_points.numbers();
  all.pressure_rate = pressure_rate_at_points.numbers();
  return all;
}

template <int dim>
SolidPoint<dim> SolidCell<dim>::point(const unsigned int q, const Stress of_law)
{
  const typename Cell::Point &geometry = present->points[q];
  SolidPoint<dim> point(scheme, Kinematics(displacement_at_points.space_gradient(q, geometry)));
  point.hoop = geometry.hoop * point.kinematics.inverse()[2][2];
  for (unsigned int c = 0; c < dim; ++c)
  {
    point.velocity[c] = velocity_at_points.value(c, q);
    point.acceleration[c] = acceleration_at_points.value(c, q);
  }
  point.velocity_gradient =
      point.kinematics.gradient(velocity_at_points.space_gradient(q, geometry));
  point.pressure = pressure_at_points.value(0, q);
  point.pressure_rate = pressure_rate_at_points.value(0, q);
  const StressFreeState *const stress_free = stress_free_states.at(*present, q);
  if (stress_free != nullptr)
    point.stress_free_ratio = stress_free->volume_ratio;
  // A step that finds the unloaded shape ends at rest, whatever the mass on the way there.
  point.mass_ratio = finds_unloaded_shape ? 1. : point.stress_free_ratio;
  if (!(std::min(point.volume_ratio(), point.stress_free_ratio) > 0.))
    return point;
  set_strain(stress_free, point);
  if (of_law == Stress::alone)
    set_stress(q, point);
  else if (of_law == Stress::with_tangent)
    set_tangent(q, point);
  if (of_law == Stress::with_tangent && scheme.has_own_mean_stress)
    material().strain_law->set_mean_stress(strain_at_point, point.mean_stress,
                                           point.mean_stress_slope);
  if (of_law == Stress::with_tangent && finds_unloaded_shape)
  {
    unloading.emplace(Tensor<2, 3>(unit_symmetric_tensor<3>()) +
                      cells.gradient(*present, unloaded, q));
    point.unloading = &*unloading;
  }
  return point;
}

template <int dim>
void SolidCell<dim>::set_strain(const StressFreeState *const stress_free,
                                const SolidPoint<dim> &point)
{
  strain_at_point.gradient = point.kinematics.deformation_gradient();
  strain_at_point.determinant = point.volume_ratio();
  if (stress_free == nullptr)
    return;
  strain_at_point.fibres = stress_free->fibres;
  strain_at_point.gradient = strain_at_point.gradient * stress_free->prestretch;
  strain_at_point.determinant /= stress_free->volume_ratio;
}

template <int dim>
void SolidCell<dim>::set_stress(const unsigned int q, SolidPoint<dim> &point) const
{
  const StrainLaw &law = *material().strain_law;
  if (scheme.has_own_mean_stress)
    law.set_stresses(strain_at_point, point.stress, point.mean_stress, point.mean_stress_slope);
  else
    law.set_stress(strain_at_point, point.stress);
  if (relaxes())
  {
    SymmetricTensor<2, 3> of_branches;
    MetricStress(metrics->predicted(number(), q)).set_stress(strain_at_point, of_branches);
    point.stress += of_branches;
  }
  point.stress *= point.stress_free_ratio;
}

template <int dim>
void SolidCell<dim>::set_tangent(const unsigned int q, SolidPoint<dim> &point) const
{
  material().strain_law->set_tangent(strain_at_point, point.stress, point.tangent);
  if (relaxes())
  {
    SymmetricTensor<2, 3> of_branches;
    SymmetricTensor<4, 3> tangent_of_branches;
    MetricStress(metrics->predicted(number(), q))
        .set_tangent(strain_at_point, of_branches, tangent_of_branches);
    point.stress += of_branches;
    point.tangent += tangent_of_branches;
  }
  point.stress *= point.stress_free_ratio;
  point.tangent *= point.stress_free_ratio;
}

template <int dim>
Tensor<2, dim> SolidCell<dim>::inverse_jacobian(const SolidPoint<dim> &point,
                                                const unsigned int q) const
{
  Tensor<2, dim> inverse;
  for (unsigned int c = 0; c < dim; ++c)
    for (unsigned int d = 0; d < dim; ++d)
      inverse[c][d] = point.kinematics.inverse()[c][d];
  return present->points[q].inverse_jacobian * inverse;
}

template class SolidCell<2>;
template class SolidCell<3>;
} // namespace Continua
