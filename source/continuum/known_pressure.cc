#include <continua/continuum/known_pressure.h>

#include <deal.II/base/mpi.h>

namespace Continua
{
void KnownPressure::reinit(const Problem &problem, const Operators &operators)
{
  entries = operators.pressures_without_history();
  // Copies are collective: a rank without such a pressure makes them, too.
  some_rank_has_entries =
      dealii::Utilities::MPI::max(entries.empty() ? 0 : 1, problem.communicator) == 1;
}

void KnownPressure::start(const DistributedVector &pressure)
{
  known.equ(1., pressure);
  time = 0.;
}

void KnownPressure::extrapolate(const Step &step,
                                const DistributedVector &of_step,
                                DistributedVector &pressure) const
{
  const double factor = (step.time - step.balance_time) / (step.balance_time - time);
  for (const unsigned int i : entries)
    pressure.begin()[i] = of_step.begin()[i] + factor * (of_step.begin()[i] - known.begin()[i]);
}

void KnownPressure::take(const Step &step, const DistributedVector &of_step)
{
  if (!some_rank_has_entries)
    return;
  known.equ(1., of_step);
  time = step.balance_time;
}

void KnownPressure::visit(StateVisitor &visitor)
{
  visitor.vector("known pressure", StateKind::pressure, known);
  visitor.value("time of the known pressure", time);
}
} // namespace Continua
