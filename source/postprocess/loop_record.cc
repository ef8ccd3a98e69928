#include <continua/postprocess/loop_record.h>

#include <algorithm>
#include <sstream>

namespace Continua
{
template <int dim>
void LoopRecord<dim>::take(const StepReport &report, const double time, Log &log)
{
  ++n_steps;
  n_corrections += report.corrections;
  most_corrections = std::max<unsigned long>(most_corrections, report.corrections);
  largest_residual = std::max(largest_residual, report.residual);
  n_linear += report.linear_iterations;
  most_linear = std::max<unsigned long>(most_linear, report.linear_iterations);
  if (!report.cap_reached)
    return;
  std::ostringstream text;
  text << "the loop of the step to t = " << time << " s ended at its cap of " << report.corrections
       << " corrections with a residual of " << report.residual;
  if (n_capped++ == 0)
    log.warning(text.str() + "; the summary counts such steps, log.txt has them all");
  else
    log.detail(text.str());
}

template <int dim>
void LoopRecord<dim>::finish(Summary &summary) const
{
  if (n_linear > 0)
  {
    // No quantities: they depend on the ranks.
    summary.set("linear iterations", static_cast<double>(n_linear));
    summary.set("linear iterations a step (mean)",
                static_cast<double>(n_linear) / static_cast<double>(n_steps));
    summary.set("linear iterations a step (maximum)", static_cast<double>(most_linear));
  }
  if (n_corrections == 0)
    return;
  summary.set("corrections", static_cast<double>(n_corrections));
  const double mean = static_cast<double>(n_corrections) / static_cast<double>(n_steps);
  summary.add({"corrections a step (mean)", mean, "1", ""});
  summary.add({"corrections a step (maximum)", static_cast<double>(most_corrections), "1", ""});
  summary.add({"largest residual", largest_residual, "1", ""});
  summary.add({"steps that reached the cap", static_cast<double>(n_capped), "1", ""});
}

template <int dim>
void LoopRecord<dim>::name_quantities(QuantityNames &names)
{
  for (const char *const name : {"corrections a step (mean)", "corrections a step (maximum)",
                                 "largest residual", "steps that reached the cap"})
    names.add(name);
}

template <int dim>
void LoopRecord<dim>::save(ArchiveWriter &archive) const
{
  archive.add("loop: steps", n_steps);
  archive.add("loop: corrections", n_corrections);
  archive.add("loop: most corrections", most_corrections);
  archive.add("loop: steps at the cap", n_capped);
  archive.add("loop: linear iterations", n_linear);
  archive.add("loop: most linear iterations", most_linear);
  archive.add("loop: largest residual", largest_residual);
}

template <int dim>
void LoopRecord<dim>::load(const ArchiveReader &archive)
{
  n_steps = archive.integer("loop: steps");
  n_corrections = archive.integer("loop: corrections");
  most_corrections = archive.integer("loop: most corrections");
  n_capped = archive.integer("loop: steps at the cap");
  n_linear = archive.integer("loop: linear iterations");
  most_linear = archive.integer("loop: most linear iterations");
  largest_residual = archive.value("loop: largest residual");
}

template class LoopRecord<2>;
template class LoopRecord<3>;
} // namespace Continua
