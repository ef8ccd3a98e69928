#include <continua/finite_volume/cell_wise_convection.h>

#include <continua/continuum/local_product.h>
#include <continua/finite_volume/liquid_cells.h>

#include <algorithm>

namespace Continua
{
using namespace dealii;

template <int dim>
CellWiseConvection<dim>::CellWiseConvection(const CellWiseSystem<dim> &system,
                                            const ExcessVelocity<dim> &excess_velocity,
                                            const LinearReconstruction<dim> &reconstruction,
                                            const SweptVolumes<dim> &swept_volumes)
    : system(system),
      excess_velocity(excess_velocity),
      reconstruction(reconstruction),
      swept_volumes(swept_volumes)
{
}

template <int dim>
bool CellWiseConvection<dim>::has_terms(const unsigned int region) const
{
  return system.problem.materials[region].phase() < 1.;
}

template <int dim>
void CellWiseConvection<dim>::reinit()
{
  faces.clear();
  forces = system.space.velocity_vector();
  const CellWiseMesh<dim> &mesh = system.space.mesh;
  for (unsigned int f = 0; f < mesh.faces().size(); ++f)
  {
    const VolumeFace<dim> &surface = mesh.faces()[f];
    if (!surface.has_value())
      add_face(f, 0, 2);
    else
      for (unsigned int side = 0; side < surface.n_sides(); ++side)
        add_face(f, side, side + 1);
  }
}

template <int dim>
void CellWiseConvection<dim>::begin_step(const DistributedVector &start)
{
  if (velocity_old.size() != start.size())
    velocity_old.reinit(start);
  velocity_old.equ(1., start);
}

template <int dim>
void CellWiseConvection<dim>::add_face(const unsigned int number,
                                       const unsigned int first_side,
                                       const unsigned int end_side)
{
  const CellWiseSpace<dim> &space = system.space;
  const VolumeFace<dim> &surface = space.mesh.faces()[number];
  const FiniteVolume<dim> &cell = space.mesh.cells()[surface.cell(first_side)];
  Face face;
  face.region = cell.material_id;
  if (!has_terms(face.region) || (surface.has_value() && !cell.is_owned))
    return;
  face.face = number;
  face.first_side = first_side;
  face.end_side = end_side;
  face.velocity = space.velocity_gradient.face_value(number, first_side);
  face.pressure = space.pressure_gradient.face_value(number, first_side);
  if (!surface.has_value())
    face.difference = system.pressure_difference(number);
  if (surface.at_boundary())
  {
    const auto &on_boundary = system.conditions.of_face(number);
    const BoundaryCondition &condition = system.problem.conditions[on_boundary.condition];
    if (condition.inflow_pressure == InflowPressure::total &&
        condition.normal.kind == BoundaryPart::Kind::traction)
    {
      face.inflow_row = on_boundary.index;
      face.weight = on_boundary.weight;
    }
  }
  faces.push_back(face);
}

template <int dim>
void CellWiseConvection<dim>::take(const StepSolution &state)
{
  velocity = reconstruction.ghosted_velocity(state.velocity);
  pressure = reconstruction.ghosted_pressure(state.pressure);
}

template <int dim>
Tensor<1, dim> CellWiseConvection<dim>::velocity_of(const unsigned int cell) const
{
  Tensor<1, dim> value;
  for (unsigned int c = 0; c < dim; ++c)
    value[c] = velocity(dim * system.space.velocities.of_cell(cell) + c);
  return value;
}

template <int dim>
double CellWiseConvection<dim>::pressure_of(const unsigned int cell) const
{
  return pressure(system.space.pressures.of_cell(cell));
}

template <int dim>
typename CellWiseConvection<dim>::Flow CellWiseConvection<dim>::flow(const Face &face) const
{
  using Reconstruction = LinearReconstruction<dim>;
  const CellWiseSpace<dim> &space = system.space;
  const VolumeFace<dim> &surface = space.mesh.faces()[face.face];
  Flow flow;
  flow.normal_velocity = Reconstruction::vector_value(face.velocity, velocity) * surface.normal;
  if (!surface.has_value())
  {
    flow.mobility = system.flux_mobility(face.face);
    if (flow.mobility > 0.)
      flow.normal_velocity -= flow.mobility * (Reconstruction::value(face.difference, pressure) +
                                               excess_velocity.past(face.face));
  }
  // Nothing passes the surface of a solid that the mesh follows.
  if (surface.undeformed_side == VolumeFace<dim>::none)
    flow.outflow = surface.area * flow.normal_velocity - swept_volumes.rate(face.face);
  // Central, blended with what comes from upstream; a face's own value is that of both.
  const double central = surface.has_value() ? 1. : system.parameters.share_of_central();
  flow.velocity.add(central, face.velocity);
  flow.pressure.add(central, face.pressure);
  if (central < 1.)
  {
    const unsigned int upstream = flow.outflow >= 0. ? surface.owner : surface.neighbour;
    flow.velocity.add(space.velocities.of_cell(upstream), 1. - central);
    flow.pressure.add(space.pressures.of_cell(upstream), 1. - central);
  }
  flow.value = Reconstruction::vector_value(flow.velocity, velocity);
  const Material &material = system.problem.materials[face.region];
  const VolumeLaw law = material.volume_law();
  const double at = Reconstruction::value(flow.pressure, pressure);
  flow.density = material.density * law.density_ratio(at);
  flow.density_slope = flow.density * law.compressibility(at);
  return flow;
}

template <int dim>
void CellWiseConvection<dim>::add_fluxes(const Face &face,
                                         const Flow &flow,
                                         DistributedVector &momentum,
                                         DistributedVector *const volume) const
{
  const CellWiseSpace<dim> &space = system.space;
  const VolumeFace<dim> &surface = space.mesh.faces()[face.face];
  const Material &material = system.problem.materials[face.region];
  for (unsigned int side = face.first_side; side < face.end_side; ++side)
  {
    const unsigned int cell = surface.cell(side);
    if (!space.mesh.cells()[cell].is_owned)
      continue;
    const double leaving = (side == 0 ? 1. : -1.) * flow.outflow;
    const Tensor<1, dim> change = leaving * flow.density * (flow.value - velocity_of(cell));
    const unsigned int row = space.local_velocity(space.velocities.of_cell(cell));
    for (unsigned int c = 0; c < dim; ++c)
      momentum.begin()[row + c] += change[c];
    if (volume != nullptr)
      volume->begin()[space.local_pressure(space.pressures.of_cell(cell))] +=
          leaving * (flow.density / (material.density *
                                     material.volume_law().density_ratio(pressure_of(cell))) -
                     1.);
  }
}

template <int dim>
double CellWiseConvection<dim>::inflow(const Face &face, const Flow &flow) const
{
  const VolumeFace<dim> &surface = system.space.mesh.faces()[face.face];
  return surface.area > 0. ? std::min(flow.outflow / surface.area, 0.) : 0.;
}

template <int dim>
void CellWiseConvection<dim>::add_inflow(const Face &face,
                                         const Flow &flow,
                                         DistributedVector &momentum) const
{
  if (face.inflow_row == VolumeFace<dim>::none)
    return;
  const double entering = inflow(face, flow);
  for (unsigned int c = 0; c < dim; ++c)
    momentum.begin()[face.inflow_row + c] -=
        0.5 * face.weight * flow.density * entering * flow.value[c];
}

template <int dim>
void CellWiseConvection<dim>::add_inertia(const unsigned int cell,
                                          const StepSolution &state,
                                          DistributedVector &momentum) const
{
  const FiniteVolume<dim> &volume = system.space.mesh.cells()[cell];
  const Material &material = system.problem.materials[volume.material_id];
  const unsigned int row = system.space.local_velocity(system.space.velocities.of_cell(cell));
  const double ratio = material.volume_law().density_ratio(pressure_of(cell));
  const double mass = volume.volume * material.density * (ratio - 1.);
  for (unsigned int c = 0; c < dim; ++c)
    momentum.begin()[row + c] += mass * state.acceleration.begin()[row + c] +
                                 material.density * ratio * growth_term(cell, state, row + c);
}

template <int dim>
double CellWiseConvection<dim>::growth_term(const unsigned int cell,
                                            const StepSolution &state,
                                            const unsigned int row) const
{
  if (!swept_volumes.moves(cell))
    return 0.;
  // a2 (U - U_older) is what dU/dt and a1 (U - U_old) leave.
  const double growth = swept_volumes.growth(cell),
               earlier = swept_volumes.growth_since_older(cell);
  return state.step.a1 * (growth - earlier) *
             (state.velocity.begin()[row] - velocity_old.begin()[row]) -
         earlier * state.acceleration.begin()[row];
}

template <int dim>
void CellWiseConvection<dim>::add(const StepSolution &state,
                                  DistributedVector &momentum,
                                  DistributedVector &volume)
{
  take(state);
  refuse_soft_liquids(system.space, system.problem, state.pressure);
  for (const Face &face : faces)
  {
    const Flow on_face = flow(face);
    add_fluxes(face, on_face, momentum, &volume);
    add_inflow(face, on_face, momentum);
  }
  const CellWiseSpace<dim> &space = system.space;
  for (unsigned int cell = 0; cell < space.mesh.n_owned_cells(); ++cell)
  {
    const FiniteVolume<dim> &here = space.mesh.cells()[cell];
    if (!has_terms(here.material_id))
      continue;
    add_inertia(cell, state, momentum);
    const VolumeLaw law = system.problem.materials[here.material_id].volume_law();
    const unsigned int row = space.local_pressure(space.pressures.of_cell(cell));
    volume.begin()[row] += here.volume *
                           (law.compressibility(pressure_of(cell)) - law.inverse_bulk_modulus) *
                           state.pressure_rate.begin()[row];
  }
}

template <int dim>
void CellWiseConvection<dim>::add_powers(const unsigned int region,
                                         const StepSolution &state,
                                         const DistributedVector &of_velocity,
                                         const TermsTaken taken,
                                         NonlinearPowers &powers,
                                         DistributedVector *const momentum)
{
  if (!has_terms(region))
    return;
  take(state);
  const auto add_kind = [&](const PowerKind kind, const auto &add_forces)
  {
    if (!takes_terms_of(taken, kind))
      return;
    forces = 0.;
    add_forces();
    powers.*kind += local_product(forces, of_velocity);
    if (momentum != nullptr)
      momentum->add(1., forces);
  };
  const auto for_each_face = [&](const auto &visit)
  {
    for (const Face &face : faces)
      if (face.region == region)
        visit(face);
  };
  add_kind(
      &NonlinearPowers::convection, [&]()
      { for_each_face([&](const Face &face) { add_fluxes(face, flow(face), forces, nullptr); }); });
  add_kind(&NonlinearPowers::inflow,
           [&]()
           {
             for_each_face(
                 [&](const Face &face)
                 {
                   if (face.inflow_row != VolumeFace<dim>::none)
                     add_inflow(face, flow(face), forces);
                 });
           });
  add_kind(&NonlinearPowers::inertia,
           [&]()
           {
             for (unsigned int cell = 0; cell < system.space.mesh.n_owned_cells(); ++cell)
               if (system.space.mesh.cells()[cell].material_id == region)
                 add_inertia(cell, state, forces);
           });
}

template <int dim>
void CellWiseConvection<dim>::add_derivative(
    const StepSolution &state,
    const typename CellWiseSystem<dim>::AddEntry &momentum_row,
    const typename CellWiseSystem<dim>::AddEntry &volume_row)
{
  take(state);
  const CellWiseSpace<dim> &space = system.space;
  const auto velocity_column = [&](const unsigned int value, const unsigned int c)
  { return static_cast<int>(dim * value + c); };
  const auto pressure_column = [&](const unsigned int value)
  { return static_cast<int>(system.n_velocities() + value); };

  for (const Face &face : faces)
  {
    const Flow on_face = flow(face);
    const VolumeFace<dim> &surface = space.mesh.faces()[face.face];
    const Material &material = system.problem.materials[face.region];
    const VolumeLaw law = material.volume_law();
    // Adds factor times the derivative of the normal velocity to a row.
    const auto add_normal_velocity = [&](const typename CellWiseSystem<dim>::AddEntry &add,
                                         const unsigned int row, const double factor)
    {
      for (const auto &[value, coefficient] : face.velocity)
        for (unsigned int d = 0; d < dim; ++d)
          if (surface.normal[d] != 0.)
            add(row, velocity_column(value, d), factor * coefficient * surface.normal[d]);
      if (on_face.mobility > 0.)
        for (const auto &[value, coefficient] : face.difference)
          add(row, pressure_column(value), -factor * on_face.mobility * coefficient);
    };
    for (unsigned int side = face.first_side; side < face.end_side; ++side)
    {
      const unsigned int cell = surface.cell(side);
      if (!space.mesh.cells()[cell].is_owned)
        continue;
      const double area = (side == 0 ? 1. : -1.) * surface.area;
      const double leaving = (side == 0 ? 1. : -1.) * on_face.outflow;
      const Tensor<1, dim> jump = on_face.value - velocity_of(cell);
      const unsigned int value_of_cell = space.velocities.of_cell(cell);
      const unsigned int row = space.local_velocity(value_of_cell);
      for (unsigned int c = 0; c < dim; ++c)
      {
        if (surface.undeformed_side == VolumeFace<dim>::none)
          add_normal_velocity(momentum_row, row + c, area * on_face.density * jump[c]);
        for (const auto &[value, coefficient] : on_face.velocity)
          momentum_row(row + c, velocity_column(value, c), leaving * on_face.density * coefficient);
        momentum_row(row + c, velocity_column(value_of_cell, c), -leaving * on_face.density);
        if (on_face.density_slope != 0.)
          for (const auto &[value, coefficient] : on_face.pressure)
            momentum_row(row + c, pressure_column(value),
                         leaving * on_face.density_slope * jump[c] * coefficient);
      }
      if (law.inverse_bulk_modulus == 0.)
        continue;
      const double at = pressure_of(cell);
      const double ratio = on_face.density / (material.density * law.density_ratio(at));
      const unsigned int value_of_pressure = space.pressures.of_cell(cell);
      const unsigned int volume = space.local_pressure(value_of_pressure);
      if (surface.undeformed_side == VolumeFace<dim>::none)
        add_normal_velocity(volume_row, volume, area * (ratio - 1.));
      for (const auto &[value, coefficient] : on_face.pressure)
        volume_row(volume, pressure_column(value),
                   leaving * ratio * on_face.density_slope / on_face.density * coefficient);
      volume_row(volume, pressure_column(value_of_pressure),
                 -leaving * ratio * law.compressibility(at));
    }
    const double entering = inflow(face, on_face);
    if (face.inflow_row == VolumeFace<dim>::none || entering >= 0.)
      continue;
    const double half = -0.5 * face.weight;
    for (unsigned int c = 0; c < dim; ++c)
    {
      const unsigned int row = face.inflow_row + c;
      add_normal_velocity(momentum_row, row, half * on_face.density * on_face.value[c]);
      for (const auto &[value, coefficient] : on_face.velocity)
        momentum_row(row, velocity_column(value, c),
                     half * on_face.density * entering * coefficient);
      for (const auto &[value, coefficient] : on_face.pressure)
        momentum_row(row, pressure_column(value),
                     half * on_face.density_slope * entering * on_face.value[c] * coefficient);
    }
  }

  for (unsigned int cell = 0; cell < space.mesh.n_owned_cells(); ++cell)
  {
    const FiniteVolume<dim> &here = space.mesh.cells()[cell];
    const Material &material = system.problem.materials[here.material_id];
    const VolumeLaw law = material.volume_law();
    if (!has_terms(here.material_id) ||
        (law.inverse_bulk_modulus == 0. && !swept_volumes.moves(cell)))
      continue;
    const unsigned int value = space.velocities.of_cell(cell);
    const unsigned int value_of_pressure = space.pressures.of_cell(cell);
    const unsigned int row = space.local_velocity(value);
    const unsigned int volume = space.local_pressure(value_of_pressure);
    const double at = pressure_of(cell);
    const double density = material.density * law.density_ratio(at);
    const double growth_of_rate = !swept_volumes.moves(cell)
                                      ? 0.
                                      : state.step.a1 * (swept_volumes.growth(cell) -
                                                         swept_volumes.growth_since_older(cell)) -
                                            swept_volumes.growth_since_older(cell) * state.step.a0;
    for (unsigned int c = 0; c < dim; ++c)
    {
      momentum_row(row + c, velocity_column(value, c),
                   here.volume * (density - material.density) * state.step.a0 +
                       density * growth_of_rate);
      if (law.inverse_bulk_modulus > 0.)
        momentum_row(row + c, pressure_column(value_of_pressure),
                     density * law.compressibility(at) *
                         (here.volume * state.acceleration.begin()[row + c] +
                          growth_term(cell, state, row + c)));
    }
    if (law.inverse_bulk_modulus == 0.)
      continue;
    volume_row(volume, pressure_column(value_of_pressure),
               here.volume * ((law.compressibility(at) - law.inverse_bulk_modulus) /
                                  state.step.pressure_time +
                              law.compressibility_slope(at) * state.pressure_rate.begin()[volume]));
  }
}

template <int dim>
NonlinearEnergy CellWiseConvection<dim>::energy_of(const unsigned int region,
                                                   const DistributedVector &of_velocity,
                                                   const DistributedVector &of_pressure) const
{
  return energy_of_liquid(system.space, system.problem, region, of_velocity, of_pressure);
}

template class CellWiseConvection<2>;
template class CellWiseConvection<3>;
} // namespace Continua
