#include <continua/postprocess/step_record.h>

#include <algorithm>
#include <sstream>
#include <vector>

namespace Continua
{
void StepRecord::attempt(const StepReport &report)
{
  if (report.factored)
    ++n_factored;
}

void StepRecord::take(const double size)
{
  smallest = std::min(smallest, size);
  largest = std::max(largest, size);
}

void StepRecord::finish(const TimeControl &control, Summary &summary, Log &log) const
{
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
  log.line(text.str());
  if (n_above > 0)
    log.warning(std::to_string(n_above) +
                " steps of the smallest size have a larger local error than Time/Error tolerance");
}

void StepRecord::name_quantities(QuantityNames &names)
{
  for (const char *const name : {"steps rejected", "steps above the tolerance",
                                 "smallest time step", "largest time step", "mean time step"})
    names.add(name);
}

void StepRecord::save(ArchiveWriter &archive) const
{
  archive.add("step record", std::vector<double>{double(n_factored), smallest, largest});
}

void StepRecord::load(const ArchiveReader &archive)
{
  const std::vector<double> values = archive.values("step record");
  n_factored = static_cast<unsigned long>(values.at(0));
  smallest = values.at(1);
  largest = values.at(2);
}
} // namespace Continua
