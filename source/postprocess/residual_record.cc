#include <continua/base/output_files.h>
#include <continua/postprocess/residual_record.h>

namespace Continua
{
namespace
{
constexpr char file_name[] = "residuals.csv";
}

template <int dim>
ResidualRecord<dim>::ResidualRecord(const MPI_Comm communicator) : run_table(communicator)
{
}

template <int dim>
std::vector<std::string> ResidualRecord<dim>::header()
{
  return {"time [s]", "correction [1]", "momentum residual [1]", "continuity residual [1]",
          "momentum imbalance [N]"};
}

template <int dim>
void ResidualRecord<dim>::open(ContinuumSolver<dim> &solver,
                               const std::string &folder,
                               const bool /*is_due*/)
{
  run_table.open(output_file(folder, file_name), header());
  listen(solver);
}

template <int dim>
void ResidualRecord<dim>::resume(ContinuumSolver<dim> &solver,
                                 const std::string &folder,
                                 const double time)
{
  run_table.resume(output_file(folder, file_name), header(), time);
  listen(solver);
}

template <int dim>
void ResidualRecord<dim>::listen(ContinuumSolver<dim> &solver)
{
  solver.report_corrections([this](const LoopCorrection &correction) { add(correction); });
}

template <int dim>
void ResidualRecord<dim>::add(const LoopCorrection &correction)
{
  if (!run_table.is_writing())
    return;
  row.assign({correction.time, static_cast<double>(correction.number), correction.residual,
              correction.continuity, correction.magnitude});
  run_table.row(row);
}

template <int dim>
void ResidualRecord<dim>::finish(const RecordedEnd<dim> & /*end*/)
{
  run_table.flush();
}

template <int dim>
void ResidualRecord<dim>::flush_to_disk()
{
  run_table.flush_to_disk();
}

template <int dim>
std::optional<WrittenTable> ResidualRecord<dim>::table() const
{
  return run_table.written();
}

template class ResidualRecord<2>;
template class ResidualRecord<3>;
} // namespace Continua
