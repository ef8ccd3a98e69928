#include <continua/base/output_files.h>
#include <continua/postprocess/residual_record.h>
#include <continua/postprocess/writing_rank.h>

namespace Continua
{
namespace
{
constexpr char file_name[] = "residuals.csv";
}

template <int dim>
ResidualRecord<dim>::ResidualRecord(const MPI_Comm communicator) : communicator(communicator)
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
  on_writing_rank(
      communicator,
      [&]() { writer = std::make_unique<TableWriter>(output_file(folder, file_name), header()); });
  listen(solver);
}

template <int dim>
void ResidualRecord<dim>::resume(ContinuumSolver<dim> &solver,
                                 const std::string &folder,
                                 const double time)
{
  on_writing_rank(
      communicator, [&]()
      { writer = std::make_unique<TableWriter>(output_file(folder, file_name), header(), time); });
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
  if (!writer)
    return;
  row.assign({correction.time, static_cast<double>(correction.number), correction.residual,
              correction.continuity, correction.magnitude});
  writer->row(row);
}

template <int dim>
void ResidualRecord<dim>::finish(const RecordedEnd<dim> & /*end*/)
{
  on_writing_rank(communicator,
                  [&]()
                  {
                    if (writer)
                      writer->flush();
                  });
}

template <int dim>
void ResidualRecord<dim>::flush_to_disk()
{
  on_writing_rank(communicator,
                  [&]()
                  {
                    if (writer)
                      writer->flush_to_disk();
                  });
}

template <int dim>
std::optional<WrittenTable> ResidualRecord<dim>::table() const
{
  return writer ? std::make_optional(writer->written()) : std::nullopt;
}

template class ResidualRecord<2>;
template class ResidualRecord<3>;
} // namespace Continua
