#include <continua/finite_volume/cell_wise_vibration.h>

#include <algorithm>

namespace Continua
{
using namespace dealii;

template <int dim>
CellWiseVibration<dim>::CellWiseVibration(CellWiseSystem<dim> &system,
                                          const CellWiseCoefficients &coefficients,
                                          const VibratingState &state)
    : system(system),
      space(system.space),
      steady(coefficients),
      state(state),
      coupled(system),
      force(space.velocity_vector()),
      mass(space.pressure_vector()),
      displacement(space.velocity_vector()),
      pressure(space.pressure_vector())
{
  for (unsigned int cell = 0; cell < space.mesh.n_owned_cells(); ++cell)
  {
    const FiniteVolume<dim> &volume = space.mesh.cells()[cell];
    masses.insert(masses.end(), dim,
                  volume.volume * system.problem.materials[volume.material_id].density);
  }
}

template <int dim>
std::vector<unsigned int> CellWiseVibration<dim>::directions() const
{
  std::vector<unsigned int> result(n_local_unknowns());
  for (unsigned int i = 0; i < result.size(); ++i)
    result[i] = i % dim;
  return result;
}

template <int dim>
void CellWiseVibration<dim>::multiply_mass(const std::vector<double> &x, std::vector<double> &y)
{
  std::transform(x.begin(), x.end(), masses.begin(), y.begin(), std::multiplies<>());
}

template <int dim>
std::vector<double>
CellWiseVibration<dim>::momentum(const std::function<Tensor<1, dim>(const Point<dim> &)> &field)
{
  std::vector<double> result(masses);
  for (unsigned int cell = 0; cell < space.mesh.n_owned_cells(); ++cell)
  {
    const Tensor<1, dim> value = field(space.mesh.cells()[cell].centre);
    for (unsigned int c = 0; c < dim; ++c)
      result[dim * cell + c] *= value[c];
  }
  return result;
}

template <int dim>
void CellWiseVibration<dim>::prepare(const double new_shift)
{
  shift = new_shift;
  CellWiseCoefficients coefficients = steady;
  for (unsigned int region = 0; region < coefficients.mass.size(); ++region)
    coefficients.mass[region] = -shift * system.problem.materials[region].density;
  system.prepare(coefficients);
}

template <int dim>
void CellWiseVibration<dim>::set_shift(const double new_shift)
{
  prepare(new_shift);
  coupled.reinit();
}

template <int dim>
void CellWiseVibration<dim>::solve(std::vector<double> &x)
{
  force = 0.;
  mass = 0.;
  std::copy(x.begin(), x.end(), force.begin());
  StepReport report;
  coupled.solve(force, mass, displacement, pressure, report);
  std::copy_n(displacement.begin(), x.size(), x.begin());
}

template <int dim>
bool CellWiseVibration<dim>::has_acceleration() const
{
  return std::all_of(system.problem.materials.begin(), system.problem.materials.end(),
                     [](const Material &material) { return !material.is_incompressible(); });
}

template <int dim>
void CellWiseVibration<dim>::accelerate(const std::vector<double> &x, std::vector<double> &y)
{
  // Without the shift's inertia in the product below.
  prepare(0.);
  if (!held)
  {
    held = std::make_unique<HeldCells<dim>>(system);
    held->reinit({}, {});
  }
  force = 0.;
  mass = 0.;
  std::copy(x.begin(), x.end(), displacement.begin());
  held->solve(force, mass, displacement, pressure);
  system.multiply(displacement, pressure, force, mass);
  for (std::size_t i = 0; i < y.size(); ++i)
    y[i] = force.begin()[i] / masses[i];
}

template <int dim>
void CellWiseVibration<dim>::set_shape(const std::vector<double> &x, const double eigenvalue)
{
  // Faces and pressures with the cells, by the factor that is there.
  if (held)
  {
    force = 0.;
    mass = 0.;
    std::copy(x.begin(), x.end(), displacement.begin());
    held->solve(force, mass, displacement, pressure);
  }
  else
  {
    std::vector<double> shape(x.size());
    multiply_mass(x, shape);
    for (double &entry : shape)
      entry *= eigenvalue - shift;
    solve(shape);
  }
  state.displacement.equ(1., displacement);
  std::copy(x.begin(), x.end(), state.displacement.begin());
  state.velocity = 0.;
  state.pressure.equ(1., pressure);
}

template class CellWiseVibration<2>;
template class CellWiseVibration<3>;
} // namespace Continua
