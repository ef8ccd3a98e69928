#ifndef continua_base_atomic_file_h
#define continua_base_atomic_file_h

#include <string>

namespace Continua
{
/**
 * Writes `content` and `rest`, one after the other, to `file` so that whoever opens `file` finds
 * the old or the new content whole, whenever the program or the machine stops: to FILE.new first,
 * flushed to the disk, then renamed. Throws RunError with the system's reason when the disk
 * refuses; the old file is then untouched and FILE.new is gone.
 */
void write_file_atomically(const std::string &file,
                           const std::string &content,
                           const std::string &rest = "");

/// Has a file's content, or a folder's entries, written to the disk. Throws RunError with the
/// system's reason.
void flush_to_disk(const std::string &path);
} // namespace Continua

#endif
