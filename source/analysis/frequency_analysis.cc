#include <continua/analysis/frequency_analysis.h>

#include <continua/analysis/harmonic_checks.h>
#include <continua/analysis/steady_search.h>
#include <continua/signal/waveform.h>

namespace Continua
{
template <int dim>
void FrequencyAnalysis<dim>::start(const double time_of_loads)
{
  run.initialise();
  if (run.input.problem.is_nonlinear())
  {
    const bool is_mean = time_of_loads == mean_over_period;
    run.log.line(std::string("Before the frequencies: the state at rest under the ") +
                 (is_mean ? "mean of the loads" : "loads of the file"));
    const auto search = [this]
    {
      return SteadySearch<dim>(
          run, [](const StepReport &, double, double) {}, "begin anew with --overwrite");
    };
    using Loads = typename SteadySearch<dim>::Loads;
    const bool finds_shape = run.input.problem.finds_unloaded_shape();
    if (finds_shape)
      search().find_unloaded_shape(true);
    // The mesh has the shape under the loads at t = 0.
    if (is_mean || !finds_shape)
      search().perform(finds_shape ? Loads::present : Loads::in_parts, time_of_loads);
    run.solver->start_from_present_state();
  }
  system = harmonic_system_of(run);
}

template <int dim>
std::unique_ptr<TableWriter>
FrequencyAnalysis<dim>::complex_table(const std::string &name,
                                      const std::vector<std::string> &first) const
{
  if (!run.is_writer)
    return nullptr;
  std::vector<std::string> header = first;
  for (const std::string &column : run.input.probes.column_names())
    for (const char *const part : {"real ", "imaginary "})
      header.push_back(part + column);
  return std::make_unique<TableWriter>(run.directory.file(name), header);
}

template <int dim>
void FrequencyAnalysis<dim>::add_row(const std::unique_ptr<TableWriter> &table,
                                     std::vector<double> first,
                                     const std::vector<Complex> &of_probes)
{
  if (!table)
    return;
  for (const Complex &value : of_probes)
  {
    first.push_back(value.real());
    first.push_back(value.imag());
  }
  table->row(first);
}

template <int dim>
void FrequencyAnalysis<dim>::write_state(const double number)
{
  const OutputParameters &output = run.input.output;
  if (!writer)
    writer = std::make_unique<FieldWriter<dim>>(
        run.input.communicator, run.directory.path(),
        output.subdivisions_for(run.input.discretisation.velocities_per_cell()),
        output.higher_order_cells, output.files_per_state);
  writer->write(*run.solver, number);
}

template <int dim>
void FrequencyAnalysis<dim>::write_fields(const HarmonicSolution &solution, const double number)
{
  system->show(solution, 1.);
  write_state(number);
  system->show(solution, {0., -1.});
  write_state(number + 0.5);
}

template <int dim>
void FrequencyAnalysis<dim>::finish_fields()
{
  if (writer)
    writer->finish(run.summary);
}

template <int dim>
void FrequencyAnalysis<dim>::finish(const double time)
{
  run.citations.add("mumps");
  run.finish(0, time);
}

template class FrequencyAnalysis<2>;
template class FrequencyAnalysis<3>;
} // namespace Continua
