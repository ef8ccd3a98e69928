#include <continua/linear_algebra/block_factor.h>
#include <continua/linear_algebra/sub_matrix.h>

#include <utility>

namespace Continua
{
BlockFactor::BlockFactor(const dealii::TrilinosWrappers::SparseMatrix &matrix,
                         const std::vector<unsigned int> &rows_of_block,
                         const double most_bytes)
    : rows(rows_of_block), part(rows_of_block.size())
{
  SymmetricTriplets entries;
  std::vector<int> owned;
  {
    const SubMatrix block(matrix.trilinos_matrix(), rows);
    entries = block.lower_triangle();
    owned = block.owned();
  }
  inverse = make_block_factor(std::move(entries), owned, most_bytes, matrix.get_mpi_communicator());
}

void BlockFactor::add_cycle(DistributedVector &target, const DistributedVector &source)
{
  for (std::size_t k = 0; k < rows.size(); ++k)
    part[k] = source.begin()[rows[k]];
  inverse->solve(part);
  for (std::size_t k = 0; k < rows.size(); ++k)
    target.begin()[rows[k]] += part[k];
}
} // namespace Continua
