#include <continua/finite_element/solvers/loaded_body.h>

#include <deal.II/base/mpi.h>
#include <deal.II/lac/vector.h>

#include <cmath>

namespace Continua
{
using namespace dealii;

namespace
{
/// Over which a state is nearly linear.
constexpr double part_of_cell = 1e-5;
} // namespace

template <int dim>
LoadedBody<dim>::LoadedBody(const Space<dim> &space,
                            const Problem &problem,
                            const NonlinearTerms<dim> &terms,
                            MetricHistory<dim> *const metrics,
                            const LoadedState &state)
    : space(space),
      problem(problem),
      terms(terms),
      loaded(state),
      cells(space, problem, terms, metrics, state),
      boundary(space, problem, cells)
{
  for (unsigned int part : {0, 1})
  {
    velocities[part].reinit(space.velocity_owned, space.velocity_relevant, space.communicator);
    pressures[part].reinit(space.pressure_owned, space.pressure_relevant, space.communicator);
    momentum_sums[part].reinit(velocities[part], space.velocity_owned, space.velocity_hanging);
    volume_sums[part].reinit(pressures[part], space.pressure_owned, space.pressure_hanging);
  }
}

template <int dim>
HarmonicCoefficients LoadedBody<dim>::coefficients(const Complex s) const
{
  HarmonicCoefficients result;
  for (const Material &material : problem.materials)
  {
    Complex modulus = 0.;
    for (const Branch &branch : material.shear.branches)
      if (!std::isinf(branch.relaxation_time))
        modulus +=
            branch.shear_modulus * s * branch.relaxation_time / (1. + s * branch.relaxation_time);
    result.mass.push_back(s * s);
    result.stiffness.push_back(modulus);
    result.viscosity.push_back(s);
  }
  result.support_damping = s;
  return result;
}

template <int dim>
void LoadedBody<dim>::take(const std::vector<Complex> &of_velocities,
                           const std::vector<Complex> &of_pressures)
{
  for (const bool is_imaginary : {false, true})
  {
    const auto copy = [is_imaginary](const std::vector<Complex> &from, DistributedVector &to)
    {
      for (std::size_t i = 0; i < from.size(); ++i)
        to.begin()[i] = is_imaginary ? from[i].imag() : from[i].real();
    };
    DistributedVector velocity = space.velocity_vector(), pressure = space.pressure_vector();
    copy(of_velocities, velocity);
    copy(of_pressures, pressure);
    space.copy_velocity(velocity, velocities[is_imaginary ? 1 : 0]);
    space.copy_pressure(pressure, pressures[is_imaginary ? 1 : 0]);
  }
}

template <int dim>
void LoadedBody<dim>::apply(const HarmonicCoefficients &at_s,
                            const std::vector<Complex> &of_displacement,
                            const std::vector<Complex> &of_pressure,
                            std::vector<Complex> &forces,
                            std::vector<Complex> &dilatations)
{
  take(of_displacement, of_pressure);
  std::vector<Complex> change, product;
  for (const Cell &cell : cells.all())
  {
    const std::vector<int> &of_velocity = cell.at->velocity_places,
                           &of_volume = cell.at->pressure_places;
    const std::size_t n = of_velocity.size(), n_all = n + of_volume.size();
    change.clear();
    for (const int place : of_velocity)
      change.emplace_back(velocities[0].begin()[place], velocities[1].begin()[place]);
    for (const int place : of_volume)
      change.emplace_back(pressures[0].begin()[place], pressures[1].begin()[place]);
    product.assign(n_all, 0.);
    const auto add = [&](const Complex factor, const FullMatrix<double> &matrix)
    {
      for (unsigned int i = 0; i < matrix.m(); ++i)
      {
        Complex sum = 0.;
        for (unsigned int j = 0; j < matrix.n(); ++j)
          sum += matrix(i, j) * change[j];
        product[i] += factor * sum;
      }
    };
    const unsigned int region = cell.at->region;
    add(1., cell.stiffness);
    add(at_s.mass[region], cell.mass);
    add(at_s.viscosity[region], cell.viscosity);
    add(at_s.stiffness[region], cell.relaxation);
    for (unsigned int part : {0, 1})
    {
      const auto number = [part](const Complex value)
      { return part == 0 ? value.real() : value.imag(); };
      for (std::size_t i = 0; i < n; ++i)
        momentum_sums[part].by_place()[of_velocity[i]] += number(product[i]);
      for (std::size_t k = n; k < n_all; ++k)
        volume_sums[part].by_place()[of_volume[k - n]] += number(product[k]);
    }
  }
  std::array<DistributedVector, 2> momentum, volume;
  for (unsigned int part : {0, 1})
  {
    momentum[part] = space.velocity_vector();
    volume[part] = space.pressure_vector();
    momentum_sums[part].add_to(momentum[part]);
    volume_sums[part].add_to(volume[part]);
  }
  const auto together = [](const std::array<DistributedVector, 2> &parts)
  {
    std::vector<Complex> result(parts[0].locally_owned_size());
    for (std::size_t i = 0; i < result.size(); ++i)
      result[i] = {parts[0].begin()[i], parts[1].begin()[i]};
    return result;
  };
  forces = together(momentum);
  dilatations = together(volume);
}

template <int dim>
void LoadedBody<dim>::show_branches(const std::vector<WeightedSolution> &parts)
{
  for (unsigned int region = 0; region < problem.materials.size(); ++region)
  {
    unsigned int number = 0;
    for (const Branch &branch : problem.materials[region].shear.branches)
    {
      if (std::isinf(branch.relaxation_time))
        continue;
      DistributedVector lagging = loaded.displacement;
      for (const auto &[solution, factor] : parts)
      {
        const Complex of_all = factor / (1. + solution.s * branch.relaxation_time);
        for (std::size_t i = 0; i < solution.displacement.size(); ++i)
          lagging.begin()[i] += (of_all * solution.displacement[i]).real();
      }
      for (const auto &of_model : terms)
        of_model->set_branch(region, number, lagging);
      ++number;
    }
  }
}

template <int dim>
double LoadedBody<dim>::square(const LoadedPart part,
                               const unsigned int region,
                               const std::vector<Complex> &of_displacement)
{
  take(of_displacement, {});
  double sum = 0.;
  Vector<double> entries;
  for (const Cell &cell : cells.all())
  {
    const FullMatrix<double> &matrix = LoadedCells<dim>::matrix_of(part, cell);
    if (cell.at->region != region || matrix.empty())
      continue;
    entries.reinit(cell.at->velocity_places.size());
    for (const DistributedVector &of_part : velocities)
    {
      set_entries(cell.at->velocity_places, of_part, entries);
      for (unsigned int i = 0; i < entries.size(); ++i)
        for (unsigned int j = 0; j < entries.size(); ++j)
          sum += entries[i] * matrix(i, j) * entries[j];
    }
  }
  return Utilities::MPI::sum(sum, space.communicator);
}

template <int dim>
double LoadedBody<dim>::small_displacement() const
{
  return part_of_cell * cells.smallest();
}

template class LoadedBody<2>;
template class LoadedBody<3>;
} // namespace Continua
