// The terms of a liquid at a point: each derivative against differences, with laws of the density
// and of the viscosity; several points at once against one; the power of inertia and convection
// against the energy.

#include <continua/finite_element/terms/flow_terms.h>
#include <continua/materials/flow_curve.h>
#include <continua/materials/volume_law.h>

#include <deal.II/base/vectorization.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "../unit_test.h"

namespace test_of_flow_terms
{
using namespace Continua;
using namespace dealii;

namespace
{
const std::array<const char *, StreamlineFlowTerms::size> names = {
    {"inertia", "convection", "grad-div", "viscosity", "pressure", "volume", "streamline"}};
const VolumeLaw volume_law{0.2, 1.5, 0.1};
const FlowCurve curve{2., 0.3, 0.8, 0.4, 1.5};
constexpr double cell_size = 0.7, kinematic_scale = 1.9;

/// What a change of the unknowns changes, and what it leaves.
template <int dim>
struct Flow
{
  FlowScheme scheme;
  double hoop = 0.;
  PointChange<dim> unknowns;
  Tensor<1, dim> mesh_velocity, acceleration_rest, body_force;
  double pressure_rate_rest = 0.;
};

template <int dim>
Tensor<1, dim> random_vector(std::mt19937 &random)
{
  Tensor<1, dim> result;
  for (unsigned int c = 0; c < dim; ++c)
    result[c] = static_cast<double>(random()) / 2147483647.5 - 1.;
  return result;
}

template <int dim>
PointChange<dim> random_change(std::mt19937 &random)
{
  PointChange<dim> result;
  result.velocity = random_vector<dim>(random);
  for (unsigned int c = 0; c < dim; ++c)
    result.velocity_gradient[c] = random_vector<dim>(random);
  result.pressure = random_vector<1>(random)[0];
  result.pressure_gradient = random_vector<dim>(random);
  result.viscous_force = random_vector<dim>(random);
  return result;
}

template <int dim>
Flow<dim> random_flow(std::mt19937 &random)
{
  Flow<dim> flow;
  flow.scheme.skew = 0.5;
  flow.scheme.grad_div_viscosity = 0.6;
  flow.scheme.rate_by_velocity = 1.4;
  flow.scheme.pressure_rate_by_pressure = 2.3;
  flow.hoop = dim == 2 ? 0.8 : 0.;
  flow.unknowns = random_change<dim>(random);
  flow.mesh_velocity = random_vector<dim>(random);
  flow.acceleration_rest = random_vector<dim>(random);
  flow.body_force = random_vector<dim>(random);
  flow.pressure_rate_rest = 0.4;
  return flow;
}

template <int dim>
Flow<dim> changed(Flow<dim> flow, const PointChange<dim> &change, const double factor)
{
  flow.unknowns.velocity += factor * change.velocity;
  flow.unknowns.velocity_gradient += factor * change.velocity_gradient;
  flow.unknowns.pressure += factor * change.pressure;
  flow.unknowns.pressure_gradient += factor * change.pressure_gradient;
  flow.unknowns.viscous_force += factor * change.viscous_force;
  return flow;
}

template <int dim>
StreamlinePoint<dim> point_of(const Flow<dim> &flow)
{
  const PointChange<dim> &unknowns = flow.unknowns;
  StreamlinePoint<dim> point;
  point.scheme = flow.scheme;
  point.hoop = flow.hoop;
  point.velocity = unknowns.velocity;
  point.acceleration = flow.acceleration_rest + flow.scheme.rate_by_velocity * unknowns.velocity;
  point.carrier = flow.scheme.carries * unknowns.velocity - flow.mesh_velocity;
  point.velocity_gradient = unknowns.velocity_gradient;
  point.pressure = unknowns.pressure;
  point.pressure_rate =
      flow.pressure_rate_rest + flow.scheme.pressure_rate_by_pressure * unknowns.pressure;
  point.pressure_gradient = unknowns.pressure_gradient;
  point.set_strain_rate();
  point.density = 3. * volume_law.density_ratio(point.pressure);
  point.compressibility = volume_law.compressibility(point.pressure);
  point.compressibility_slope = volume_law.compressibility_slope(point.pressure);
  point.viscosity = curve.viscosity(point.shear_rate());
  point.viscosity_slope = curve.slope_over_rate(point.shear_rate());
  point.grad_div_over_speed = 0.9;
  point.finish();
  point.viscous_force = unknowns.viscous_force;
  point.body_force = flow.body_force;
  const double by_flow = 2. * point.carrier.norm() / cell_size;
  point.time_scale = 1. / std::sqrt(kinematic_scale + by_flow * by_flow);
  point.time_scale_slope = -4. * std::pow(point.time_scale, 3) / (cell_size * cell_size);
  return point;
}

/// All entries of what is tested, one after the other.
template <int dim, typename Number>
std::vector<Number> entries(const Tested<dim, Number> &tested)
{
  std::vector<Number> result;
  for (unsigned int c = 0; c < dim; ++c)
  {
    result.push_back(tested.by_value[c]);
    for (unsigned int d = 0; d < dim; ++d)
      result.push_back(tested.by_gradient[c][d]);
  }
  result.push_back(tested.of_volume);
  return result;
}

template <int dim>
void check_derivatives(const std::string &place)
{
  std::mt19937 random(dim);
  const double h = 1e-5;
  for (unsigned int trial = 0; trial < 3; ++trial)
  {
    Flow<dim> flow = random_flow<dim>(random);
    // The second time what carries is the mesh alone.
    flow.scheme.carries = trial == 1 ? 0. : 1.;
    flow.scheme.skew *= flow.scheme.carries;
    const PointChange<dim> of_unknowns = random_change<dim>(random);
    const StreamlinePoint<dim> here = point_of(flow),
                               above = point_of(changed(flow, of_unknowns, h)),
                               below = point_of(changed(flow, of_unknowns, -h));
    const FlowChange<dim> change(here, of_unknowns);
    unsigned int number = 0;
    StreamlineFlowTerms::for_each(
        [&](const auto term)
        {
          Tested<dim> derivative, of_above, of_below;
          term.add_derivative(here, change, derivative);
          term.add(above, of_above);
          term.add(below, of_below);
          const std::vector<double> exact = entries(derivative), up = entries(of_above),
                                    down = entries(of_below);
          double largest = 0., difference = 0.;
          for (std::size_t i = 0; i < exact.size(); ++i)
          {
            largest = std::max(largest, std::abs(exact[i]));
            difference = std::max(difference, std::abs(exact[i] - (up[i] - down[i]) / (2. * h)));
          }
          const std::string name =
              place + ", " + names[number++] + ", trial " + std::to_string(trial);
          check::is_true(name + ": there is a derivative", largest > 1e-3);
          check::absolute(name + ": derivative", difference / largest, 0., 1e-8);
        });
  }
}

/// A point with two states in its lanes against the two points.
template <int dim>
void check_lanes(const std::string &place)
{
  using Lanes = VectorizedArray<double>;
  std::mt19937 random(10 + dim);
  const Flow<dim> flow = random_flow<dim>(random);
  const PointChange<dim> one = random_change<dim>(random);
  std::vector<StreamlinePoint<dim>> points;
  for (unsigned int lane = 0; lane < Lanes::size(); ++lane)
    points.push_back(point_of(changed(flow, one, 0.1 * lane)));
  FlowPoint<dim, Lanes> together;
  PointChange<dim, Lanes> of_unknowns;
  together.scheme = flow.scheme;
  together.hoop = flow.hoop;
  for (unsigned int lane = 0; lane < Lanes::size(); ++lane)
  {
    const StreamlinePoint<dim> &point = points[lane];
    for (unsigned int c = 0; c < dim; ++c)
    {
      together.velocity[c][lane] = point.velocity[c];
      together.acceleration[c][lane] = point.acceleration[c];
      together.carrier[c][lane] = point.carrier[c];
      together.pressure_gradient[c][lane] = point.pressure_gradient[c];
      of_unknowns.velocity[c][lane] = one.velocity[c];
      of_unknowns.pressure_gradient[c][lane] = one.pressure_gradient[c];
      for (unsigned int d = 0; d < dim; ++d)
      {
        together.velocity_gradient[c][d][lane] = point.velocity_gradient[c][d];
        of_unknowns.velocity_gradient[c][d][lane] = one.velocity_gradient[c][d];
      }
    }
    of_unknowns.pressure[lane] = one.pressure;
    together.pressure[lane] = point.pressure;
    together.pressure_rate[lane] = point.pressure_rate;
    together.density[lane] = point.density;
    together.compressibility[lane] = point.compressibility;
    together.compressibility_slope[lane] = point.compressibility_slope;
    together.viscosity[lane] = point.viscosity;
    together.viscosity_slope[lane] = point.viscosity_slope;
    together.grad_div_over_speed[lane] = point.grad_div_over_speed;
  }
  together.set_strain_rate();
  together.finish();
  Tested<dim, Lanes> tested;
  FlowTerms::add(together, tested);
  FlowTerms::add_derivative(together, FlowChange<dim, Lanes>(together, of_unknowns), tested);
  const std::vector<Lanes> of_lanes = entries(tested);
  double difference = 0.;
  for (unsigned int lane = 0; lane < Lanes::size(); ++lane)
  {
    Tested<dim> alone;
    FlowTerms::add(points[lane], alone);
    FlowTerms::add_derivative(points[lane], FlowChange<dim>(points[lane], one), alone);
    const std::vector<double> of_point = entries(alone);
    for (std::size_t i = 0; i < of_point.size(); ++i)
      difference = std::max(difference, std::abs(of_point[i] - of_lanes[i][lane]));
  }
  check::absolute(place + ": several points at once", difference, 0., 1e-12);
}

/// In a uniform flow the power of inertia and of the skew form is the rate of the kinetic energy.
template <int dim>
void check_energy(const std::string &place)
{
  std::mt19937 random(20 + dim);
  Flow<dim> flow = random_flow<dim>(random);
  flow.hoop = 0.;
  flow.mesh_velocity = 0.;
  flow.unknowns.velocity_gradient = 0.;
  flow.unknowns.pressure_gradient = 0.;
  const StreamlinePoint<dim> here = point_of(flow);
  Tested<dim> tested;
  FlowInertia::add(here, tested);
  FlowConvection::add(here, tested);
  PointChange<dim> rate;
  rate.velocity = here.acceleration;
  rate.pressure = here.pressure_rate;
  const double h = 1e-5;
  const double of_energy = (FlowInertia::energy(point_of(changed(flow, rate, h))) -
                            FlowInertia::energy(point_of(changed(flow, rate, -h)))) /
                           (2. * h);
  check::absolute(place + ": power of inertia and convection", tested.by_value * here.velocity,
                  of_energy, 1e-8);
}
} // namespace

UNIT_TEST(flow_terms)
{
  check_derivatives<2>("axisymmetry");
  check_derivatives<3>("space");
  check_lanes<2>("axisymmetry");
  check_lanes<3>("space");
  check_energy<2>("plane");
  check_energy<3>("space");
}
} // namespace test_of_flow_terms
