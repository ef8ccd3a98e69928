#ifndef continua_base_output_directory_h
#define continua_base_output_directory_h

#include <mpi.h>

#include <string>
#include <vector>

namespace Continua
{
/**
 * The folder of one run. The constructor creates it (with fields/, checkpoint/, input/), refuses
 * (InputError) one that is not writable, that is a file, or that holds a run (a summary.json,
 * parameters.prm or checkpoint) unless `overwrite` (which removes what a run writes, and nothing
 * else) or `restart` (which wants a checkpoint there). Files that no run writes stay. Collective:
 * rank 0 does it and all ranks throw alike.
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

  /// Path of a file in it.
  std::string file(const std::string &name) const;
  const std::string &path() const;
  /// Copies the user's files to input/ (same base names; a second one of the same name gets a
  /// number). Collective; throws RunError on all ranks.
  void copy_inputs(const std::vector<std::string> &files) const;

private:
  std::string directory;
  MPI_Comm communicator;
};
} // namespace Continua

#endif
