// Volumes of bodies and closed surfaces of cells, weights and centres known by hand, and that the
// ranks on both sides of a face say the same of it.

#include "cell_wise_meshes.h"

#include "../unit_test.h"

#include <algorithm>
#include <map>
#include <optional>

namespace test_of_cell_wise_mesh
{
using namespace cell_wise_meshes;
namespace
{
const double pi = dealii::numbers::PI;

/// What must hold on every mesh; `volume` [m^3, m^2], of bodies with a simple one.
template <int dim>
void check_measures(const std::string &name,
                    const std::function<void(Triangulation<dim> &)> &make,
                    const bool axisymmetric,
                    const std::optional<double> &volume)
{
  Triangulation<dim> triangulation(MPI_COMM_WORLD);
  make(triangulation);
  CellWiseMesh<dim> mesh(triangulation, axisymmetric);
  mesh.build();

  double total = 0., axis_area = 0.;
  std::vector<dealii::Tensor<1, dim>> closed(mesh.cells().size());
  std::vector<double> around(mesh.cells().size(), 0.);
  for (unsigned int f = 0; f < mesh.faces().size(); ++f)
  {
    const auto &face = mesh.faces()[f];
    for (unsigned int side = 0; side < face.n_sides(); ++side)
    {
      closed[face.cell(side)] += face.plane_area * face.outward(side);
      around[face.cell(side)] += face.area * face.outward(side)[0];
    }
    if (axisymmetric && std::abs(face.centre[1]) < 1e-14)
      axis_area = std::max(axis_area, face.area);
  }
  double open = 0.;
  for (unsigned int c = 0; c < mesh.n_owned_cells(); ++c)
  {
    total += mesh.cells()[c].volume;
    open = std::max({open, closed[c].norm(), std::abs(around[c])});
  }
  total = sum(total);
  if (volume)
    check::relative(name + ": volume", total, *volume, 1e-13);
  check::absolute(name + ": closed cells", largest(open), 0., 1e-14);
  if (axisymmetric)
    check::absolute(name + ": nothing on the axis", largest(axis_area), 0., 0.);

  // Of a face between ranks both must say the same: numbers, place, normal, area, weight.
  std::vector<std::vector<double>> sent;
  for (const auto &face : mesh.faces())
    if (!face.at_boundary() &&
        mesh.cells()[face.owner].is_owned != mesh.cells()[face.neighbour].is_owned)
    {
      std::vector<double> facts = {double(mesh.cells()[face.owner].number),
                                   double(mesh.cells()[face.neighbour].number),
                                   double(face.is_interface),
                                   face.area,
                                   face.plane_area,
                                   face.owner_weight,
                                   mesh.cells()[face.owner].volume,
                                   mesh.cells()[face.neighbour].volume};
      for (unsigned int c = 0; c < dim; ++c)
        for (const double value : {face.centre[c], face.normal[c], face.distance[c]})
          facts.push_back(value);
      sent.push_back(facts);
    }
  std::map<std::pair<double, double>, std::vector<std::vector<double>>> facts_of;
  for (const auto &of_rank : dealii::Utilities::MPI::all_gather(MPI_COMM_WORLD, sent))
    for (const auto &facts : of_rank)
      facts_of[{facts[0], facts[1]}].push_back(facts);
  bool twice = true;
  double difference = 0.;
  for (const auto &[numbers, facts] : facts_of)
  {
    twice = twice && facts.size() == 2 && numbers.first < numbers.second;
    if (facts.size() == 2)
      for (unsigned int i = 0; i < facts[0].size(); ++i)
        difference = std::max(difference, std::abs(facts[0][i] - facts[1][i]));
  }
  check::is_true(name + ": the owner is the cell with the smaller number on both ranks", twice);
  check::absolute(name + ": both ranks measure the same", difference, 0., 1e-14);
}

/// The number of faces of a mesh, each counted by its owner's rank.
template <int dim>
unsigned int n_faces(const CellWiseMesh<dim> &mesh)
{
  unsigned int n = 0;
  for (const auto &face : mesh.faces())
    n += mesh.cells()[face.owner].is_owned;
  return dealii::Utilities::MPI::sum(n, MPI_COMM_WORLD);
}

/// Largest tangent of the angle between a face's normal and the line of centres.
double largest_angle(const CellWiseMesh<2> &mesh)
{
  double tangent = 0.;
  for (const auto &face : mesh.faces())
  {
    const double along = face.distance * face.normal;
    tangent = std::max(tangent, (face.distance - along * face.normal).norm() / std::abs(along));
  }
  return largest(tangent);
}

/// Largest distance of a face's centre from the line of centres, over the length of that line.
double largest_skewness(const CellWiseMesh<2> &mesh)
{
  double skewness = 0.;
  for (const auto &face : mesh.faces())
  {
    const dealii::Tensor<1, 2> to_face = face.centre - mesh.cells()[face.owner].centre;
    const double share = to_face * face.distance / face.distance.norm_square();
    skewness = std::max(skewness, (to_face - share * face.distance).norm() / face.distance.norm());
  }
  return largest(skewness);
}

} // namespace

UNIT_TEST(cell_wise_mesh)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  quiet_other_ranks();

