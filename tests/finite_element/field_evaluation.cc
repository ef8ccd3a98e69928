// Probes of fields that the spaces hold exactly: values, means, integrals and stresses, on hanging
// nodes, at corners of cells and on either side of an interface.

#include <continua/finite_element/looking/field_evaluation.h>
#include <continua/finite_element/looking/traction_jump.h>
#include <continua/finite_element/products/region_operators.h>

#include "../unit_test.h"
#include "small_problem.h"

namespace test_of_field_evaluation
{
using namespace Continua;
using namespace dealii;

namespace
{
Problem make_problem(const Model model)
{
  Problem problem;
  problem.model = model;
  problem.regions = {"one", "two"};
  problem.boundaries = {"left", "right", "bottom", "top"};
  Material one, two;
  one.shear.branches = {Branch{3., std::numeric_limits<double>::infinity()}};
  one.compression = two.compression = Compression::elastic(1.);
  two.shear.viscosity = 2.;
  problem.materials = {one, two};
  for (unsigned int b = 0; b < 4; ++b)
  {
    BoundaryCondition fixed;
    fixed.name = problem.boundaries[b];
    fixed.boundary_id = b;
    fixed.region_ids = {0, 1};
    fixed.normal.kind = fixed.tangential.kind = BoundaryPart::Kind::velocity;
    problem.conditions.push_back(fixed);
  }
  return problem;
}

struct Body
{
  explicit Body(const Model model)
      : mesh(MPI_COMM_WORLD),
        problem(make_problem(model)),
        space(mesh, SpaceParameters(), model, 2),
        history(problem.materials),
        evaluation(space, problem)
  {
    small_problem::make_box<2>(mesh, {4, 2}, Point<2>(), 2.);
    small_problem::refine<2>(mesh, [](const Point<2> &x) { return x[0] > 2. && x[1] > 1.; });
    space.distribute();
    std::vector<RegionOperators> operators(2);
    assemble_region_operators(space, operators);
    history.reinit(space.velocity_vector(), velocity_nodes(operators));
    velocity = small_problem::interpolated<2>(
        space,
        [](const Point<2> &x) {
          return Tensor<1, 2>({1. + 2. * x[0] + 3. * x[1], 5. * x[1]});
        });
    history.displacement() =
        small_problem::interpolated<2>(space,
                                       [](const Point<2> &x) {
                                         return Tensor<1, 2>({x[0] * x[1], 4. * x[1]});
                                       });
    pressure = small_problem::interpolated_pressure<2>(
        space, [](const Point<2> &x, const unsigned int region) { return x[0] + 100. * region; });
  }
  double probe(const std::string &field, const Point<2> &point, const int region = -1)
  {
    ProbeRequest<2> request;
    request.field = field;
    request.point = point;
    if (region >= 0)
      request.region_ids = {static_cast<unsigned int>(region)};
    return value(request);
  }
  double on_boundary(const std::string &field, const unsigned int boundary, const bool mean)
  {
    ProbeRequest<2> request;
    request.field = field;
    request.kind =
        mean ? ProbeRequest<2>::Kind::boundary_mean : ProbeRequest<2>::Kind::boundary_integral;
    request.boundary_ids = {boundary};
    return value(request);
  }
  double on_section(const ProbeRequest<2>::Kind kind,
                    const std::string &field,
                    const double x,
                    const std::set<unsigned int> &regions = {})
  {
    ProbeRequest<2> request;
    request.kind = kind;
    request.field = field;
    request.point[0] = x;
    request.region_ids = regions;
    return value(request);
  }
  double value(const ProbeRequest<2> &request)
  {
    const unsigned int number = evaluation.add(request);
    std::vector<double> values;
    evaluation.evaluate(State{velocity, pressure, history}, nullptr, values);
    return values.at(number);
  }

