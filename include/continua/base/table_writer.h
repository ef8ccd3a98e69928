#ifndef continua_base_table_writer_h
#define continua_base_table_writer_h

#include <fstream>
#include <string>
#include <vector>

namespace Continua
{
/**
 * A csv file that grows row by row (probes.csv, power.csv). First row: names with units, "time [s],tip: displacement
 * y [m]". Numbers with 17 significant digits' worth of information (shortest text that reads back to the same
 * double). Rows are buffered and flushed at least every second and at the end. After a restart the file is first cut
 * behind the last row whose first column is not after `restart_time`, so that it continues without gap or duplicate.
 * Only the rank that writes has one.
 */
class TableWriter
{
public:
  TableWriter(const std::string &file, const std::vector<std::string> &header);
  TableWriter(const std::string &file, const std::vector<std::string> &header, double restart_time);
  ~TableWriter();
  void row(const std::vector<double> &values);
  void flush();

private:
  std::string file_name;
  std::ofstream stream;
  std::string buffer;
  std::size_t n_columns;
  double last_flush;
};
} // namespace Continua

#endif
