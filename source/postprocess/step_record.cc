#include <continua/postprocess/step_record.h>

#include <algorithm>
#include <sstream>
#include <vector>

namespace Continua
{
template <int dim>
void StepRecord<dim>::attempt(const StepReport &report)
{
  n_factored += report.factors;
}

template <int dim>
void StepRecord<dim>::record(const RecordedStep<dim> &step)
{
  if (!step.ends_step)
    return;
  smallest = std::min(smallest, step.size);
  largest = std::max(largest, step.size);
}

template <int dim>
void StepRecord<dim>::finish(const RecordedEnd<dim> &end)
{
  const TimeControl &control = end.time_control;
  Summary &summary = end.summary;
  // No quantity: a restart makes one more.
  summary.set("matrices factored", static_cast<double>(n_factored));
  if (!control.is_adaptive() || control.n_steps() == 0)
    return;
  const unsigned int n_steps = control.n_steps(), n_rejected = control.sizes().n_rejected(),
                     n_above = control.sizes().n_above_tolerance();
  const auto add = [&summary](const char *name, const double value, const char *unit) {
    summary.add({name, value, unit, ""});
  };
  add("steps rejected", n_rejected, "1");
  add("steps above the tolerance", n_above, "1");
  add("smallest time step", smallest, "s");
  add("largest time step", largest, "s");
  add("mean time step", control.time() / n_steps, "s");
  std::ostringstream text;
  text << n_steps << " time steps of " << smallest << " s to " << largest << " s; " << n_rejected
       << " more were rejected";
  end.log.line(text.str());
  if (n_above > 0)
    end.log.warning(
        std::to_string(n_above) +
        " steps of the smallest size have a larger local error than Time/Error tolerance");
}

template <int dim>
void StepRecord<dim>::name_quantities(QuantityNames &names)
{
  for (const char *const name : {"steps rejected", "steps above the tolerance",
                                 "smallest time step", "largest time step", "mean time step"})
    names.add(name);
}

template <int dim>
void StepRecord<dim>::save(ArchiveWriter &archive) const
{
  archive.add("step record", std::vector<double>{double(n_factored), smallest, largest});
}

template <int dim>
void StepRecord<dim>::load(const ArchiveReader &archive)
{
  const std::vector<double> values = archive.values("step record");
  n_factored = static_cast<unsigned long>(values.at(0));
  smallest = values.at(1);
  largest = values.at(2);
}

template class StepRecord<2>;
template class StepRecord<3>;
} // namespace Continua
