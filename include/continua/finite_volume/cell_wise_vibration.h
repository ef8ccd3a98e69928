#ifndef continua_finite_volume_cell_wise_vibration_h
#define continua_finite_volume_cell_wise_vibration_h

#include <continua/continuum/vibration_operator.h>
#include <continua/finite_volume/coupled_solve.h>
#include <continua/finite_volume/held_cells.h>

#include <functional>
#include <memory>
#include <vector>

namespace Continua
{
/**
 * Free vibrations of the cell-wise discretisation. The unknowns are the cells' displacements; the
 * faces' and all pressures follow from them. The operator is not symmetric: Gauss's gradient beside
 * boundaries is not, and so a few of the highest modes may grow or decay by themselves.
 */
template <int dim>
class CellWiseVibration : public VibrationOperator<dim>
{
public:
  /// `coefficients`: of the body at rest.
  CellWiseVibration(CellWiseSystem<dim> &system,
                    const CellWiseCoefficients &coefficients,
                    const VibratingState &state);

  unsigned int n_local_unknowns() const override { return dim * space.mesh.n_owned_cells(); }
  std::vector<unsigned int> directions() const override;
  bool is_symmetric() const override { return false; }
  void multiply_mass(const std::vector<double> &x, std::vector<double> &y) override;
  std::vector<double>
  momentum(const std::function<dealii::Tensor<1, dim>(const dealii::Point<dim> &)> &field) override;
  void set_shift(double shift) override;
  void solve(std::vector<double> &x) override;
  /// Without it the pressure of an incompressible solid's cells does not follow from their places.
  bool has_acceleration() const override;
  void accelerate(const std::vector<double> &x, std::vector<double> &y) override;
  void set_shape(const std::vector<double> &x, double eigenvalue) override;

private:
  CellWiseSystem<dim> &system;
  const CellWiseSpace<dim> &space;
  const CellWiseCoefficients steady;
  VibratingState state;
  CoupledSolve<dim> coupled;
  std::unique_ptr<HeldCells<dim>> held; ///< made when it is asked for
  double shift = 0.;
  std::vector<double> masses;                            ///< of the cells, by unknown [kg]
  DistributedVector force, mass, displacement, pressure; ///< work space

  void prepare(double new_shift);
};
} // namespace Continua

#endif
