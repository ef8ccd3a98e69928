#include <continua/continuum/motion_extremes.h>

#include <continua/continuum/problem.h>
#include <continua/continuum/right_stretch.h>
#include <continua/continuum/stress_and_strain.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/symmetric_tensor.h>

#include <algorithm>
#include <cmath>

namespace Continua
{
using namespace dealii;

namespace
{
SymmetricTensor<2, 3> tensor_of(const std::array<double, 6> &components)
{
  SymmetricTensor<2, 3> tensor;
  for (unsigned int k = 0; k < components.size(); ++k)
    tensor[stress_pairs[k][0]][stress_pairs[k][1]] = components[k];
  return tensor;
}

/// Half of the vector of the antisymmetric part: of a small displacement its rotation.
double length_of_vector(const Tensor<2, 3> &gradient)
{
  double square = 0.;
  for (unsigned int i = 0; i < 3; ++i)
  {
    const double difference =
        gradient[(i + 2) % 3][(i + 1) % 3] - gradient[(i + 1) % 3][(i + 2) % 3];
    square += 0.25 * difference * difference;
  }
  return std::sqrt(square);
}

void take_finite(const Kinematics &kinematics, MotionExtremes &extremes)
{
  // What the step has found has a positive volume; a state that is only looked at need not.
  if (!(kinematics.volume_ratio() > 0.))
    return;
  for (const double green : eigenvalues(tensor_of(green_strain(kinematics))))
    extremes.strain =
        std::max(extremes.strain, std::abs(2. * green / (1. + std::sqrt(1. + 2. * green))));
  const Tensor<2, 3> &gradient = kinematics.deformation_gradient();
  const Tensor<2, 3> turn = gradient * RightStretch(gradient).inverse();
  extremes.rotation = std::max(
      extremes.rotation, std::atan2(length_of_vector(turn), 0.5 * (dealii::trace(turn) - 1.)));
}
} // namespace

template <int dim>
void take_point_of_solid(const Tensor<2, dim> &gradient,
                         const double hoop,
                         const Problem &problem,
                         const unsigned int region,
                         MotionExtremes &extremes)
{
  if (problem.deformation == Deformation::finite)
    return take_finite(Kinematics(whole_gradient<dim>(gradient, hoop)), extremes);
  extremes.rotation =
      std::max(extremes.rotation, length_of_vector(whole_gradient<dim>(gradient, 0.)));
  const SymmetricTensor<2, 3> strains =
      tensor_of(strain<dim>(gradient, hoop, problem.model, problem.plane_stress(region)));
  // No principal strain is larger than the norm, which costs less.
  if (strains.norm() > extremes.strain)
    for (const double principal : eigenvalues(strains))
      extremes.strain = std::max(extremes.strain, std::abs(principal));
}

bool is_wall(const Problem &problem, const unsigned int boundary, const unsigned int region)
{
  return std::any_of(problem.conditions.begin(), problem.conditions.end(),
                     [&](const BoundaryCondition &condition)
                     {
                       return condition.boundary_id == boundary &&
                              condition.region_ids.count(region) > 0 && condition.is_wall();
                     });
}

void LiquidSizes::sum(const MPI_Comm communicator)
{
  for (double *const size : {&volume, &area, &area_of_solids})
    *size = Utilities::MPI::sum(*size, communicator);
}

void LiquidSizes::set(MotionExtremes &extremes) const
{
  extremes.liquid_radius = area > 0. ? 2. * volume / area : 0.;
  extremes.wall_area = area_of_solids;
}

template void
take_point_of_solid(const Tensor<2, 2> &, double, const Problem &, unsigned int, MotionExtremes &);
template void
take_point_of_solid(const Tensor<2, 3> &, double, const Problem &, unsigned int, MotionExtremes &);
} // namespace Continua
