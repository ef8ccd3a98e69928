// The discrete flow of a flow-rate boundary is the prescribed one: straight, with hanging nodes,
// and for profiles that the elements do not hold; at the rim and along the boundary nothing moves.

#include <continua/boundary/boundary_conditions.h>
#include <continua/boundary/flow_rates.h>
#include <continua/finite_element/conditions/boundary_constraints.h>
#include <continua/finite_element/conditions/flow_shapes.h>

#include "../parameter_text.h"
#include "../unit_test.h"
#include "small_problem.h"

namespace test_of_flow_shapes
{
using namespace Continua;
using namespace dealii;

namespace
{
const std::vector<std::string> names = {"left", "right", "bottom", "top"};

/// An axisymmetric tube of radius 3 and length 2 of unit cells, some of them divided.
struct Case
{
  Case(const std::string &entries)
      : mesh(MPI_COMM_WORLD), space(mesh, SpaceParameters(), Model::axisymmetric, 1)
  {
    static std::vector<ParameterFile> files;
    // One rank after the other: they write a file of the same name.
    for (unsigned int rank = 0; rank < Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD); ++rank)
    {
      if (rank == Utilities::MPI::this_mpi_process(MPI_COMM_WORLD))
        files.push_back(parameters_of("subsection left\nset Type = flow rate\n" + entries +
                                      "\nend\nsubsection right\nset Type = free\nend\n"
                                      "subsection bottom\nset Type = axis\nend\n"
                                      "subsection top\nset Type = fixed\nend\n"));
      MPI_Barrier(MPI_COMM_WORLD);
    }
    std::set<std::pair<unsigned int, unsigned int>> pairs;
    for (unsigned int b = 0; b < 4; ++b)
      pairs.insert({b, 0});
    conditions = read_boundary_conditions(files.back().root(), names, {"body"}, pairs, 2, true);
    small_problem::make_box<2>(mesh, {2, 3});
    Material liquid;
    liquid.density = 1.;
    liquid.shear.viscosity = 0.5;
    set_flow_profiles(conditions, files.back().root(), mesh, {liquid}, {false, 4., 0.01});
    small_problem::refine<2>(mesh, [](const Point<2> &x) { return x[1] > 1. && x[1] < 2.; });
    space.distribute();
    constraints = std::make_unique<BoundaryConstraints<2>>(space, conditions);
    constraints->build();
  }
  /// The prescribed velocities at a time, with the hanging nodes set.
  DistributedVector prescribed(const double time) const
  {
    DistributedVector u = space.velocity_vector(), g = space.velocity_vector();
    constraints->evaluate(time, g);
    constraints->set_constrained(u, g);
    return space.ghosted_velocity(u);
  }
  /// The flow through the left side, by a rule of many points.
  double flow(const DistributedVector &u) const
  {
    FEFaceValues<2> values(space.mapping, space.velocity_element, QGauss<1>(8),
                           update_values | update_quadrature_points | update_JxW_values);
    const FEValuesExtractors::Scalar axial(0);
    std::vector<double> velocity(8);
    double sum = 0.;
    for (const auto &cell : space.velocity_dofs.active_cell_iterators())
      if (cell->is_locally_owned() && cell->at_boundary(0))
      {
        values.reinit(cell, 0);
        values[axial].get_function_values(u, velocity);
        for (unsigned int q = 0; q < velocity.size(); ++q)
          sum += velocity[q] * values.JxW(q) * 2. * M_PI * values.quadrature_point(q)[1];
      }
    return Utilities::MPI::sum(sum, MPI_COMM_WORLD);
  }

  small_problem::Mesh<2> mesh;
  Space<2> space;
  std::vector<BoundaryCondition> conditions;
  std::unique_ptr<BoundaryConstraints<2>> constraints;
};
} // namespace

UNIT_TEST(flow_shapes)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  small_problem::quiet_other_ranks();
  for (const std::string profile : {"flat", "parabolic", "womersley"})
  {
    const Case c("set Flow rate = 5*sin(3*t)\nset Profile = " + profile);
    for (const double time : {0.3, 2.})
      check::relative(profile + ": flow at " + std::to_string(time).substr(0, 3) + " s",
                      c.flow(c.prescribed(time)), 5. * std::sin(3. * time), 1e-12);
    check::is_true(profile + ": no conflict with the wall", c.constraints->conflicts().empty());
    check::is_true(profile + ": no jump",
                   !c.constraints->jumps(0.29, 0.31) && !c.constraints->is_homogeneous());
    double rim = 0.;
    const auto shapes = nodal_flow_shapes(c.space, c.conditions.front());
    for (const auto &shape : shapes)
      for (const double value : shape.second)
        rim = std::max(rim, std::abs(value));
    const unsigned int n_nodes =
        Utilities::MPI::sum(static_cast<unsigned int>(shapes.size()), MPI_COMM_WORLD);
    // The three cells of the side, one of them in two, have nine nodes; one of them is the rim.
    check::is_true(profile + ": the rim has no shape", n_nodes == 8 && std::isfinite(rim));
  }
  const Case jump("set Flow rate = step(t-1)");
  check::is_true("a flow rate that jumps",
                 jump.constraints->jumps(0.95, 1.05) && !jump.constraints->jumps(1.05, 1.15));
  const Case parabola("set Flow rate = 1");
  // The elements hold a parabola: the velocity on the axis is 2 Q/(pi R^2).
  double largest = 0.;
  const DistributedVector u = parabola.prescribed(0.);
  for (const auto i : parabola.space.velocity_owned)
    largest = std::max(largest, u[i]);
  check::relative("parabola: axis", Utilities::MPI::max(largest, MPI_COMM_WORLD), 2. / (9. * M_PI),
                  1e-12);
}
} // namespace test_of_flow_shapes
