#ifndef continua_postprocess_run_table_h
#define continua_postprocess_run_table_h

#include <continua/base/table_writer.h>

#include <mpi.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace Continua
{
/// A table of a run, which rank 0 of the communicator writes (see TableWriter). Opening and
/// flushing are collective: where the disk refuses every rank throws the RunError.
class RunTable
{
public:
  explicit RunTable(MPI_Comm communicator) : communicator(communicator) {}

  /// Starts the file.
  void open(const std::string &file, const std::vector<std::string> &header);
  /// Continues it after a restart at `restart_time` [s].
  void resume(const std::string &file, const std::vector<std::string> &header, double restart_time);
  /// Whether this rank writes rows.
  bool is_writing() const { return writer != nullptr; }
  /// Nothing on ranks that do not write.
  void row(const std::vector<double> &values);
  void flush();
  /// As flush(), and waits until the disk has it.
  void flush_to_disk();
  /// None on ranks that do not write.
  std::optional<WrittenTable> written() const;

private:
  MPI_Comm communicator;
  std::unique_ptr<TableWriter> writer;
};
} // namespace Continua

#endif
