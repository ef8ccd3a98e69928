#ifndef continua_postprocess_residual_record_h
#define continua_postprocess_residual_record_h

#include <continua/postprocess/record.h>
#include <continua/postprocess/run_table.h>

#include <mpi.h>

#include <memory>
#include <string>
#include <vector>

namespace Continua
{
/// The residuals of every correction of a solver that corrects its solution in a loop
/// (residuals.csv), also of those steps that are undone or fail. Rank 0 writes the file.
template <int dim>
class ResidualRecord : public Record<dim>
{
public:
  explicit ResidualRecord(MPI_Comm communicator);

  void open(ContinuumSolver<dim> &solver, const std::string &folder, bool is_due) override;
  void resume(ContinuumSolver<dim> &solver, const std::string &folder, double time) override;
  void finish(const RecordedEnd<dim> &end) override;
  void flush_to_disk() override;
  std::optional<WrittenTable> table() const override;

private:
  RunTable run_table;
  std::vector<double> row; ///< its memory is kept

  static std::vector<std::string> header();
  void listen(ContinuumSolver<dim> &solver);
  void add(const LoopCorrection &correction);
};
} // namespace Continua

#endif
