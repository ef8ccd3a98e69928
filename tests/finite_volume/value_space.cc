// How many values a mesh has, by hand, and that the ranks agree on whose they are and what number
// each has.

#include "cell_wise_meshes.h"

#include "../unit_test.h"

#include <algorithm>
#include <map>

namespace test_of_value_space
{
using namespace cell_wise_meshes;

namespace
{
template <int dim>
void check_space(const std::string &name,
                 const std::function<void(Triangulation<dim> &)> &make,
                 const InterfaceValue interface_value,
                 const unsigned int n_values)
{
  Triangulation<dim> triangulation(MPI_COMM_WORLD);
  make(triangulation);
  CellWiseMesh<dim> mesh(triangulation, false);
  mesh.build();
  ValueSpace<dim> space(mesh, interface_value);
  space.distribute();
  check::is_true(name + ": values", space.n_values() == n_values);

  // Where each number is, says every rank that knows it: the place, for a broken value also the
  // region, and whether the value is the rank's own.
  std::vector<std::vector<double>> sent;
  const auto add = [&](const unsigned int number, const dealii::Point<dim> &place,
                       const double region, const bool owned)
  {
    std::vector<double> facts = {double(number), double(owned), region};
    for (unsigned int c = 0; c < dim; ++c)
      facts.push_back(place[c]);
    sent.push_back(facts);
  };
  bool contiguous = true, beyond = true;
  for (unsigned int c = 0; c < mesh.cells().size(); ++c)
  {
    const auto &cell = mesh.cells()[c];
    add(space.of_cell(c), cell.centre, -1., cell.is_owned);
    if (cell.is_owned)
      contiguous = contiguous && space.of_cell(c) == space.first_owned() + c;
  }
  for (unsigned int f = 0; f < mesh.faces().size(); ++f)
  {
    const auto &face = mesh.faces()[f];
    for (unsigned int side = 0; side < face.n_sides(); ++side)
    {
      beyond = beyond &&
               space.beyond(f, side) ==
                   (face.has_value() ? space.of_face(f, side) : space.of_cell(face.cell(1 - side)));
      if (face.has_value())
        add(space.of_face(f, side), face.centre,
            interface_value == InterfaceValue::broken ? mesh.cells()[face.cell(side)].material_id
                                                      : -1.,
            space.owns_face(f, side));
    }
  }
  std::map<unsigned int, std::vector<std::vector<double>>> facts_of;
  std::vector<unsigned int> n_owners(space.n_values(), 0);
  const auto of_ranks = dealii::Utilities::MPI::all_gather(MPI_COMM_WORLD, sent);
  for (const auto &of_rank : of_ranks)
  {
    std::map<unsigned int, bool> owned; // a common value is reported from both sides
    for (const auto &facts : of_rank)
    {
      facts_of[facts[0]].push_back(facts);
      owned[facts[0]] = facts[1] > 0.;
    }
    for (const auto &[number, is_owned] : owned)
      n_owners[number] += is_owned;
  }
  double difference = 0.;
  for (const auto &[number, facts] : facts_of)
    for (const auto &other : facts)
      for (unsigned int i = 2; i < other.size(); ++i)
        difference = std::max(difference, std::abs(other[i] - facts[0][i]));
  check::is_true(name + ": every number is used", facts_of.size() == space.n_values());
  check::is_true(
      name + ": every number has one owner",
      std::all_of(n_owners.begin(), n_owners.end(), [](const unsigned int n) { return n == 1; }));
  check::absolute(name + ": a number is in one place", difference, 0., 1e-14);
  check::is_true(name + ": cells come first, in their order", largest(contiguous ? 0. : 1.) == 0.);
  check::is_true(name + ": beyond a face", largest(beyond ? 0. : 1.) == 0.);

  const auto owned = dealii::Utilities::MPI::all_gather(MPI_COMM_WORLD, space.owned(dim));
  unsigned int next = 0;
  bool in_turn = true;
  for (const auto &set : owned)
  {
    in_turn = in_turn && set.is_contiguous() &&
              (set.n_elements() == 0 || set.nth_index_in_set(0) == next);
    next += set.n_elements();
  }
  check::is_true(name + ": the entries of a vector field, rank by rank",
                 in_turn && next == dim * n_values && space.vector(dim).size() == next);
}
} // namespace

UNIT_TEST(value_space)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  quiet_other_ranks();

  // The block that is region 1 has 2 x 2 cells of the square and 2 + 2 + 2 faces inside; of the
  // cube 2 x 2 x 2 and 4 + 4 x 4.
  const auto square = [](Triangulation<2> &mesh) { make_box(mesh, 4); };
  const auto cube = [](Triangulation<3> &mesh) { make_box(mesh, 4); };
  check_space<2>("square, common", square, InterfaceValue::common, 16 + 16 + 6);
  check_space<2>("square, broken", square, InterfaceValue::broken, 16 + 16 + 2 * 6);
  check_space<3>("cube, common", cube, InterfaceValue::common, 64 + 96 + 20);
  check_space<3>("cube, broken", cube, InterfaceValue::broken, 64 + 96 + 2 * 20);
  // The lower left quarter divided: 3 more cells for each of 4; two more faces on each side for 2
  // x 2; on the interface the two lower faces and the left ones are counted by hand: the quarter
  // x, y < 1/2 has the lower side of the block, two faces that become four.
  const auto divided = [](Triangulation<2> &mesh)
  {
    make_box(mesh, 4);
    refine<2>(mesh,
              [](const dealii::Point<2> &centre) { return centre[0] < 0.5 && centre[1] < 0.5; });
  };
  check_space<2>("divided, common", divided, InterfaceValue::common, 28 + 20 + 9);
  check_space<2>("divided, broken", divided, InterfaceValue::broken, 28 + 20 + 2 * 9);
}
} // namespace test_of_value_space
