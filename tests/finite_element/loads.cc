// Resultants of tractions, pressure and body force on straight, inclined and axisymmetric bodies;
// what follows a solid in finite deformation is none of them.

#include <continua/boundary/boundary_conditions.h>
#include <continua/finite_element/conditions/loads.h>

#include <limits>

#include "../parameter_text.h"
#include "../unit_test.h"
#include "small_problem.h"

namespace test_of_loads
{
using namespace Continua;
using namespace dealii;

namespace
{
struct Case
{
  Case(const std::string &loads_text,
       const std::string &body_force,
       const double angle,
       const Model model = Model::plane_strain,
       const bool is_finite = false)
      : mesh(MPI_COMM_WORLD),
        space(mesh, SpaceParameters(), model, 1),
        file(parameters_of("subsection Boundaries\n" + loads_text + "end\n" + body_force)),
        loads(space, problem)
  {
    small_problem::make_box<2>(mesh, {2, 2});
    small_problem::refine<2>(mesh, [](const Point<2> &x) { return x[0] > 1. && x[1] > 1.; });
    GridTools::rotate(angle, mesh);
    space.distribute();
    problem.model = model;
    problem.regions = {"body"};
    problem.materials.resize(1);
    problem.materials[0].density = 1000.;
    if (is_finite)
    {
      problem.deformation = Deformation::finite;
      problem.materials[0].shear.branches = {{1., std::numeric_limits<double>::infinity()}};
    }
    problem.boundaries = {"left", "right", "bottom", "top"};
    std::set<std::pair<unsigned int, unsigned int>> pairs;
    for (unsigned int b = 0; b < 4; ++b)
      pairs.insert({b, 0});
    problem.conditions =
        read_boundary_conditions(file.root().subsection("Boundaries"), problem.boundaries,
                                 problem.regions, pairs, 2, model == Model::axisymmetric);
    problem.interior.read(file.root().subsection("Body force"),
                          file.root().subsection("Initial state"), problem.regions, 2);
    loads.build();
  }
  DistributedVector vector(const double time) const
  {
    DistributedVector f = space.velocity_vector();
    loads.add(time, f);
    return f;
  }
  /// f . u for a motion u.
  double work(const double time, const std::function<Tensor<1, 2>(const Point<2> &)> &motion) const
  {
    return vector(time) * small_problem::interpolated<2>(space, motion);
  }
  double force(const double time, const unsigned int component) const
  {
    return work(time,
                [component](const Point<2> &)
                {
                  Tensor<1, 2> unit;
                  unit[component] = 1.;
                  return unit;
                });
  }

