#include <continua/finite_volume/face_conditions.h>

#include <continua/mesh/coordinates.h>
#include <continua/signal/jump.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace Continua
{
using namespace dealii;

namespace
{

/// The Cartesian vector of one half of a condition, without a flow rate.
template <int dim>
Tensor<1, dim> value_of(const BoundaryPart &part,
                        const std::array<double, 3> &point,
                        const Tensor<1, dim> &normal,
                        const double time)
{
  Tensor<1, dim> result;
  for (unsigned int c = 0; c < part.vector.size(); ++c)
    result[c] = part.vector[c](point.data(), time);
  result += (part.negative ? -1. : 1.) * part.along_normal(point.data(), time) * normal;
  return result;
}
} // namespace

template <int dim>
FaceConditions<dim>::FaceConditions(const CellWiseSpace<dim> &space,
                                    const std::vector<BoundaryCondition> &conditions)
    : space(space), conditions(conditions)
{
}

template <int dim>
void FaceConditions<dim>::build()
{
  std::map<std::pair<unsigned int, unsigned int>, unsigned int> condition_of;
  for (unsigned int c = 0; c < conditions.size(); ++c)
    for (const unsigned int region : conditions[c].region_ids)
      condition_of[{conditions[c].boundary_id, region}] = c;

  boundary_faces.clear();
  const CellWiseMesh<dim> &mesh = space.mesh;
  number_of_face.assign(mesh.faces().size(), numbers::invalid_unsigned_int);
  for (unsigned int f = 0; f < mesh.faces().size(); ++f)
  {
    const VolumeFace<dim> &surface = mesh.faces()[f];
    if (!surface.at_boundary())
      continue;
    const auto found =
        condition_of.find({surface.boundary_id, mesh.cells()[surface.owner].material_id});
    AssertThrow(found != condition_of.end(), ExcInternalError());
    const BoundaryCondition &condition = conditions[found->second];
    Face face;
    face.face = f;
    face.index = space.local_velocity(space.velocities.of_face(f, 0));
    face.condition = found->second;
    face.normal_is_prescribed = condition.normal.kind == BoundaryPart::Kind::velocity;
    face.place = coordinates(surface.centre);
    number_of_face[f] = boundary_faces.size();
    boundary_faces.push_back(face);
  }
  take_shapes();
  homogeneous = true;
  for (unsigned int c = 0; c < conditions.size(); ++c)
  {
    for (const BoundaryPart *part : {&conditions[c].normal, &conditions[c].tangential})
      if (part->kind == BoundaryPart::Kind::velocity && !part->is_zero())
        homogeneous = false;
    if (conditions[c].normal.flow)
    {
      homogeneous = false;
      set_flow_shapes(c);
    }
  }
}

template <int dim>
bool FaceConditions<dim>::take_shapes()
{
  constexpr double round_off = 1e-12;
  bool have_turned = false;
  for (Face &face : boundary_faces)
  {
    const VolumeFace<dim> &surface = space.mesh.faces()[face.face];
    const BoundaryCondition &condition = conditions[face.condition];
    face.weight = surface.area > 0. ? surface.area : surface.plane_area;
    const Tensor<2, dim> along = outer_product(surface.normal, surface.normal);
    Tensor<2, dim> prescribed;
    if (face.normal_is_prescribed)
      prescribed += along;
    if (condition.tangential.kind == BoundaryPart::Kind::velocity)
      prescribed += Tensor<2, dim>(unit_symmetric_tensor<dim>()) - along;
    have_turned = have_turned || (prescribed - face.prescribed).norm() > round_off;
    face.prescribed = prescribed;
  }
  return have_turned;
}

template <int dim>
void FaceConditions<dim>::set_flow_shapes(const unsigned int condition)
{
  const FlowProfile &profile = *conditions[condition].normal.flow;
  const std::size_t n_shapes = profile.shapes(0.).size();
  std::vector<double> means(n_shapes, 0.);
  const double section = profile.area();
  for (Face &face : boundary_faces)
    if (face.condition == condition)
    {
      const VolumeFace<dim> &surface = space.mesh.faces()[face.face];
      face.flow_shapes = profile.shapes_at(coordinates(surface.centre));
      for (std::size_t m = 0; m < n_shapes; ++m)
        means[m] += surface.area * face.flow_shapes[m] / section;
    }
  Utilities::MPI::sum(means, space.communicator, means);
  // The faces together pass the flow rate exactly.
  for (Face &face : boundary_faces)
    if (face.condition == condition)
    {
      const double first = face.flow_shapes[0] / means[0];
      for (std::size_t m = 0; m < n_shapes; ++m)
        face.flow_shapes[m] += ((m == 0 ? 1. : 0.) - means[m]) * first;
    }
}

template <int dim>
Tensor<1, dim> FaceConditions<dim>::prescribed_velocity(const Face &face, const double time) const
{
  const BoundaryCondition &condition = conditions[face.condition];
  const VolumeFace<dim> &surface = space.mesh.faces()[face.face];
  const std::array<double, 3> &point = face.place;
  const Tensor<1, dim> &normal = surface.normal;
  Tensor<1, dim> result;
  if (condition.normal.kind == BoundaryPart::Kind::velocity)
  {
    if (condition.normal.flow)
    {
      const std::vector<double> &amplitudes = condition.normal.flow->amplitudes(time);
      for (std::size_t m = 0; m < face.flow_shapes.size(); ++m)
        result -= face.flow_shapes[m] * amplitudes[m] * normal;
    }
    else
      result += (value_of(condition.normal, point, normal, time) * normal) * normal;
  }
  if (condition.tangential.kind == BoundaryPart::Kind::velocity)
  {
    const Tensor<1, dim> value = value_of(condition.tangential, point, normal, time);
    result += value - (value * normal) * normal;
  }
  return result;
}

template <int dim>
void FaceConditions<dim>::evaluate(const double time, DistributedVector &velocity) const
{
  double *const values = velocity.begin();
  for (const Face &face : boundary_faces)
    if (face.prescribed.norm_square() > 0.)
    {
      const Tensor<1, dim> value = prescribed_velocity(face, time);
      for (unsigned int c = 0; c < dim; ++c)
        values[face.index + c] = value[c];
    }
}

template <int dim>
void FaceConditions<dim>::follow(const SweptVolumes<dim> &swept_volumes,
                                 DistributedVector &velocity) const
{
  for (const Face &face : boundary_faces)
  {
    const VolumeFace<dim> &surface = space.mesh.faces()[face.face];
    if (!conditions[face.condition].liquid_carries_mesh() || surface.area == 0. ||
        !swept_volumes.moves(surface.owner))
      continue;
    double *const value = velocity.begin() + face.index;
    double change = swept_volumes.rate(face.face) / surface.area;
    for (unsigned int c = 0; c < dim; ++c)
      change -= value[c] * surface.normal[c];
    for (unsigned int c = 0; c < dim; ++c)
      value[c] += change * surface.normal[c];
  }
}

template <int dim>
void FaceConditions<dim>::clear_prescribed(DistributedVector &vector) const
{
  double *const values = vector.begin();
  for (const Face &face : boundary_faces)
    if (face.prescribed.norm_square() > 0.)
    {
      Tensor<1, dim> value;
      for (unsigned int c = 0; c < dim; ++c)
        value[c] = values[face.index + c];
      value -= face.prescribed * value;
      for (unsigned int c = 0; c < dim; ++c)
        values[face.index + c] = value[c];
    }
}

template <int dim>
void FaceConditions<dim>::set_prescribed(const DistributedVector &prescribed,
                                         DistributedVector &velocity) const
{
  clear_prescribed(velocity);
  for (const Face &face : boundary_faces)
    if (face.prescribed.norm_square() > 0.)
      for (unsigned int c = 0; c < dim; ++c)
        velocity.begin()[face.index + c] += prescribed.begin()[face.index + c];
}

template <int dim>
void FaceConditions<dim>::prescribed_part(const DistributedVector &velocity,
                                          DistributedVector &part) const
{
  part = 0.;
  for (const Face &face : boundary_faces)
    if (face.prescribed.norm_square() > 0.)
    {
      Tensor<1, dim> value;
      for (unsigned int c = 0; c < dim; ++c)
        value[c] = velocity.begin()[face.index + c];
      value = face.prescribed * value;
      for (unsigned int c = 0; c < dim; ++c)
        part.begin()[face.index + c] = value[c];
    }
}

template <int dim>
Tensor<1, dim> FaceConditions<dim>::traction(const Face &face, const double time) const
{
  const BoundaryCondition &condition = conditions[face.condition];
  const VolumeFace<dim> &surface = space.mesh.faces()[face.face];
  const std::array<double, 3> &point = face.place;
  const Tensor<1, dim> &normal = surface.normal;
  Tensor<1, dim> result;
  if (condition.normal.kind == BoundaryPart::Kind::traction)
    result += (value_of(condition.normal, point, normal, time) * normal) * normal;
  if (condition.tangential.kind == BoundaryPart::Kind::traction)
  {
    const Tensor<1, dim> value = value_of(condition.tangential, point, normal, time);
    result += value - (value * normal) * normal;
  }
  return result;
}

template <int dim>
bool FaceConditions<dim>::jumps(const double begin, const double end) const
{
  // A few faces of each condition tell.
  constexpr unsigned int n_watched = 8;
  std::map<unsigned int, std::vector<const Face *>> of_condition;
  for (const Face &face : boundary_faces)
    for (const BoundaryPart *part :
         {&conditions[face.condition].normal, &conditions[face.condition].tangential})
      if (part->kind == BoundaryPart::Kind::velocity && part->depends_on_time())
      {
        of_condition[face.condition].push_back(&face);
        break;
      }
  bool found = false;
  for (const auto &[condition, watched] : of_condition)
  {
    const std::size_t n = std::min<std::size_t>(n_watched, watched.size());
    for (std::size_t i = 0; i < n; ++i)
      for (unsigned int c = 0; c < dim; ++c)
      {
        const Face &face = *watched[i * watched.size() / n];
        found = found ||
                jumps_within([&](const double time) { return prescribed_velocity(face, time)[c]; },
                             begin, end);
      }
  }
  return Utilities::MPI::max(found ? 1 : 0, space.communicator) == 1;
}

template class FaceConditions<2>;
template class FaceConditions<3>;
} // namespace Continua
