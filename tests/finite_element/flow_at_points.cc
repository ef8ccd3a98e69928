// The terms of a liquid for several points at a time, with each set of instructions that this
// processor has, against the same terms at one point after the other, whose state is made here:
// numbers of points that no set divides, liquids with and without compressibility and flow curve,
// a mesh that moves, and powers by kind.

#include <continua/finite_element/assembly/flow_at_points.h>
#include <continua/finite_element/terms/flow_terms.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "../unit_test.h"
#include "numbers_of_cell.h"

namespace test_of_flow_at_points
{
using namespace Continua;
using namespace dealii;
using numbers_of_cell::distance;
using numbers_of_cell::Field;
using numbers_of_cell::numbers;

namespace
{
/// A cell with its numbers.
template <int dim>
struct Cell
{
  Field velocity, acceleration, pressure, pressure_rate, mesh_velocity, of_powers;
  std::vector<CellPoint<dim>> geometry;
  FlowAtPoints<dim> flow;

  Cell(const unsigned int n_points, const bool mesh_moves)
      : velocity(n_points, dim, 0.1),
        acceleration(n_points, dim, 0.9),
        pressure(n_points, 1, 0.4),
        pressure_rate(n_points, 1, 1.3),
        mesh_velocity(n_points, dim, 2.2),
        of_powers(n_points, dim, 3.1),
        geometry(n_points)
  {
    const std::vector<double> any = numbers((2 + dim * dim) * n_points, 5.3);
    auto next = any.begin();
    for (CellPoint<dim> &point : geometry)
    {
      point.weight = 1.5 + *next++;
      point.hoop = dim == 2 ? 1.2 + *next++ : 0.;
      for (unsigned int d = 0; d < dim; ++d)
        for (unsigned int e = 0; e < dim; ++e)
          point.inverse_jacobian[d][e] = *next++;
    }
    flow.n_points = n_points;
    flow.geometry = geometry.data();
    flow.scheme.carries = 1.;
    flow.scheme.skew = 0.5;
    flow.scheme.grad_div_viscosity = 0.3;
    flow.density = 1.7;
    flow.viscosity = 0.6;
    flow.grad_div_over_speed = 0.8;
    flow.velocity = velocity.view();
    flow.acceleration = acceleration.view();
    flow.pressure = pressure.view();
    flow.pressure_rate = pressure_rate.view();
    if (mesh_moves)
      flow.mesh_velocity = mesh_velocity.view();
  }

  bool has_pressure_gradient() const { return flow.volume_law.inverse_bulk_modulus != 0.; }
  FlowPoint<dim> point(const unsigned int q) const
  {
    FlowPoint<dim> result;
    result.scheme = flow.scheme;
    result.hoop = geometry[q].hoop;
    result.velocity = velocity.value<dim>(q);
    result.acceleration = acceleration.value<dim>(q);
    result.carrier = result.velocity;
    if (flow.mesh_velocity.values != nullptr)
      result.carrier -= mesh_velocity.value<dim>(q);
    for (unsigned int c = 0; c < dim; ++c)
      result.velocity_gradient[c] = velocity.gradient<dim>(c, q, geometry[q].inverse_jacobian);
    result.pressure = pressure.at(0, 0, q);
    result.pressure_rate = pressure_rate.at(0, 0, q);
    result.pressure_gradient = pressure.gradient<dim>(0, q, geometry[q].inverse_jacobian);
    result.density = flow.density * flow.volume_law.density_ratio(result.pressure);
    result.compressibility = flow.volume_law.compressibility(result.pressure);
    result.compressibility_slope = flow.volume_law.compressibility_slope(result.pressure);
    result.grad_div_over_speed = flow.grad_div_over_speed;
    result.set_strain_rate();
    result.viscosity = flow.flow_curve != nullptr ? flow.flow_curve->viscosity(result.shear_rate())
                                                  : flow.viscosity;
    if (flow.flow_curve != nullptr)
      result.viscosity_slope = flow.flow_curve->slope_over_rate(result.shear_rate());
    result.finish();
    return result;
  }
};

/// Rows that terms have set, and what stands beside them.
template <int dim>
struct Result
{
  std::size_t component_size;
  std::vector<double> momentum, volume, derivative;
  NonlinearPowers powers;
  double least_stiffening = 0.;

