// u = T u_free + g(t) on straight and inclined faces, at corners, with rollers and conflicts.

#include <continua/boundary/boundary_conditions.h>
#include <continua/finite_element/conditions/boundary_constraints.h>

#include "../parameter_text.h"
#include "../unit_test.h"
#include "small_problem.h"

#include <deal.II/dofs/dof_tools.h>

namespace test_of_boundary_constraints
{
using namespace Continua;
using namespace dealii;

namespace
{
const std::vector<std::string> names = {"left", "right", "bottom", "top"};

std::vector<BoundaryCondition> conditions_of(const std::string &text)
{
  static std::vector<ParameterFile> files;
  files.push_back(parameters_of(text));
  std::set<std::pair<unsigned int, unsigned int>> pairs;
  for (unsigned int b = 0; b < 4; ++b)
    pairs.insert({b, 0});
  return read_boundary_conditions(files.back().root(), names, {"body"}, pairs, 2, false);
}

std::string boundary(const std::string &name, const std::string &entries)
{
  return "subsection " + name + "\n" + entries + "\nend\n";
}

/// 2 x 2 unit cells turned by an angle about the origin, one of them divided.
struct Case
{
  Case(const std::string &text, const double angle)
      : mesh(MPI_COMM_WORLD),
        space(mesh, SpaceParameters(), Model::plane_strain, 1),
        conditions(conditions_of(text)),
        constraints(space, conditions)
  {
    small_problem::make_box<2>(mesh, {2, 2});
    small_problem::refine<2>(mesh, [](const Point<2> &x) { return x[0] > 1. && x[1] > 1.; });
    GridTools::rotate(angle, mesh);
    space.distribute();
    constraints.build();
    // Something at every dof.
    raw = space.velocity_vector();
    for (const auto i : space.velocity_owned)
      raw[i] = std::sin(3. + 1.7 * i);
    raw.compress(VectorOperation::insert);
  }
  DistributedVector obeying(const double time)
  {
    DistributedVector u(raw), g = space.velocity_vector();
    constraints.evaluate(time, g);
    constraints.set_constrained(u, g);
    return u;
  }
  /// Velocity at a node of the mesh, in the coordinates turned back.
  Tensor<1, 2> at(const DistributedVector &u, const Point<2> &point, const double angle) const
  {
    Tensor<1, 2> value;
    const Point<2> turned(std::cos(angle) * point[0] - std::sin(angle) * point[1],
                          std::sin(angle) * point[0] + std::cos(angle) * point[1]);
    for (unsigned int c = 0; c < 2; ++c)
    {
      ComponentMask mask(2, false);
      mask.set(c, true);
      std::map<types::global_dof_index, Point<2>> places;
      DoFTools::map_dofs_to_support_points(StaticMappingQ1<2>::mapping, space.velocity_dofs, places,
                                           mask);
      for (const auto &place : places)
        if (place.second.distance(turned) < 1e-10)
          value[c] = u[place.first];
    }
    return Tensor<1, 2>({std::cos(angle) * value[0] + std::sin(angle) * value[1],
                         -std::sin(angle) * value[0] + std::cos(angle) * value[1]});
  }
  void check_transposition(const std::string &name)
  {
    // <T^T r, u> = <r, T u> for any r, u.
    DistributedVector r(raw), u(raw), zero = space.velocity_vector();
    for (const auto i : space.velocity_owned)
      r[i] = std::cos(0.3 * i);
    r.compress(VectorOperation::insert);
    DistributedVector transposed(r), extended(u);
    constraints.restrict_to_free(transposed);
    constraints.set_constrained(extended, zero);
    check::relative(name + ": <T^T r, u> = <r, T u>", transposed * u, r * extended, 1e-12);
    // T T = T, and T u is what the AffineConstraints say, but at hanging nodes.
    DistributedVector twice(extended), distributed(extended);
    constraints.set_constrained(twice, zero);
    twice.add(-1., extended);
    check::absolute(name + ": T T = T", twice.linfty_norm(), 0., 1e-13);
    constraints.all().distribute(distributed);
    space.set_hanging_velocities_to_zero(distributed);
    distributed.add(-1., extended);
    check::absolute(name + ": the same lines", distributed.linfty_norm(), 0., 1e-13);
  }

