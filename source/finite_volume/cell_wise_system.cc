#include <continua/finite_volume/cell_wise_system.h>

#include <continua/base/nearly_equal.h>
#include <continua/finite_volume/sparse_rows.h>
#include <continua/linear_algebra/for_row.h>
#include <continua/linear_algebra/matrix_product.h>
#include <continua/mesh/ghost_exchange.h>

#include <algorithm>
#include <cmath>

namespace Continua
{
using namespace dealii;

namespace
{
using Matrix = TrilinosWrappers::SparseMatrix;
} // namespace

bool CellWiseCoefficients::operator==(const CellWiseCoefficients &other) const
{
  return with_pressure == other.with_pressure && correct_fluxes == other.correct_fluxes &&
         nearly_equal(mass, other.mass) && nearly_equal(stiffness, other.stiffness) &&
         nearly_equal(compressibility, other.compressibility) &&
         nearly_equal(increment_mobility, other.increment_mobility);
}

template <int dim>
CellWiseSystem<dim>::CellWiseSystem(const CellWiseSpace<dim> &space,
                                    const Problem &problem,
                                    const FaceConditions<dim> &conditions,
                                    const std::vector<CellWiseOperators> &operators,
                                    const PressureClosure &closure,
                                    const CellWiseParameters &parameters)
    : space(space),
      problem(problem),
      conditions(conditions),
      operators(operators),
      closure(closure),
      parameters(parameters)
{
}

template <int dim>
void CellWiseSystem<dim>::reinit()
{
  is_prepared = false;
  has_correction = has_increment_correction = false;
  velocity_work = space.velocity_vector();
  pressure_work = space.pressure_vector();
  measure_diffusion();
}

template <int dim>
void CellWiseSystem<dim>::remeasure()
{
  measure_diffusion();
  if (is_prepared)
    assemble_corrections();
}

template <int dim>
void CellWiseSystem<dim>::measure_diffusion()
{
  const CellWiseMesh<dim> &mesh = space.mesh;
  diffusion.assign(mesh.cells().size(), 0.);
  for (unsigned int f = 0; f < mesh.faces().size(); ++f)
    for (unsigned int side = 0; side < mesh.faces()[f].n_sides(); ++side)
    {
      // From a face with its own value the way to the cell is half as long.
      const VolumeFace<dim> &surface = mesh.faces()[f];
      diffusion[surface.cell(side)] +=
          surface.shape(side).area / (mesh.distance(f, side) * surface.outward(side));
    }
  for (unsigned int cell = 0; cell < diffusion.size(); ++cell)
    diffusion[cell] /= mesh.cells()[cell].volume;
  // A ghost has only the faces that it shares with this rank's cells.
  exchange_with_ghosts<dim>(
      mesh.triangulation,
      [&](const auto &cell) { return std::vector<double>{diffusion[mesh.cell_number(cell)]}; },
      [&](const auto &cell, const std::vector<double> &numbers)
      { diffusion[mesh.cell_number(cell)] = numbers[0]; });
}

template <int dim>
bool CellWiseSystem<dim>::prepare(const CellWiseCoefficients &coefficients)
{
  if (is_prepared && coefficients == present)
    return false;
  present = coefficients;
  is_prepared = true;
  assemble_corrections();
  return true;
}

template <int dim>
void CellWiseSystem<dim>::assemble_corrections()
{
  has_correction = has_increment_correction = false;
  const CellWiseMesh<dim> &mesh = space.mesh;
  diagonal.resize(mesh.cells().size());
  viscous_diagonal.resize(mesh.cells().size());
  std::vector<double> ratios;
  for (const Material &material : problem.materials)
    ratios.push_back(traction_coefficients(material, parameters).stencil_ratio);
  for (unsigned int cell = 0; cell < diagonal.size(); ++cell)
  {
    const unsigned int region = mesh.cells()[cell].material_id;
    viscous_diagonal[cell] = present.stiffness[region] * ratios[region] * diffusion[cell];
    diagonal[cell] = present.mass[region] + viscous_diagonal[cell];
  }
  if (!present.with_pressure || !present.correct_fluxes)
    return;
  const IndexSet rows = space.pressures.owned(1);
  SparseRows of_pressure(rows, rows, space.communicator),
      of_increment(rows, rows, space.communicator);
  for (const double mobility : present.increment_mobility)
    (mobility > 0. ? has_increment_correction : has_correction) = true;
  for (unsigned int face = 0; face < mesh.faces().size(); ++face)
  {
    const VolumeFace<dim> &surface = mesh.faces()[face];
    if (surface.has_value())
      continue;
    const unsigned int region = mesh.cells()[surface.owner].material_id;
    const double mobility = present.increment_mobility[region];
    const double normal_distance = surface.distance * surface.normal;
    const double tau =
        mobility > 0. ? 0.25 * normal_distance * normal_distance * mobility : flux_mobility(face);
    const Stencil<double> difference = pressure_difference(face);
    SparseRows &target = mobility > 0. ? of_increment : of_pressure;
    for (unsigned int side = 0; side < 2; ++side)
      if (mesh.cells()[surface.cell(side)].is_owned)
        for (const auto &[value, coefficient] : difference)
          target.add(space.pressures.of_cell(surface.cell(side)), value,
                     (side == 0 ? 1. : -1.) * surface.area * tau * coefficient);
  }
  if (has_correction)
    of_pressure.move_to(correction);
  if (has_increment_correction)
    of_increment.move_to(increment);
}

template <int dim>
double CellWiseSystem<dim>::flux_mobility(const unsigned int face) const
{
  const VolumeFace<dim> &surface = space.mesh.faces()[face];
  const unsigned int region = space.mesh.cells()[surface.owner].material_id;
  if (!has_correction || present.increment_mobility[region] > 0.)
    return 0.;
  const auto mean_of_inverse = [&](const std::vector<double> &numbers)
  {
    return surface.owner_weight / numbers[surface.owner] +
           (1. - surface.owner_weight) / numbers[surface.neighbour];
  };
  if (!has_excess_velocity(region))
    return mean_of_inverse(diagonal);
  // The mean must not depend on the time step.
  return 1. / (present.mass[region] + 1. / mean_of_inverse(viscous_diagonal));
}

template <int dim>
Stencil<double> CellWiseSystem<dim>::pressure_difference(const unsigned int face) const
{
  Stencil<double> difference = space.pressure_normal_gradient(face, 0);
  for (const auto &[value, g] : space.pressure_gradient.on_face(face, 0))
    difference.add(value, -(g * space.mesh.faces()[face].normal));
  return difference;
}

template <int dim>
bool CellWiseSystem<dim>::has_excess_velocity(const unsigned int region) const
{
  return parameters.formulation == Formulation::velocity_pressure &&
         parameters.rhie_chow != RhieChow::none &&
         parameters.rhie_chow_in_time == RhieChowInTime::momentum_of_faces &&
         problem.materials[region].shear.branches.empty();
}

template <int dim>
void CellWiseSystem<dim>::add_pressure_correction(const double factor,
                                                  const DistributedVector &pressure,
                                                  DistributedVector &target) const
{
  if (!has_correction)
    return;
  Continua::multiply(correction, pressure_work, pressure);
  target.add(factor, pressure_work);
}

template <int dim>
void CellWiseSystem<dim>::add_increment_correction(const double factor,
                                                   const DistributedVector &pressure,
                                                   DistributedVector &target) const
{
  if (!has_increment_correction)
    return;
  Continua::multiply(increment, pressure_work, pressure);
  target.add(factor, pressure_work);
}

template <int dim>
void CellWiseSystem<dim>::add_velocity_product(const DistributedVector &velocity,
                                               DistributedVector &target) const
{
  for (unsigned int region = 0; region < operators.size(); ++region)
  {
    Continua::multiply(operators[region].stiffness, velocity_work, velocity);
    target.add(present.stiffness[region], velocity_work);
    velocity_work.equ(present.mass[region], velocity);
    velocity_work.scale(operators[region].volume);
    target.add(1., velocity_work);
  }
}

template <int dim>
void CellWiseSystem<dim>::add_transposed_velocity_product(const DistributedVector &velocity,
                                                          DistributedVector &target) const
{
  for (unsigned int region = 0; region < operators.size(); ++region)
  {
    multiply_transposed(operators[region].stiffness, velocity_work, velocity);
    target.add(present.stiffness[region], velocity_work);
    velocity_work.equ(present.mass[region], velocity);
    velocity_work.scale(operators[region].volume);
    target.add(1., velocity_work);
  }
}

template <int dim>
void CellWiseSystem<dim>::multiply(const DistributedVector &velocity,
                                   const DistributedVector &pressure,
                                   DistributedVector &momentum,
                                   DistributedVector &mass) const
{
  momentum = 0.;
  mass = 0.;
  add_velocity_product(velocity, momentum);
  for (unsigned int region = 0; region < operators.size() && present.with_pressure; ++region)
  {
    const CellWiseOperators &of_region = operators[region];
    Continua::multiply(of_region.gradient, velocity_work, pressure);
    momentum.add(1., velocity_work);
    Continua::multiply(of_region.divergence, pressure_work, velocity);
    mass.add(1., pressure_work);
    pressure_work.equ(present.compressibility[region], pressure);
    pressure_work.scale(of_region.pressure_volume);
    mass.add(1., pressure_work);
  }
  if (present.with_pressure)
    add_flux_correction(pressure, mass);
}

template <int dim>
void CellWiseSystem<dim>::add_flux_correction(const DistributedVector &pressure,
                                              DistributedVector &mass) const
{
  add_pressure_correction(-1., pressure, mass);
  add_increment_correction(-1., pressure, mass);
  Continua::multiply(closure.matrix, pressure_work, pressure);
  mass.add(1., pressure_work);
}

template <int dim>
double CellWiseSystem<dim>::scale(const typename FaceConditions<dim>::Face &face) const
{
  const VolumeFace<dim> &surface = space.mesh.faces()[face.face];
  const FiniteVolume<dim> &cell = space.mesh.cells()[surface.owner];
  return present.mass[cell.material_id] * cell.volume +
         present.stiffness[cell.material_id] * face.weight / (surface.distance * surface.normal);
}

template <int dim>
void CellWiseSystem<dim>::set_prescribed(const DistributedVector &prescribed,
                                         DistributedVector &momentum) const
{
  for (const auto &face : conditions.faces())
    if (face.prescribed.norm_square() > 0.)
    {
      Tensor<1, dim> value, equation;
      for (unsigned int c = 0; c < dim; ++c)
      {
        value[c] = scale(face) * prescribed.begin()[face.index + c];
        equation[c] = momentum.begin()[face.index + c];
      }
      equation += face.prescribed * (value - equation);
      for (unsigned int c = 0; c < dim; ++c)
        momentum.begin()[face.index + c] = equation[c];
    }
}

template <int dim>
void CellWiseSystem<dim>::for_entries(const std::function<void(int, int, double)> &function) const
{
  const int first = dim * space.velocities.first_owned();
  const int first_pressure = n_velocities() + space.pressures.first_owned();
  const unsigned int n_owned = dim * space.velocities.n_owned();
  // The prescribed directions of faces take the place of their equations.
  std::vector<const typename FaceConditions<dim>::Face *> face_of(n_owned / dim, nullptr);
  for (const auto &face : conditions.faces())
    if (face.prescribed.norm_square() > 0.)
      face_of[face.index / dim] = &face;
  const auto add = [&](const unsigned int row, const int column, const double value)
  {
    const auto *const face = face_of[row / dim];
    if (face == nullptr)
      function(first + row, column, value);
    else
      for (unsigned int c = 0; c < dim; ++c)
      {
        const double share = (c == row % dim ? 1. : 0.) - face->prescribed[c][row % dim];
        if (std::abs(share) > 1e-14)
          function(first + row / dim * dim + c, column, share * value);
      }
  };
  for (const auto &face : conditions.faces())
    if (face_of[face.index / dim] != nullptr)
      for (unsigned int a = 0; a < dim; ++a)
        for (unsigned int b = 0; b < dim; ++b)
          if (std::abs(face.prescribed[a][b]) > 1e-14)
            function(first + face.index + a, first + face.index + b,
                     scale(face) * face.prescribed[a][b]);

  for (unsigned int region = 0; region < operators.size(); ++region)
  {
    const CellWiseOperators &of_region = operators[region];
    for (unsigned int row = 0; row < n_owned; ++row)
    {
      for_row(of_region.stiffness, row,
              [&](const int column, const double value)
              { add(row, column, present.stiffness[region] * value); });
      const double volume = of_region.volume.begin()[row];
      if (volume != 0.)
        add(row, first + row, present.mass[region] * volume);
      if (present.with_pressure)
        for_row(of_region.gradient, row,
                [&](const int column, const double value)
                { add(row, n_velocities() + column, value); });
    }
    if (!present.with_pressure)
      continue;
    for (unsigned int row = 0; row < space.pressures.n_owned(); ++row)
    {
      for_row(of_region.divergence, row,
              [&](const int column, const double value)
              { function(first_pressure + row, column, value); });
      const double volume = of_region.pressure_volume.begin()[row];
      if (volume != 0.)
        function(first_pressure + row, first_pressure + row,
                 present.compressibility[region] * volume);
    }
  }
  if (!present.with_pressure)
    return;
  for (unsigned int row = 0; row < space.pressures.n_owned(); ++row)
  {
    for_row(closure.matrix, row,
            [&](const int column, const double value)
            { function(first_pressure + row, n_velocities() + column, value); });
    for (const Matrix *const matrix : {pressure_correction(), increment_correction()})
      if (matrix != nullptr)
        for_row(*matrix, row,
                [&](const int column, const double value)
                { function(first_pressure + row, n_velocities() + column, -value); });
  }
  if (tangent)
    tangent(add, [&](const unsigned int row, const int column, const double value)
            { function(first_pressure + row, column, value); });
}

template class CellWiseSystem<2>;
template class CellWiseSystem<3>;
} // namespace Continua
