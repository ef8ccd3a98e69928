#include <continua/finite_element/assembly/face_points.h>

#include <continua/finite_element/conditions/loads.h>
#include <continua/mesh/coordinates.h>

#include <limits>

namespace Continua
{
using namespace dealii;

template <int dim>
void FacePoints<dim>::set_step(const Step &of_state,
                               const std::vector<double> &pressures_of_boundaries)
{
  step = of_state;
  boundary_pressures = pressures_of_boundaries;
}

template <int dim>
SolidFacePoint<dim> FacePoints<dim>::of_solid(const TermFace<dim> &face,
                                              const unsigned int q,
                                              const Vector<double> &displacement) const
{
  const DeformedFacePoint<dim> &undeformed = face.points[q];
  SolidFacePoint<dim> point(undeformed.kinematics(displacement));
  point.weight = undeformed.area.norm();
  point.area = point.kinematics.area(undeformed.area) / point.weight;
  point.hoop = undeformed.hoop * point.kinematics.inverse()[2][2];
  // A step that finds the unloaded shape leaves the mesh, on which the pressure acts.
  if (!step.finds_unloaded_shape)
    point.displacement_by_velocity = step.branch(std::numeric_limits<double>::infinity()).velocity;
  point.pressure =
      face.unknown_pressure >= 0
          ? boundary_pressures[face.unknown_pressure]
          : step.load_factor * face.condition->normal.along_normal(
                                   coordinates(undeformed.place).data(), step.balance_time);
  return point;
}

template <int dim>
Tensor<1, dim> FacePoints<dim>::traction(const TermFace<dim> &face,
                                         const Point<dim> &place,
                                         const Tensor<1, dim> &normal) const
{
  if (face.unknown_pressure >= 0)
    return -boundary_pressures[face.unknown_pressure] * normal;
  return step.load_factor *
         Loads<dim>::prescribed_traction(*face.condition, place, normal, step.balance_time);
}

template <int dim>
FlowFacePoint<dim> FacePoints<dim>::of_flow(const TermFace<dim> &face,
                                            const unsigned int q,
                                            const Material &liquid,
                                            const CellState<dim> &state) const
{
  const DeformedFacePoint<dim> &undeformed = face.points[q];
  const bool moves = state.mesh_displacement != nullptr;
  const Tensor<1, 3> area =
      moves ? undeformed.kinematics(*state.mesh_displacement).area(undeformed.area)
            : undeformed.area;
  FlowFacePoint<dim> point;
  point.weight = area.norm();
  for (unsigned int c = 0; c < dim; ++c)
    point.normal[c] = area[c] / point.weight;
  if (face.unknown_pressure >= 0 || face.has_traction)
    point.traction = traction(
        face,
        moves ? undeformed.place + undeformed.value_of(*state.mesh_displacement) : undeformed.place,
        point.normal);
  point.velocity = undeformed.value_of(state.velocity);
  point.through = point.velocity * point.normal;
  if (moves)
    point.through -= undeformed.value_of(*state.mesh_velocity) * point.normal;
  if (!face.has_total_pressure)
    return point;
  double pressure = 0.;
  for (unsigned int k = 0; k < state.pressure.size(); ++k)
    pressure += state.pressure[k] * face.pressure_values[q][k];
  const VolumeLaw law = liquid.volume_law();
  point.density = liquid.density * law.density_ratio(pressure);
  point.compressibility = law.compressibility(pressure);
  return point;
}

template class FacePoints<2>;
template class FacePoints<3>;
} // namespace Continua
