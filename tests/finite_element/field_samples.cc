// Fields of a liquid whose mesh has moved: gradients, normals, lengths, areas, volumes and places
// of the present shape, and indicators of it, against closed forms and against deal.II's estimator.

#include <continua/finite_element/looking/field_evaluation.h>
#include <continua/finite_element/looking/kelly_indicator.h>
#include <continua/finite_element/looking/traction_jump.h>
#include <continua/finite_element/products/region_operators.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/mapping_q_eulerian.h>
#include <deal.II/numerics/error_estimator.h>

#include "../unit_test.h"
#include "small_problem.h"

namespace test_of_field_samples
{
using namespace Continua;
using namespace dealii;

namespace
{
template <int dim>
using Motion = std::function<Tensor<1, dim>(const Point<dim> &)>;

template <int dim>
Problem make_problem(const Model model, const unsigned int n_regions)
{
  Problem problem;
  problem.model = model;
  problem.deformation = Deformation::finite;
  problem.mesh_moves = true;
  Material liquid;
  liquid.shear.viscosity = 2.;
  liquid.compression = Compression::elastic(1.);
  for (unsigned int region = 0; region < n_regions; ++region)
  {
    problem.regions.push_back("liquid " + std::to_string(region));
    problem.materials.push_back(liquid);
  }
  for (unsigned int b = 0; b < 2 * dim; ++b)
  {
    problem.boundaries.push_back(std::to_string(b));
    BoundaryCondition fixed;
    fixed.boundary_id = b;
    for (unsigned int region = 0; region < n_regions; ++region)
      fixed.region_ids.insert(region);
    fixed.normal.kind = fixed.tangential.kind = BoundaryPart::Kind::velocity;
    problem.conditions.push_back(fixed);
  }
  return problem;
}

/// A box of unit cells, of which one corner is finer, with X -> x(X); velocity and pressure are
/// functions of X.
template <int dim>
struct MovedBody
{
  using Request = ProbeRequest<dim>;
  using Kind = typename Request::Kind;

  MovedBody(const Model model,
            const Point<dim> &origin,
            const Motion<dim> &place,
            const Motion<dim> &velocity_at,
            const std::function<double(const Point<dim> &, unsigned int)> &pressure_at,
            const double interface = 1e9)
      : mesh(MPI_COMM_WORLD, Triangulation<dim>::limit_level_difference_at_vertices),
        problem(make_problem<dim>(model, interface < 1e9 ? 2 : 1)),
        space(mesh, SpaceParameters(), model, problem.regions.size()),
        history(problem.materials),
        evaluation(space, problem)
  {
    small_problem::make_box<dim>(mesh, std::vector<unsigned int>(dim, 2), origin, interface);
    small_problem::refine<dim>(mesh,
                               [&](const Point<dim> &x) {
                                 return x[0] > origin[0] + 1. && x[1] > origin[1] + 1. &&
                                        x[dim - 1] > origin[dim - 1] + 1.;
                               });
    space.distribute();
    std::vector<RegionOperators> operators(problem.regions.size());
    assemble_region_operators(space, operators);
    history.reinit(space.velocity_vector(), velocity_nodes(operators));
    displacement =
        small_problem::interpolated<dim>(space, [&](const Point<dim> &x) { return place(x) - x; });
    velocity = small_problem::interpolated<dim>(space, velocity_at);
    pressure = small_problem::interpolated_pressure<dim>(space, pressure_at);
  }
  State state() const
  {
    State result{velocity, pressure, history};
    result.mesh_displacement = &displacement;
    return result;
  }
  double value(const Kind kind,
               const std::string &field,
               const unsigned int boundary = 0,
               const Point<dim> &point = Point<dim>(),
               const bool is_fixed_in_space = false)
  {
    Request request;
    request.is_fixed_in_space = is_fixed_in_space;
    request.kind = kind;
    request.field = field;
    request.point = point;
    if (kind == Kind::boundary_mean || kind == Kind::boundary_integral || kind == Kind::sign_change)
      request.boundary_ids = {boundary};
    const unsigned int number = evaluation.add(request);
    std::vector<double> values;
    evaluation.evaluate(state(), nullptr, values);
    return values.at(number);
  }