  small_problem::Mesh<2> mesh;
  Problem problem;
  Space<2> space;
  BranchHistory history;
  FieldEvaluation<2> evaluation;
  DistributedVector velocity, pressure;
};

/// The liquid right of x = 2 on its boundaries and on the solid, of which every face has a quarter
/// of it finer: grad U = (2, 3; 0, 5) and eta = 2, so that n.sigma has the tangential part 6.
void test_walls()
{
  Body body(Model::plane_strain);
  const auto on_wall = [&body](const std::string &field, const unsigned int boundary)
  {
    ProbeRequest<2> request;
    request.kind = ProbeRequest<2>::Kind::boundary_mean;
    request.field = field;
    request.boundary_ids = {boundary};
    request.region_ids = {1};
    return body.value(request);
  };
  const auto on_interface =
      [&body](const ProbeRequest<2>::Kind kind, const std::string &field, const unsigned int region)
  {
    ProbeRequest<2> request;
    request.kind = kind;
    request.field = field;
    request.region_ids = {region};
    request.neighbour_ids = {1 - region};
    return body.value(request);
  };
  using Kind = ProbeRequest<2>::Kind;
  check::relative("vorticity", body.probe("vorticity z", {1.3, 0.7}), -3., 1e-12);
  check::relative("Q criterion", body.probe("Q criterion", {1.3, 0.7}), -14.5, 1e-12);
  check::relative("mean Q criterion", body.on_boundary("Q criterion", 3, true), -14.5, 1e-12);
  check::relative("shear on the top", on_wall("wall shear stress x", 3), -6., 1e-12);
  check::relative("shear on the bottom", on_wall("wall shear stress x", 2), 6., 1e-12);
  check::relative("shear on the right", on_wall("wall shear stress y", 1), -6., 1e-12);
  check::absolute("none along the normal", on_wall("wall shear stress x", 1), 0., 1e-12);
  check::relative("its magnitude", on_wall("magnitude of wall shear stress", 2), 6., 1e-12);
  check::relative("shear on the solid", on_interface(Kind::boundary_mean, "wall shear stress y", 1),
                  6., 1e-12);
  check::relative("its integral", on_interface(Kind::boundary_integral, "wall shear stress y", 1),
                  12., 1e-12);
  check::relative("pressure on the solid's side", on_interface(Kind::boundary_mean, "pressure", 0),
                  2., 1e-12);
  check::relative("pressure on the liquid's side", on_interface(Kind::boundary_mean, "pressure", 1),
                  102., 1e-12);
  // Of the velocity x - 1.3 - y/10 on the bottom and on the top; 0.4 m and more along the right.
  body.velocity =
      small_problem::interpolated<2>(body.space,
                                     [](const Point<2> &x) {
                                       return Tensor<1, 2>({x[0] - 1.3 - 0.1 * x[1], x[1] - 0.4});
                                     });
  const auto sign_change =
      [&body](const unsigned int boundary, const std::string &field, const unsigned int coordinate)
  {
    ProbeRequest<2> request;
    request.kind = Kind::sign_change;
    request.field = field;
    request.boundary_ids = {boundary};
    request.component = coordinate;
    request.range.second = 3.5;
    return body.value(request);
  };
  check::relative("change of sign on the bottom", sign_change(2, "velocity x", 0), 1.3, 1e-12);
  check::relative("change of sign on the top", sign_change(3, "velocity x", 0), 1.5, 1e-12);
  check::relative("change of sign on the right", sign_change(1, "velocity y", 1), 0.4, 1e-12);
  check::is_true("no change of sign", std::isnan(sign_change(2, "velocity y", 0)));
}

/// A liquid in simple shear whose viscosity follows the rate of shear.
void test_flow_curve()
{
  Body body(Model::plane_strain);
  FlowCurve curve;
  curve.zero_rate_viscosity = 2.;
  curve.infinite_rate_viscosity = 0.5;
  curve.time = 1.;
  curve.yasuda_exponent = 2.;
  curve.index = 0.;
  body.problem.materials[1].shear.flow_curve = curve;
  body.velocity = small_problem::interpolated<2>(body.space,
                                                 [](const Point<2> &x) {
                                                   return Tensor<1, 2>({3. * x[1], 0.});
                                                 });
  // The rate of shear is 3, and eta = 0.5 + 1.5/sqrt(1 + 9).
  const double shear_stress = 3. * (0.5 + 1.5 / std::sqrt(10.));
  check::relative("stress of a flow curve", body.probe("stress xy", {3.1, 0.3}), shear_stress,
                  1e-12);
  check::relative("its pressure", body.probe("stress xx", {3.1, 0.3}), -103.1, 1e-12);
  ProbeRequest<2> request;
  request.kind = ProbeRequest<2>::Kind::boundary_mean;
  request.boundary_ids = {2};
  request.region_ids = {1};
  request.field = "wall shear stress x";
  check::relative("its shear on a wall", body.value(request), shear_stress, 1e-12);
}

/// About the x axis in three dimensions: a box with the corner (0, 1, 1), v = (y, y, z), so that
/// the radial velocity is r; fluid with eta = 2.
void test_three_dimensions()
{
  small_problem::Mesh<3> mesh(MPI_COMM_WORLD);
  small_problem::make_box<3>(mesh, {2, 1, 1}, Point<3>(0., 1., 1.));
  small_problem::refine<3>(mesh, [](const Point<3> &x) { return x[0] > 1.; });
  Problem problem = make_problem(Model::three_dimensional);
  problem.regions = {"two"};
  problem.materials = {problem.materials[1]};
  Space<3> space(mesh, SpaceParameters(), Model::three_dimensional, 1);
  space.distribute();
  BranchHistory history(problem.materials);
  std::vector<RegionOperators> operators(1);
  assemble_region_operators(space, operators);
  history.reinit(space.velocity_vector(), velocity_nodes(operators));
  FieldEvaluation<3> evaluation(space, problem);
  const DistributedVector velocity =
      small_problem::interpolated<3>(space,
                                     [](const Point<3> &x) {
                                       return Tensor<1, 3>({x[1], x[1], x[2]});
                                     });
  const DistributedVector pressure = small_problem::interpolated_pressure<3>(
      space, [](const Point<3> &x, unsigned int) { return x[1]; });
  const auto value = [&](const ProbeRequest<3>::Kind kind, const std::string &field,
                         const Point<3> &point, const Tensor<1, 3> &normal)
  {
    ProbeRequest<3> request;
    request.kind = kind;
    request.field = field;
    request.point = point;
    request.normal = normal;
    const unsigned int number = evaluation.add(request);
    std::vector<double> values;
    evaluation.evaluate(State{velocity, pressure, history}, nullptr, values);
    return values.at(number);
  };
  using Kind = ProbeRequest<3>::Kind;
  const Point<3> point(0.4, 1.5, 2.);
  const Tensor<1, 3> axial({1., 0., 0.});
  check::relative("radial velocity", value(Kind::point, "radial velocity", point, axial), 2.5,
                  1e-13);
  // e_r = (0, 0.6, 0.8), and s_xy = eta = 2.
  check::relative("wall shear stress", value(Kind::point, "wall shear stress", point, axial), -1.2,
                  1e-12);
  // e_theta.e.e_theta = 1, a third of the trace is 2/3.
  check::relative("hoop stress in three dimensions",
                  value(Kind::point, "hoop stress", point, axial), 4. / 3. - 1.5, 1e-12);
  check::relative("integral over a plane",
                  value(Kind::section_integral, "velocity z", point, axial), 1.5, 1e-8);
  check::relative("through faces with hanging nodes",
                  value(Kind::section_mean, "pressure", Point<3>(1., 0., 0.), axial), 1.5, 1e-8);
  check::relative(
      "over an oblique plane",
      value(Kind::section_integral, "pressure", Point<3>(1., 1.5, 1.5), Tensor<1, 3>({1., 1., 0.})),
      1.5 * std::sqrt(2.), 1e-8);
  // On the face y = 2 with n = e_y: eta dv_x/dy = 2 along x.
  const auto on_boundary = [&](const std::string &field)
  {
    ProbeRequest<3> request;
    request.kind = ProbeRequest<3>::Kind::boundary_mean;
    request.field = field;
    request.boundary_ids = {3};
    const unsigned int number = evaluation.add(request);
    std::vector<double> values;
    evaluation.evaluate(State{velocity, pressure, history}, nullptr, values);
    return values.at(number);
  };
  check::relative("shear on a wall in three dimensions", on_boundary("wall shear stress x"), -2.,
                  1e-12);
  check::absolute("none across it", on_boundary("wall shear stress z"), 0., 1e-12);
  check::relative("its magnitude", on_boundary("magnitude of wall shear stress"), 2., 1e-12);
  check::relative("vorticity", value(Kind::point, "vorticity z", point, axial), -1., 1e-12);
  check::relative("Q criterion", value(Kind::point, "Q criterion", point, axial), -1., 1e-12);
}
} // namespace

UNIT_TEST(field_evaluation)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  small_problem::quiet_other_ranks();
  test_three_dimensions();
  test_walls();
  test_flow_curve();
  {
    Body body(Model::plane_strain);
    check::relative("velocity x", body.probe("velocity x", {1.3, 0.7}), 5.7, 1e-13);
    check::relative("velocity y at a corner of cells", body.probe("velocity y", {2., 1.}), 5.,
                    1e-13);
    check::relative("velocity x at a hanging node", body.probe("velocity x", {2., 1.5}), 9.5,
                    1e-13);
    check::relative("displacement x", body.probe("displacement x", {3.1, 1.7}), 5.27, 1e-13);
    check::relative("pressure, left of the interface", body.probe("pressure", {2., 1.5}, 0), 2.,
                    1e-13);
    check::relative("pressure, right of it", body.probe("pressure", {2., 1.5}, 1), 102., 1e-13);
    // Region one: w = 3 D, grad D = (y, x; 0, 4); at (1, 0.5) e = (0.5, 4), e_xy = 0.5, tr / 3
    // = 1.5.
    check::relative("stress xx of the solid", body.probe("stress xx", {1., 0.5}),
                    6. * (0.5 - 1.5) - 1., 1e-12);
    check::relative("stress yy of the solid", body.probe("stress yy", {1., 0.5}), 6. * 2.5 - 1.,
                    1e-12);
    check::relative("stress zz of the solid", body.probe("stress zz", {1., 0.5}), 6. * -1.5 - 1.,
                    1e-12);
    check::relative("stress xy of the solid", body.probe("stress xy", {1., 0.5}), 3., 1e-12);
    // Region two: w = 2 U, grad U = (2, 3; 0, 5), tr / 3 = 7 / 3; p = 103.
    check::relative("stress xx of the fluid", body.probe("stress xx", {3., 0.5}),
                    4. * (2. - 7. / 3.) - 103., 1e-12);
    check::relative("stress xy of the fluid", body.probe("stress xy", {3., 0.5}), 6., 1e-12);
    check::relative("mean on the top", body.on_boundary("velocity x", 3, true), 11., 1e-13);
    check::relative("integral on the right", body.on_boundary("velocity x", 1, false), 24., 1e-13);
    check::relative("mean pressure on the right", body.on_boundary("pressure", 1, true), 104.,
                    1e-13);
    // The plane is moved by 1e-9 of the body's extent. At x = 3 there are hanging nodes.
    using Kind = ProbeRequest<2>::Kind;
    check::relative("integral over a section",
                    body.on_section(Kind::section_integral, "velocity x", 2.5), 2. * 9., 1e-8);
    check::relative("mean over a section", body.on_section(Kind::section_mean, "velocity y", 2.7),
                    5., 1e-8);
    check::relative("through faces of cells",
                    body.on_section(Kind::section_integral, "velocity x", 3.), 2. * 10., 1e-8);
    check::relative("at the end", body.on_section(Kind::section_mean, "velocity x", 4.), 12., 1e-8);
    check::relative("at the beginning", body.on_section(Kind::section_mean, "velocity x", 0.), 4.,
                    1e-8);
    check::relative("through the interface, region one",
                    body.on_section(Kind::section_mean, "pressure", 2., {0}), 2., 1e-8);
    check::relative("through the interface, region two",
                    body.on_section(Kind::section_mean, "pressure", 2., {1}), 102., 1e-8);
    check::relative("stress over a section", body.on_section(Kind::section_mean, "stress xy", 3.5),
                    6., 1e-8);
    check::throws<std::invalid_argument>(
        "a section outside", [&] { body.on_section(Kind::section_mean, "pressure", 4.1); },
        "a section without area");
    check::throws<std::invalid_argument>(
        "a section beside the region",
        [&] { body.on_section(Kind::section_mean, "pressure", 3., {0}); },
        "a section without area");
    check::throws<std::invalid_argument>(
        "no radial field in a plane",
        [&] {
          body.probe("radial velocity", {1., 1.});
        },
        "radial velocity");
    check::throws<std::invalid_argument>(
        "outside",
        [&] {
          body.probe("pressure", {4.1, 1.});
        },
        "not inside");
    check::throws<std::invalid_argument>(
        "not in that region",
        [&] {
          body.probe("pressure", {3., 1.}, 0);
        },
        "not inside");
    check::throws<std::invalid_argument>(
        "no such field",
        [&] {
          body.probe("helicity", {1., 1.});
        },
        "helicity");
    Body error_body(Model::plane_strain);
    const State state{error_body.velocity, error_body.pressure, error_body.history};
    const std::vector<Expression> exact = {Expression("1+2*x+3*y", Dimensions::none),
                                           Expression("5*y+0.5", Dimensions::none)};
    // Off by 0.5 everywhere on an area of 8.
    check::relative("error norm",
                    error_body.evaluation.error_norm(state, ComparedField::velocity, exact, 0.),
                    0.5 * std::sqrt(8.), 1e-12);
  }
  {
    Body tube(Model::axisymmetric);
    // Hoop strain of D is 4: e = (y, 4, 4) at (1, 0.5), tr / 3 = 8.5 / 3.
    check::relative("hoop stress", tube.probe("stress zz", {1., 0.5}), 6. * (4. - 8.5 / 3.) - 1.,
                    1e-12);
    check::relative("hoop stress on the axis", tube.probe("stress zz", {1., 0.}),
                    6. * (4. - 8. / 3.) - 1., 1e-12);
    check::relative("flow through the right end", tube.on_boundary("velocity x", 1, false),
                    // int (9 + 3 r) 2 pi r dr over r < 2
                    2. * numbers::PI * (18. + 8.), 1e-13);
    using Kind = ProbeRequest<2>::Kind;
    check::relative("flow through a section",
                    tube.on_section(Kind::section_integral, "velocity x", 2.5),
                    // int (6 + 3 r) 2 pi r dr
                    2. * numbers::PI * (12. + 8.), 1e-8);
    check::relative("mean over a round section",
                    tube.on_section(Kind::section_mean, "velocity x", 2.5), 10., 1e-8);
    check::relative("mean round the rim",
                    tube.on_section(Kind::rim_mean, "radial displacement", 2.5), 8., 1e-8);
    check::relative("hoop stress by its name", tube.probe("hoop stress", {1., 0.5}),
                    tube.probe("stress zz", {1., 0.5}), 1e-14);
    // eta dU_x/dr = 6 drags what is outside against the flow.
    check::relative("shear stress at the rim",
                    tube.on_section(Kind::rim_mean, "wall shear stress", 2.5), -6., 1e-8);
  }
  {
    // A pressure of 2 in region one and 5 in region two, at rest: the traction jumps by 3 at x = 2.
    Body body(Model::plane_strain);
    body.velocity = 0.;
    body.history.displacement() = 0.;
    body.pressure = small_problem::interpolated_pressure<2>(
        body.space,
        [](const Point<2> &, const unsigned int region) { return region == 0 ? 2. : 5.; });
    const std::vector<double> no_outlets(body.problem.conditions.size(), 0.);
    Vector<float> indicators;
    traction_jump_indicators<2>(body.space, body.problem, nullptr,
                                State{body.velocity, body.pressure, body.history}, no_outlets, 0.,
                                indicators);
    double largest_elsewhere = 0., coarse = 0., fine = 0.;
    for (const auto &cell : body.mesh.active_cell_iterators())
      if (cell->is_locally_owned())
      {
        const double value = indicators[cell->active_cell_index()];
        if (cell->center().distance(Point<2>(1.5, 0.5)) < 1e-6)
          coarse = value;
        else if (cell->center().distance(Point<2>(2.25, 1.25)) < 1e-6)
          fine = value;
        else if (std::abs(cell->center()[0] - 2.) > 0.6)
          largest_elsewhere = std::max(largest_elsewhere, value);
      }
    // eta^2 = h / 2 int 3^2 over a face of length h.
    check::relative("jump of the traction, coarse face", coarse, std::sqrt(4.5), 1e-6);
    check::relative("jump of the traction, fine face", fine, std::sqrt(0.25 * 4.5), 1e-6);
    check::absolute("none elsewhere", largest_elsewhere, 0., 1e-12);

    // One linear motion and one material: no jump, hanging nodes included.
    body.problem.materials[1] = body.problem.materials[0];
    std::vector<RegionOperators> operators(2);
    assemble_region_operators(body.space, operators);
    BranchHistory history(body.problem.materials);
    history.reinit(body.space.velocity_vector(), velocity_nodes(operators));
    body.pressure = small_problem::interpolated_pressure<2>(
        body.space, [](const Point<2> &, unsigned int) { return 7.; });
    history.displacement() =
        small_problem::interpolated<2>(body.space,
                                       [](const Point<2> &x) {
                                         return Tensor<1, 2>({x[0] + 2. * x[1], 3. * x[0]});
                                       });
    traction_jump_indicators<2>(body.space, body.problem, nullptr,
                                State{body.velocity, body.pressure, history}, no_outlets, 0.,
                                indicators);
    check::absolute("linear state", indicators.linfty_norm(), 0., 1e-5);
  }
}
} // namespace test_of_field_evaluation