  // The corners of the projected square; areas by the shoelace formula, volumes of revolution as
  // sums of frusta, the projected cube by the determinant: V = integral of 1 / divisor^4.
  const std::vector<dealii::Point<2>> corners = {
      {0., 0.}, {1. / 1.5, 0.}, {1. / 1.8, 1. / 1.8}, {0., 1. / 1.3}};
  double projected_area = 0., projected_revolution = 0.;
  for (unsigned int i = 0; i < 4; ++i)
  {
    const dealii::Point<2> &a = corners[i], &b = corners[(i + 1) % 4];
    projected_area += 0.5 * (a[0] * b[1] - b[0] * a[1]);
    projected_revolution += pi / 3. * (a[0] - b[0]) * (a[1] * a[1] + a[1] * b[1] + b[1] * b[1]);
  }
  double projected_volume = 0.; // of 1 / divisor over -6 times its slopes, between the corners
  for (const double x : {0., 1.})
    for (const double y : {0., 1.})
      for (const double z : {0., 1.})
        projected_volume += (2. * x - 1.) * (2. * y - 1.) * (2. * z - 1.) /
                            (1. + 0.5 * x + 0.3 * y + 0.1 * z) / (-6. * 0.5 * 0.3 * 0.1);
  // A quarter of a ring with four cells around, as a polygon: divided once, eight pieces.
  const double ring = 0.5 * 8. * std::sin(pi / 16.) * (1. - 0.25);

  for (const auto &named : flat_faced<2>())
    if (named.name != "adaptive and curved" && named.name != "random")
    {
      const bool projected = named.name.find("projective") != std::string::npos;
      check_measures<2>("2-D, " + named.name, named.make, false, projected ? projected_area : 1.);
      check_measures<2>("axisymmetric, " + named.name, named.make, true,
                        projected ? projected_revolution : pi);
    }
  check_measures<2>(
      "2-D, random",
      [](Triangulation<2> &mesh)
      {
        make_box(mesh, 4);
        distort_coarse_mesh(mesh, 0.3);
        refine_corner(mesh);
      },
      false, 1.);
  check_measures<2>(
      "2-D, curved",
      [](Triangulation<2> &mesh)
      {
        dealii::GridGenerator::quarter_hyper_shell(mesh, dealii::Point<2>(), 0.5, 1., 4);
        refine(mesh);
      },
      false, ring);
  // Nodes that hang inside, off the straight edges of the coarser cells, change nothing: the
  // polygon of the body is divided near its ends and not elsewhere.
  check_measures<2>(
      "2-D, curved and adaptive inside",
      [](Triangulation<2> &mesh)
      {
        dealii::GridGenerator::quarter_hyper_shell(mesh, dealii::Point<2>(), 0.5, 1., 4);
        refine(mesh);
        refine(mesh);
        refine<2>(mesh, [](const dealii::Point<2> &centre)
                  { return std::abs(centre.norm() - 0.75) < 0.12; });
      },
      false, 0.5 * 16. * std::sin(pi / 32.) * (1. - 0.25));
  for (const auto &named : flat_faced<3>())
    check_measures<3>("3-D, " + named.name, named.make, false,
                      named.name.find("projective") != std::string::npos ? projected_volume : 1.);
  check_measures<3>(
      "3-D, random and adaptive",
      [](Triangulation<3> &mesh)
      {
        make_box(mesh, 4);
        distort_coarse_mesh(mesh, 0.25);
        refine_corner(mesh);
      },
      false, 1.);
  check_measures<3>("3-D, curved and adaptive",
                    [](Triangulation<3> &mesh)
                    {
                      dealii::GridGenerator::cylinder_shell(mesh, 1., 0.5, 1., 16, 4);
                      refine<3>(mesh, [](const dealii::Point<3> &centre)
                                { return centre[0] > 0. && std::abs(centre[2] - 0.5) < 0.3; });
                    },
                    false, {});