  small_problem::Mesh<2> mesh;
  Space<2> space;
  std::vector<BoundaryCondition> conditions;
  BoundaryConstraints<2> constraints;
  DistributedVector raw;
};
} // namespace

UNIT_TEST(boundary_constraints)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const std::string free_sides =
      boundary("right", "set Type = free") + boundary("top", "set Type = free");
  {
    Case c(boundary("left", "set Type = fixed") + boundary("bottom", "set Type = free") +
               free_sides,
           0.);
    const DistributedVector u = c.obeying(0.);
    check::absolute("fixed", c.at(u, {0., 0.5}, 0.).norm() + c.at(u, {0., 2.}, 0.).norm(), 0., 0.);
    check::is_true("free elsewhere", c.at(u, {1., 1.}, 0.).norm() > 0.1);
    check::is_true("homogeneous", c.constraints.is_homogeneous());
    c.check_transposition("fixed");
  }
  for (const double angle : {0., 0.4})
  {
    const std::string name = angle == 0. ? "straight" : "inclined";
    Case c(boundary("left", "set Type = roller") + boundary("bottom", "set Type = roller") +
               free_sides,
           angle);
    const DistributedVector u = c.obeying(0.);
    check::absolute(name + " roller: normal", c.at(u, {0., 1.5}, angle)[0], 0., 1e-14);
    check::is_true(name + " roller: tangential is free",
                   std::abs(c.at(u, {0., 1.5}, angle)[1]) > 1e-3);
    check::absolute(name + " rollers: corner", c.at(u, {0., 0.}, angle).norm(), 0., 1e-14);
    c.check_transposition(name + " rollers");
    check::is_true(name + " rollers: no conflict", c.constraints.conflicts().empty());

    Case m(boundary("left", "set Type = mixed\nset Normal = velocity\nset Normal velocity = 2*t\n"
                            "set Tangential = traction") +
               boundary("bottom", "set Type = free") + free_sides,
           angle);
    const DistributedVector v = m.obeying(1.5);
    // The outward normal of the left side is -x.
    check::absolute(name + " normal velocity", m.at(v, {0., 1.}, angle)[0], -3., 1e-13);
    check::is_true(name + " normal velocity: not homogeneous", !m.constraints.is_homogeneous());
    m.check_transposition(name + " normal velocity");
    DistributedVector g = m.space.velocity_vector(), again(v);
    m.constraints.prescribed_part(v, g);
    m.constraints.set_constrained(again, g);
    again.add(-1., v);
    check::absolute(name + " prescribed part", again.linfty_norm(), 0., 1e-14);
  }
  {
    // The tangential half alone of a vector that has both; the normal velocity is 0.
    Case c(boundary("left", "set Type = mixed\nset Normal = velocity\nset Normal velocity = 0\n"
                            "set Tangential = velocity\nset Tangential velocity = 5, 7") +
               boundary("bottom", "set Type = free") + free_sides,
           0.);
    const Tensor<1, 2> u = c.at(c.obeying(0.), {0., 1.}, 0.);
    check::absolute("mixed: normal part is its own", u[0], 0., 1e-14);
    check::absolute("mixed: tangential part", u[1], 7., 1e-14);
  }
  {
    Case c(boundary("left", "set Type = velocity\nset Velocity = 1 + y, x*t + 2") +
               boundary("bottom", "set Type = fixed") + free_sides,
           0.);
    const DistributedVector u = c.obeying(3.);
    check::absolute("velocity: x", c.at(u, {0., 1.5}, 0.)[0], 2.5, 1e-14);
    check::absolute("velocity: y", c.at(u, {0., 1.5}, 0.)[1], 2., 1e-14);
    check::is_true("conflict: one", c.constraints.conflicts().size() == 1);
    check::equal("conflict: text", c.constraints.conflicts().at(0),
                 "the boundaries 'left' and 'bottom' meet with different velocities; 'left' holds "
                 "at the nodes they share (it stands first)");
    check::absolute("conflict: the first holds", c.at(u, {0., 0.}, 0.)[0], 1., 1e-14);
    check::absolute("conflict: the second elsewhere", c.at(u, {0.5, 0.}, 0.).norm(), 0., 0.);
  }
  {
    Case c(boundary("left", "set Type = velocity\nset Velocity = 2, 0") +
               boundary("bottom", "set Type = velocity\nset Velocity = 2, 0") + free_sides,
           0.);
    check::is_true("the same velocity is no conflict", c.constraints.conflicts().empty());
    Case j(boundary("left", "set Type = velocity\nset Velocity = step(t-1), 0") +
               boundary("bottom", "set Type = free") + free_sides,
           0.);
    check::is_true("jump", j.constraints.jumps(0.95, 1.05) && !j.constraints.jumps(1.05, 1.15));
    Case s(boundary("left", "set Type = velocity\nset Velocity = sin(t), 0") +
               boundary("bottom", "set Type = free") + free_sides,
           0.);
    check::is_true("no jump", !s.constraints.jumps(-0.05, 0.05) && !s.constraints.jumps(1., 1.1));
  }
}
} // namespace test_of_boundary_constraints
