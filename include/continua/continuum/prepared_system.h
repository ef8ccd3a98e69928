#ifndef continua_continuum_prepared_system_h
#define continua_continuum_prepared_system_h

#include <continua/base/log.h>
#include <continua/continuum/branch_history.h>
#include <continua/continuum/operators.h>
#include <continua/continuum/outlet_coupling.h>
#include <continua/continuum/problem.h>
#include <continua/continuum/system_coefficients.h>

#include <set>

namespace Continua
{
/// The linear system of the steps: its coefficients, and what follows from a change of them.
class PreparedSystem
{
public:
  /// All must outlive it.
  PreparedSystem(const Problem &problem,
                 Operators &operators,
                 OutletCoupling &outlets,
                 const BranchHistory &history,
                 Log &log);

  /// Prepares the system for a step, with the responses of the outlets to a new factor. Collective.
  SystemChange prepare(const Step &step, StepReport &report);
  /// Without those of regions whose terms are not linear.
  const SystemCoefficients &coefficients() const { return of_system; }

private:
  const Problem &problem;
  Operators &operators;
  OutletCoupling &outlets;
  const BranchHistory &history;
  Log &log;
  SystemCoefficients of_step, of_system;
  /// Relaxation times whose exponential update the log has told of.
  std::set<double> exponential_branches_reported;

  void report_exponential_branches(const Step &step);
};
} // namespace Continua

#endif
