#ifndef continua_linear_algebra_block_factor_h
#define continua_linear_algebra_block_factor_h

#include <continua/linear_algebra/symmetric_factor.h>
#include <continua/linear_algebra/velocity_cycle.h>

#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <memory>
#include <vector>

namespace Continua
{
/// The factor of the rows and columns of some of the velocities. It solves for them, in one cycle.
class BlockFactor : public VelocityCycle
{
public:
  /// `rows`: the local indices of its velocities. Of the matrix nothing is kept. Throws
  /// FactorTooLarge if the entries of the factor need more than `most_bytes` [bytes]. Collective.
  BlockFactor(const dealii::TrilinosWrappers::SparseMatrix &matrix,
              const std::vector<unsigned int> &rows,
              double most_bytes);

  void add_cycle(DistributedVector &target, const DistributedVector &source) override;
  const SymmetricFactor &factor() const { return *inverse; }

private:
  const std::vector<unsigned int> rows;
  std::unique_ptr<SymmetricFactor> inverse;
  std::vector<double> part;
};
} // namespace Continua

#endif
