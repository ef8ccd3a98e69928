#ifndef continua_base_written_table_h
#define continua_base_written_table_h

#include <continua/base/checksum.h>

#include <limits>
#include <string>

namespace Continua
{
/// What a run has written so far of a file that a restart continues.
struct WrittenTable
{
  std::string name; ///< from the output folder
  Checksum all;
  /// Without its last row, which a restart leaves out when the row stands there only because the
  /// part of the run before ended with it.
  Checksum without_last_row;
  /// The first column of the last row; there may be none.
  double last_time = -std::numeric_limits<double>::infinity();
};
} // namespace Continua

#endif
