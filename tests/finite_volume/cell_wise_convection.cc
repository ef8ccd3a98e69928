// Convection of the cell-wise path: that the derivative is that of the terms, by differences; that
// a uniform flow is not changed; that fluxes carry momentum from one cell to the next; what their
// power is with central interpolation; and that upwinding dissipates.

#include <continua/continuum/state_vectors.h>
#include <continua/finite_volume/cell_wise_convection.h>

#include "cell_wise_step.h"

#include "../unit_test.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace test_of_cell_wise_convection
{
namespace
{
using namespace cell_wise_meshes;

std::string convection_in(const Model model)
{
  return model == Model::axisymmetric   ? "axisymmetric: "
         : model == Model::plane_strain ? "2-D: "
                                        : "3-D: ";
}

template <int dim>
struct Stream
{
  /// `change`: of the problem, in which all is a liquid of density 1.3 and the exponent 3, and the
  /// ends along x are open with the total pressure.
  Stream(
      const std::function<void(Triangulation<dim> &)> &make_mesh,
      const Model model,
      const CellWiseParameters &parameters,
      const std::function<void(Problem &)> &change = [](Problem &) {})
      : body(
            [&](Triangulation<dim> &mesh)
            {
              make_mesh(mesh);
              for (const auto &cell : mesh.active_cell_iterators())
                cell->set_material_id(1);
            },
            model,
            coefficients(),
            [&](Problem &problem)
            {
              Material &liquid = problem.materials[1];
              liquid.density = 1.3;
              liquid.compression = Compression::elastic(0.5);
              liquid.volume_exponent = 3.;
              for (unsigned int end = 0; end < 2; ++end)
              {
                set_free(problem.conditions[end]);
                problem.conditions[end].inflow_pressure = InflowPressure::total;
              }
              problem.convection.is_on = true;
              change(problem);
            },
            parameters),
        reconstruction(body.space, body.problem),
        excess(body.system, reconstruction),
        swept_volumes(body.space.mesh),
        convection(body.system, excess, reconstruction, swept_volumes)
  {
    reconstruction.build();
    excess.reinit();
    swept_volumes.reset();
    convection.reinit();
    const CellWiseSpace<dim> &space = body.space;
    state.step = euler_step(0., 0.2, Update::implicit);
    state.velocity = velocity_field<dim>(space,
                                         [](const dealii::Point<dim> &p)
                                         {
                                           dealii::Tensor<1, dim> u;
                                           for (unsigned int c = 0; c < dim; ++c)
                                             u[c] = 0.2 + std::sin(3. * p[c] + c) + 0.3 * p[0];
                                           return u;
                                         });
    state.pressure = pressure_field<dim>(space, [](const dealii::Point<dim> &p, const unsigned int)
                                         { return 0.2 * std::cos(4. * p[0]) + 0.1 * p[1]; });
    set_rates();
  }
  static CellWiseCoefficients coefficients()
  {
    CellWiseCoefficients result = make_coefficients();
    result.mass = {1.3 / 0.2, 1.3 / 0.2};
    return result;
  }
  /// As a step from a velocity of 1/2 and a pressure of 0.1 would have them.
  void set_rates()
  {
    state.acceleration = state.velocity;
    state.acceleration.add(-0.5);
    state.acceleration *= state.step.a0;
    state.pressure_rate = state.pressure;
    state.pressure_rate.add(-0.1);
    state.pressure_rate *= 1. / state.step.pressure_time;
  }
  std::pair<DistributedVector, DistributedVector> terms()
  {
    set_rates();
    std::pair<DistributedVector, DistributedVector> rows(body.space.velocity_vector(),
                                                         body.space.pressure_vector());
    convection.add(state, rows.first, rows.second);
    return rows;
  }

  CellWiseStep<dim> body;
  LinearReconstruction<dim> reconstruction;
  ExcessVelocity<dim> excess;
  SweptVolumes<dim> swept_volumes;
  CellWiseConvection<dim> convection;
  StepSolution state;
};

/// Moves all vertices twice, by steps of two sizes; returns the volumes of the cells at the three
/// levels, the present one first. The state has a step from a velocity of 1/2, which is all that is
/// known of its past.
template <int dim>
std::array<std::vector<double>, 3> move_mesh(Stream<dim> &stream)
{
  CellWiseStep<dim> &body = stream.body;
  std::array<VertexPlaces<dim>, 3> places;
  std::array<std::vector<double>, 3> volumes;
  const std::vector<bool> all = {true, true};
  for (const unsigned int level : {2, 1, 0})
  {
    const double time = level == 2 ? 0. : level == 1 ? 0.3 : 1.;
    places[level] = body.triangulation.get_vertices();
    for (dealii::Point<dim> &p : places[level])
    {
      const dealii::Point<dim> undeformed = p;
      for (unsigned int c = 0; c < dim; ++c)
        p[c] += 0.15 * time * undeformed[c] * std::sin(4. * undeformed[0] + 3. * undeformed[1] - c);
    }
    body.space.move(places[level], all);
    for (unsigned int cell = 0; cell < body.space.mesh.n_owned_cells(); ++cell)
      volumes[level].push_back(body.space.mesh.cells()[cell].volume);
  }
  body.conditions.take_shapes();
  assemble_cell_operators(body.space, body.problem, body.conditions, body.parameters, all,
                          body.operators, body.closure);
  body.system.remeasure();
  stream.state.step = backward_differencing_step(0.3, 0.7, 0.3, Update::implicit);
  stream.swept_volumes.measure(stream.state.step, places[2], places[1], places[0], all);
  stream.reconstruction.build();
  stream.excess.reinit();
  stream.convection.reinit();
  DistributedVector before = body.space.velocity_vector();
  before = 0.5;
  stream.convection.begin_step(before);
  return volumes;
}

CellWiseParameters blended(const double factor)
{
  CellWiseParameters parameters;
  parameters.convective_interpolation = ConvectiveInterpolation::blended;
  parameters.blending_factor = factor;
  return parameters;
}

template <int dim>
void check_derivative(const Model model, const bool moves = false)
{
  Stream<dim> stream(
      [](Triangulation<dim> &mesh)
      {
        make_box(mesh, 4);
        refine_corner(mesh);
      },
      model, blended(0.6));
  if (moves)
    move_mesh(stream);
  const CellWiseSpace<dim> &space = stream.body.space;
  DistributedVector velocity_change = space.velocity_vector(),
                    pressure_change = space.pressure_vector();
  fill_at_random(velocity_change, 1);
  fill_at_random(pressure_change, 2);
  const std::vector<double> change = all_unknowns<dim>(space, velocity_change, pressure_change);
  DistributedVector momentum = space.velocity_vector(), volume = space.pressure_vector();
  stream.set_rates();
  stream.convection.add_derivative(
      stream.state,
      [&](const unsigned int row, const int column, const double value)
      { momentum.begin()[row] += value * change[column]; },
      [&](const unsigned int row, const int column, const double value)
      { volume.begin()[row] += value * change[column]; });
  const double size = 1e-5;
  const auto moved = [&](const double factor)
  {
    stream.state.velocity.add(factor, velocity_change);
    stream.state.pressure.add(factor, pressure_change);
  };
  moved(size);
  const auto after = stream.terms();
  moved(-2. * size);
  const auto before = stream.terms();
  const auto compare = [&](const std::string &name, const DistributedVector &derivative,
                           const DistributedVector &plus, const DistributedVector &minus)
  {
    DistributedVector difference = derivative;
    difference.add(-0.5 / size, plus, 0.5 / size, minus);
    check::absolute(convection_in(model) + "derivative of " + name +
                        (moves ? " on a mesh that moves" : ""),
                    difference.linfty_norm() / derivative.linfty_norm(), 0., 1e-7);
  };
  compare("momentum", momentum, after.first, before.first);
  compare("volume", volume, after.second, before.second);
}

/// What the fluxes take from the cells, their first rows, and inflow at open ends.
template <int dim>
DistributedVector carrying_forces(Stream<dim> &stream)
{
  DistributedVector forces = stream.body.space.velocity_vector();
  NonlinearPowers powers;
  stream.convection.add_powers(1, stream.state, stream.state.velocity, TermsTaken::carrying, powers,
                               &forces);
  return forces;
}

/// A uniform velocity and pressure leave nothing but rates, on any mesh; the sum of what the fluxes
/// take from the cells is what leaves through the boundary.
template <int dim>
void check_conservation(const Model model)
{
  Stream<dim> stream(
      [](Triangulation<dim> &mesh)
      {
        make_box(mesh, 4);
        refine_corner(mesh);
      },
      model, blended(0.3), [](Problem &problem) { problem.materials[1].volume_exponent = 0.; });
  const CellWiseSpace<dim> &space = stream.body.space;

  // rho U U.n A at the boundary less U_P times what leaves the cell.
  const DistributedVector convection = carrying_forces(stream);
  const VolumeLaw law = stream.body.problem.materials[1].volume_law();
  dealii::Tensor<1, dim> taken, left;
  double size = 0.;
  DistributedVector mass = space.pressure_vector(), nothing = mass, momentum;
  momentum.reinit(convection);
  stream.convection.add(stream.state, stream.state.acceleration, mass);
  stream.set_rates();
  stream.body.system.multiply(stream.state.velocity, stream.state.pressure, momentum, nothing);
  mass.add(1., nothing);
  for (unsigned int cell = 0; cell < space.mesh.n_owned_cells(); ++cell)
  {
    const auto &here = space.mesh.cells()[cell];
    const unsigned int row = stream.body.cell_row(cell),
                       pressure_row = stream.body.cell_pressure_row(cell);
    const double density = 1.3 * law.density_ratio(stream.state.pressure.begin()[pressure_row]);
    // rho_P times (c dp/dt V + sum of u_f A_f rho_f/rho_P), without the first, where what the
    // linear part has of p_plus is not.
    const double flux =
        density * (mass.begin()[pressure_row] -
                   here.volume * (0.25 * stream.state.pressure.begin()[pressure_row]));
    for (unsigned int c = 0; c < dim; ++c)
      taken[c] += convection.begin()[row + c] + stream.state.velocity.begin()[row + c] * flux;
  }
  for (const auto &face : stream.body.conditions.faces())
  {
    const auto &surface = space.mesh.faces()[face.face];
    const double p =
        stream.state.pressure.begin()[space.local_pressure(space.pressures.of_face(face.face, 0))];
    dealii::Tensor<1, dim> u;
    for (unsigned int c = 0; c < dim; ++c)
      u[c] = stream.state.velocity.begin()[face.index + c];
    const double flux = 1.3 * law.density_ratio(p) * surface.area * (u * surface.normal);
    left += flux * u;
    size += std::abs(flux) * u.norm();
  }
  for (unsigned int c = 0; c < dim; ++c)
    taken[c] = sum(taken[c] - left[c]);
  check::absolute(convection_in(model) + "momentum is carried on", taken.norm() / sum(size), 0.,
                  1e-12);

  dealii::Tensor<1, dim> uniform;
  uniform[0] = 2.;
  if (model != Model::axisymmetric)
    uniform[1] = -1.;
  stream.state.velocity =
      velocity_field<dim>(space, [&](const dealii::Point<dim> &) { return uniform; });
  stream.state.pressure = pressure_field<dim>(
      space, [](const dealii::Point<dim> &, const unsigned int) { return 0.3; });
  const DistributedVector of_uniform = carrying_forces(stream);
  double largest = 0.;
  for (unsigned int i = 0; i < dim * space.mesh.n_owned_cells(); ++i)
    largest = std::max(largest, std::abs(of_uniform.begin()[i]));
  check::absolute(convection_in(model) + "a uniform flow stays", largest, 0., 1e-13);
}

/// The rate of all momentum on a mesh that moves is that of the volumes at the levels of the step:
/// nothing is lost between the cells. With the swept volumes of a single step, or rates of another
/// formula, it does not hold.
template <int dim>
void check_momentum_on_moving_mesh(const Model model)
{
  Stream<dim> stream(
      [](Triangulation<dim> &mesh)
      {
        make_box(mesh, 4);
        refine_corner(mesh);
      },
      model, blended(0.3),
      [](Problem &problem) { problem.materials[1].compression = Compression::elastic(0.); });
  const std::array<std::vector<double>, 3> volumes = move_mesh(stream);
  const CellWiseSpace<dim> &space = stream.body.space;
  const Step &step = stream.state.step;
  DistributedVector old = space.velocity_vector(), older = old;
  fill_at_random(old, 3);
  fill_at_random(older, 4);
  stream.convection.begin_step(old);
  stream.state.acceleration.equ(step.a0, stream.state.velocity);
  stream.state.acceleration.add(step.a1, old, step.a2, older);
  DistributedVector momentum = space.velocity_vector(), volume = space.pressure_vector(),
                    fluxes = volume, unused = momentum;
  stream.convection.add(stream.state, momentum, volume);
  stream.body.system.multiply(stream.state.velocity, stream.state.pressure, unused, fluxes);
  dealii::Tensor<1, dim> sum_of_terms, expected;
  double size = 0.;
  for (unsigned int cell = 0; cell < space.mesh.n_owned_cells(); ++cell)
  {
    const unsigned int row = stream.body.cell_row(cell),
                       pressure_row = stream.body.cell_pressure_row(cell);
    // make_coefficients() has a compressibility, which the equation of volume leaves out here.
    const double flux = fluxes.begin()[pressure_row] -
                        0.25 * volumes[0][cell] * stream.state.pressure.begin()[pressure_row];
    for (unsigned int c = 0; c < dim; ++c)
    {
      const double u = stream.state.velocity.begin()[row + c];
      sum_of_terms[c] += 1.3 * volumes[0][cell] * stream.state.acceleration.begin()[row + c] +
                         momentum.begin()[row + c] + 1.3 * u * flux;
      expected[c] += 1.3 * (step.a0 * volumes[0][cell] * u +
                            step.a1 * volumes[1][cell] * old.begin()[row + c] +
                            step.a2 * volumes[2][cell] * older.begin()[row + c]);
      size += std::abs(1.3 * volumes[0][cell] * stream.state.acceleration.begin()[row + c]);
    }
  }
  for (const auto &face : stream.body.conditions.faces())
  {
    const auto &surface = space.mesh.faces()[face.face];
    dealii::Tensor<1, dim> u;
    for (unsigned int c = 0; c < dim; ++c)
      u[c] = stream.state.velocity.begin()[face.index + c];
    const double outflow =
        surface.area * (u * surface.normal) - stream.swept_volumes.rate(face.face);
    expected += 1.3 * outflow * u;
  }
  // The balances of open ends are no momentum of cells.
  for (unsigned int c = 0; c < dim; ++c)
    sum_of_terms[c] = sum(sum_of_terms[c] - expected[c]);
  check::absolute(convection_in(model) + "momentum is conserved on a mesh that moves",
                  sum_of_terms.norm() / sum(size), 0., 1e-12);
}

/// Central interpolation on a uniform mesh between walls: sum of U_P . F_P = -1/2 sum of U_P^2
/// times the mass that leaves P. Upwinding takes more.
template <int dim>
void check_power(const Model model)
{
  for (const double factor : {1., 0.})
  {
    Stream<dim> stream([](Triangulation<dim> &mesh) { make_uniform_box(mesh, dim == 2 ? 8 : 4); },
                       model, blended(factor),
                       [](Problem &problem)
                       { problem.materials[1].compression = Compression::elastic(0.); });
    const CellWiseSpace<dim> &space = stream.body.space;
    for (unsigned int i = dim * space.mesh.n_owned_cells();
         i < stream.state.velocity.locally_owned_size(); ++i)
      stream.state.velocity.begin()[i] = 0.;
    NonlinearPowers powers;
    stream.convection.add_powers(1, stream.state, stream.state.velocity, TermsTaken::carrying,
                                 powers, nullptr);
    DistributedVector momentum = space.velocity_vector(), mass = space.pressure_vector();
    stream.body.system.multiply(stream.state.velocity, stream.state.pressure, momentum, mass);
    double expected = 0., size = 0.;
    for (unsigned int cell = 0; cell < space.mesh.n_owned_cells(); ++cell)
    {
      const unsigned int row = stream.body.cell_row(cell),
                         pressure_row = stream.body.cell_pressure_row(cell);
      const double leaving =
          1.3 * (mass.begin()[pressure_row] - 0.25 * space.mesh.cells()[cell].volume *
                                                  stream.state.pressure.begin()[pressure_row]);
      double square = 0.;
      for (unsigned int c = 0; c < dim; ++c)
      {
        const double u = stream.state.velocity.begin()[row + c];
        square += u * u;
      }
      expected -= 0.5 * leaving * square;
      size += std::abs(leaving) * square;
    }
    const double power = sum(powers.convection);
    expected = sum(expected);
    size = sum(size);
    if (factor == 1.)
      check::absolute(convection_in(model) + "power, central", (power - expected) / size, 0.,
                      1e-13);
    else
      check::is_true(convection_in(model) + "power, upwind", power > expected + 1e-3 * size);
  }
}
} // namespace

UNIT_TEST(cell_wise_convection)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  quiet_other_ranks();
  check_derivative<2>(Model::plane_strain);
  check_derivative<2>(Model::axisymmetric);
  check_derivative<3>(Model::three_dimensional);
  check_conservation<2>(Model::plane_strain);
  check_conservation<2>(Model::axisymmetric);
  check_conservation<3>(Model::three_dimensional);
  check_derivative<2>(Model::plane_strain, true);
  check_derivative<2>(Model::axisymmetric, true);
  check_momentum_on_moving_mesh<2>(Model::plane_strain);
  check_momentum_on_moving_mesh<2>(Model::axisymmetric);
  check_momentum_on_moving_mesh<3>(Model::three_dimensional);
  check_power<2>(Model::plane_strain);
  check_power<3>(Model::three_dimensional);
}
} // namespace test_of_cell_wise_convection