  {
    // Between two cells, from the lengths of both; their centres are in their middle.
    Triangulation<2> triangulation(MPI_COMM_WORLD);
    make_box(triangulation, 4);
    grade(triangulation);
    CellWiseMesh<2> mesh(triangulation, false);
    mesh.build();
    double error = 0.;
    for (const auto &face : mesh.faces())
      if (!face.at_boundary() && std::abs(face.normal[0]) > 0.5)
      {
        const double s = not_graded(face.centre[0]);
        const double before = 0.5 * (graded(s) - graded(s - 0.25)),
                     after = 0.5 * (graded(s + 0.25) - graded(s));
        const double weight = (face.normal[0] > 0. ? after : before) / (before + after);
        error = std::max({error, std::abs(face.owner_weight - weight),
                          std::abs(face.distance * face.normal - before - after)});
      }
    check::absolute("graded: weights and distances", largest(error), 0., 1e-14);
    check::is_true("graded: faces", n_faces(mesh) == 2 * 4 * 5);
    check::absolute("graded: orthogonal", largest_angle(mesh) + largest_skewness(mesh), 0., 1e-13);
  }
  {
    // Four unit squares, the first divided: 3 + 4 cells; 4 + 4 faces in the divided one and around
    // it twice as many as before.
    Triangulation<2> triangulation(MPI_COMM_WORLD);
    make_box(triangulation, 2);
    refine<2>(triangulation,
              [](const dealii::Point<2> &centre) { return centre[0] < 0.5 && centre[1] < 0.5; });
    CellWiseMesh<2> mesh(triangulation, false);
    mesh.build();
    check::is_true("hanging nodes: faces", n_faces(mesh) == 12 + 4 + 4);
    bool pieces = true;
    for (const auto &cell : mesh.cells())
      if (cell.is_owned)
        pieces = pieces &&
                 cell.faces.size() ==
                     (cell.volume > 0.2 && (cell.centre[0] < 0.5 || cell.centre[1] < 0.5) ? 5 : 4);
    check::is_true("hanging nodes: a face for each finer neighbour",
                   largest(pieces ? 0. : 1.) == 0.);
    // From the middle (1/8, 1/8 or 3/8) of a small cell to that of its neighbour (3/4, 1/4).
    check::absolute("hanging nodes: angle", largest_angle(mesh), 1. / 3., 1e-14);
  }
  {
    // Shear by x + y/2 makes angles and no skewness: it tilts lines of centres by 1/2 against the
    // normals of faces y = const, and the normals of faces x = const as much against the others.
    Triangulation<2> triangulation(MPI_COMM_WORLD);
    make_box(triangulation, 4);
    move_vertices<2>(triangulation, [](const dealii::Point<2> &point)
                     { return dealii::Point<2>(point[0] + 0.5 * point[1], point[1]); });
    CellWiseMesh<2> mesh(triangulation, true);
    mesh.build();
    check::absolute("sheared: angle", largest_angle(mesh), 0.5, 1e-14);
    check::absolute("sheared: not skewed", largest_skewness(mesh), 0., 1e-14);
  }
  {
    // One trapezium, the axis its longer side of 2, the other 1, 1 apart: its middle is at 4/9, and
    // what it sweeps is a cylinder of radius 1 and length 1 with cones at its ends of 1/2 each.
    Triangulation<2> triangulation(MPI_COMM_WORLD);
    dealii::GridGenerator::general_cell(triangulation, {{0., 0.}, {2., 0.}, {0.5, 1.}, {1.5, 1.}},
                                        false);
    CellWiseMesh<2> mesh(triangulation, true);
    mesh.build();
    double height = 0., volume = 0.;
    if (mesh.n_owned_cells() == 1)
    {
      height = mesh.cells()[0].centre[1];
      volume = mesh.cells()[0].volume;
    }
    check::absolute("trapezium: centre", sum(height), 4. / 9., 1e-15);
    check::absolute("trapezium: volume", sum(volume), pi + 2. * pi / 3. * 0.5, 1e-14);
  }
}
} // namespace test_of_cell_wise_mesh