  explicit Result(const unsigned int n_points)
      : component_size((dim + 1) * n_points + 2),
        momentum(dim * component_size, 0.),
        volume(n_points, 0.)
  {
  }
};

template <int dim>
void add_derivative(const FlowPoint<dim> &point,
                    const CellPoint<dim> &geometry,
                    const bool has_pressure_gradient,
                    std::vector<double> &derivative)
{
  const auto add = [&](const PointChange<dim> &change)
  {
    Tested<dim> tested;
    FlowTerms::add_derivative(point, FlowChange<dim>(point, change), tested);
    for (unsigned int c = 0; c < dim; ++c)
    {
      derivative.push_back(geometry.weight * tested.by_value[c]);
      for (unsigned int s = 0; s < dim; ++s)
        derivative.push_back(geometry.weight *
                             (geometry.inverse_jacobian[s] * tested.by_gradient[c]));
    }
    derivative.push_back(geometry.weight * tested.of_volume);
  };
  for (unsigned int d = 0; d < dim; ++d)
    for (unsigned int k = 0; k <= dim; ++k)
    {
      PointChange<dim> change;
      if (k == 0)
        change.velocity[d] = 1.;
      else
        change.velocity_gradient[d] = geometry.inverse_jacobian[k - 1];
      add(change);
    }
  for (unsigned int k = 0; k <= (has_pressure_gradient ? dim : 0); ++k)
  {
    PointChange<dim> change;
    if (k == 0)
      change.pressure = 1.;
    else
      change.pressure_gradient = geometry.inverse_jacobian[k - 1];
    add(change);
  }
}

/// One point after the other.
template <int dim>
Result<dim> expected_of(const Cell<dim> &cell, const TermsTaken *const taken)
{
  const unsigned int n_points = cell.flow.n_points;
  Result<dim> result(n_points);
  result.least_stiffening = 1.;
  for (unsigned int q = 0; q < n_points; ++q)
  {
    const CellPoint<dim> &geometry = cell.geometry[q];
    const FlowPoint<dim> point = cell.point(q);
    result.least_stiffening =
        std::min(result.least_stiffening, cell.flow.volume_law.stiffening(point.pressure));
    Tested<dim> sum;
    if (taken == nullptr)
      FlowTerms::add(point, sum);
    else
      FlowTerms::for_each(
          [&](const auto term)
          {
            const PowerKind kind = decltype(term)::power;
            if (kind == nullptr || !takes_terms_of(*taken, kind))
              return;
            Tested<dim> tested;
            term.add(point, tested);
            double power = tested.by_value * cell.of_powers.template value<dim>(q);
            for (unsigned int c = 0; c < dim; ++c)
              power += tested.by_gradient[c] *
                       cell.of_powers.template gradient<dim>(c, q, geometry.inverse_jacobian);
            result.powers.*kind += geometry.weight * power;
            sum += tested;
          });
    for (unsigned int c = 0; c < dim; ++c)
    {
      double *const of_component = &result.momentum[c * result.component_size + q];
      of_component[0] = geometry.weight * sum.by_value[c];
      for (unsigned int s = 0; s < dim; ++s)
        of_component[(s + 1) * n_points] =
            geometry.weight * (geometry.inverse_jacobian[s] * sum.by_gradient[c]);
    }
    result.volume[q] = geometry.weight * sum.of_volume;
    add_derivative(point, geometry, cell.has_pressure_gradient(), result.derivative);
  }
  return result;
}

template <int dim>
void compare(const std::string &name, const Cell<dim> &cell, const TermsTaken *const taken)
{
  const Result<dim> expected = expected_of(cell, taken);
  for (const InstructionSet wanted :
       {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512})
  {
    // What this processor lacks is as good as what it has: the answer must not depend on it.
    const InstructionSet set = can_run(wanted) ? wanted : InstructionSet::baseline;
    Result<dim> result(cell.flow.n_points);
    const PowersAtPoints asked{cell.of_powers.view(), taken != nullptr ? *taken : TermsTaken::all,
                               result.powers};
    const FlowTermsAtPoints<dim> terms = flow_terms_of<dim>(set);
    result.derivative.assign(expected.derivative.size(), 0.);
    terms.set_derivative(cell.flow, cell.has_pressure_gradient(), result.derivative.data());
    result.least_stiffening =
        terms.set(cell.flow, taken != nullptr ? &asked : nullptr,
                  {{result.momentum.data(), result.component_size}, result.volume.data()});
    const NonlinearPowers &powers = result.powers, &of_expected = expected.powers;
    double of_powers = 0.;
    for (const PowerKind kind :
         {&NonlinearPowers::inertia, &NonlinearPowers::convection, &NonlinearPowers::stabilisation,
          &NonlinearPowers::viscosity, &NonlinearPowers::compression})
      of_powers = std::max(of_powers, std::abs(powers.*kind - of_expected.*kind));
    const std::string of_set = name + ", " + word_of(instruction_set_words(), wanted);
    check::absolute(of_set + ": momentum", distance(result.momentum, expected.momentum), 0., 1e-12);
    check::absolute(of_set + ": volume", distance(result.volume, expected.volume), 0., 1e-12);
    check::absolute(of_set + ": derivative", distance(result.derivative, expected.derivative), 0.,
                    1e-11);
    check::absolute(of_set + ": powers", of_powers, 0., 1e-12);
    check::absolute(of_set + ": stiffening", result.least_stiffening, expected.least_stiffening,
                    1e-14);
  }
}

template <int dim>
void check_cells(const std::string &name)
{
  const TermsTaken all = TermsTaken::all, carrying = TermsTaken::carrying;
  compare(name + ", incompressible", Cell<dim>(16, false), nullptr);
  Cell<dim> gas(11, true);
  gas.flow.volume_law = {0.05, 7.15, 0.3};
  const FlowCurve curve{2., 0.3, 0.8, 0.4, 1.5};
  gas.flow.flow_curve = &curve;
  compare(name + ", gas on a mesh that moves", gas, nullptr);
  compare(name + ", its powers", gas, &all);
  compare(name + ", powers of what carries", gas, &carrying);
}
} // namespace

UNIT_TEST(flow_at_points)
{
  check_cells<2>("plane");
  check_cells<3>("in space");
}
} // namespace test_of_flow_at_points
