// The stress of the mesh as a body at a point: the hyperelastic one is the derivative of its
// energy, and both derivatives agree with differences; in axisymmetry and in space.

#include <continua/finite_element/terms/mesh_stress.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "../materials/strain_at_point.h"
#include "../unit_test.h"

namespace test_of_mesh_stress
{
using namespace Continua;
using namespace dealii;

namespace
{
constexpr double h = 1e-5;

/// A displacement at a point: its gradient in the plane or in space and, beside it, its value.
template <int dim>
PointChange<dim> random_motion(std::mt19937 &random, const double size)
{
  const Tensor<2, 3> gradient = strain_at_point::random_tensor(random, size),
                     values = strain_at_point::random_tensor(random, size);
  PointChange<dim> result;
  for (unsigned int c = 0; c < dim; ++c)
  {
    result.velocity[c] = values[0][c];
    for (unsigned int d = 0; d < dim; ++d)
      result.velocity_gradient[c][d] = gradient[c][d];
  }
  return result;
}

template <int dim>
MeshPoint<> point_of(const PointChange<dim> &motion,
                     const PointChange<dim> &change,
                     const double factor,
                     const bool is_hyperelastic)
{
  MeshPoint<> point;
  point.is_hyperelastic = is_hyperelastic;
  point.hoop = dim == 2 ? 0.8 : 0.;
  point.displacement_gradient =
      whole_gradient<dim>(motion.velocity_gradient + factor * change.velocity_gradient,
                          point.hoop * (motion.velocity[1] + factor * change.velocity[1]));
  point.inverse = Kinematics(point.displacement_gradient).inverse();
  return point;
}

template <int dim>
double power(const Tested<dim> &tested, const PointChange<dim> &change)
{
  return tested.by_value * change.velocity +
         scalar_product(tested.by_gradient, change.velocity_gradient);
}

template <int dim>
void check_stress(const std::string &name, const bool is_hyperelastic)
{
  std::mt19937 random(dim);
  for (unsigned int trial = 0; trial < 3; ++trial)
  {
    const PointChange<dim> motion = random_motion<dim>(random, 0.2),
                           change = random_motion<dim>(random, 1.),
                           test = random_motion<dim>(random, 1.);
    const MeshPoint<> here = point_of(motion, change, 0., is_hyperelastic),
                      above = point_of(motion, change, h, is_hyperelastic),
                      below = point_of(motion, change, -h, is_hyperelastic);
    Tested<dim> stress, of_above, of_below, derivative;
    MeshStress::add(here, stress);
    MeshStress::add(above, of_above);
    MeshStress::add(below, of_below);
    MeshStress::add_derivative(here, change, derivative);
    const std::string of_trial = name + ", trial " + std::to_string(trial);
    check::relative(of_trial + ": derivative", power(derivative, test),
                    (power(of_above, test) - power(of_below, test)) / (2. * h), 1e-7);
    if (is_hyperelastic)
      check::relative(of_trial + ": the derivative of the energy", power(stress, change),
                      (MeshStress::energy(above) - MeshStress::energy(below)) / (2. * h), 1e-7);
  }
}
} // namespace

UNIT_TEST(mesh_stress)
{
  check_stress<2>("hyperelastic in axisymmetry", true);
  check_stress<3>("hyperelastic in space", true);
  check_stress<2>("elastic in axisymmetry", false);
  check_stress<3>("elastic in space", false);
}
} // namespace test_of_mesh_stress
