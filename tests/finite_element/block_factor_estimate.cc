// The estimate of a block's factor by the graph of its nodes beside MUMPS's analysis of the block
// itself: of a plate and of a part of it, with hanging nodes, a fixed side and an inclined roller.

#include <continua/finite_element/solvers/block_factor_estimate.h>
#include <continua/finite_element/solvers/condensed_system.h>
#include <continua/finite_element/space/velocity_nodes.h>
#include <continua/linear_algebra/mumps_solver.h>

#include "../unit_test.h"
#include "conditions_in_turn.h"
#include "small_problem.h"

#include <Epetra_CrsMatrix.h>

#include <set>
#include <string>
#include <utility>

namespace test_of_block_factor_estimate
{
using namespace Continua;
using namespace dealii;

namespace
{
std::vector<BoundaryCondition> conditions_of_plate()
{
  const std::vector<std::string> names = {"left", "right", "bottom", "top", "back", "front"};
  std::string entries;
  std::set<std::pair<unsigned int, unsigned int>> pairs;
  for (unsigned int b = 0; b < names.size(); ++b)
  {
    const std::string type = b == 0 ? "fixed" : b == 2 ? "roller" : "free";
    entries += "subsection " + names[b] + "\nset Type = " + type + "\nend\n";
    pairs.insert({b, 0});
  }
  return conditions_in_turn(entries, names, {"body"}, pairs, 3);
}

/// Entries of the factor of the rows of the block, by the analysis of A itself.
double analysed(const TrilinosWrappers::SparseMatrix &matrix,
                const Space<3> &space,
                const std::vector<bool> &is_in_block)
{
  // Rows outside the block stay as rows with a diagonal entry alone, which are counted.
  const Epetra_CrsMatrix &a = matrix.trilinos_matrix();
  DistributedVector owned = space.velocity_vector(),
                    flags(space.velocity_owned, space.velocity_relevant, space.communicator);
  for (unsigned int i = 0; i < is_in_block.size(); ++i)
    owned.begin()[i] = is_in_block[i] ? 1. : 0.;
  flags = owned;
  std::vector<int> rows, columns;
  double n_outside = 0.;
  for (unsigned int i = 0; i < is_in_block.size(); ++i)
  {
    const int row = a.GRID(static_cast<int>(i));
    if (!is_in_block[i])
    {
      n_outside += 1.;
      rows.push_back(row);
      columns.push_back(row);
      continue;
    }
    int n_entries = 0;
    double *values = nullptr;
    int *locals = nullptr;
    a.ExtractMyRowView(static_cast<int>(i), n_entries, values, locals);
    for (int e = 0; e < n_entries; ++e)
    {
      const int column = a.GCID(locals[e]);
      if (column <= row && values[e] != 0. && flags[column] > 0.)
      {
        rows.push_back(row);
        columns.push_back(column);
      }
    }
  }
  return MumpsSolver<float>(MumpsSymmetry::quasi_definite, MumpsScaling::none, MPI_COMM_WORLD)
             .analyse(static_cast<int>(space.velocity_dofs.n_dofs()), rows, columns)
             .n_entries -
         Utilities::MPI::sum(n_outside, MPI_COMM_WORLD);
}
} // namespace

UNIT_TEST(block_factor_estimate)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  small_problem::quiet_other_ranks();
  const std::vector<BoundaryCondition> conditions = conditions_of_plate();
  small_problem::Mesh<3> mesh(MPI_COMM_WORLD);
  small_problem::make_box<3>(mesh, {12, 8, 2});
  GridTools::rotate(Tensor<1, 3>({0., 0., 1.}), 0.4, mesh);
  small_problem::refine<3>(mesh, [](const Point<3> &x) { return x[1] > 10.; });
  Space<3> space(mesh, SpaceParameters(), Model::three_dimensional, 1);
  space.distribute();
  BoundaryConstraints<3> constraints(space, conditions);
  constraints.build();
  std::vector<RegionOperators> operators(1);
  assemble_region_operators(space, operators);
  TrilinosWrappers::SparseMatrix matrix;
  assemble_velocity_block(space, operators, constraints, SystemCoefficients{{1.}, {1.}, {1.}},
                          nullptr, nullptr, matrix);

  const std::vector<unsigned int> all = nodes_in_order(space.velocity_dofs);
  std::vector<bool> is_in_block(all.size(), true);
  check::relative("all: estimate over analysis",
                  estimate_block_factor<3>(space, constraints, all) /
                      analysed(matrix, space, is_in_block),
                  1., 0.2);
  // All components of a node lie at one place.
  std::vector<unsigned int> part;
  const DistributedVector x =
      small_problem::interpolated<3>(space,
                                     [](const Point<3> &point) {
                                       return Tensor<1, 3>({point[0], point[0], point[0]});
                                     });
  for (const unsigned int i : all)
  {
    is_in_block[i] = x.begin()[i] > 4.;
    if (is_in_block[i])
      part.push_back(i);
  }
  check::relative("a part: estimate over analysis",
                  estimate_block_factor<3>(space, constraints, part) /
                      analysed(matrix, space, is_in_block),
                  1., 0.2);
}
} // namespace test_of_block_factor_estimate
