#ifndef continua_finite_volume_coupled_solve_h
#define continua_finite_volume_coupled_solve_h

#include <continua/finite_volume/cell_wise_system.h>
#include <continua/linear_algebra/unsymmetric_factor.h>

#include <memory>
#include <string>
#include <vector>

namespace Continua
{
/// Velocities and pressures of a step at once, by one factor of the whole matrix that is kept as
/// long as the matrix is the same: the limit of the segregated loop.
template <int dim>
class CoupledSolve : public CellWiseSolve<dim>
{
public:
  explicit CoupledSolve(const CellWiseSystem<dim> &system);

  void reinit() override;
  /// After a new factor the solution is checked once: RunError if a step of refinement changes its
  /// velocity or pressure by more than 1e-7 of the largest value.
  void solve(const DistributedVector &momentum,
             const DistributedVector &mass,
             DistributedVector &velocity,
             DistributedVector &pressure,
             StepReport &report) override;
  double factor_entries() const override;
  double factor_memory() const override;
  std::string name() const override;

private:
  const CellWiseSystem<dim> &system;
  std::unique_ptr<UnsymmetricFactor> factor;
  std::vector<double> packed;
  bool is_checked = false;

  void check_solution(const DistributedVector &momentum,
                      const DistributedVector &mass,
                      const DistributedVector &velocity,
                      const DistributedVector &pressure);
};
} // namespace Continua

#endif
