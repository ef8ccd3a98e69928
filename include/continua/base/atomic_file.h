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
 *
 * After a power failure the rename is kept only if the folder, too, reached the disk:
 * flush_to_disk(folder_of(file)).
 */
void replace_file(const std::string &file,
                  const std::string &content,
                  const std::string &rest = "");

/// replace_file(), and flushes the folder. Throws RunError also when only the folder cannot be
/// flushed: the new file stands then, though a power failure may bring the old one back.
void write_file_atomically(const std::string &file,
                           const std::string &content,
                           const std::string &rest = "");

/// Has a file's content, or a folder's entries, written to the disk. Throws RunError with the
/// system's reason.
void flush_to_disk(const std::string &path);

/// The folder of a file, "." where its path has none.
std::string folder_of(const std::string &file);

/// Refuses a file that the command line names if its folder does not exist: throws InputError.
void require_folder_of(const std::string &file);
} // namespace Continua

#endif
