// What the conditions say of boundary faces, with oblique normals: directions that are prescribed,
// velocities and tractions at the faces' centres, jumps in time, and a flow rate that the faces
// together pass exactly.

#include <continua/finite_volume/face_conditions.h>

#include "cell_wise_step.h"

#include "../unit_test.h"

#include <algorithm>

namespace test_of_face_conditions
{
namespace
{
using namespace cell_wise_meshes;
const double pi = dealii::numbers::PI;

Waveform formula(const std::string &text)
{
  return Waveform(Expression(text, Dimensions::none));
}

/// At the faces: (x + 10 t, 2 y, 3), the velocity as well as the traction, which has the pressure
/// 5 x t besides.
template <int dim>
dealii::Tensor<1, dim> given(const dealii::Point<dim> &p, const double time)
{
  dealii::Tensor<1, dim> result;
  result[0] = p[0] + 10. * time;
  result[1] = 2. * p[1];
  if (dim == 3)
    result[dim - 1] = 3.;
  return result;
}

/// On x = 0 a roller of region 0 and held region 1, on x = 1 a tangential velocity, on y = 0 loads,
/// elsewhere a velocity.
template <int dim>
std::vector<BoundaryCondition> make_conditions()
{
  Problem problem = make_problem<dim>(Model::plane_strain);
  std::vector<BoundaryCondition> conditions = problem.conditions;
  conditions.push_back(conditions[0]);
  conditions[0].region_ids = {0};
  conditions.back().region_ids = {1};
  set_roller(conditions[0]);
  conditions[1].normal.kind = BoundaryPart::Kind::traction;
  set_free(conditions[2]);
  for (BoundaryCondition &condition : conditions)
    for (BoundaryPart *const part : {&condition.normal, &condition.tangential})
    {
      part->vector = {formula("x + 10*t"), formula("2*y")};
      if (dim == 3)
        part->vector.push_back(formula("3"));
      if (part == &condition.normal && part->kind == BoundaryPart::Kind::traction)
      {
        part->along_normal = formula("5*x*t");
        part->negative = true;
      }
    }
  return conditions;
}

template <int dim>
void check_parts()
{
  const std::string kind = dim == 2 ? "2-D: " : "3-D: ";
  Triangulation<dim> triangulation(MPI_COMM_WORLD);
  make_box(triangulation, 4);
  shear(triangulation);
  CellWiseSpace<dim> space(triangulation, Model::plane_strain);
  space.distribute();
  const std::vector<BoundaryCondition> list = make_conditions<dim>();
  FaceConditions<dim> conditions(space, list);
  conditions.build();
  const double time = 0.3;

  DistributedVector velocity = space.velocity_vector(), random = velocity, cleared, part = velocity;
  velocity.add(7.);
  conditions.evaluate(time, velocity);
  fill_at_random(random, 1);
  cleared = random;
  conditions.clear_prescribed(cleared);
  part.add(9.);
  conditions.prescribed_part(random, part);

  const dealii::Tensor<2, dim> identity = dealii::unit_symmetric_tensor<dim>();
  std::vector<bool> is_prescribed(velocity.locally_owned_size(), false);
  double projector = 0., value = 0., traction = 0., split = 0., oblique = 0.;
  unsigned int n_boundary_faces = 0;
  bool numbers = true;
  for (const auto &face : space.mesh.faces())
    n_boundary_faces += face.at_boundary();
  for (const auto &face : conditions.faces())
  {
    const auto &surface = space.mesh.faces()[face.face];
    numbers = numbers && &conditions.of_face(face.face) == &face &&
              face.index == space.local_velocity(space.velocities.of_face(face.face, 0));
    const dealii::Tensor<1, dim> &n = surface.normal;
    oblique = std::max(oblique, std::min(std::abs(n[0]), std::abs(n[1])));
    const dealii::Tensor<2, dim> along = dealii::outer_product(n, n);
    const bool of_region_1 = space.mesh.cells()[surface.owner].material_id == 1;
    dealii::Tensor<2, dim> expected;
    switch (surface.boundary_id)
    {
    case 0:
      expected = of_region_1 ? identity : along;
      break;
    case 1:
      expected = identity - along;
      break;
    case 2:
      break;
    default:
      expected = identity;
    }
    projector = std::max(projector, (face.prescribed - expected).norm());
    const dealii::Tensor<1, dim> at_centre = given<dim>(surface.centre, time);
    const dealii::Tensor<1, dim> loads =
        at_centre - (surface.boundary_id == 1 || surface.boundary_id == 2
                         ? 5. * surface.centre[0] * time
                         : 0.) *
                        n;
    traction =
        std::max(traction, (conditions.traction(face, time) - (loads - expected * loads)).norm());
    dealii::Tensor<1, dim> at_face, kept, taken, all;
    for (unsigned int c = 0; c < dim; ++c)
    {
      at_face[c] = velocity.begin()[face.index + c];
      kept[c] = cleared.begin()[face.index + c];
      taken[c] = part.begin()[face.index + c];
      all[c] = random.begin()[face.index + c];
      is_prescribed[face.index + c] = expected.norm() > 0.;
    }
    if (expected.norm() > 0.)
      value = std::max(value, (at_face - expected * at_centre).norm());
    split = std::max({split, (taken - expected * all).norm(), (kept + taken - all).norm()});
  }
  double elsewhere = 0.;
  for (unsigned int i = 0; i < is_prescribed.size(); ++i)
    if (!is_prescribed[i])
      elsewhere =
          std::max({elsewhere, std::abs(velocity.begin()[i] - 7.), std::abs(part.begin()[i]),
                    std::abs(cleared.begin()[i] - random.begin()[i])});
  check::is_true(kind + "one for each boundary face",
                 largest(conditions.faces().size() == n_boundary_faces && numbers ? 0. : 1.) == 0.);
  check::is_true(kind + "normals are oblique", largest(oblique) > 0.3);
  check::absolute(kind + "prescribed directions", largest(projector), 0., 1e-13);
  check::absolute(kind + "velocity", largest(value), 0., 1e-13);
  check::absolute(kind + "traction in the others", largest(traction), 0., 1e-13);
  check::absolute(kind + "prescribed part and the rest", largest(split), 0., 1e-13);
  check::absolute(kind + "other values stay", largest(elsewhere), 0., 0.);
  check::is_true(kind + "not homogeneous", !conditions.is_homogeneous());
}

/// A disc of radius 1, its faces at r = 1/8, 3/8, 5/8 and 7/8.
void check_flow_rate()
{
  Triangulation<2> triangulation(MPI_COMM_WORLD);
  make_uniform_box(triangulation, 4);
  CellWiseSpace<2> space(triangulation, Model::axisymmetric);
  space.distribute();
  std::vector<BoundaryCondition> list = make_problem<2>(Model::axisymmetric).conditions;
  list[0].normal.flow = std::make_shared<FlowProfile>(FlowProfile::Shape::parabolic, formula("3*t"),
                                                      FlowProfile::Section{1., 1.});
  FaceConditions<2> conditions(space, list);
  conditions.build();
  DistributedVector velocity = space.velocity_vector();
  conditions.evaluate(2., velocity);
  double rate = 0., profile = 0., weights = 0.;
  for (const auto &face : conditions.faces())
  {
    const auto &surface = space.mesh.faces()[face.face];
    const double r = surface.centre[1];
    // On the axis, where a face has no area, its length.
    weights = std::max(
        weights, std::abs(face.weight - (surface.boundary_id == 2 ? 0.25 : 2. * pi * r * 0.25)));
    if (surface.boundary_id != 0)
      continue;
    const double speed = velocity.begin()[face.index];
    rate += surface.area * speed;
    // Twice the mean velocity 6/pi times 1 - r^2; the sum over the faces is 1.03125 times the exact
    // flow: 4 h (sum of r - sum of r^3).
    profile = std::max(profile, std::abs(speed - 12. / pi * (1. - r * r) / 1.03125));
  }
  check::absolute("flow rate", sum(rate), 6., 1e-13);
  check::absolute("its profile", largest(profile), 0., 1e-13);
  check::absolute("weights, on the axis as in the plane", largest(weights), 0., 1e-13);
}

void check_times()
{
  Triangulation<2> triangulation(MPI_COMM_WORLD);
  make_uniform_box(triangulation, 2);
  CellWiseSpace<2> space(triangulation, Model::plane_strain);
  space.distribute();
  std::vector<BoundaryCondition> list = make_problem<2>(Model::plane_strain).conditions;
  FaceConditions<2> conditions(space, list);
  conditions.build();
  check::is_true("at rest: homogeneous", conditions.is_homogeneous());
  check::is_true("nothing jumps", !conditions.jumps(0., 1.));
  list[3].tangential.vector = {formula("x*t + step(t - 0.5)"), formula("0")};
  conditions.build();
  check::is_true("no longer homogeneous", !conditions.is_homogeneous());
  check::is_true("a jump", conditions.jumps(0.4, 0.6));
  check::is_true("none after it", !conditions.jumps(0.6, 0.8));
}
} // namespace

UNIT_TEST(face_conditions)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  quiet_other_ranks();
  check_parts<2>();
  check_parts<3>();
  check_flow_rate();
  check_times();
}
} // namespace test_of_face_conditions
