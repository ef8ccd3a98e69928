#ifndef continua_analysis_checkpoint_h
#define continua_analysis_checkpoint_h

#include <continua/base/archive.h>

#include <mpi.h>

#include <functional>
#include <string>

namespace Continua
{
/**
 * The state of a run on disk, to go on from: `checkpoint/STEP/` with one archive a rank and, where
 * the mesh has changed, the mesh; `checkpoint/current` names the last complete one. A new one is
 * written beside the old, then named, then the old one is removed, so that a kill at any moment
 * leaves a good one.
 */
class Checkpoint
{
public:
  /// `folder`: the output's checkpoint folder. `identity`: hash of the case, which must be the same
  /// at the restart.
  Checkpoint(MPI_Comm communicator, const std::string &folder, const std::string &identity);

  /// Writes what `fill` adds to this rank's archive. `save_mesh`, if any, writes the mesh to the
  /// file it is given. Collective.
  void write(unsigned int step,
             const std::function<void(ArchiveWriter &)> &fill,
             const std::function<void(const std::string &)> &save_mesh) const;

  /// Opens the last complete checkpoint: this rank's archive. Throws InputError if there is none,
  /// or if it belongs to another case, version or number of ranks; RunError if it is damaged.
  ArchiveReader read() const;
  /// The mesh file of the last complete checkpoint; empty if the mesh was not changed.
  std::string mesh_file() const;

private:
  MPI_Comm communicator;
  std::string folder;
  std::string identity;

  std::string current() const;
  std::string archive_file(const std::string &step) const;
};
} // namespace Continua

#endif
