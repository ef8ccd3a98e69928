#ifndef continua_base_table_writer_h
#define continua_base_table_writer_h

#include <continua/base/written_table.h>

#include <chrono>
#include <cstddef>
#include <fstream>
#include <string>
#include <vector>

namespace Continua
{
/**
 * A csv file that grows row by row (probes.csv, power.csv). First row: names with units, "time
 * [s],tip: displacement y [m]". Numbers with 17 significant digits' worth of information (shortest
 * text that reads back to the same double). Rows are buffered and flushed at least every second and
 * at the end. After a restart the file is first cut behind the last row whose first column is not
 * after `restart_time`, so that it continues without gap or duplicate. Only the rank that writes
 * has one. Every method throws RunError when the disk refuses.
 */
class TableWriter
{
public:
  /// Starts a new file.
  TableWriter(const std::string &file, const std::vector<std::string> &header);
  /// Continues a file after a restart at `restart_time` [s] (or the unit of the first column); a
  /// row that a crash left half written is cut, too. Throws RunError if the file has another
  /// header. A file that is not there is started.
  TableWriter(const std::string &file, const std::vector<std::string> &header, double restart_time);
  /// Flushes; a failure can no longer be told here, so call flush() at the end of a run.
  ~TableWriter();
  /// As many values as the header has names.
  void row(const std::vector<double> &values);
  void flush();
  /// As flush(), and waits until the disk has it: a later power failure takes nothing of it.
  void flush_to_disk();
  /// All rows so far, those that are still buffered included.
  const WrittenTable &written() const { return contents; }

private:
  void open(bool append);
  void start();
  std::string file_name;
  std::ofstream stream;
  std::string buffer;
  std::size_t n_columns;
  WrittenTable contents;
  bool is_in_folder_on_disk = false;
  std::chrono::steady_clock::time_point last_flush;
};
} // namespace Continua

#endif
