#include <continua/linear_algebra/block_multigrid.h>

#include <Epetra_Vector.h>
#include <Teuchos_ParameterList.hpp>
#include <ml_MultiLevelPreconditioner.h>

#include <algorithm>

namespace Continua
{
using namespace dealii;

BlockMultigrid::BlockMultigrid(const TrilinosWrappers::SparseMatrix &matrix,
                               const std::vector<unsigned int> &rows,
                               const VelocityBlocks &blocks)
    : block(matrix.trilinos_matrix(), rows), part(rows.size()), part_of_solution(rows.size())
{
  std::vector<double> modes;
  for (const std::vector<double> &mode : blocks.modes)
    for (const unsigned int row : rows)
      modes.push_back(mode[row]);
  modes.resize(std::max<std::size_t>(modes.size(), 1));
  Teuchos::ParameterList list;
  ML_Epetra::SetDefaults("SA", list);
  list.set("ML output", 0);
  list.set("PDE equations", static_cast<int>(blocks.n_components));
  list.set("null space: type", "pre-computed");
  list.set("null space: dimension", static_cast<int>(blocks.modes.size()));
  list.set("null space: vectors", modes.data());
  list.set("null space: add default vectors", false);
  list.set("aggregation: type", "Uncoupled");
  list.set("aggregation: threshold", 0.);
  list.set("smoother: type", "Chebyshev");
  list.set("smoother: sweeps", 2);
  list.set("smoother: Chebyshev alpha", 20.);
  list.set("coarse: max size", 1000);
  list.set("coarse: type", "Amesos-KLU");
  multigrid.initialize(block.matrix(), list);
}

void BlockMultigrid::add_cycle(DistributedVector &target, const DistributedVector &source)
{
  block.gather(source.begin(), part.data());
  const Epetra_Vector right_hand_side(View, block.matrix().RowMap(), part.data());
  Epetra_Vector solution(View, block.matrix().RowMap(), part_of_solution.data());
  multigrid.trilinos_operator().ApplyInverse(right_hand_side, solution);
  block.scatter_add(part_of_solution.data(), target.begin());
}
} // namespace Continua
