// Loads: weights and pressures in sum by hand, a constant, a function of time, one of place and
// time, pressure on a closed surface, and jumps.

#include <continua/finite_volume/cell_wise_loads.h>

#include "cell_wise_step.h"

#include "../unit_test.h"

#include <algorithm>

namespace test_of_cell_wise_loads
{
namespace
{
using namespace cell_wise_meshes;
const double pi = dealii::numbers::PI;

Waveform formula(const std::string &text)
{
  return Waveform(Expression(text, Dimensions::none));
}

/// A mesh, its conditions and loads.
template <int dim>
struct LoadedBody
{
  LoadedBody(const std::function<void(Triangulation<dim> &)> &make_mesh,
             const Model model,
             const std::function<void(Problem &)> &change)
      : triangulation(MPI_COMM_WORLD),
        problem(make_problem<dim>(model)),
        space(triangulation, model),
        conditions(space, problem.conditions),
        loads(space, problem, conditions)
  {
    make_mesh(triangulation);
    for (BoundaryCondition &condition : problem.conditions)
      set_free(condition);
    problem.materials[0].density = 2.;
    problem.materials[1].density = 5.;
    change(problem);
    space.distribute();
    conditions.build();
    loads.build();
  }
  DistributedVector at(const double time) const
  {
    DistributedVector result = space.velocity_vector();
    loads.add(time, result);
    return result;
  }

  Triangulation<dim> triangulation;
  Problem problem;
  CellWiseSpace<dim> space;
  FaceConditions<dim> conditions;
  CellWiseLoads<dim> loads;
};

/// Sum over this rank's cells or faces of a component, over all ranks.
template <int dim>
double total(const LoadedBody<dim> &body,
             const DistributedVector &loads,
             const unsigned int component,
             const bool of_cells)
{
  double result = 0.;
  const unsigned int n_cells = body.space.mesh.n_owned_cells();
  for (unsigned int i = component; i < loads.locally_owned_size(); i += dim)
    if ((i / dim < n_cells) == of_cells)
      result += loads.begin()[i];
  return sum(result);
}

/// Region 1 is 0 < x < 1/2, 1/4 < y < 3/4 (1/4 < z < 3/4): 1/4 of the square, 1/8 of the cube; of
/// the cylinder (pi (9 - 1)/16) / 2 = pi/4 of pi.
template <int dim>
void check_weight(const Model model)
{
  const std::string name = model == Model::axisymmetric ? "axisymmetric: "
                           : dim == 2                   ? "2-D: "
                                                        : "3-D: ";
  const double all = model == Model::axisymmetric ? pi : 1., fluid = model == Model::axisymmetric
                                                                         ? pi / 4.
                                                                     : dim == 2 ? 0.25
                                                                                : 0.125;
  const LoadedBody<dim> body([](Triangulation<dim> &mesh) { make_box(mesh, 4); }, model,
                             [](Problem &problem)
                             {
                               // b = (3, 7 t), and rho b = (0, 1 + 2 t x).
                               problem.interior.acceleration = {formula("3"), formula("7*t")};
                               problem.interior.body_force = {formula("0"), formula("1+2*t*x")};
                               if (dim == 3)
                               {
                                 problem.interior.acceleration.push_back(formula("0"));
                                 problem.interior.body_force.push_back(formula("0"));
                               }
                             });
  const double mass = 2. * (all - fluid) + 5. * fluid, time = 0.5;
  const DistributedVector loads = body.at(time);
  check::relative(name + "constant", total(body, loads, 0, true), 3. * mass, 1e-13);
  // The mean of x is 1/2.
  check::relative(name + "in time, and in time and place", total(body, loads, 1, true),
                  7. * time * mass + (1. + 2. * time * 0.5) * all, 1e-13);
  check::absolute(name + "nothing on faces",
                  total(body, loads, 0, false) + total(body, loads, 1, false), 0., 0.);
}

/// A pressure all around is in balance: along every direction in the plane and in space, along the
/// axis in axisymmetry, where the force outwards on the rim is 2 pi p.
template <int dim>
void check_pressure(const Model model)
{
  const std::string name = model == Model::axisymmetric ? "axisymmetric: "
                           : dim == 2                   ? "2-D: "
                                                        : "3-D: ";
  const auto body = [&](const std::function<void(Problem &)> &change)
  {
    return std::make_unique<LoadedBody<dim>>(
        [&](Triangulation<dim> &mesh)
        {
          make_box(mesh, 4);
          if (model != Model::axisymmetric)
            project(mesh);
        },
        model, change);
  };
  const auto around = body(
      [](Problem &problem)
      {
        for (BoundaryCondition &condition : problem.conditions)
        {
          condition.normal.along_normal = formula("4*t");
          condition.normal.negative = true;
        }
      });
  const DistributedVector loads = around->at(0.75);
  check::absolute(name + "pressure all around, along x", total(*around, loads, 0, false), 0.,
                  1e-13);
  if (model == Model::axisymmetric)
    // Where the axis has no area the equation counts as in the plane: a length of 1.
    check::absolute(name + "pressure on the rim", total(*around, loads, 1, false),
                    -3. * 2. * pi + 3., 1e-12);
  else
    check::absolute(name + "pressure all around, along y", total(*around, loads, 1, false), 0.,
                    1e-13);
  check::absolute(name + "nothing on cells", total(*around, loads, 0, true), 0., 0.);

  // A traction vector is a normal and a tangential part; the one on x = 1 alone is held.
  const auto parts = body(
      [](Problem &problem)
      {
        BoundaryCondition &condition = problem.conditions[1];
        condition.normal.kind = BoundaryPart::Kind::velocity;
        condition.tangential.vector.assign(dim, formula("0"));
        condition.tangential.vector[0] = formula("5");
        condition.tangential.vector[1] = formula("6 + x - x");
      });
  const DistributedVector tangential = parts->at(0.);
  double error = 0.;
  for (const auto &face : parts->conditions.faces())
  {
    const auto &surface = parts->space.mesh.faces()[face.face];
    dealii::Tensor<1, dim> load, expected;
    expected[0] = 5.;
    expected[1] = 6.;
    expected -= (expected * surface.normal) * surface.normal;
    if (surface.boundary_id != 1)
      expected = 0.;
    for (unsigned int c = 0; c < dim; ++c)
      load[c] = tangential.begin()[face.index + c];
    error = std::max(error, (load - surface.area * expected).norm());
  }
  check::absolute(name + "tangential part", largest(error), 0., 1e-14);
}

void check_jumps()
{
  const LoadedBody<2> body([](Triangulation<2> &mesh) { make_box(mesh, 2); }, Model::plane_strain,
                           [](Problem &problem)
                           {
                             problem.conditions[0].normal.along_normal = formula("x + step(t-0.5)");
                             problem.interior.body_force = {formula("t"), formula("sin(t)")};
                           });
  check::is_true("a jump", body.loads.jumps(0.4, 0.6));
  check::is_true("none before", !body.loads.jumps(0.2, 0.4));
  check::is_true("none after", !body.loads.jumps(0.6, 0.9));
}
} // namespace

UNIT_TEST(cell_wise_loads)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  quiet_other_ranks();
  check_weight<2>(Model::plane_strain);
  check_weight<2>(Model::axisymmetric);
  check_weight<3>(Model::three_dimensional);
  check_pressure<2>(Model::plane_strain);
  check_pressure<2>(Model::axisymmetric);
  check_pressure<3>(Model::three_dimensional);
  check_jumps();
}
} // namespace test_of_cell_wise_loads
