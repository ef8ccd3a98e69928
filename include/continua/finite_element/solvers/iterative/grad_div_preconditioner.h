#ifndef continua_finite_element_solvers_iterative_grad_div_preconditioner_h
#define continua_finite_element_solvers_iterative_grad_div_preconditioner_h

#include <continua/finite_element/solvers/iterative/step_preconditioner.h>
#include <continua/finite_element/space/space.h>

#include <vector>

namespace Continua
{
/// The part of the stabilisation grad-div, int gamma div v div u, that the preconditioner has: in
/// the relaxation of the fluid and in the mass form of the Schur complement. Like an augmentation
/// it adds gamma to 1/s.
template <int dim>
class GradDivPreconditioner
{
public:
  /// `space` must outlive it.
  explicit GradDivPreconditioner(const Space<dim> &space);

  /// Takes gamma of each cell, by active_cell_index() [Pa s], for a preconditioner. A change below
  /// `smallest_change` is left out. Returns whether it was taken; add_to() is then due. Collective.
  bool take(const std::vector<double> &viscosities, const StepPreconditioner<dim> &preconditioner);
  /// Gives a preconditioner the present gamma, if there is any and the fluid is relaxed by products
  /// without a matrix. Collective.
  void add_to(StepPreconditioner<dim> &preconditioner) const;

private:
  /// Part of gamma that the preconditioner has [1]. With more of it the pressure gains, but the
  /// relaxation loses: in a bend FGMRES takes 27, 12, 11, 12 and 14 iterations with 0, 0.3, 0.5,
  /// 0.7 and 1 of it.
  static constexpr double share_of_grad_div = 0.5;
  /// Of gamma: the sum of |change| V over the liquid's cells, over that of (gamma + alpha) V [1].
  static constexpr double smallest_change = 0.3;

  const Space<dim> &space;
  /// gamma of each cell, of which the preconditioner has a part [Pa s]; empty: none.
  std::vector<double> grad_div;
};
} // namespace Continua

#endif
