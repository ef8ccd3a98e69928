// The terms on faces, and the body force, at a point: each derivative against differences; the
// power of a pressure around a body that is strained against the rate of its volume, that of a
// traction at the total pressure against the kinetic energy that flows in, that of a body force
// against its potential.

#include <continua/finite_element/terms/body_force.h>
#include <continua/finite_element/terms/flow_face_terms.h>
#include <continua/finite_element/terms/solid_face_terms.h>
#include <continua/materials/volume_law.h>

#include <deal.II/base/point.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>

#include "../materials/strain_at_point.h"
#include "../unit_test.h"

namespace test_of_face_terms
{
using namespace Continua;
using namespace dealii;

namespace
{
const std::array<const char *, SolidFaceTerms::size> solid_names = {{"follower pressure"}};
const std::array<const char *, FlowFaceTerms::size> flow_names = {
    {"given traction", "inflow traction"}};
constexpr double h = 1e-5;

template <int dim>
Tensor<1, dim> random_vector(std::mt19937 &random)
{
  const Tensor<2, 3> whole = strain_at_point::random_tensor(random, 1.);
  Tensor<1, dim> result;
  for (unsigned int c = 0; c < dim; ++c)
    result[c] = whole[0][c];
  return result;
}

/// A solid: b times velocity and gradient is what follows of the displacement; by the undeformed
/// place.
template <int dim>
struct Solid
{
  double displacement_by_velocity = 0.3, hoop = dim == 2 ? 0.8 : 0.;
  Tensor<2, dim> displacement_gradient, velocity_gradient;
  double radial_displacement = 0.1;
  Tensor<1, dim> velocity;
  Tensor<1, 3> normal; ///< at rest
};

template <int dim>
SolidFacePoint<dim> point_of(const Solid<dim> &solid)
{
  const double b = solid.displacement_by_velocity;
  SolidFacePoint<dim> point(Kinematics(
      whole_gradient<dim>(solid.displacement_gradient + b * solid.velocity_gradient,
                          solid.hoop * (solid.radial_displacement + b * solid.velocity[1]))));
  point.area = point.kinematics.area(solid.normal);
  point.hoop = solid.hoop * point.kinematics.inverse()[2][2];
  point.displacement_by_velocity = b;
  point.pressure = 1.7;
  return point;
}

template <int dim>
void check_solid(const std::string &place)
{
  std::mt19937 random(dim);
  Solid<dim> solid;
  for (unsigned int c = 0; c < dim; ++c)
  {
    solid.displacement_gradient[c] = 0.2 * random_vector<dim>(random);
    solid.velocity_gradient[c] = 0.2 * random_vector<dim>(random);
    solid.normal[c] = random_vector<dim>(random)[0];
  }
  solid.velocity = random_vector<dim>(random);
  solid.normal /= solid.normal.norm();
  Tensor<2, dim> gradient;
  for (unsigned int c = 0; c < dim; ++c)
    gradient[c] = random_vector<dim>(random);
  const Tensor<1, dim> value = random_vector<dim>(random);
  const auto changed = [&](const double factor)
  {
    Solid<dim> result = solid;
    result.velocity_gradient += factor * gradient;
    result.velocity += factor * value;
    return point_of(result);
  };
  const SolidFacePoint<dim> here = point_of(solid), above = changed(h), below = changed(-h);
  PointChange<dim> of_unknowns;
  of_unknowns.velocity = value;
  for (unsigned int c = 0; c < dim; ++c)
    for (unsigned int d = 0; d < dim; ++d)
      for (unsigned int e = 0; e < dim; ++e)
        of_unknowns.velocity_gradient[c][d] += gradient[c][e] * here.kinematics.inverse()[e][d];
  const SolidFaceChange<dim> change(here, of_unknowns);
  unsigned int number = 0;
  SolidFaceTerms::for_each(
      [&](const auto term)
      {
        TestedOnFace<dim> derivative, up, down;
        term.add_derivative(here, change, derivative);
        term.add(above, up);
        term.add(below, down);
        const std::string name = place + ", " + solid_names[number++];
        check::is_true(name + ": there is a derivative", derivative.by_value.norm() > 1e-2);
        check::absolute(name + ": derivative",
                        (derivative.by_value - (up.by_value - down.by_value) / (2. * h)).norm(), 0.,
                        1e-8);
      });
}

/// A pressure around a cube that moves by x = F X, with dF/dt: its power is p dJ/dt.
void check_power_of_pressure()
{
  std::mt19937 random(7);
  const Tensor<2, 3> gradient = strain_at_point::random_tensor(random, 0.3),
                     rate = strain_at_point::random_tensor(random, 1.);
  double power = 0.;
  for (unsigned int d = 0; d < 3; ++d)
    for (const double side : {-1., 1.})
    {
      Solid<3> solid;
      solid.displacement_gradient = gradient;
      solid.normal[d] = side;
      TestedOnFace<3> tested;
      SolidFaceTerms::add(point_of(solid), tested);
      // The middle of the face has the mean of the velocity.
      power += tested.by_value * (rate * (0.5 * side * Point<3>::unit_vector(d)));
    }
  const auto volume = [&](const double time)
  { return determinant(strain_at_point::unit_tensor() + gradient + time * rate); };
  check::relative("power of a pressure", power, 1.7 * (volume(h) - volume(-h)) / (2. * h), 1e-8);
}

const VolumeLaw volume_law{0.2, 1.5, 0.1};

template <int dim>
FlowFacePoint<dim> point_of(const Tensor<1, dim> &normal,
                            const Tensor<1, dim> &traction,
                            const double velocity_of_mesh,
                            const PointChange<dim> &unknowns)
{
  FlowFacePoint<dim> point;
  point.normal = normal;
  point.traction = traction;
  point.velocity = unknowns.velocity;
  point.through = unknowns.velocity * normal - velocity_of_mesh;
  point.density = 3. * volume_law.density_ratio(unknowns.pressure);
  point.compressibility = volume_law.compressibility(unknowns.pressure);
  return point;
}

template <int dim>
void check_flow(const std::string &place)
{
  std::mt19937 random(dim);
  const Tensor<1, dim> traction = random_vector<dim>(random);
  Tensor<1, dim> normal = random_vector<dim>(random);
  normal /= normal.norm();
  for (const bool flows_in : {true, false})
  {
    const double velocity_of_mesh = 0.2;
    PointChange<dim> unknowns, change;
    unknowns.velocity = random_vector<dim>(random);
    // 0.7 through the face, in or out.
    unknowns.velocity +=
        ((flows_in ? -0.7 : 0.7) + velocity_of_mesh - unknowns.velocity * normal) * normal;
    unknowns.pressure = 0.4;
    change.velocity = random_vector<dim>(random);
    change.pressure = -0.8;
    const auto changed = [&](const double factor)
    {
      PointChange<dim> then = unknowns;
      then.velocity += factor * change.velocity;
      then.pressure += factor * change.pressure;
      return point_of(normal, traction, velocity_of_mesh, then);
    };
    const FlowFacePoint<dim> here = changed(0.), above = changed(h), below = changed(-h);
    unsigned int number = 0;
    FlowFaceTerms::for_each(
        [&](const auto term)
        {
          TestedOnFace<dim> derivative, up, down;
          term.add_derivative(here, FlowFaceChange<dim>(here, change), derivative);
          term.add(above, up);
          term.add(below, down);
          const bool is_inflow = number == 1;
          const std::string name = place + (flows_in ? ", in, " : ", out, ") + flow_names[number++];
          check::is_true(
              name + (is_inflow && flows_in ? ": there is a derivative" : ": there is none"),
              (derivative.by_value.norm() > 1e-2) == (is_inflow && flows_in));
          check::absolute(name + ": derivative",
                          (derivative.by_value - (up.by_value - down.by_value) / (2. * h)).norm(),
                          0., 1e-8);
        });
    // What is given does work, and takes the kinetic energy that flows in.
    TestedOnFace<dim> tested;
    FlowFaceTerms::add(here, tested);
    const double energy = 0.5 * here.density * here.velocity.norm_square();
    check::absolute(place + (flows_in ? ", in: power" : ", out: power"),
                    tested.by_value * here.velocity,
                    -traction * here.velocity + (flows_in ? 0.7 * energy : 0.), 1e-12);
  }
}

/// f = -grad phi, phi = x^2 y + 2 x y^2, so that the power of the term is the rate of phi.
void check_body_force()
{
  const auto potential = [](const Tensor<1, 2> &x)
  { return x[0] * x[0] * x[1] + 2. * x[0] * x[1] * x[1]; };
  const Tensor<1, 2> place({0.7, -0.4}), velocity({0.3, 1.1});
  const double b = 0.3;
  const auto point_at = [b](const Tensor<1, 2> &x)
  {
    BodyForcePoint<2> point;
    point.force =
        Tensor<1, 2>({-2. * x[0] * x[1] - 2. * x[1] * x[1], -x[0] * x[0] - 4. * x[0] * x[1]});
    point.slope[0] = Tensor<1, 2>({-2. * x[1], -2. * x[0] - 4. * x[1]});
    point.slope[1] = Tensor<1, 2>({-2. * x[0] - 4. * x[1], -4. * x[0]});
    point.displacement_by_velocity = b;
    return point;
  };
  PointChange<2> change;
  change.velocity = velocity;
  Tested<2> here, derivative, up, down;
  BodyForceTerms::add(point_at(place), here);
  BodyForceTerms::add_derivative(point_at(place), change, derivative);
  BodyForceTerms::add(point_at(place + h * b * velocity), up);
  BodyForceTerms::add(point_at(place - h * b * velocity), down);
  check::absolute("body force: derivative",
                  (derivative.by_value - (up.by_value - down.by_value) / (2. * h)).norm(), 0.,
                  1e-8);
  check::relative("body force: power", here.by_value * velocity,
                  (potential(place + h * velocity) - potential(place - h * velocity)) / (2. * h),
                  1e-8);
}
} // namespace

UNIT_TEST(face_terms)
{
  check_solid<2>("solid in axisymmetry");
  check_solid<3>("solid in space");
  check_power_of_pressure();
  check_flow<2>("liquid in the plane");
  check_flow<3>("liquid in space");
  check_body_force();
}
} // namespace test_of_face_terms
