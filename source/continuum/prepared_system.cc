#include <continua/continuum/prepared_system.h>

#include <sstream>

namespace Continua
{
PreparedSystem::PreparedSystem(const Problem &problem,
                               Operators &operators,
                               OutletCoupling &outlets,
                               const BranchHistory &history,
                               Log &log)
    : problem(problem), operators(operators), outlets(outlets), history(history), log(log)
{
}

SystemChange PreparedSystem::prepare(const Step &step, StepReport &report)
{
  SectionTimer::Scope scope(log.timer(), "factor");
  of_system.set(problem, step);
  // Regions that are left out change with the step, too, and the tangent with them.
  const bool is_other = !(of_system == of_step);
  of_step = of_system;
  for (unsigned int region = 0; region < problem.materials.size(); ++region)
    if (operators.has_all_terms_in(region))
      of_system.leave_out(region);
  SystemChange change = operators.system().prepare(of_system, step.pressure_time);
  if (change == SystemChange::none && is_other && operators.is_nonlinear())
    change = SystemChange::coefficients;
  if (change != SystemChange::none && !operators.is_nonlinear())
    outlets.respond(report);
  if (change == SystemChange::factor)
    ++report.factors;
  if (report.factors > 0 || (change != SystemChange::none && operators.is_nonlinear()))
    report_exponential_branches(step);
  return change;
}

void PreparedSystem::report_exponential_branches(const Step &step)
{
  for (const double relaxation_time : history.exponential_branches(step))
    if (exponential_branches_reported.insert(relaxation_time).second)
    {
      std::ostringstream text;
      text << "The time step is longer than the relaxation time " << relaxation_time
           << " s: its branches take the exponential update";
      log.line(text.str());
    }
}
} // namespace Continua