  small_problem::Mesh<dim> mesh;
  Problem problem;
  Space<dim> space;
  BranchHistory history;
  FieldEvaluation<dim> evaluation;
  DistributedVector displacement, velocity, pressure;
};

template <int dim>
double no_pressure(const Point<dim> &, unsigned int)
{
  return 0.;
}

/// x = X + X^2/10 along x, and v_y = X, so that dv_y/dx = 1/(1 + X/5) and dx = (1 + X/5) dX.
template <int dim>
void test_uneven_stretch(const Model model, const std::string &name)
{
  using Kind = typename ProbeRequest<dim>::Kind;
  const Motion<dim> place = [](const Point<dim> &x)
  {
    Tensor<1, dim> result = x;
    result[0] += 0.1 * x[0] * x[0];
    return result;
  };
  MovedBody<dim> body(
      model, Point<dim>(), place,
      [](const Point<dim> &x)
      {
        Tensor<1, dim> result;
        result[1] = x[0];
        return result;
      },
      no_pressure<dim>);
  const double depth = dim == 3 ? 2. : 1.;
  check::relative(name + "mean of a gradient", body.value(Kind::volume_mean, "vorticity z"),
                  2. / 2.4, 1e-12);
  check::relative(name + "its integral", body.value(Kind::volume_integral, "vorticity z"),
                  2. * 2. * depth, 1e-12);
  check::relative(name + "mean over a boundary",
                  body.value(Kind::boundary_mean, "wall shear stress x", 3), -2. * 2. / 2.4, 1e-12);
  check::relative(name + "mean of a velocity over a volume",
                  body.value(Kind::volume_mean, "velocity y"), (2. + 0.4 * 4. / 3.) / 2.4, 1e-12);
  check::relative(name + "mean over matter", body.value(Kind::volume_mean, "displacement x"),
                  0.4 / 3., 1e-12);
  Point<dim> point;
  point[0] = 0.5;
  check::relative(name + "at a point of the mesh", body.value(Kind::point, "stress xy", 0, point),
                  2. / 1.1, 1e-12);
  point[0] = 1.;
  point[1] = 0.3;
  const double at_rest = 5. * (std::sqrt(1.4) - 1.);
  check::relative(name + "at a point in space",
                  body.value(Kind::point, "velocity y", 0, point, true), at_rest, 1e-12);
  check::relative(name + "stress there", body.value(Kind::point, "stress xy", 0, point, true),
                  2. / (1. + 0.2 * at_rest), 1e-12);
}

/// A shear x = X + Y/2, and what flows through the oblique plane into which that of X = 1 goes.
void test_oblique_section()
{
  using Kind = ProbeRequest<3>::Kind;
  MovedBody<3> body(
      Model::three_dimensional, Point<3>(),
      [](const Point<3> &x) {
        return Tensor<1, 3>({x[0] + 0.5 * x[1], x[1], x[2]});
      },
      [](const Point<3> &) {
        return Tensor<1, 3>({3., 1., 0.});
      },
      no_pressure<3>);
  // J F^-T e_x = (1, -1/2, 0).
  check::relative("flow through an oblique section",
                  body.value(Kind::section_integral, "axial velocity", 0, Point<3>(1., 0., 0.)),
                  4. * 2.5, 1e-8);
  check::relative("velocity over it",
                  body.value(Kind::section_integral, "velocity x", 0, Point<3>(1., 0., 0.)),
                  12. * std::sqrt(1.25), 1e-8);
}

/// A square pipe about the x axis, of which y is doubled and that is then turned about z.
void test_rim()
{
  using Kind = ProbeRequest<3>::Kind;
  const double c = std::cos(0.5), s = std::sin(0.5);
  const auto turned = [&](const Tensor<1, 3> &x) {
    return Tensor<1, 3>({c * x[0] - s * x[1], s * x[0] + c * x[1], x[2]});
  };
  MovedBody<3> body(
      Model::three_dimensional, Point<3>(0., -1., -1.),
      [&](const Point<3> &x) {
        return turned(Tensor<1, 3>({x[0], 2. * x[1], x[2]}));
      },
      [&](const Point<3> &x) {
        return turned(Tensor<1, 3>({x[2] * x[2], 0., x[1] * x[1]}));
      },
      no_pressure<3>);
  const Point<3> point(1., 0., 0.);
  // Two sides of the length 4 with the mean 1/3, two of the length 2 with 1.
  check::relative("mean round a rim", body.value(Kind::rim_mean, "velocity z", 0, point),
                  (8. / 3. + 4.) / 12., 1e-8);
  // The velocity z^2 along the pipe: -eta 2 z e_r on the sides z = 1 and -1. At their points the
  // direction from the axis at rest has sin(arctan Y) = 1/sqrt(1 + Y^2) along z, but turned and
  // stretched along y as its normal. On the other sides dv/dz has z along z/sqrt(1/4 + z^2).
  const auto mean_on_line = [](const std::function<double(double)> &function)
  {
    const QGauss<1> points(40);
    double sum = 0.;
    for (unsigned int q = 0; q < points.size(); ++q)
      sum += points.weight(q) * function(2. * points.point(q)[0] - 1.);
    return sum;
  };
  const double on_long =
                   mean_on_line([](const double y) { return -4. / std::sqrt(1. + 0.25 * y * y); }),
               on_short = mean_on_line([](const double z)
                                       { return -4. * z * z / std::sqrt(0.25 + z * z); });
  // Gauss points on the rim of hanging and other cells are few.
  check::relative("shear round a turned rim",
                  body.value(Kind::rim_mean, "wall shear stress", 0, point),
                  (8. * on_long + 4. * on_short) / 12., 1e-4);
}

/// Axisymmetry: r = 1.5 R, x = 2 X; v = (r^2, 0).
void test_axisymmetric()
{
  using Kind = ProbeRequest<2>::Kind;
  MovedBody<2> body(
      Model::axisymmetric, Point<2>(),
      [](const Point<2> &x) {
        return Tensor<1, 2>({2. * x[0], 1.5 * x[1]});
      },
      [](const Point<2> &x) {
        return Tensor<1, 2>({2.25 * x[1] * x[1], 0.});
      },
      no_pressure<2>);
  const double pi = numbers::PI;
  check::relative("round a tube: shear over the wall",
                  body.value(Kind::boundary_integral, "wall shear stress x", 3),
                  -12. * 2. * pi * 3. * 4., 1e-12);
  check::relative("round a tube: shear round the rim",
                  body.value(Kind::rim_mean, "wall shear stress", 0, Point<2>(1., 0.)), -12., 1e-8);
  check::relative("round a tube: flow through a section",
                  body.value(Kind::section_integral, "axial velocity", 0, Point<2>(1., 0.)),
                  pi * 81. / 2., 1e-8);
  check::relative("round a tube: vorticity in the volume",
                  body.value(Kind::volume_integral, "vorticity z"), -2. * 2. * pi * 4. * 9., 1e-12);
}

/// Where a velocity changes its sign is said by the present place. The body leaves x < 1.
void test_sign_change()
{
  MovedBody<2> body(
      Model::plane_strain, Point<2>(),
      [](const Point<2> &x) {
        return Tensor<1, 2>({2. * x[0] + 1., x[1]});
      },
      [](const Point<2> &x) {
        return Tensor<1, 2>({x[0] - 0.7, 0.});
      },
      no_pressure<2>);
  check::relative("change of sign", body.value(ProbeRequest<2>::Kind::sign_change, "velocity x", 2),
                  2.4, 1e-12);
  check::is_true("a point in space that the body has left",
                 std::isnan(body.value(ProbeRequest<2>::Kind::point, "pressure", 0,
                                       Point<2>(0.5, 0.5), true)));
}

/// Kelly's indicator is that of deal.II on the moved mesh.
template <int dim>
void compare_with_library()
{
  const std::string name = dim == 2 ? "2-D: " : "3-D: ";
  MovedBody<dim> body(
      dim == 2 ? Model::plane_strain : Model::three_dimensional, Point<dim>(),
      [](const Point<dim> &x)
      {
        Tensor<1, dim> result = x;
        result[0] += 0.3 * std::sin(x[1]) + 0.1 * x[dim - 1] * x[dim - 1];
        result[1] *= 1.5 + 0.2 * x[0];
        return result;
      },
      [](const Point<dim> &x)
      {
        Tensor<1, dim> result;
        for (unsigned int c = 0; c < dim; ++c)
          result[c] = std::sin(3. * x[0] + 2. * c) * std::exp(x[1] - x[dim - 1] * c);
        return result;
      },
      [](const Point<dim> &x, unsigned int) { return std::cos(2. * x[0]) + x[1] * x[1]; });
  const Space<dim> &space = body.space;
  const DistributedVector displacement = space.ghosted_velocity(body.displacement);
  const MappingQEulerian<dim, DistributedVector> moved(space.degree(), space.velocity_dofs,
                                                       displacement);
  const hp::QCollection<dim - 1> points(QGauss<dim - 1>(space.degree() + 1));
  const auto compare = [&](const std::string &field, const DoFHandler<dim> &dofs,
                           const DistributedVector &vector, const Vector<float> &own)
  {
    Vector<float> library(body.mesh.n_active_cells());
    KellyErrorEstimator<dim>::estimate(moved, dofs, points, {}, vector, library);
    double largest = 0., scale = 0.;
    for (const auto &cell : body.mesh.active_cell_iterators())
      if (cell->is_locally_owned())
      {
        // deal.II takes the diameter of the undeformed cell.
        const auto corners = moved.get_vertices(cell);
        double diameter = 0.;
        for (unsigned int v = 0; v < corners.size() / 2; ++v)
          diameter = std::max(diameter, corners[v].distance(corners[corners.size() - 1 - v]));
        const unsigned int i = cell->active_cell_index();
        const double expected = library[i] * std::sqrt(diameter / cell->diameter());
        largest = std::max(largest, std::abs(own[i] - expected));
        scale = std::max(scale, expected);
      }
    check::absolute(name + field,
                    Utilities::MPI::max(largest, MPI_COMM_WORLD) /
                        Utilities::MPI::max(scale, MPI_COMM_WORLD),
                    0., 1e-5);
  };
  Vector<float> own(body.mesh.n_active_cells());
  kelly_indicators_of_velocity(space, body.velocity, &body.displacement, own);
  compare("Kelly's indicator of the velocity", space.velocity_dofs,
          space.ghosted_velocity(body.velocity), own);
  kelly_indicators_of_pressure(space, body.pressure, &body.displacement, own);
  compare("Kelly's indicator of the pressure", space.pressure_dofs,
          space.ghosted_pressure(body.pressure), own);
}

/// A pressure that jumps by 3 at X = 1, on a mesh that is stretched threefold along y.
void test_traction_jump()
{
  MovedBody<2> body(
      Model::plane_strain, Point<2>(),
      [](const Point<2> &x) {
        return Tensor<1, 2>({2. * x[0], 3. * x[1]});
      },
      [](const Point<2> &x) {
        return Tensor<1, 2>({3. * x[1], 0.});
      },
      [](const Point<2> &, const unsigned int region) { return region == 0 ? 2. : 5.; }, 1.);
  Vector<float> indicators;
  traction_jump_indicators<2>(body.space, body.problem, nullptr, body.state(),
                              std::vector<double>(4, 0.), 0., indicators);
  double error = 0.;
  for (const auto &cell : body.mesh.active_cell_iterators())
    if (cell->is_locally_owned())
    {
      // eta^2 = h/2 int 3^2 over a face of the present length h.
      const double length = cell->level() == 0 ? 3. : 1.5,
                   expected = cell->center()[0] > 1.3 && cell->level() > 0
                                  ? 0.
                                  : std::sqrt(0.5 * 9.) * length;
      error = std::max(error, std::abs(indicators[cell->active_cell_index()] - expected));
    }
  check::absolute("jump of the traction", Utilities::MPI::max(error, MPI_COMM_WORLD), 0., 1e-5);
}
} // namespace

UNIT_TEST(field_samples)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  small_problem::quiet_other_ranks();
  test_uneven_stretch<2>(Model::plane_strain, "2-D: ");
  test_uneven_stretch<3>(Model::three_dimensional, "3-D: ");
  test_oblique_section();
  test_rim();
  test_axisymmetric();
  test_sign_change();
  compare_with_library<2>();
  compare_with_library<3>();
  test_traction_jump();
}
} // namespace test_of_field_samples
