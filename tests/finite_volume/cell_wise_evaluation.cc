// Probes of linear fields, which reconstruction has exactly on every mesh with flat faces: values,
// stresses and strains at centres and corners of cells, on boundaries and on either side of an
// interface; means and integrals; and of quadratic fields with second order.

#include "../unit_test.h"
#include "cell_wise_body.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace test_of_cell_wise_evaluation
{
using namespace cell_wise_meshes;
using dealii::Point;
using dealii::Tensor;
namespace numbers = dealii::numbers;
namespace Utilities = dealii::Utilities;

namespace
{
template <int dim>
using Kind = typename ProbeRequest<dim>::Kind;

/// With grad U = A, grad D = B and p = a.x + 100 region; in axisymmetry U_r, D_r in proportion to
/// r.
template <int dim>
struct Linear
{
  explicit Linear(const bool axisymmetric)
  {
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = 0; j < dim; ++j)
      {
        of_velocity[i][j] = 1. + i + 3. * j - 0.7 * i * j;
        of_displacement[i][j] = 2. - 0.5 * i + 0.3 * j + i * j;
      }
    if (axisymmetric)
      of_velocity[1][0] = of_displacement[1][0] = 0.;
    else
      at_origin[1] = 0.4;
    at_origin[0] = -0.3;
  }
  Tensor<1, dim> velocity(const Point<dim> &x) const { return at_origin + of_velocity * x; }
  Tensor<1, dim> displacement(const Point<dim> &x) const { return at_origin + of_displacement * x; }
  static double pressure(const Point<dim> &x, const unsigned int region)
  {
    return slope<dim>() * x + 100. * region;
  }
  Tensor<2, dim> of_velocity, of_displacement;
  Tensor<1, dim> at_origin;
};

template <int dim>
void set(Body<dim> &body, const Linear<dim> &linear)
{
  body.velocity =
      velocity_field<dim>(body.space, [&](const Point<dim> &x) { return linear.velocity(x); });
  body.history.displacement() =
      velocity_field<dim>(body.space, [&](const Point<dim> &x) { return linear.displacement(x); });
  body.pressure = pressure_field<dim>(body.space, linear.pressure);
}

/// Some centres, corners and middles of faces of cells, with the region of the cell; the same on
/// all ranks.
template <int dim>
std::vector<std::pair<Point<dim>, unsigned int>> places(const Body<dim> &body,
                                                        const bool with_faces)
{
  std::vector<std::pair<Point<dim>, unsigned int>> mine, all;
  for (unsigned int cell = 0; cell < body.space.mesh.n_owned_cells(); cell += dim == 2 ? 3 : 13)
  {
    const auto &volume = body.space.mesh.cells()[cell];
    mine.emplace_back(volume.centre, volume.material_id);
    mine.emplace_back(volume.iterator->vertex(cell % 4), volume.material_id);
    // The middle of a chord is not inside a body that is hollow there.
    if (with_faces)
      mine.emplace_back(body.space.mesh.faces()[volume.faces[cell % 4]].centre, volume.material_id);
  }
  for (const auto &other : Utilities::MPI::all_gather(MPI_COMM_WORLD, mine))
    all.insert(all.end(), other.begin(), other.end());
  return all;
}

/// Whether a boundary face of a cell has the point, as a corner or its middle; on any rank.
template <int dim>
bool is_on_boundary(const Body<dim> &body, const Point<dim> &point)
{
  double nearest = 1.;
  for (const auto &cell : body.triangulation.active_cell_iterators())
    for (const auto &face : cell->face_iterators())
      if (face->at_boundary())
      {
        nearest = std::min(nearest, face->center().distance(point));
        for (const unsigned int v : face->vertex_indices())
          nearest = std::min(nearest, face->vertex(v).distance(point));
      }
  return Utilities::MPI::min(nearest, MPI_COMM_WORLD) < 1e-9;
}

template <int dim>
void test_points(const Model model)
{
  const bool axisymmetric = model == Model::axisymmetric;
  for (const auto &named : flat_faced<dim>())
  {
    Body<dim> body(named.make, model);
    const Linear<dim> linear(axisymmetric);
    set(body, linear);
    std::map<std::string, double> errors;
    for (const auto &place : places(body, named.name != "adaptive and curved"))
    {
      // Names that a lambda can take.
      const auto &point = place.first;
      const unsigned int region = place.second;
      const auto error = [&](const std::string &field, const double exact)
      {
        ProbeRequest<dim> request;
        request.field = field;
        request.point = point;
        request.region_ids = {region};
        double &largest = errors[field];
        largest = std::max(largest, std::abs(body.value(request) - exact));
      };
      error("velocity x", linear.velocity(point)[0]);
      // On a face that is held a liquid's displacement is that of the face's middle, all over.
      if (region == 0 || !is_on_boundary(body, point))
        error("displacement y", linear.displacement(point)[1]);
      const double p = linear.pressure(point, region);
      error("pressure", p);
      // s = 2 dev sym grad w, w = 3 D in the solid and 2 U in the fluid.
      const Tensor<2, dim> gradient =
          region == 0 ? 3. * linear.of_displacement : 2. * linear.of_velocity;
      const double hoop = axisymmetric ? gradient[1][1] : 0.;
      const double mean = (trace(gradient) + hoop) / 3.;
      error("stress xx", 2. * (gradient[0][0] - mean) - p);
      error("stress xy", gradient[0][1] + gradient[1][0]);
      if (dim == 2)
        error("stress zz", 2. * (hoop - mean) - p);
      error("strain xy", 0.5 * (linear.of_displacement[0][1] + linear.of_displacement[1][0]));
      error("strain yy", linear.of_displacement[1][1]);
    }
    for (const auto &[field, error] : errors)
      check::absolute((axisymmetric ? "axisymmetric, "
                       : dim == 2   ? "2-D, "
                                    : "3-D, ") +
                          named.name + ": " + field,
                      error, 0., 1e-10);
  }
}

template <int dim>
ProbeRequest<dim> request(const Kind<dim> kind, const std::string &field, const double x)
{
  ProbeRequest<dim> result;
  result.kind = kind;
  result.field = field;
  result.point[0] = x;
  return result;
}

template <int dim>
ProbeRequest<dim>
on_boundary(const Kind<dim> kind, const std::string &field, const unsigned int boundary)
{
  ProbeRequest<dim> result;
  result.kind = kind;
  result.field = field;
  result.boundary_ids = {boundary};
  return result;
}

/// Means over boundaries and sections of the unit square or cube are values in the middle.
template <int dim>
void test_means()
{
  using K = Kind<dim>;
  const Model model = dim == 2 ? Model::plane_strain : Model::three_dimensional;
  const std::string name = dim == 2 ? "2-D: " : "3-D: ";
  Body<dim> body(
      [](Triangulation<dim> &mesh)
      {
        make_box(mesh, 4);
        refine_corner(mesh);
      },
      model);
  const Linear<dim> linear(false);
  set(body, linear);
  Point<dim> middle;
  for (unsigned int c = 1; c < dim; ++c)
    middle[c] = 0.5;
  middle[0] = 1.;
  check::relative(name + "mean on a boundary",
                  body.value(on_boundary<dim>(K::boundary_mean, "velocity x", 1)),
                  linear.velocity(middle)[0], 1e-12);
  check::relative(name + "integral of the stress",
                  body.value(on_boundary<dim>(K::boundary_integral, "stress xy", 1)),
                  3. * (linear.of_displacement[0][1] + linear.of_displacement[1][0]), 1e-11);
  auto of_fluid = on_boundary<dim>(K::boundary_mean, "pressure", 0);
  of_fluid.region_ids = {1};
  middle[0] = 0.;
  check::relative(name + "pressure where the fluid touches a boundary", body.value(of_fluid),
                  linear.pressure(middle, 1), 1e-12);
  // The plane is moved by 1e-9 of the body's extent.
  for (const double x : {0., 0.3, 0.5, 0.9, 1.})
  {
    middle[0] = x;
    auto section = request<dim>(K::section_mean, "velocity y", x);
    check::relative(name + "mean over the section at " + std::to_string(x).substr(0, 3),
                    body.value(section), linear.velocity(middle)[1], 1e-7);
  }
  auto section = request<dim>(K::section_integral, "pressure", 0.3);
  section.region_ids = {1};
  middle[0] = 0.3;
  const double area = dim == 2 ? 0.5 : 0.25;
  check::relative(name + "integral over a section of the fluid", body.value(section),
                  area * linear.pressure(middle, 1), 1e-7);

  std::vector<Expression> exact;
  for (unsigned int c = 0; c < dim; ++c)
  {
    std::string text = std::to_string(linear.at_origin[c] + 0.5);
    for (unsigned int d = 0; d < dim; ++d)
      text += " + " + std::to_string(linear.of_velocity[c][d]) + " * " + "xyz"[d];
    exact.emplace_back(text, Dimensions::none);
  }
  check::relative(name + "error norm of what is off by 0.5",
                  body.evaluation.error_norm(body.state(), ComparedField::velocity, exact, 0.),
                  0.5 * std::sqrt(double(dim)), 1e-5);
  const std::vector<Expression> pressure = {
      Expression(dim == 2 ? "2*x + 3*y" : "2*x + 3*y + 4*z", Dimensions::none)};
  // Off by 100 in the fluid alone.
  check::relative(name + "error norm of the pressure",
                  body.evaluation.error_norm(body.state(), ComparedField::pressure, pressure, 0.),
                  100. * std::sqrt(dim == 2 ? 0.25 : 0.125), 1e-10);

  check::throws<std::invalid_argument>(
      name + "outside", [&] { body.value(request<dim>(K::point, "pressure", 1.1)); }, "not inside");
  check::throws<std::invalid_argument>(
      name + "a section outside",
      [&] { body.value(request<dim>(K::section_mean, "pressure", 1.1)); },
      "a section without area");
  check::throws<std::invalid_argument>(
      name + "no such boundary",
      [&] { body.value(on_boundary<dim>(K::boundary_mean, "pressure", 17)); }, "no faces");
}

/// A tube of radius 1 whose wall begins at 0.5.
void test_tube()
{
  using K = Kind<2>;
  Body<2> tube(
      [](Triangulation<2> &mesh)
      {
        make_box(mesh, 4);
        for (const auto &cell : mesh.active_cell_iterators())
          cell->set_material_id(cell->center()[1] < 0.5 ? 1 : 0);
        refine<2>(mesh, [](const Point<2> &centre) { return centre[0] > 0.5; });
        refine<2>(mesh, [](const Point<2> &centre) { return centre[0] > 0.7 && centre[1] < 0.5; });
      },
      Model::axisymmetric);
  const Linear<2> linear(true);
  set(tube, linear);
  // U_x = -0.3 + x + 4 r, U_r = (2 + 2.3) r.
  for (const double x : {0.3, 0.75, 0.9})
  {
    const std::string name = "tube at " + std::to_string(x).substr(0, 4) + ": ";
    auto section = request<2>(K::section_integral, "velocity x", x);
    section.region_ids = {1};
    check::relative(name + "flow", tube.value(section),
                    numbers::PI * ((x - 0.3) * 0.25 + 4. * 2. / 3. * 0.125), 1e-7);
    auto rim = request<2>(K::rim_mean, "radial velocity", x);
    rim.region_ids = {1};
    check::relative(name + "mean round the rim", tube.value(rim), 0.5 * linear.of_velocity[1][1],
                    1e-8);
    rim.field = "wall shear stress";
    check::relative(name + "shear stress at the rim", tube.value(rim), -2. * 4., 1e-8);
    rim.field = "pressure";
    check::relative(name + "pressure at the rim", tube.value(rim), 2. * x + 1.5 + 100., 1e-8);
  }
  // The liquid's cells have gone any way along a stream: the wall has not.
  for (unsigned int cell = 0; cell < tube.space.mesh.n_owned_cells(); ++cell)
  {
    const auto &volume = tube.space.mesh.cells()[cell];
    if (volume.material_id == 1)
      tube.history.displacement()
          .begin()[tube.space.local_velocity(tube.space.velocities.of_cell(cell)) + 1] +=
          50. * volume.centre[0];
  }
  for (const double x : {0.3, 0.75, 0.9})
    for (const unsigned int region : {0, 1})
    {
      const std::string name = "tube at " + std::to_string(x).substr(0, 4) + ": wall distension";
      const std::string side = region == 0 ? ", at the wall" : ", at the liquid";
      auto at_wall = request<2>(region == 0 ? K::point : K::rim_mean,
                                region == 0 ? "displacement y" : "radial displacement", x);
      at_wall.point[1] = region == 0 ? 0.5 : 0.;
      at_wall.region_ids = {region};
      check::relative(name + side, tube.value(at_wall), 0.5 * linear.of_displacement[1][1], 1e-8);
    }
  check::relative("tube: mean pressure on its outside",
                  tube.value(on_boundary<2>(K::boundary_mean, "pressure", 3)), 1. + 3., 1e-12);
}

/// Errors of a quadratic field halve twice with the cells.
void test_order(const bool axisymmetric)
{
  using K = Kind<2>;
  std::map<std::string, std::vector<double>> errors;
  for (const unsigned int n : {8, 16})
  {
    Body<2> body([n](Triangulation<2> &mesh) { make_box(mesh, n); },
                 axisymmetric ? Model::axisymmetric : Model::plane_strain);
    body.velocity =
        velocity_field<2>(body.space,
                          [](const Point<2> &x) {
                            return Tensor<1, 2>({x[0] * x[0] + x[1] * x[1], x[0] * x[1]});
                          });
    auto point = request<2>(K::point, "velocity x", 0.75);
    point.point[1] = 0.25;
    point.region_ids = {0};
    errors["value in a corner of cells"].push_back(body.value(point) - 0.625);
    point.point[0] = 1.;
    errors["value on a boundary"].push_back(body.value(point) - 1.0625);
    errors["flow through a boundary"].push_back(
        body.value(on_boundary<2>(K::boundary_integral, "velocity x", 1)) -
        (axisymmetric ? 2. * numbers::PI * 0.75 : 4. / 3.));
    const std::vector<Expression> exact = {Expression("x^2+y^2", Dimensions::none),
                                           Expression("x*y", Dimensions::none)};
    errors["norm"].push_back(
        body.evaluation.error_norm(body.state(), ComparedField::velocity, exact, 0.));
  }
  for (const auto &[name, pair] : errors)
    check::absolute((axisymmetric ? "axisymmetric: order of the " : "2-D: order of the ") + name,
                    std::log2(pair[0] / pair[1]), 2., 0.2);
}
} // namespace

UNIT_TEST(cell_wise_evaluation)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  quiet_other_ranks();
  test_points<2>(Model::plane_strain);
  test_points<2>(Model::axisymmetric);
  test_points<3>(Model::three_dimensional);
  test_means<2>();
  test_means<3>();
  test_tube();
  test_order(false);
  test_order(true);
}
} // namespace test_of_cell_wise_evaluation
