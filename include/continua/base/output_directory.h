#ifndef continua_base_output_directory_h
#define continua_base_output_directory_h

#include <continua/base/folder_lock.h>

#include <mpi.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace Continua
{
/**
 * The folder of one run. The constructor creates it (with fields/, checkpoint/, input/), locks it
 * as long as the object lives, refuses (InputError) one in which another run works, that is not
 * writable, that is a file, or that holds a run (a summary.json, parameters.prm or checkpoint)
 * unless `overwrite` (which removes what a run writes, and nothing else) or `restart` (which wants
 * a checkpoint there). Files that no run writes stay. Collective: rank 0 does it and all ranks
 * throw alike.
 */
class OutputDirectory
{
public:
  enum class Mode
  {
    fresh,
    overwrite,
    restart
  };
  /// `inputs`: the user's files; an overwrite that would remove one of them is refused.
  OutputDirectory(const std::string &path,
                  Mode mode,
                  MPI_Comm communicator,
                  const std::vector<std::string> &inputs = {});

  OutputDirectory(OutputDirectory &&) = default;

  /// Whether a checkpoint was finished in the folder: its files have lost the ending of the
  /// temporary ones.
  static bool has_checkpoint(const std::string &path);

  /// Path of a file in it; the name is one of output_files().
  std::string file(const std::string &name) const;
  /// Path of a file whose name depends on the case, or of the folder "NAME/" of a run of its own.
  /// The folder remembers the name (other-files.txt), so that an overwrite removes it. On rank 0
  /// alone; throws RunError when the disk refuses.
  std::string file_of_case(const std::string &name) const;
  const std::string &path() const;
  /// What the user should know of the folder: that it cannot be locked. The same on all ranks.
  const std::string &warning() const { return text_of_warning; }
  /// Copies the user's files to input/ (same base names; a second one of the same name gets a
  /// number). Collective; throws RunError on all ranks.
  void copy_inputs(const std::vector<std::string> &files) const;
  /// The names that their copies have or will have, "input/NAME", by the files' absolute paths.
  static std::map<std::string, std::string> names_of_copies(const std::vector<std::string> &files);

private:
  std::string directory;
  MPI_Comm communicator;
  std::string text_of_warning;
  std::unique_ptr<FolderLock> lock; ///< on rank 0
};
} // namespace Continua

#endif
