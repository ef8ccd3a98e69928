#include <continua/linear_algebra/block_factor.h>

namespace Continua
{
BlockFactor::BlockFactor(const dealii::TrilinosWrappers::SparseMatrix &matrix,
                         const std::vector<unsigned int> &rows_of_block,
                         const double most_bytes)
    : rows(rows_of_block), part(rows_of_block.size())
{
  const SubMatrix block(matrix.trilinos_matrix(), rows);
  inverse = make_block_factor(block.lower_triangle(), block.owned(), most_bytes,
                              matrix.get_mpi_communicator());
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