  small_problem::Mesh<2> mesh;
  Space<2> space;
  ParameterFile file;
  Problem problem;
  Loads<2> loads;
};

std::string on_the_right(const std::string &entries)
{
  return "subsection left\nset Type = free\nend\nsubsection bottom\nset Type = free\nend\n"
         "subsection top\nset Type = free\nend\nsubsection right\n" +
         entries + "\nend\n";
}
std::string body_force(const std::string &components)
{
  return "subsection Body force\nset Force density = " + components + "\nend\n";
}
} // namespace

UNIT_TEST(loads)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const double angle = 0.4;
  {
    const Case c(on_the_right("set Type = traction\nset Traction = 3, -5"), "", 0.);
    check::relative("traction: x", c.force(0., 0), 6., 1e-13);
    check::relative("traction: y", c.force(0., 1), -10., 1e-13);
    // y from 0 to 2 on the side x = 2: force -5 y ds has the moment -5 * 2.
    check::relative("traction: moment",
                    c.work(0.,
                           [](const Point<2> &x) {
                             return Tensor<1, 2>({0., x[1]});
                           }),
                    -10., 1e-13);
    check::is_true("constant: no jump", !c.loads.jumps(0.95, 1.05));
  }
  {
    const Case c(on_the_right("set Type = pressure\nset Pressure = 10"), "", angle);
    check::relative("pressure on an inclined side: x", c.force(0., 0), -20. * std::cos(angle),
                    1e-13);
    check::relative("pressure on an inclined side: y", c.force(0., 1), -20. * std::sin(angle),
                    1e-13);
    const Tensor<1, 2> normal({std::cos(angle), std::sin(angle)});
    const Tensor<1, 2> t =
        Loads<2>::prescribed_traction(c.problem.conditions.back(), Point<2>(), normal, 0.);
    check::absolute("prescribed traction", (t + 10. * normal).norm(), 0., 1e-13);
  }
  {
    // The tangential half alone counts where the normal one is a velocity.
    const Case c(on_the_right("set Type = mixed\nset Normal = velocity\nset Normal velocity = 0\n"
                              "set Tangential traction = 3, 4"),
                 "", 0.);
    check::absolute("tangential traction: x", c.force(0., 0), 0., 1e-13);
    check::relative("tangential traction: y", c.force(0., 1), 8., 1e-13);
    const Case n(on_the_right("set Type = mixed\nset Normal = traction\nset Normal traction = 6"),
                 "", angle);
    check::relative("normal traction pulls", n.force(0., 0), 12. * std::cos(angle), 1e-13);
  }
  {
    const Case c(on_the_right("set Type = free"), body_force("7, -9.81*x"), 0.);
    check::relative("body force: x", c.force(0., 0), 28., 1e-13);
    check::relative("body force: y", c.force(0., 1), -9.81 * 4., 1e-13);
  }
  {
    // A function of time times a function of place, as one and as two of which each is the quick
    // kind.
    const Case c(on_the_right("set Type = traction\nset Traction = cos(t), 2*t*y"),
                 body_force("0, t"), 0.);
    check::relative("in time: x", c.force(2., 0), 2. * std::cos(2.), 1e-13);
    check::relative("in time and place: y", c.force(2., 1), 8. + 8., 1e-13);
    const Case general(on_the_right("set Type = traction\nset Traction = cos(t) + 0*x, 3*t + 0*x"),
                       "", 0.);
    const Case separable(on_the_right("set Type = traction\nset Traction = cos(t), 3*t"), "", 0.);
    DistributedVector difference = general.vector(0.7);
    difference.add(-1., separable.vector(0.7));
    check::absolute("separable = general", difference.linfty_norm(), 0., 1e-14);
  }
  {
    const Case c(on_the_right("set Type = pressure\nset Pressure = step(t-1)"), "", 0.);
    check::is_true("jump", c.loads.jumps(0.95, 1.05) && !c.loads.jumps(1.05, 1.15));
    const Case s(on_the_right("set Type = pressure\nset Pressure = (1+y)*step(t-1)"), "", 0.);
    check::is_true("jump of a function of place",
                   s.loads.jumps(0.95, 1.05) && !s.loads.jumps(1.05, 1.15));
    const Case n(on_the_right("set Type = pressure\nset Pressure = sin(t)"), "", 0.);
    check::is_true("no jump", !n.loads.jumps(-0.05, 0.05) && !n.loads.jumps(3., 3.1));
  }
  {
    const std::string pressure = on_the_right("set Type = pressure\nset Pressure = 10"),
                      traction = on_the_right("set Type = traction\nset Traction = 3, 0");
    const Case follows(pressure, body_force("7*x, 0"), 0., Model::plane_strain, true);
    check::absolute("finite strain: pressure and force of the place", follows.vector(0.).l2_norm(),
                    0., 0.);
    check::relative("finite strain: flow", follows.loads.flow_of_velocities(3).l1_norm(), 2.,
                    1e-13);
    const Case stays(traction, body_force("7, 0"), 0., Model::plane_strain, true);
    check::relative("finite strain: traction and constant force", stays.force(0., 0), 6. + 28.,
                    1e-13);
    const Case jumps(on_the_right("set Type = pressure\nset Pressure = step(t-1)"), "", 0.,
                     Model::plane_strain, true);
    check::is_true("finite strain: jump", jumps.loads.jumps(0.95, 1.05));
  }
  {
    // Radius 2: the disc of area 4 pi at x = 2, and the volume 8 pi.
    const std::string sides = on_the_right("set Type = pressure\nset Pressure = 10");
    const Case c(sides, body_force("1, 0"), 0., Model::axisymmetric);
    check::relative("axisymmetric: pressure on a disc and body force", c.force(0., 0),
                    -40. * numbers::PI + 8. * numbers::PI, 1e-13);
  }
}
} // namespace test_of_loads
